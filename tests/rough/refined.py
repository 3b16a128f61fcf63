#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a dam break through a refined box, and the same one with the size of the box everywhere: the mesh must have the size
of the box in it and that of the case elsewhere, at the start, while the fluid runs in and once it has left it; remeshing may
not change the volume by more than 0.5 % in either; the fronts must stay within a mesh size of each other.

Usage: refined.py LAHAR CASE.prm
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "contrib" / "plot"), str(ROOT / "tests")]

from lahar_output import column, read_pvd, read_statistics, read_vtu  # noqa: E402
from program_test import ALONE  # noqa: E402

lahar, case = [os.path.abspath(path) for path in sys.argv[1:3]]
MESH_SIZE, FINE, BOX = 0.0146, 0.0073, (0.1, 0., 0.25, 0.1)
GROWTH = 0.2  # of the mesh size over the distance from the box


def run(parent, name, *arguments):
    process = subprocess.run([lahar, "--set", "Output directory=" + name, *arguments, case], cwd=parent, env=ALONE,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if process.returncode != 0 or process.stderr:
        sys.exit("%s: status %s: %s" % (name, process.returncode, process.stderr))
    path = pathlib.Path(parent) / name
    statistics = read_statistics(path / "statistics")
    change = np.abs(column(statistics, "Volume change by remeshing", path)).max()
    print("%s: largest change of the volume by remeshing %.2g, repeated steps %d"
          % (name, change, column(statistics, "Rejected steps", path)[-1]))
    assert change < 0.005, "remeshing changes the volume by %g" % change
    return path, column(statistics, "Time (s)", path), column(statistics, "front (m)", path)


def edges(path):
    """Middles and lengths of the edges of a snapshot."""
    mesh = read_vtu(path)
    corners = mesh.points[mesh.triangles]
    ends = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    return ends.mean(axis=1), np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)


def check_mesh(time, path):
    middle, length = edges(path)
    outside = np.maximum(np.array(BOX[:2]) - middle, middle - np.array(BOX[2:])).clip(min=0)
    distance = np.hypot(*outside.T)
    size = np.minimum(MESH_SIZE, FINE + GROWTH * distance)
    inside, far = distance == 0, size == MESH_SIZE
    medians = [np.median(length[part]) / h for part, h in ((inside, FINE), (far, MESH_SIZE))]
    ratios = np.percentile(length / size, [1, 50, 99])
    print("%.2f s: %d edges in the box, median %.2f of its mesh size; %d far from it, %.2f; all 1, 50, 99 %%: %.2f %.2f %.2f"
          % (time, inside.sum(), medians[0], far.sum(), medians[1], *ratios))
    assert inside.sum() > 200 and far.sum() > 200, "too few edges"
    assert all(0.85 < median < 1.15 for median in medians), "the mesh has another size"
    assert ratios[0] > 0.4 and ratios[2] < 1.8, "edges too short or too long"


with tempfile.TemporaryDirectory() as directory:
    path, time, front = run(directory, "refined")
    _, uniform_time, uniform_front = run(directory, "uniform", "--set", "Remeshing/Refined boxes=", "--set",
                                         "Mesh size=%g" % FINE)
    snapshots = read_pvd(path / "solution.pvd")
    assert len(snapshots) == 5, snapshots
    for snapshot in snapshots:
        check_mesh(*snapshot)
times = np.linspace(0.01, 0.2, 20)
difference = np.abs(np.interp(times, time, front) - np.interp(times, uniform_time, uniform_front)).max()
print("front at the end %.4f m, largest difference from that on the fine mesh %.4f m" % (front[-1], difference))
assert front[-1] > BOX[2] + 2 * MESH_SIZE, "the front has not left the box"
assert difference < MESH_SIZE, "the fronts differ"
