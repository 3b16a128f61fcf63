#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a rough case of this folder: it must reach its end, with status 0 and nothing on stderr, with finite numbers in
the statistics, and solver and remeshing may change the volume by 3 % at most.

Usage: rough.py LAHAR CASE.prm [MPIEXEC RANKS]
"""
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program_test import on_ranks

lahar, case = [os.path.abspath(path) for path in sys.argv[1:3]]
mpiexec, n_ranks = sys.argv[3] if len(sys.argv) > 3 else "", int(sys.argv[4]) if len(sys.argv) > 4 else 1

with tempfile.TemporaryDirectory() as directory:
    command, environment = on_ranks([lahar, "--set", "Output directory=out", case], mpiexec, n_ranks)
    process = subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if process.returncode != 0 or process.stderr:
        sys.exit("status %s: %s" % (process.returncode, process.stderr))
    with open(os.path.join(directory, "out", "statistics")) as file:
        lines = file.read().splitlines()

with open(case) as file:
    end_time = float(re.search(r"set End time *= *(\S+)", file.read())[1])
columns = [line.split(":", 1)[1].strip() for line in lines if line.startswith("#")]
rows = [[float(word) for word in line.split()] for line in lines if line.strip() and not line.startswith("#")]
last = dict(zip(columns, rows[-1]))
print("%d steps, %d of them repeated" % (len(rows), last["Rejected steps"]))
assert all(math.isfinite(number) for row in rows for number in row), "a number that is not finite"
assert abs(last["Time (s)"] - end_time) < 1e-9, "ends at %g s" % last["Time (s)"]
change = [abs(row[columns.index("Volume change by solver")] + row[columns.index("Volume change by remeshing")]) for row in rows]
print("largest change of the volume: %.3g" % max(change))
assert max(change) < 0.03, "the volume changes by %g" % max(change)
if os.path.basename(case) == "leaving.prm":
    print("volume that left: %.3g" % last["Volume left the domain"])
    assert last["Volume left the domain"] > 0.5, "only %g of the volume left" % last["Volume left the domain"]
