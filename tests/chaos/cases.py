# SPDX-License-Identifier: GPL-3.0-or-later
"""Random small cases for chaos.py, and the comparison of what their runs leave.

Linear and nonlinear tolerances are tight, so that the number of ranks changes rounding only.
"""
import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import barrier, fluid, section, walls  # noqa: E402

COMMON = """
set Output directory = out
set Output interval  = %(interval)g
set Time step        = 2e-3
set End time         = %(end)g
set Mesh size        = %(size)g
set Largest number of particles = 30000
subsection Checkpoint
  set Steps between   = %(steps)d
  set Minutes between = 0
end
subsection Solids
  set Largest number of nodes = 30000
end
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

YIELDING = section("Bingham", "set Yield stress = %(stress)g")

COLUMN = fluid("0, 0 : 0.146, %(height)g", YIELDING) + walls("0, 0.4 : 0, 0 : 0.5, 0")

SPACE = "set Dimension = 3\n" + fluid("0, 0, 0 : 0.1, 0.1, %(height)g", YIELDING) + \
    walls("-0.2, -0.2, 0 : 0.3, -0.2, 0 : 0.3, 0.3, 0 : -0.2, 0.3, 0")

# What measures convergence or time, not the flow.
NOT_THE_FLOW = ("Velocity increment", "Pressure increment", "Momentum residual (N)", "Mass residual (m^dim/s)",
                "Linear iterations", "Nonlinear iterations", "Wall time (s)")


def random_case(random):
    """Name and parameter file of a case of 15 to 25 steps."""
    kind = random.choice(["column", "column", "barrier", "space"])
    values = {"size": random.choice([0.015, 0.02]), "stress": random.choice([0, 20, 100]),
              "end": 2e-3 * random.randint(15, 25), "interval": 2e-3 * random.randint(1, 8),
              "steps": random.choice([0, 1, 3, 7]), "height": random.choice([0.15, 0.2, 0.292])}
    text = COMMON + COLUMN
    if kind == "barrier":
        text += barrier(0.17, 0.19).replace("%", "%%")
    elif kind == "space":
        values.update(size=0.025, height=0.1, end=2e-3 * random.randint(6, 10))
        text = COMMON + SPACE
    return kind, text % values


class Statistics:
    """Columns and rows of the file; none if it is not there."""

    def __init__(self, directory):
        try:
            with open(os.path.join(directory, "out", "statistics"), errors="replace") as file:
                text = file.read()
        except OSError:
            text = ""
        self.columns = re.findall(r"^# \d+: (.*)$", text, re.M)
        self.rows = [line.split() for line in text.splitlines() if not line.startswith("#")]

    def without_wall_time(self):
        wall = self.columns.index("Wall time (s)") if "Wall time (s)" in self.columns else len(self.columns)
        return [row[:wall] + row[wall + 1:] for row in self.rows]

    def difference(self, other):
        """Nothing, or how the rows of the other one differ, bit for bit."""
        if self.columns != other.columns:
            return "the columns differ"
        own, others = self.without_wall_time(), other.without_wall_time()
        for i, (a, b) in enumerate(zip(own, others)):
            if a != b:
                return "row %d is %s instead of %s" % (i + 1, " ".join(b), " ".join(a))
        return "" if len(own) == len(others) else "%d rows instead of %d" % (len(others), len(own))

    def distance(self, other):
        """The largest difference of two numbers of the flow, as a part of the largest one in its column, and where; of
        volumes' changes, which are relative already, itself."""
        if self.columns != other.columns or len(self.rows) != len(other.rows):
            return math.inf, "columns or rows: %d instead of %d" % (len(other.rows), len(self.rows))
        worst = (0., "")
        for c, column in enumerate(self.columns):
            if column in NOT_THE_FLOW:
                continue
            a, b = ([float(row[c]) for row in rows] for rows in (self.rows, other.rows))
            scale = 1. if column.startswith("Volume change") else max(map(abs, a)) or 1.
            worst = max(worst, (max(abs(x - y) for x, y in zip(a, b)) / scale, column))
        return worst
