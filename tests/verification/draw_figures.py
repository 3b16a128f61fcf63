#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw the figures of doc/benchmarks/verification.md from the runs of the checks: draw_figures.py RUNS DIRECTORY"""

import pathlib
import sys

import numpy as np

from verification import deposit, fluid_fronts, read_reference, read_run

from figure_style import INK, WIDTH, plt, save, use_style
from lahar_output import OutputError, read_pvd, read_vtu


YIELD_NUMBER = 0.2
EXACT_FRONT = (9. / (8. * YIELD_NUMBER))**(1. / 3.)
FRONT_OF_NEXT_ORDER = 1.7117  # front_of_next_order() of arrested_dam_break.py


def draw_hydrostatic_column(runs):
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 3.), layout="constrained")
    names = ("newtonian_no_slip", "newtonian_slip", "bingham_no_slip", "bingham_slip")
    for name, marker in zip(names, "os^d"):
        statistics = read_run(runs / name)
        mesh = read_vtu(read_pvd(runs / name / "solution.pvd")[-1][1])
        label = name.replace("_", " ", 1).replace("newtonian", "Newtonian").replace("bingham", "Bingham").replace("_", "-")
        left.plot(mesh.at_points("pressure"), mesh.points[:, 1], marker, markersize=3, fillstyle="none", label=label)
        error = abs(statistics["b pressure (Pa)"] + 9810. * 0.15) / 1962.
        right.semilogy(1e3 * statistics["Time (s)"], np.maximum(error, 1e-17), marker + "-", markersize=3, label=label)
    left.plot([-1962., 0.], [0., 0.2], color=INK, linewidth=0.8, label="exact")
    left.set(xlabel="pressure (Pa), negative in compression", ylabel="$y$ (m)")
    left.legend()
    right.axhline(1e-8, color=INK, linewidth=0.8, linestyle=":")
    right.set(xlabel="$t$ (ms)", ylabel="error of $p(0.05\\,\\mathrm{m})$ over $\\rho g H$")
    return figure


def draw_viscous_sloshing(runs):
    figure, axes = plt.subplots(figsize=(WIDTH, 2.8), layout="constrained")
    statistics = read_run(runs / "viscous_sloshing")
    exact = read_reference("viscous_sloshing/viscous_sloshing_prosperetti.csv")
    shown = exact["t"] <= statistics["Time (s)"][-1]
    axes.plot(exact["t"][shown], exact["a"][shown], color=INK, linewidth=1., label="Prosperetti, left wall")
    axes.plot(exact["t"][shown], -exact["a"][shown], color=INK, linewidth=1., linestyle=":", label="right wall")
    axes.plot(statistics["Time (s)"], statistics["height (m)"] - 1., label="Lahar, highest point of the surface")
    axes.set(xlabel="$t$ (s)", ylabel="elevation (m)")
    axes.legend(loc="upper right")
    return figure


def draw_elliptic_drop(runs):
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(WIDTH, 3.), layout="constrained",
                                                 gridspec_kw={"width_ratios": [1.2, 1.2, 1.]})
    statistics = read_run(runs / "elliptic_drop")
    exact = read_reference("elliptic_drop/evolving_elliptic_drop.csv")
    shown = exact["t"] < 8e-3
    time = 1e3 * statistics["Time (s)"]
    left.plot(time, 0.5 * (statistics["top (m)"] - statistics["bottom (m)"]), label="$b$")
    left.plot(time, 0.5 * (statistics["right (m)"] - statistics["left (m)"]), label="$a$")
    for name in ("b_y", "a_x"):
        left.plot(1e3 * exact["t"][shown], exact[name][shown], "o", color=INK, markersize=4, fillstyle="none",
                  label="exact" if name == "b_y" else None)
    left.set(xlabel="$t$ (ms)", ylabel="semi-axis (m)")
    left.legend()
    energy = statistics["Kinetic energy (J)"]
    middle.plot(time, 100. * (energy / energy[0] - 1.), label="energy")
    middle.plot(time, 100. * statistics["Volume change by remeshing"], label="volume, remeshing")
    middle.plot(time, 100. * statistics["Volume change by solver"], label="volume, solver")
    middle.set(xlabel="$t$ (ms)", ylabel="change (%)")
    middle.legend()
    mesh = read_vtu(read_pvd(runs / "elliptic_drop" / "solution.pvd")[-1][1])
    right.triplot(*mesh.points.T, mesh.triangles, linewidth=0.3)
    angle = np.linspace(0., 2. * np.pi, 200)
    row = int(np.argmin(abs(exact["t"] - 7.6e-3)))
    right.plot(exact["a_x"][row] * np.cos(angle), exact["b_y"][row] * np.sin(angle), color="#D55E00", linewidth=1.)
    right.set(aspect="equal", title="7.6 ms, exact outline", xlabel="$x$ (m)", ylabel="$y$ (m)")
    return figure


