#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid that comes in and goes out: the volume of a jet in free space, of a tank that fills by a hydrograph and of a jet in
space is what has come in; flow between two walls and a film on a slope keep their profiles, and as much goes out as comes
in, also against a level; a run that is resumed goes on bit for bit, and two ranks compute what one does."""

import numpy as np

from verification import Check, at_time, last_mesh, read_pvd, read_run, read_vtu, run_check, volume_changes


def came_in(statistics):
    return statistics["Inflow volume (m^dim)"]


def check_volume(check, name, statistics, expected):
    """What has come in, to the digits of the statistics, and the volume of the fluid, to the solver's and remeshing's own account."""
    check.below(f"{name}: inflow volume", np.abs(came_in(statistics) - expected).max() / expected.max(), 1e-9)
    volume = statistics["Fluid volume (m^dim)"]
    out = statistics.get("Outflow volume (m^dim)", 0. * volume)
    start = volume[0] - came_in(statistics)[0] + out[0]
    changes = (statistics["Volume change by solver"] + statistics["Volume change by remeshing"]) * (
        start + came_in(statistics))
    check.below(f"{name}: fluid volume against what came in and went out and the account of its errors",
                np.abs(volume - start - came_in(statistics) + out - changes + changes[0]).max() / volume.max(), 1e-8)


def check_plug(check):
    """Without gravity a jet is a rigid body, and long as U t."""
    directory = check.run("inflow/plug.prm")
    statistics = read_run(directory)
    check_volume(check, "plug", statistics, 0.2 * statistics["Time (s)"])
    check.below("plug: volume over Q t", np.abs(statistics["Fluid volume (m^dim)"] / (0.02 + 0.2 * statistics["Time (s)"])
                                                - 1.).max(), 1e-9)
    mesh = last_mesh(directory)
    check.below("plug: velocity", np.abs(mesh.point_data["velocity"][:, :2] - [1., 0.]).max(), 1e-7)
    check.near("plug: its tip", mesh.points[:, 0].max(), 0.6, 1e-7)
    # The momentum that comes in needs no force.
    momentum = statistics["Momentum x (N s)"] - statistics["Momentum inflow x (N s)"]
    check.below("plug: momentum less what came in", np.abs(momentum - 20.).max() / 20., 1e-7)


def parabola_error(directory):
    """Largest error of the velocity in the middle of the channel, over the largest velocity."""
    mesh = last_mesh(directory)
    x, y = mesh.points[:, 0], mesh.points[:, 1]
    middle = (x > 0.1) & (x < 0.3)
    error = mesh.point_data["velocity"][middle, :2] - np.stack([30. * y * (0.2 - y), 0. * y], axis=1)[middle]
    return float(np.sqrt((error**2).sum(axis=1).mean())) / 0.3


def check_channel(check):
    """u = 6 U y (H − y)/H²."""
    errors = []
    for h in (0.04, 0.02):
        directory = check.run("inflow/channel.prm", f"Mesh size={h}", f"Time step={0.5 * h}")
        statistics = read_run(directory)
        check_volume(check, f"channel, h = {h}", statistics, 0.04 * statistics["Time (s)"])
        errors.append(parabola_error(directory))
    check.below("channel: velocity, h = 0.02 m, over the largest", errors[1], 0.02)
    check.below("channel: the same over that with twice the mesh size", errors[1] / errors[0], 0.5)


def check_filling(check):
    """The level of a tank: what was in it and what came in, over its width."""
    directory = check.run("inflow/filling.prm")
    statistics = read_run(directory)
    time = statistics["Time (s)"]
    table = np.array([[0., 0.], [0.3, 0.06], [0.6, 0.06], [1., 0.02], [1.2, 0.], [9., 0.]])
    fine = np.union1d(np.append(time, 0.), table[:-1, 0])
    rate = np.interp(fine, table[:, 0], table[:, 1])
    volume = np.concatenate([[0.], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * np.diff(fine))])
    check_volume(check, "filling", statistics, np.interp(time, fine, volume))
    check.near("filling: all that the hydrograph brings", came_in(statistics)[-1], 0.045, 1e-9)
    solver, remeshing = volume_changes(statistics)
    check.below("filling: volume change by the solver", solver, 1e-7)
    check.below("filling: volume change by remeshing", remeshing, 2e-3)
    mesh = last_mesh(directory)
    surface = [mesh.points[np.abs(mesh.points[:, 0] - x) < 0.02, 1].max() for x in (0.1, 0.2, 0.3, 0.4)]
    check.near("filling: level", float(np.mean(surface)), (0.075 + 0.045) / 0.5, 0.01)


def check_film(check):
    """u = ρ g_x y (2 H − y)/(2 μ), thickness H."""
    directory = check.run("inflow/film.prm")
    statistics = read_run(directory)
    check_volume(check, "film", statistics, 3.35522 * 1000. * 0.05**3 / 15. * statistics["Time (s)"])
    out = statistics["Outflow volume (m^dim)"]
    late = at_time(statistics, "Outflow volume (m^dim)", 2.) - at_time(statistics, "Outflow volume (m^dim)", 1.)
    check.near("film: what goes out in a second", late, 3.35522 * 1000. * 0.05**3 / 15., 0.02)
    check.below("film: what goes out, over what is there and comes in", out[-1] / (0.025 + came_in(statistics)[-1]), 1.)
    mesh = last_mesh(directory)
    x, y = mesh.points[:, 0], mesh.points[:, 1]
    thickness = [y[np.abs(x - place) < 0.011].max() for place in (0.1, 0.15, 0.2)]
    check.near("film: thickness", float(np.mean(thickness)), 0.05, 0.01)
    middle = (x > 0.05) & (x < 0.25)
    exact = 3.35522 * 1000. / 5. * y * (0.1 - y) / 2.
    error = mesh.point_data["velocity"][middle, 0] - exact[middle]
    check.below("film: velocity, over that of the surface", float(np.sqrt((error**2).mean())) / (3.35522 * 0.25), 0.02)


def depths(mesh, places):
    """Height of the surface at each place x (m)."""
    x, y = mesh.points[:, 0], mesh.points[:, 1]
    return np.array([y[np.abs(x - place) < 0.02].max() for place in places])


def check_level(check):
    """A uniform channel flow against its own level stays as it is; a level that rises sends a wave up the channel; a film that
    leaves against its own depth is hardly drawn down."""
    directory = check.run("inflow/level.prm", "End time=1")
    statistics = read_run(directory)
    check_volume(check, "level", statistics, 0.1 * statistics["Time (s)"])
    check.below("level: depth along the channel, over that given", np.abs(depths(last_mesh(directory), np.arange(0.05, 1., 0.1)) / 0.2
                                                                      - 1.).max(), 1e-3)
    check.near("level: what goes out, over what comes in", statistics["Outflow volume (m^dim)"][-1] / 0.1, 1., 0.03)
    check.near("level: force on what stands behind, over rho g H²/2", statistics["downstream force x (N)"][-1] / 196.2, 1., 1e-3)

    # Nothing is lost of the force where particles of the inflow are renewed.
    check.below("level: force on the inflow, over rho g H²/2", np.abs(statistics["upstream force x (N)"] / -196.2 - 1.).max(), 1e-6)

    table = (check.output / "level.csv").resolve()
    table.write_text("# t (s), level (m)\n0, 0.2\n1, 0.22\n")
    directory = check.run("inflow/level.prm", "Boundaries/downstream/outflow/Level=",
                          f"Boundaries/downstream/outflow/Level table={table}", "End time=0.75")
    statistics = read_run(directory)
    check_volume(check, "rising level", statistics, 0.1 * statistics["Time (s)"])
    # The wave goes up the channel with sqrt(g H) − U = 0.9 m/s.
    near, far = depths(last_mesh(directory), (0.95, 0.15))
    check.near("rising level: depth at the outlet (m)", near, 0.2 + 0.02 * (0.75 - 0.05 / 0.9), 0.01)
    check.near("rising level: depth where the wave has not come yet (m)", far, 0.2, 0.01)

    directory = check.run("inflow/film.prm", "Boundaries/downstream/outflow/Level=0.05", "End time=0.75")
    x, y = (last_mesh(directory).points[:, d] for d in (0, 1))
    thickness = np.array([y[np.abs(x - place) < 0.011].max() for place in np.arange(0.05, 0.41, 0.05)])
    check.below("film against its depth: thickness along the slope, over that of the film", np.abs(thickness / 0.05 - 1.).max(), 0.01)


def check_resumed_level(check):
    """A run against a rising level in two parts, with steps of 1/256 s, which add up to the end of the first part exactly."""
    short = ["Boundaries/downstream/outflow/Level=0.2 + 0.02 * t", "Checkpoint/Steps between=10", "Mesh size=0.04",
             "Time step=0.00390625"]
    whole = read_run(check.run("inflow/level.prm", *short, "End time=0.3125"))
    check.run("inflow/level.prm", *short, "End time=0.15625")
    resumed = read_run(check.run("inflow/level.prm", *short, "End time=0.3125", resume=True))
    for name in ("Fluid volume (m^dim)", "Outflow volume (m^dim)", "Kinetic energy (J)", "downstream force x (N)"):
        check.below(f"resumed against a level: '{name}'", np.abs(whole[name] - resumed[name]).max(), 0.)


def check_space(check):
    """A jet in space, and what comes in through a part of a wall."""
    statistics = read_run(check.run("inflow/jet_3d.prm", "Nonlinear solver/Tolerance=1e-8"))
    check_volume(check, "jet in space", statistics, 0.04 * statistics["Time (s)"])
    check.below("jet in space: volume over Q t",
                np.abs(statistics["Fluid volume (m^dim)"] / (0.004 + 0.04 * statistics["Time (s)"]) - 1.).max(), 1e-7)
    statistics = read_run(check.run("inflow/tank_3d.prm"))
    time = statistics["Time (s)"]
    expected = 0.006 * np.where(time < 0.1, 0.5 * time**2 / 0.1, time - 0.05)
    check_volume(check, "tank in space", statistics, expected)
    # What one step owes the next one gives back.
    error = np.abs(statistics["Fluid volume (m^dim)"] / (0.0048 + expected) - 1.)
    check.below("tank in space: fluid volume against what was there and came in, mean", error.mean(), 1e-3)
    check.below("tank in space: the same, largest", error.max(), 5e-3)
    check.below("tank in space: the same at the end", error[-1], 5e-3)
    check.below("tank in space: repeated steps", statistics["Rejected steps"][-1], 0.5)


def check_flume(check):
    """Flat cells at the inlet's upper edge, between its particles and fluid that is faster, stop nothing."""
    statistics = read_run(check.run("inflow/flume_3d.prm"))
    check_volume(check, "flume", statistics, 0.03 * statistics["Time (s)"])
    error = np.abs(statistics["Fluid volume (m^dim)"] / (0.003 + 0.03 * statistics["Time (s)"]) - 1.)
    check.below("flume: fluid volume against what was there and came in, largest", error.max(), 1e-3)
    check.below("flume: repeated steps", statistics["Rejected steps"][-1], 0.5)


