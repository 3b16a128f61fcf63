#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test the program `lahar` on several ranks, each run in a directory of its own.

column, barrier, rotational, space: 1, 2 and 3 ranks compute the same: fluid in the plane with the direct solver, with an
          elastic barrier, with rotational symmetry, in space with the iterative solver; linear and nonlinear tolerances are
          tight, so that rounding is all that differs. The pieces of a snapshot are the whole.
exact, exact_space, chosen, thixotropic: the same of a fluid whose yield stress is exact, in the plane and in space, with the
          direct solver, of one whose parameter of the multipliers the program chooses, and of one that builds up and breaks
          down.
rejected: the same where a step is given up and repeated with half its length.
resume:   a checkpoint of two ranks is resumed on three and on one; a piece that is damaged or missing is refused.
pieces:   so is a piece in the place of another rank's, of another checkpoint or another run, or of the same number in a run
          that has taken another way.
same:     a run that is resumed on as many ranks is, bit for bit, the one that is not, with the iterative solver and with
          KLU; with MUMPS, which adds up in the order in which messages come, to rounding. With an exact yield stress, too.
faults:   wrong input and failed runs end all ranks with the status of one rank and one message; if one rank alone has
          too little memory to start the others do not wait for ever.

Usage: ranks.py GROUP LAHAR MPIEXEC
"""
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "contrib", "plot"))

import numpy as np  # noqa: E402

from lahar_output import read_pvd, read_vtu  # noqa: E402
from program_test import barrier, check, failed, fluid, new_case, on_ranks, section, walls  # noqa: E402

LAHAR, MPIEXEC = os.path.abspath(sys.argv[2]), sys.argv[3]

YIELDING = section("Bingham", "set Yield stress = 20")

COLUMN = """
set Output directory = out
set End time         = 0.03
set Time step        = 2e-3
set Mesh size        = 0.015
""" + fluid("0, 0 : 0.146, 0.292", YIELDING) + walls("0, 0.4 : 0, 0 : 0.5, 0") + """
subsection Postprocess
  subsection Point gauges
    set Points = inside: 0.05, 0.1; middle: 0.073, 0.146; foot: 0.01, 0.003; dry: 0.4, 0.3
  end
  subsection Wall forces
    set Boxes = floor: 0, -0.001 : 0.5, 0.001
  end
end
"""

# Appended to every case: rounding is all that may differ.
TIGHT = """
subsection Nonlinear solver
  set Tolerance = 1e-8
end
subsection Linear solver
  subsection Direct
    set Tolerance = 1e-8
  end
  subsection Iterative
    set Tolerance = 1e-8
  end
end
"""

BARRIER = COLUMN + barrier(0.16, 0.172) + """
subsection Postprocess
  subsection Solid points
    set Points = tip: 0.16, 0.08
  end
end
"""

ROTATIONAL = COLUMN.replace("0, 0.4 : 0, 0 : 0.5, 0", "0, 0 : 0.5, 0") + "set Geometry = rotational symmetry\n"

SPACE = """
set Dimension        = 3
set Output directory = out
set End time         = 0.012
set Time step        = 2e-3
set Mesh size        = 0.02
""" + fluid("0, 0, 0 : 0.1, 0.1, 0.15", YIELDING) + \
    walls("-0.2, -0.2, 0 : 0.3, -0.2, 0 : 0.3, 0.3, 0 : -0.2, 0.3, 0") + """
subsection Postprocess
  subsection Point gauges
    set Points = middle: 0.035, 0.06, 0.075; foot: 0.01, 0.09, 0.003; dry: 0.2, 0.2, 0.2
  end
  subsection Wall forces
    set Boxes = floor: -0.2, -0.2, -0.001 : 0.3, 0.3, 0.001
  end
end
"""

# Structure that grows and breaks within the run.
STRUCTURE = "\n".join(["set Yield stress = 20", "set Flocculation time = 0.02", "set Deflocculation parameter = 2",
                       "set Initial structure = 0.5"])


def exact(text):
    """The same case with a fluid whose yield stress is exact."""
    return text.replace("set Yield stress = 20", "set Yield stress = 300\nset Plastic viscosity = 1\nset Yield = exact")


# Multipliers make increments smaller by a factor an iteration only.
MULTIPLIERS = """
subsection Nonlinear solver
  set Tolerance          = 1e-6
  set Maximum iterations = 100