def draw_column_collapse(runs):
    figure, axes = plt.subplots(figsize=(0.6 * WIDTH, 3.), layout="constrained")
    statistics = read_run(runs / "column_collapse")
    measured = read_reference("column_collapse/martin_moyce_1952_front.csv")
    time = statistics["Time (s)"] * np.sqrt(2. * 9.81 / 0.05715)
    for shift, style in ((0., ":"), (0.28, "-")):
        axes.plot(time + shift, statistics["front (m)"] / 0.05715, style, color="#0072B2", label=f"Lahar, shifted by {shift:g}")
    axes.plot(measured["T"], measured["Z"], "o", color=INK, markersize=4, fillstyle="none", label="Martin & Moyce")
    axes.set(xlabel="$T = t\\,(2 g/a)^{1/2}$", ylabel="$Z = x/a$", xlim=(0., 3.1), ylim=(0.9, 4.2))
    axes.legend()
    return figure


def draw_arrested_dam_break(runs):
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.8), layout="constrained",
                                         gridspec_kw={"width_ratios": [1., 1.6]})
    statistics = read_run(runs / "arrested_dam_break")
    left.plot(statistics["Time (s)"], statistics["front (m)"])
    left.axhline(EXACT_FRONT, color="#D55E00", linewidth=0.8)
    left.axhline(FRONT_OF_NEXT_ORDER, color="#009E73", linewidth=0.8, linestyle="--")
    left.set(xlabel="$t$ (s)", ylabel="front (m)")
    mesh = read_vtu(read_pvd(runs / "arrested_dam_break" / "solution.pvd")[-1][1])
    right.triplot(*mesh.points.T, mesh.triangles, linewidth=0.1)
    x = np.linspace(0., EXACT_FRONT, 300)
    right.plot(x, 0.1 * np.sqrt(2. * YIELD_NUMBER * (EXACT_FRONT - x)), color="#D55E00", label="lubrication theory")
    slope = YIELD_NUMBER * 0.1**2
    b = 0.5 * np.pi * slope
    x = np.linspace(0., FRONT_OF_NEXT_ORDER, 300)
    right.plot(x, b + np.sqrt(b**2 + 2. * slope * (FRONT_OF_NEXT_ORDER - x)), color="#009E73", linestyle="--",
               label="next order")
    right.set(xlabel="$x$ (m)", ylabel="$y$ (m), enlarged", title=f"$t$ = {statistics['Time (s)'][-1]:.3g} s")
    right.legend()
    return figure


def draw_free_motion(runs):
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 2.6), layout="constrained")
    statistics = read_run(runs / "free_fall")
    time = statistics["Time (s)"]
    left.plot(time, 1e6 * (0.2 - statistics["height (m)"] - 0.5 * 9.81 * time**2))
    left.set(xlabel="$t$ (s)", ylabel="error of the fall (µm)", title="free fall", ylim=(0., 40.))
    statistics = read_run(runs / "spinning_drop")
    time = statistics["Time (s)"]
    energy = statistics["Kinetic energy (J)"]
    right.plot(time, 1e4 * (energy / energy[0] - 1.), label="energy")
    right.plot(time, 1e4 * statistics["Volume change by solver"], label="volume")
    right.set(xlabel="$t$ (s)", ylabel="change ($10^{-4}$)", title="spinning drop, one turn")
    right.legend()
    return figure


