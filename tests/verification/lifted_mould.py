#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slump cones whose mould is lifted: later they spread as far as without a mould, and keep their volume; a mould without slip
takes a film along, and what it leaves spreads as that volume does. A run that is resumed while the mould moves goes on bit for
bit, and two ranks compute what one does.

    lifted_mould.py --lahar PROGRAM --output DIRECTORY [--cases NAME ...]
"""

import sys

import numpy as np

from verification import ROOT, Check, at_time, read_pvd, read_run, read_vtu, run_check, volume_changes

SLUMP = ROOT / "prm" / "slump"
names = ["coarse", "table"]
if "--cases" in sys.argv:
    at = sys.argv.index("--cases")
    names = sys.argv[at + 1:]
    del sys.argv[at:]


def spread(statistics, time):
    """The diameter, in space the mean of four directions; the front flickers by a part of the mesh size: the mean of some time
    before."""
    before = np.linspace(0.97 * time, time, 20)
    in_space = [f"spread{direction} (m)" for direction in ("", " 45", " 90", " 135")]
    columns = in_space if in_space[0] in statistics else ["front (m)"]
    factor = 1. if columns is in_space else 2.
    return factor * float(np.mean([at_time(statistics, name, instant) for name in columns for instant in before]))


def speed_on_floor(directory, dim):
    """The largest speed of a particle on the floor in any snapshot."""
    largest = 0.
    for _, path in read_pvd(directory / "solution.pvd"):
        mesh = read_vtu(path, dim)
        on_floor = np.abs(mesh.points[:, dim - 1]) < 1e-9
        largest = max(largest, np.linalg.norm(mesh.at_points("velocity")[on_floor], axis=1).max())
    return largest


def check_cone(check, name, prm, instant_prm, end, *settings, motion=(), slower=True, tolerance=0.02):
    """A mould that lets the fluid slip, against the instantaneous release."""
    settings = [*settings, f"End time={end}"]
    instant = read_run(check.run(SLUMP / instant_prm, *settings))
    directory = check.run(SLUMP / prm, *settings, *motion)
    lifted = read_run(directory)
    # What the mould has pushed along the floor sticks to it once the mould is gone.
    check.below(f"{name}: speed on the floor (m/s)", speed_on_floor(directory, 3 if "3d" in prm else 2), 0.)
    check.near(f"{name}: spread at {end} s (m)", spread(lifted, end), spread(instant, end), tolerance)
    if slower:
        early = 0.04 * end
        check.below(f"{name}: spread at {early:g} s, over that without a mould", spread(lifted, early) / spread(instant, early), 0.9)
    check.below(f"{name}: volume change by the solver", volume_changes(lifted)[0], 1e-5)
    check.below(f"{name}: volume change by remeshing", volume_changes(lifted)[1], 5e-3)
    check.below(f"{name}: volume at the end", abs(lifted["Fluid volume (m^dim)"][-1] / lifted["Fluid volume (m^dim)"][0] - 1.), 1e-5)
    check.below(f"{name}: repeated steps", lifted["Rejected steps"][-1], 0.01 * len(lifted["Time (s)"]))


def check_film(check):
    """At rest the spread goes with the volume as V^(2/5), see thin_layer.py."""
    settings = ["End time=5"]
    instant = read_run(check.run(SLUMP / "mini_cone_rz.prm", *settings))
    film = read_run(check.run(SLUMP / "mini_cone_lifted.prm", *settings, "Boundaries/mould/Law=no slip",
                              "Remeshing/Domain=-0.01, -0.01 : 0.2, 0.1"))
    left = film["Fluid volume (m^dim)"][-1] / film["Fluid volume (m^dim)"][0]
    check.below("no slip: what the mould leaves, over all", left, 0.95)
    check.near("no slip: spread at 5 s (m)", spread(film, 5.), left**0.4 * spread(instant, 5.), 0.02)
    check.near("no slip: what has left the domain and what is there, over all", left + film["Volume left the domain"][-1], 1., 2e-3)


def check_table(check):
    """The same motion by a table, whole and in two parts, and by a function."""
    table = (check.output / "lift.csv").resolve()
    table.parent.mkdir(parents=True, exist_ok=True)
    table.write_text("# t (s), x (m), y (m)\n0, 0, 0\n2, 0, 0.2\n")
    short = ["Mesh size=0.005", "Checkpoint/Steps between=10"]
    motion = ["Boundaries/mould/Motion=table", f"Boundaries/mould/table/File={table}"]
    whole = read_run(check.run(SLUMP / "mini_cone_lifted.prm", *short, *motion, "End time=0.3"))
    check.run(SLUMP / "mini_cone_lifted.prm", *short, *motion, "End time=0.18")
    resumed = read_run(check.run(SLUMP / "mini_cone_lifted.prm", *short, *motion, "End time=0.3", resume=True))
    for name in ("Fluid volume (m^dim)", "Kinetic energy (J)", "front (m)", "mould force y (N)"):
        check.below(f"resumed: '{name}'", np.abs(whole[name] - resumed[name]).max(), 0.)
    formula = read_run(check.run(SLUMP / "mini_cone_lifted.prm", *short, "End time=0.3"))
    check.near("table: front against that by a function (m)", whole["front (m)"][-1], formula["front (m)"][-1], 1e-3)


def check_ranks(check):
    tight = ["Mesh size=0.005", "End time=0.08", "Nonlinear solver/Tolerance=1e-9", "Nonlinear solver/Maximum iterations=60",
             "Linear solver/Type=direct"]
    runs = []
    for check.n_ranks in (1, 2):
        runs.append(read_run(check.run(SLUMP / "mini_cone_lifted.prm", *tight)))
    for name in ("Fluid volume (m^dim)", "Kinetic energy (J)", "front (m)", "mould force y (N)"):
        check.below(f"two ranks: '{name}'", np.abs(runs[0][name] - runs[1][name]).max() / np.abs(runs[0][name]).max(), 1e-6)


def main():
    check = Check(__doc__)
    if check.n_ranks > 1:
        check_ranks(check)
        check.finish()
        return
    if "coarse" in names:
        check_cone(check, "coarse", "mini_cone_lifted.prm", "mini_cone_rz.prm", 2., "Mesh size=0.005")
    if "table" in names:
        check_table(check)
    slow = ["Boundaries/mould/translation/Displacement=0; 0.02 * t"]
    if "full" in names:
        check_cone(check, "mini cone, 0.1 m/s", "mini_cone_lifted.prm", "mini_cone_rz.prm", 5.)
        check_cone(check, "mini cone, 0.02 m/s", "mini_cone_lifted.prm", "mini_cone_rz.prm", 5., motion=slow, slower=False)
        check_cone(check, "Abrams cone, 0.1 m/s", "abrams_lifted.prm", "abrams_rz.prm", 40., "Mesh size=0.006", slower=False)
    if "film" in names:
        check_film(check)
    if "space" in names:
        check_cone(check, "in space", "mini_cone_lifted_3d.prm", "mini_cone.prm", 3., "Mesh size=0.006")
    check.finish()


run_check(main)
