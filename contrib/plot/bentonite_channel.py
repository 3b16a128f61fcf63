# SPDX-License-Identifier: GPL-3.0-or-later
"""Bentonite in a channel on a slope, without and with a falling block (Franci & Zhang 2018, Sections 5.3 and 5.4)."""

import numpy as np
from benchmark_table import divide, state_if_unfinished, worst_changes, write_table
from bentonite_slope import CASES, GRAVITY, TIME
from figure_style import WIDTH, finish_axes, plt, save, use_style
from render_runs import draw_sections, draw_views

CASE = "bentonite_channel"
HEIGHT = CASES["a"][1]
TAU0 = 93.05
INSTANTS = (1, 2, 3, 4, 5, 6, 8, 10)  # t sqrt(g/H0)
COARSE = (0.0168, 0.0126, 0.009)
FINE = 0.00725  # the paper's number of tetrahedra


def geometry(left, right, plane_of_symmetry):
    """A channel from y = @p left to @p right; walls at its sides do not slip, but those in @p plane_of_symmetry do."""
    bed = f"-0.3024, {left}, 0 : 0.8, {left}, 0 : 0.8, {right}, 0 : -0.3024, {right}, 0"
    upstream = f"-0.3024, {left}, 0 : -0.3024, {right}, 0 : -0.3024, {right}, 0.12 : -0.3024, {left}, 0.12"
    sides = {y: f"-0.3024, {y}, 0 : 0.8, {y}, 0 : 0.8, {y}, 0.12 : -0.3024, {y}, 0.12" for y in (left, right)}
    rough = "; ".join([bed, upstream] + [side for y, side in sides.items() if y not in plane_of_symmetry])
    smooth = "; ".join(side for y, side in sides.items() if y in plane_of_symmetry)
    return (f"Fluids/fluid/box/Corners=-0.3024, {left}, 0 : 0, {right}, 0.0756", "Boundaries=walls, slip walls",
            f"Boundaries/walls/polygon/Corners={rough}", "Boundaries/slip walls/Shape=polygon",
            f"Boundaries/slip walls/polygon/Corners={smooth}", "Boundaries/slip walls/Law=free slip")


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""

    def make(label, file, h, end, more=()):
        return make_run(CASE, f"{label}-h{h:g}", f"prm/bentonite_slope/{file}.prm",
                        (f"Mesh size={h:g}", "Time step=2e-3", f"End time={end:g}", *more), label, TAU0, h)

    half = geometry(-0.17, 0, (0,))
    return ([make("plane", "case_a_2d", h, 1) for h in (*COARSE, FINE)]
            + [make("slab", "case_a_3d", 0.0126, 1, geometry(0, 0.05, (0, 0.05)))]
            + [make("channel", "case_a_3d", h, 1, half) for h in COARSE] + [make("channel", "case_a_3d", FINE, 0.53, half)]
            + [make("block", "falling_block", FINE, 0.53)])


def scaled(results):
    """Dimensionless time t sqrt(g/H0) and front X/H0; in a channel that of the centre line."""
    name = "centre front (m)" if results.run.label in ("channel", "block") else "front (m)"
    return results.column(TIME) * np.sqrt(GRAVITY / HEIGHT), results.column(name) / HEIGHT


def table_row(results):
    times, front = scaled(results)
    iterations, cells = results.column("Nonlinear iterations"), results.column("Fluid cells")
    wall_time, memory = results.column("Wall time (s)")[-1], results.record.get("peak memory (MiB)")
    return [results.run.label + state_if_unfinished(results), f"{1e3 * results.run.h:g}", f"{cells[0]:.0f}",
            *(f"{np.interp(t, times, front):.3f}" if t <= times[-1] + 1e-2 else "–" for t in INSTANTS),
            f"{np.median(iterations):.0f} / {iterations.max():.0f}",
            f"{results.column('Linear iterations').sum() / iterations.sum():.1f}",
            f"{results.column('Rejected steps')[-1]:.0f}", *worst_changes(results), f"{wall_time:.0f}",
            f"{1e6 * wall_time / (cells * iterations).sum():.1f}", f"{memory:.0f}" if memory else "–"]


def write_results(usable, missing, path):
    header = ["flow", "h (mm)", "fluid cells at the start", f"front X/H0 at t* = {INSTANTS[0]}", *map(str, INSTANTS[1:]),
              "iterations, median / largest", "linear iterations per solve", "rejected steps", "volume by solver, worst",
              "volume by remeshing, worst", "wall time (s)", "µs per cell and iteration", "peak memory (MiB)"]
    write_table(header, map(table_row, usable), "Case A, block-shaped reservoir, τ0 = 93.05 Pa, time step 2 ms, t* = t sqrt(g/H0). "
                "Slab: in space, 0.05 m wide, with slip at its sides. Channel: half of it, front on the centre line. Block: the "
                "whole channel with the falling block. Volume: cumulative, relative to the initial volume. One thread a run.",
                usable, missing, path)


def draw_fronts(usable, path):
    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.5 * WIDTH))
    colors = {"plane": "0.4", "slab": "#009E73", "channel": "#0072B2", "block": "#D55E00"}
    sizes = sorted({results.run.h for results in usable}, reverse=True)
    for results in usable:
        axes.plot(*scaled(results), color=colors[results.run.label],
                  linewidth=0.6 + 1.2 * (sizes.index(results.run.h) + 1) / len(sizes),
                  linestyle=((0, (1, 1.5)), (0, (4, 1.5)), (0, (7, 1.5)), "-")[min(sizes.index(results.run.h), 3)],
                  label=f"{results.run.label}, h = {1e3 * results.run.h:g} mm")
    finish_axes(axes, xlabel="$t\\,\\sqrt{g/H_0}$", ylabel="front $X/H_0$")
    save(figure, path)
    plt.close(figure)


def report(all_results, doc):
    usable, missing = divide(all_results, CASE)
    if not usable:
        return
    write_results(usable, missing, doc / "benchmarks" / f"{CASE}_table.md")
    use_style()
    figures = doc / "figures"
    draw_fronts(usable, figures / f"{CASE}_front.png")
    by_name = {results.run.name: results for results in usable}
    for h in (0.009, 0.0126, 0.0168):
        channel, plane = by_name.get(f"channel-h{h:g}"), by_name.get(f"plane-h{h:g}")
        if channel and plane:
            draw_sections(channel, "y=-0.0005", (0.2, 0.4, 0.8), figures / "bentonite_slope_3d_section.png", "--over", str(plane.directory))
            draw_sections(channel, "z=0.02", (0.2, 0.4, 0.8), figures / "bentonite_slope_3d_from_above.png")
            break
    if f"block-h{FINE:g}" in by_name:
        draw_views(by_name[f"block-h{FINE:g}"], (0.1, 0.18, 0.3, 0.53), figures / "falling_block_views.png", "--columns", "2")
