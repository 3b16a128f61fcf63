# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests that run the program `lahar` from outside share."""
import os

failed = []

# One thread a rank; Open MPI may run as root, without a remote shell or a network, and with more ranks than cores
# (version 4 and 5).
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", DEAL_II_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe", OMPI_MCA_plm_rsh_agent="",
                   OMPI_MCA_btl="^tcp")


def on_ranks(command, mpiexec, n_ranks):
    """The command on several ranks, with the environment for it; on one rank without MPI's launcher."""
    if n_ranks == 1:
        return command, ENVIRONMENT
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


def barrier(left, right):
    """Parameters of an elastic barrier, 8 cm high and clamped below."""
    return f"""
subsection Solids
  set Number of solids = 1
  subsection Solid 1
    set Box     = {left}, 0 : {right}, 0.08
    set Clamped = {left}, 0 : {right}, 0
    subsection hypoelastic
      set Density         = 2500
      set Young's modulus = 1e6
      set Poisson's ratio = 0
    end
  end
end
"""