def draw_granular_column(runs):
    figure = plt.figure(figsize=(WIDTH, 4.6), layout="constrained")
    rows = figure.add_gridspec(3, 2)
    statistics = read_reference("granular_column/contact_dynamics_fronts.csv")
    for row, instant in enumerate((1., 2., 6.)):
        axes = figure.add_subplot(rows[row, 0])
        unit = np.sqrt(0.324 / 9.81)
        mesh = read_vtu(min(read_pvd(runs / "granular_column_1.42" / "solution.pvd"),
                            key=lambda snapshot: abs(snapshot[0] - instant * unit))[1])
        x, y = mesh.points.T[:2] / 0.324
        axes.tripcolor(x, y, mesh.triangles, facecolors=mesh.at_cells("yielded"), cmap="Blues", vmin=-0.3, vmax=1.6,
                       edgecolors="white", linewidth=0.2)
        axes.set(aspect="equal", xlim=(0., 2.8), ylim=(0., 1.), ylabel="$y/H_0$",
                 title=f"$t$ = {instant:g} $(H_0/g)^{{1/2}}$, yielded dark")
    axes.set(xlabel="$x/H_0$")
    axes = figure.add_subplot(rows[:, 1])
    for ratio, height, colour in (("0.5", 0.149, "#0072B2"), ("1.42", 0.324, "#D55E00"), ("6.26", 0.67, "#009E73")):
        run = read_run(runs / f"granular_column_{ratio}")
        axes.plot(run["Time (s)"] / np.sqrt(height / 9.81), run["front (m)"] / height, color=colour, label=f"Lahar, $a$ = {ratio}")
        axes.plot(statistics["t"], statistics[f"{ratio} deep"], "o", color=colour, markersize=4)
        axes.plot(statistics["t"], statistics[f"{ratio} last"], "o", color=colour, markersize=4, fillstyle="none")
    axes.set(xlabel="$t (g/H_0)^{1/2}$", ylabel="front, $x/H_0$")
    axes.legend(fontsize="small")
    return figure


def draw_inflow(runs):
    """Meshes of a film and of a tank that fills; what has come into the tank (doc/inflow.md)."""
    figure = plt.figure(figsize=(WIDTH, 3.7), layout="constrained")
    rows = figure.add_gridspec(2, 2, height_ratios=[1., 1.9])
    for place, name, time, scale, label in ((rows[0, :], "film", 9., 3.35522 * 0.25, "$u/u_s$"),
                                            (rows[1, 0], "filling", 0.7, 1., "speed (m/s)")):
        axes = figure.add_subplot(place)
        mesh = read_vtu([file for instant, file in read_pvd(runs / name / "solution.pvd") if instant < time + 1e-6][-1])
        speed = np.linalg.norm(mesh.at_points("velocity"), axis=1) / scale
        colours = axes.tripcolor(mesh.points[:, 0], mesh.points[:, 1], mesh.triangles, speed, shading="gouraud", rasterized=True)
        axes.triplot(mesh.points[:, 0], mesh.points[:, 1], mesh.triangles, color="white", linewidth=0.25)
        figure.colorbar(colours, ax=axes, label=label, shrink=0.6)
        axes.set(xlabel="$x$ (m)", ylabel="$y$ (m)", aspect="equal")
    axes.plot([0., 0., 0.5, 0.5], [0.3, 0., 0., 0.3], color=INK, linewidth=0.8)
    right = figure.add_subplot(rows[1, 1])
    statistics = read_run(runs / "filling")
    right.plot(statistics["Time (s)"], statistics["Inflow volume (m^dim)"], label="inflow volume")
    right.plot(statistics["Time (s)"], statistics["Fluid volume (m^dim)"] - 0.075, "--", label="fluid volume less the first")
    right.plot([0., 0.3, 0.6, 1., 1.2, 1.5], [0., 0.06, 0.06, 0.02, 0., 0.], color=INK, linewidth=0.8, label="$Q$ (m²/s)")
    right.set(xlabel="$t$ (s)", ylabel="volume (m²)", ylim=(-0.003, 0.088))
    right.legend(loc="upper right")
    return figure


def draw_thixotropy(runs):
    """The structure of a block that slumps (doc/fluid-laws.md)."""
    figure, axes = plt.subplots(1, 3, figsize=(WIDTH, 2.), layout="constrained", sharey=True)
    for place, (time, path) in zip(axes, read_pvd(runs / "slump" / "solution.pvd")):
        mesh = read_vtu(path)
        colours = place.tripcolor(mesh.points[:, 0], mesh.points[:, 1], mesh.triangles, facecolors=mesh.at_cells("structure"),
                                  cmap="viridis", vmin=0., vmax=1., rasterized=True)
        place.set(xlabel="$x$ (m)", aspect="equal", title=f"$t$ = {time:g} s", xlim=(0., 0.26), ylim=(0., 0.105))
    axes[0].set(ylabel="$y$ (m)")
    figure.colorbar(colours, ax=axes, label="λ", shrink=0.8)
    return figure