end
"""

# Velocities that are zero by symmetry are as large as the iterative solver leaves them.
DIRECT = """
subsection Linear solver
  set Type = direct
end
"""

# The first step moves particles three times as far as this.
CAUTIOUS = """
set End time         = 0.005
set Largest movement = 1e-3
"""

CASES = {"column": COLUMN + TIGHT, "barrier": BARRIER + TIGHT, "rotational": ROTATIONAL + TIGHT, "space": SPACE + TIGHT,
         "exact": exact(COLUMN) + TIGHT + MULTIPLIERS, "exact_space": exact(SPACE) + TIGHT + MULTIPLIERS + DIRECT,
         "chosen": exact(COLUMN).replace("set Yield = exact", "set Yield = exact\nset Augmentation parameter = auto") + TIGHT +
         MULTIPLIERS,
         "rejected": BARRIER + TIGHT + CAUTIOUS,
         "thixotropic": COLUMN.replace("set Yield stress = 20", STRUCTURE) + TIGHT}

# What measures convergence, not the flow.
CONVERGENCE = ("Velocity increment", "Pressure increment", "Momentum residual (N)", "Mass residual (m^dim/s)",
               "Linear iterations", "Nonlinear iterations", "Yield gap (W)", "Relative yield gap",
               "Wall time (s)")

def run(directory, n_ranks, *arguments, program=None):
    """Run case.prm, by hand-made mpiexec arguments if there is a program."""
    command, environment = on_ranks(program or [LAHAR, *arguments, "case.prm"], MPIEXEC, n_ranks)
    return subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=400)


def read_statistics(directory):
    text = open(os.path.join(directory, "out", "statistics")).read()
    columns = re.findall(r"^# \d+: (.*)$", text, re.M)
    rows = [[float(value) for value in line.split()] for line in text.splitlines() if not line.startswith("#")]
    return {name: [row[i] for row in rows] for i, name in enumerate(columns)}


def largest_difference(expected, found):
    """Of two columns; where one has a number and the other one none, they differ."""
    return max(float(math.isnan(a) != math.isnan(b)) if math.isnan(a) or math.isnan(b) else abs(a - b)
               for a, b in zip(expected, found))


def compare(what, expected, found, tolerance=1e-6):
    check(what + ": the same columns and steps", list(expected) == list(found) and
          len(expected["Time (s)"]) == len(found["Time (s)"]) > 5)
    worst, where = 0., ""
    for name, values in expected.items():
        if name not in CONVERGENCE and not name.startswith("Volume change"):
            scale = max((abs(value) for value in values if not math.isnan(value)), default=1.) or 1.
            error = largest_difference(values, found[name]) / scale
            worst, where = max((worst, where), (error, name))
    for name in ("Volume change by solver", "Volume change by remeshing"):  # relative already
        error = largest_difference(expected[name], found[name])
        worst, where = max((worst, where), (error, name))
    check(what + ": the same values", worst <= tolerance, f"{where} differs by {worst}")


def area_and_integrals(directory):
    """Area, and integrals of pressure, strain rate and speed over the last snapshot in the plane."""
    path = read_pvd(os.path.join(directory, "out", "solution.pvd"))[-1][1]
    mesh = read_vtu(path)
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    areas = 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    speed = np.linalg.norm(mesh.point_data["velocity"], axis=1)
    return path.suffix, np.array([len(areas), areas.sum(), areas @ mesh.point_data["strain_rate"][mesh.triangles].mean(axis=1),
                                  areas @ mesh.point_data["pressure"][mesh.triangles].mean(axis=1),
                                  areas @ speed[mesh.triangles].mean(axis=1)])


def same_on_all(name):
    with tempfile.TemporaryDirectory() as parent:
        results = {}
        for n_ranks in (1, 2, 3):
            directory = new_case(parent, str(n_ranks), CASES[name])
            result = run(directory, n_ranks)
            check(f"{name}: {n_ranks} ranks", result.returncode == 0, result.returncode, result.stdout, result.stderr)
            check(f"{name}: {n_ranks} ranks write once", result.stdout.count("Fluid particles") == 1, result.stdout)
            results[n_ranks] = read_statistics(directory)
        compare(f"{name}: 2 ranks and 1", results[1], results[2])
        compare(f"{name}: 3 ranks and 1", results[1], results[3])
        gauges = [values[-1] for column, values in results[1].items() if column.endswith(" pressure (Pa)")]
        check(f"{name}: gauges in the fluid and outside", 0 < sum(map(math.isnan, gauges)) < len(gauges), gauges)
        if name == "rejected":
            check("rejected: steps were repeated", results[1]["Rejected steps"][-1] > 0)
        if "space" not in name:
            (suffix, whole), (several, pieces) = (area_and_integrals(os.path.join(parent, n)) for n in "13")
            check(f"{name}: pieces for several ranks", (suffix, several) == (".vtu", ".pvtu"), suffix, several)
            check(f"{name}: the pieces are the whole", np.allclose(whole, pieces, rtol=1e-5, atol=0), whole, pieces)


def resume():
    with tempfile.TemporaryDirectory() as parent:
        whole, parts = (new_case(parent, name, CASES["column"]) for name in ("whole", "parts"))
        run(whole, 1)
        check("resume: begun by 2 ranks", run(parts, 2, "--set", "End time=0.01").returncode == 0)
        folder = os.path.join(parts, "out", "checkpoint")
        pieces = [name for name in os.listdir(folder) if name.startswith("piece-")]
        check("resume: the second rank has a piece", len(pieces) == 1 and pieces[0].endswith("-1-of-2"), pieces)
        path = os.path.join(folder, pieces[0])
        good = open(path, "rb").read()
        for what, data, words in (("damaged", good[:-1] + bytes([good[-1] ^ 1]), "checksum is wrong"),
                                  ("missing", None, "is not there")):
            os.remove(path)
            if data:
                with open(path, "wb") as file:
                    file.write(data)
            result = run(parts, 3, "--resume", "--set", "End time=0.02")
            check(f"resume: a {what} piece: status 2", result.returncode == 2, result.returncode, result.stderr)
            check("resume: ... one message names it", len(re.findall("^lahar: ", result.stderr, re.M)) == 1 and
                  pieces[0] in result.stderr and words in result.stderr, result.stderr)
        with open(path, "wb") as file:
            file.write(good)
        check("resume: continued by 3", run(parts, 3, "--resume", "--set", "End time=0.02").returncode == 0)
        result = run(parts, 1, "--resume")
        check("resume: ended by 1", result.returncode == 0, result.stdout, result.stderr)
        compare("resume: 2, 3 and 1 ranks", read_statistics(whole), read_statistics(parts))


def pieces():
    with tempfile.TemporaryDirectory() as parent:
        coarse = CASES["column"].replace("= 0.015", "= 0.03")
        case, other = (new_case(parent, name, coarse) for name in ("case", "other"))
        for directory in (case, other):
            check("pieces: begun by 3", run(directory, 3, "--set", "End time=0.004").returncode == 0)
        before, sibling = os.path.join(parent, "before"), os.path.join(parent, "sibling")
        shutil.copytree(case, before)
        shutil.copytree(case, sibling)
        check("pieces: continued", run(case, 3, "--resume", "--set", "End time=0.008").returncode == 0)
        result = run(sibling, 3, "--resume", "--set", "End time=0.008", "--set", "Time step=1e-3")
        check("pieces: continued in another way", result.returncode == 0, result.stderr)

        def path(directory, rank):
            folder = os.path.join(directory, "out", "checkpoint")
            names = [name for name in os.listdir(folder) if name.endswith(f"-{rank}-of-3")]
            return os.path.join(folder, names[0])

        place = path(case, 1)
        good = open(place, "rb").read()
        for what, source, words in (("of another rank", path(case, 2), "is the piece of rank 2 of 3"),
                                    ("of an earlier checkpoint", path(before, 1), "is of checkpoint 1 of the run"),
                                    ("of another run", path(other, 1), "is of another run"),
                                    ("of the same number", path(sibling, 1), "is not the piece with which 'state' was")):
            shutil.copy(source, place)
            result = run(case, 1, "--resume")
            check(f"pieces: one {what}: status 2", result.returncode == 2, result.returncode, result.stdout, result.stderr)
            check("pieces: ... the message names it", words in result.stderr and os.path.basename(place) in result.stderr,
                  result.stderr)
        with open(place, "wb") as file:
            file.write(good)
        check("pieces: the good one works", run(case, 1, "--resume", "--set", "End time=0.01").returncode == 0)


def lines(directory, name):
    """The file's lines; those of the statistics without wall times."""
    text = open(os.path.join(directory, "out", name)).read().splitlines()
    return [line if line.startswith("#") else line.split()[:-1] for line in text] if name == "statistics" else text


