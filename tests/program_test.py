# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests that run the program `lahar` from outside share."""
import os
import tempfile

failed = []

# Where Open MPI keeps its files: another program's MPI may remove the common directory at the wrong moment.
_session = tempfile.TemporaryDirectory(prefix="lahar-mpi-")

# One thread a rank; Open MPI may run as root, without a remote shell or a network, and with more ranks than cores
# (version 4 and 5).
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", DEAL_II_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe", OMPI_MCA_plm_rsh_agent="",
                   OMPI_MCA_btl="^tcp", OMPI_MCA_orte_tmpdir_base=_session.name)

# For one rank without MPI's launcher: without a daemon and drivers for networks, which take minutes now and then.
ALONE = dict(ENVIRONMENT, OMPI_MCA_ess_singleton_isolated="1", OMPI_MCA_pml="ob1", OMPI_MCA_btl="self")


def on_ranks(command, mpiexec, n_ranks):
    """The command on several ranks, with the environment for it; on one rank without MPI's launcher."""
    if n_ranks == 1:
        return command, ALONE
    return [mpiexec, "-np", str(n_ranks), *command], dict(ENVIRONMENT, OMPI_MCA_mpi_yield_when_idle="1")


def check(what, condition, *details):
    """Print whether the condition holds, and the details if not; failed keeps what does not."""
    print(("ok: " if condition else "FAILED: ") + what, flush=True)
    if not condition:
        failed.append(what)
        for detail in details:
            print("    " + str(detail).replace("\n", "\n    "))


def new_case(parent, name, text):
    """A new directory with the parameter file case.prm."""
    directory = os.path.join(parent, name)
    os.mkdir(directory)
    with open(os.path.join(directory, "case.prm"), "w") as file:
        file.write(text)
    return directory


def section(name, *texts):
    """A subsection of a parameter file with the texts, each of one or more lines."""
    lines = [line for text in texts for line in text.splitlines() if line.strip()]
    return "\n".join([f"subsection {name}", *("  " + line for line in lines), "end\n"])


def shape(kind, *settings):
    """Entries of a fluid, boundary or solid of this shape; settings of the shape are texts 'entry = value'."""
    return f"set Shape = {kind}\n" + section(kind, *("set " + setting for setting in settings))


def mesh(file, groups, scale=1.):
    """The shape of groups of a gmsh file."""
    return shape("mesh", f"File = {file}", f"Groups = {groups}", f"Scale = {scale:g}")


def parts(kind, texts, *more):
    """The fluids, boundaries or solids of a case, by their names, as text; more stands beside them in the subsection."""
    return f"set {kind} = {', '.join(texts)}\n" + section(kind, *more, *(section(*part) for part in texts.items()))


def wall(points, law="no slip"):
    """Entries of a boundary of lines in the plane, of polygons in space."""
    in_space = points.split(":")[0].count(",") == 2
    return (shape("polygon", "Corners = " + points) if in_space else shape("polyline", "Points = " + points)) + \
        f"set Law = {law}\n"


def walls(points):
    """One boundary 'walls', to which fluid sticks."""
    return parts("Boundaries", {"walls": wall(points)})


def fluid(corners, *more):
    """One fluid 'fluid' of boxes, and its further entries."""
    return parts("Fluids", {"fluid": shape("box", "Corners = " + corners) + "".join(more)})


def barrier(left, right):
    """One solid 'barrier', elastic, 8 cm high and clamped below."""
    return parts("Solids", {"barrier": shape("box", f"Corners = {left}, 0 : {right}, 0.08") + f"""
set Clamped = {left}, 0 : {right}, 0
subsection hypoelastic
  set Density         = 2500
  set Young's modulus = 1e6
  set Poisson's ratio = 0
end
"""})