def draw_lock_exchange(runs):
    """The two fluids, and their fronts (doc/several-fluids.md)."""
    figure = plt.figure(figsize=(WIDTH, 4.2), layout="constrained")
    rows = figure.add_gridspec(4, 1, height_ratios=[1., 1., 1., 2.])
    snapshots = read_pvd(runs / "lock_exchange" / "solution.pvd")
    for row, wanted in enumerate((2., 4., 6.)):
        axes = figure.add_subplot(rows[row])
        mesh = read_vtu([path for time, path in snapshots if time < wanted + 1e-6][-1])
        axes.tripcolor(mesh.points[:, 0], mesh.points[:, 1], mesh.triangles, facecolors=1. - mesh.at_cells("fluid"), cmap="Blues",
                       vmin=-0.3, vmax=1.4, rasterized=True)
        axes.triplot(mesh.points[:, 0], mesh.points[:, 1], mesh.triangles, color="white", linewidth=0.15)
        axes.set(ylabel="$y$ (m)", aspect="equal", xlim=(0., 8.), ylim=(0., 1.), title=f"$t$ = {wanted:g} s")
    axes.set(xlabel="$x$ (m)")
    time, fronts = fluid_fronts(runs / "lock_exchange")
    axes = figure.add_subplot(rows[3])
    axes.plot(time, fronts[:, 0, 1] - 4., "o", markersize=3.5, fillstyle="none", label="heavy, at the bottom")
    axes.plot(time, 4. - fronts[:, 1, 0], "s", markersize=3.5, fillstyle="none", label="light, at the top")
    start = int(np.argmin(abs(time - 2.)))
    axes.plot(time[start:], fronts[start, 0, 1] - 4. + 0.5 * (time[start:] - time[start]), color=INK, linewidth=0.8,
              label="0.5 m/s from 2 s on")
    axes.set(xlabel="$t$ (s)", ylabel="way of the front (m)")
    axes.legend()
    return figure


def draw_submerged_column(runs):
    """Grains that collapse under water, and how far the deposit comes in water and in air (doc/fluid-laws.md)."""
    figure = plt.figure(figsize=(WIDTH, 3.2), layout="constrained")
    columns = figure.add_gridspec(1, 2, width_ratios=[1.3, 1.])
    rows = columns[0].subgridspec(3, 1)
    unit = 0.074
    snapshots = read_pvd(runs / "column_in_water" / "solution.pvd")
    for row, wanted in enumerate((1., 3., 8.)):
        axes = figure.add_subplot(rows[row])
        time = wanted * np.sqrt(unit / 9.81)
        mesh = read_vtu([path for t, path in snapshots if t < 1.001 * time][-1])
        axes.tripcolor(mesh.points[:, 0] / unit, mesh.points[:, 1] / unit, mesh.triangles, facecolors=1. - mesh.at_cells("fluid"),
                       cmap="Blues", vmin=-0.3, vmax=1.4, rasterized=True)
        axes.set(ylabel="$y/H_0$", aspect="equal", xlim=(0., 6.), ylim=(0., 2.2))
        axes.text(0.97, 0.9, f"$t\\,(g/H_0)^{{1/2}}$ = {wanted:g}", transform=axes.transAxes, ha="right", va="top")
    axes.set(xlabel="$x/H_0$")
    axes = figure.add_subplot(columns[1])
    for name, fluid, label in (("column_in_air", None, "in air"), ("column_in_water", 0., "in water")):
        time, way, *rest = deposit(runs / name, unit, fluid)
        axes.plot(time / np.sqrt(unit / 9.81), way, "o-", markersize=3.5, label=label)
    axes.set(xlabel="$t\\,(g/H_0)^{1/2}$", ylabel="run-out/$H_0$, deeper than 0.1 $H_0$", ylim=(0., None))
    axes.legend()
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    use_style()
    for name, draw in list(globals().items()):
        if name.startswith("draw_"):
            runs = pathlib.Path(sys.argv[1])
            case = name[len("draw_"):]
            runs = runs / case if (runs / case).is_dir() and not (runs / case / "statistics").exists() else runs
            try:
                save(draw(runs), pathlib.Path(sys.argv[2]) / f"verification_{case}.png")
            except (OutputError, OSError, IndexError) as error:
                print(f"{case}: no figure: {error}", file=sys.stderr)


main()