def same():
    # Ten digits show differences of rounding only where tolerances are not tight; and the division of space must have
    # changed before the checkpoint.
    text = COLUMN.replace("End time         = 0.03", "Output interval  = 0.04\nset End time         = 0.08").replace(
        "= 0.015", "= 0.02")
    with tempfile.TemporaryDirectory() as parent:
        for law, solver, package in (("regularised", "iterative", "MUMPS"), ("regularised", "direct", "KLU"),
                                     ("regularised", "direct", "MUMPS"), ("exact", "direct", "KLU")):
            n_ranks = 2
            is_reproducible = (solver, package) != ("direct", "MUMPS")
            case = exact(text) if law == "exact" else text
            whole, parts = (new_case(parent, f"{name}-{law}-{solver}-{package}", case + ("" if is_reproducible else TIGHT))
                            for name in ("whole", "parts"))
            options = ["--set", f"Linear solver/Type={solver}", "--set", f"Linear solver/Direct/Package={package}"]
            what = f"same: {n_ranks} ranks, {law}, {solver} solver" + (f" {package}" if solver == "direct" else "")
            check(f"{what}: the whole run", run(whole, n_ranks, *options).returncode == 0)
            check(f"{what}: a part of it", run(parts, n_ranks, *options, "--set", "End time=0.04").returncode == 0)
            check(f"{what}: the rest", run(parts, n_ranks, "--resume", *options).returncode == 0)
            if not is_reproducible:
                compare(what, read_statistics(whole), read_statistics(parts))
                continue
            for name in ("statistics", "convergence"):
                check(f"{what}: {name} bit for bit", lines(whole, name) == lines(parts, name) and
                      len(lines(whole, name)) > 40)


