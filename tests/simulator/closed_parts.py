#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test fluid without a free surface by whole runs: in a full tank a vortex decays and the weight shows in the pressure,
with either linear solver; a lid that moves into a full tank ends the run with the place, one that leaves a gap does not.

Usage: closed_parts.py LAHAR
"""
import math
import os
import re
import subprocess
import sys
import tempfile

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [TESTS, os.path.join(os.path.dirname(TESTS), "contrib", "plot")]

from lahar_output import read_statistics  # noqa: E402
from program_test import ALONE, check, failed, fluid, new_case, parts, shape, wall, walls  # noqa: E402

LAHAR = os.path.abspath(sys.argv[1])

NEWTONIAN = """
set Law = Newtonian
subsection Newtonian
  set Density   = 1000
  set Viscosity = 1
end
"""
VISCOSITY = 1. / 1000.  # kinematic, m²/s

TANK = """
set Dimension        = 2
set Output directory = out
set End time         = 0.1
set Time step        = 2e-3
set Mesh size        = 0.02
""" + fluid("0, 0 : 0.2, 0.2", NEWTONIAN, """
set Initial velocity = 0.1*sin(pi*x/0.2)*cos(pi*y/0.2); -0.1*cos(pi*x/0.2)*sin(pi*y/0.2)
""") + parts("Boundaries", {
    "slip walls": wall("0, 0.2 : 0, 0 : 0.2, 0 : 0.2, 0.2 ; 0, 0.2 : 0.2, 0.2", "free slip")}) + """
subsection Linear solver
  set Type = %s
end
subsection Postprocess
  subsection Point gauges
    set Points = low: 0.1, 0.05 ; high: 0.1, 0.15
  end
end
"""

BASIN = """
set Dimension        = 2
set Output directory = out
set End time         = 0.01
set Time step        = 1e-3
set Mesh size        = 0.01
""" + fluid("0, 0 : 0.1, 0.1", NEWTONIAN) + walls("0, 0.12 : 0, 0 : 0.1, 0 : 0.1, 0.12")


def lid(left, right):
    """A lid between these x."""
    box = f"{left:g}, 0.1 : {right:g}, 0.12"
    return parts("Solids", {"lid": shape("box", "Corners = " + box) + f"""
set Driven           = {box}
set Driving velocity = 0 ; -0.1
subsection hypoelastic
  set Density         = 1000
  set Young's modulus = 1e6
  set Poisson's ratio = 0.3
end
"""})


def run(parent, name, text):
    directory = new_case(parent, name, text)
    result = subprocess.run([LAHAR, "case.prm"], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                            capture_output=True, text=True, timeout=900)
    return directory, result


def test_tank(parent, solver):
    directory, result = run(parent, solver, TANK % solver)
    check(f"full tank, {solver}: it runs to its end", result.returncode == 0, result.stderr)
    statistics = read_statistics(os.path.join(directory, "out", "statistics"))
    energy, time = (statistics[name] for name in ("Kinetic energy (J)", "Time (s)"))
    # An eigenfunction of Stokes' equations between slip walls: v ~ exp(-2 nu (pi/L)^2 t).
    rate = math.log(energy[0] / energy[-1]) / (time[-1] - time[0])
    exact = 4. * VISCOSITY * (math.pi / 0.2)**2
    check(f"... the energy decays at {exact:.3f} 1/s within 4 %", abs(rate / exact - 1.) < 0.04, rate)
    # The vortex is symmetric about half the height, its own pressure too.
    difference = statistics["low pressure (Pa)"] - statistics["high pressure (Pa)"]
    check("... the pressures differ by the weight within 0.2 %", max(abs(difference / -981. - 1.)) < 2e-3, difference)
    check("... the volume stays", max(abs(statistics["Volume change by solver"])) < 1e-9)


def test_lids(parent):
    directory, result = run(parent, "lid", BASIN + lid(0., 0.1))
    place = re.search(r"the fluid around \((\S+) (\S+)\) m has no free surface.*would change its volume by -", result.stderr)
    check("a lid that moves into a full tank: status 1 and a place in the tank",
          result.returncode == 1 and place and all(0. <= float(x) <= 0.1 for x in place.groups()), result.stderr)
    check("... a checkpoint is left", os.path.exists(os.path.join(directory, "out", "checkpoint", "state")))
    _, result = run(parent, "gap", BASIN + lid(0.02, 0.08))
    check("a lid with gaps beside it moves", result.returncode == 0, result.stderr)


def main():
    with tempfile.TemporaryDirectory() as parent:
        for solver in ("direct", "iterative"):
            test_tank(parent, solver)
        test_lids(parent)
    return 1 if failed else 0


sys.exit(main())
