# SPDX-License-Identifier: GPL-3.0-or-later
"""The dam break against an elastic barrier in a channel (Franci & Zhang 2018, Section 5.1) beside the flow in the plane."""

import numpy as np
from benchmark_table import divide, state_if_unfinished, worst_changes, write_table
from dam_break_elastic import TIME, TIP, passing_time, peak, plot_tip, tip_axes
from figure_style import WIDTH, plt, save, use_style
from render_runs import draw_views

CASE = "dam_break_channel"
FILES = {"plane": "prm/dam_break_barrier/elastic_2d.prm", "channel": "prm/dam_break_barrier/elastic_3d.prm"}
MESH_SIZE = 0.008
COLORS = {25: "#009E73", 50: "#E69F00", 100: "#D55E00"}


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""
    return [make_run(CASE, f"{flow}-tau{tau0}-h{MESH_SIZE:g}", file,
                     (f"Fluids/fluid/Bingham/Yield stress={tau0}", f"Mesh size={MESH_SIZE:g}", "Output interval=0.025"), flow, tau0,
                     MESH_SIZE)
            for tau0 in COLORS for flow, file in FILES.items()]


def table_row(results):
    run, record, times = results.run, results.record, results.column(TIME)
    iterations, cells = results.column("Nonlinear iterations"), results.column("Fluid cells")
    wall_time, memory = results.column("Wall time (s)")[-1], record.get("peak memory (MiB)")
    largest, when = peak(results)
    tip = [f"{1e3 * np.interp(t, times, results.column(TIP)):.1f}" if t <= times[-1] + 1e-9 else "–" for t in (0.3, 0.4, 0.5)]
    return [f"{run.tau0}", run.label + state_if_unfinished(results), f"{cells[0]:.0f}", f"{passing_time(results):.3f}",
            f"{1e3 * largest:.1f}", f"{when:.3f}", *tip, f"{np.median(iterations):.0f} / {iterations.max():.0f}",
            f"{results.column('Linear iterations').sum() / iterations.sum():.1f}",
            f"{results.column('Rejected steps')[-1]:.0f}", *worst_changes(results), f"{wall_time:.0f}",
            f"{1e6 * wall_time / (cells * iterations).sum():.1f}", f"{memory:.0f}" if memory else "–"]


def write_results(usable, missing, path):
    header = ["τ0 (Pa)", "flow", "fluid cells at the start", "passes 1 mm at (s)", "largest displacement (mm)", "at (s)",
              "at 0.3 s (mm)", "0.4", "0.5", "iterations, median / largest", "linear iterations per solve", "rejected steps",
              "volume by solver, worst", "volume by remeshing, worst", "wall time (s)", "µs per cell and iteration",
              "peak memory (MiB)"]
    write_table(header, map(table_row, usable), f"h = {1e3 * MESH_SIZE:g} mm, time step 1 ms, quadratic solid; direct solver in "
                "the plane, iterative one in the channel. Volume: cumulative, relative to the initial volume. One thread a run.",
                usable, missing, path)


def draw_tips(usable, path):
    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.5 * WIDTH))
    for results in usable:
        dash = "-" if results.run.label == "channel" else (0, (4, 1.5))
        plot_tip(axes, results, color=COLORS[results.run.tau0], linestyle=dash,
                 label=f"$\\tau_0$ = {results.run.tau0} Pa, {results.run.label}")
    tip_axes(axes)
    save(figure, path)
    plt.close(figure)


def report(all_results, doc):
    usable, missing = divide(all_results, CASE)
    if not usable:
        return
    write_results(usable, missing, doc / "benchmarks" / f"{CASE}_table.md")
    use_style()
    draw_tips(usable, doc / "figures" / f"{CASE}_tip.png")
    for results in usable:
        if results.run.label == "channel" and results.run.tau0 == 100:
            draw_views(results, (0.1, 0.2, 0.275, 0.35), doc / "figures" / f"{CASE}_views.png", "--columns", "2", "--cut", "y=0.04",
                       "--fastest", "1.8")