def faults():
    with tempfile.TemporaryDirectory() as parent:
        directory = new_case(parent, "faults", CASES["column"])
        for what, arguments, status, message in (
                ("wrong input", ("--set", "Mesh size=-1"), 2, "Mesh size"),
                ("an entry that is none", ("--set", "Mash size=1"), 2, "Mash size"),
                ("output that cannot be written", ("--set", "Output directory=/proc/none"), 2, "Output directory"),
                ("a run that fails", ("--set", "Nonlinear solver/Maximum iterations=1"), 1, "no convergence")):
            result = run(directory, 2, *arguments)
            check(f"faults: {what}: status {status}", result.returncode == status, result.returncode, result.stderr)
            check(f"faults: {what}: one message", len(re.findall("^lahar: ", result.stderr, re.M)) == 1 and
                  message in result.stderr, result.stderr)

        # 600,000 kB of addresses are too few for the second rank, which ends before it starts MPI.
        case = [LAHAR, "--overwrite", "--set", "Mesh size=0.0015", "case.prm"]
        result = run(directory, 1, program=[*case, ":", "-np", "1", "/bin/sh", "-c",
                                            'ulimit -v 600000; exec "$@"', "sh", *case])
        check("faults: one rank without memory ends all", result.returncode != 0, result.returncode, result.stderr)


if sys.argv[1] in CASES:
    same_on_all(sys.argv[1])
else:
    {"resume": resume, "pieces": pieces, "same": same, "faults": faults}[sys.argv[1]]()
sys.exit(1 if failed else 0)