def check_resumed(check):
    """The hydrograph's run in two parts, the second one from a checkpoint while fluid comes in."""
    short = ["End time=0.5", "Checkpoint/Steps between=10"]
    whole = read_run(check.run("inflow/filling.prm", *short))
    check.run("inflow/filling.prm", *short[1:], "End time=0.35")
    resumed = read_run(check.run("inflow/filling.prm", *short, resume=True))
    # On several ranks MUMPS does not sum in the same order twice.
    tolerance = 0. if check.n_ranks == 1 else 1e-8
    for name in ("Fluid volume (m^dim)", "Inflow volume (m^dim)", "Kinetic energy (J)", "inlet force x (N)"):
        check.below(f"resumed: '{name}'", np.abs(whole[name] - resumed[name]).max() / np.abs(whole[name]).max(), tolerance)


def check_ranks(check):
    """Two ranks and one, film and tanks, with tight tolerances and the direct solver: a held vertex keeps a velocity that is
    not converged, on which iterative solvers agree to their tolerance only."""
    tight = ["Nonlinear solver/Tolerance=1e-9", "Linear solver/Type=direct", "End time=0.3"]
    rising = ["Boundaries/downstream/outflow/Level=0.2 + 0.02 * t", "Mesh size=0.04", "Time step=0.00390625", "End time=0.125"]
    for name, columns, settings in (("film", ["Outflow volume (m^dim)"], []), ("filling", [], []), ("tank_3d", [], []),
                                    ("level", ["Outflow volume (m^dim)", "downstream force x (N)"], rising)):
        runs = []
        for check.n_ranks in (1, 2):
            runs.append(read_run(check.run(f"inflow/{name}.prm", *tight, *settings)))
        for column in ["Fluid volume (m^dim)", "Inflow volume (m^dim)", "Kinetic energy (J)", *columns]:
            check.below(f"two ranks, {name}: '{column}'",
                        np.abs(runs[0][column] - runs[1][column]).max() / np.abs(runs[0][column]).max(), 1e-8)


def main():
    check = Check(__doc__)
    if check.n_ranks > 1:
        check_ranks(check)
    else:
        check_plug(check)
        check_channel(check)
        check_filling(check)
        check_film(check)
        check_level(check)
        check_resumed_level(check)
        check_space(check)
        check_flume(check)
        check_resumed(check)
    check.finish()


run_check(main)
