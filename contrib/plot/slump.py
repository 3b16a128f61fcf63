# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmarks of slumping cones in space (Franci & Zhang 2018, Section 5.2): their runs, table, figures."""

import numpy as np
from benchmark_table import divide, state_if_unfinished, worst_changes, write_table
from figure_style import WIDTH, finish_axes, plt, save, use_style
from lahar_output import read_pvd, read_vtu
from mesh_geometry import rim_radius
from render_runs import draw_views
from thin_layer import NEXT_ORDER, Cone
from thin_layer import spread as thin_layer_spread

CASE = "slump"
TIME = "Time (s)"
SPREADS = ("spread (m)", "spread 45 (m)", "spread 90 (m)", "spread 135 (m)")

# Final diameters (m). Roussel & Coussot, J. Rheol. 49 (2005) 705-718: spread of a yield-stress fluid, in the closed form
# of thin layers; for the mini cone also the experiment and the axisymmetric solution that the paper quotes.
CASES = {
    "mini": {"file": "prm/slump/mini_cone.prm", "title": "mini cone", "sizes": (0.005, 0.004, 0.0029), "half plane": 0.001,
             "diameter": 0.1,
             "lines": (("formula and experiment 0.225 m", 0.2249, "--"), ("axisymmetric solution 0.220 m", 0.220, ":")),
             "times": ("0", "0.1", "5"), "cone": Cone(0.05, 0.05, 0.035, 2252., 4.018, 18.0182), "huppert": None},
    "abrams": {"file": "prm/slump/abrams.prm", "title": "Abrams cone", "sizes": (0.015, 0.012, 0.01, 0.0075),
               "half plane": 0.004, "diameter": 0.2,
               "lines": (("formula, at rest: 0.650 m", 0.650, "--"),), "times": ("0", "1", "40"),
               "cone": Cone(0.3, 0.1, 0.05, 2200., 255., 32.),
               # Huppert, J. Fluid Mech. 121 (1982) 43-58: a viscous layer without yield stress, D = 1.788 (rho g V^3 t/(3 mu))^(1/8).
               "huppert": 1.788 * (2200. * 9.81 * 5.497787e-3**3 / (3. * 255.))**0.125},
}


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""
    return ([make_run(CASE, f"{name}-h{h:g}", case["file"], (f"Mesh size={h}",), name, 0, h)
             for name, case in CASES.items() for h in case["sizes"]]
            + [make_run(CASE, f"{name}-rz-h{case['half plane']:g}", case["file"].replace(".prm", "_rz.prm"),
                        (f"Mesh size={case['half plane']}",), f"{name} in the half plane", 0, case["half plane"])
               for name, case in CASES.items()])


def is_in_space(results):
    return results.run.label in CASES


def spreads(results):
    """Spread in four directions, in the half plane in one, one row each, m."""
    if not is_in_space(results):
        return 2. * results.column("front (m)")[np.newaxis]
    return np.array([results.column(name) for name in SPREADS])


def table_row(results):
    run, record, times = results.run, results.record, results.column(TIME)
    iterations, cells = results.column("Nonlinear iterations"), results.column("Fluid cells")
    linear, wall_time = results.column("Linear iterations"), results.column("Wall time (s)")[-1]
    spread = spreads(results)
    memory = record.get("peak memory (MiB)")
    # The largest advance of the front between two steps, once the collapse is over.
    jumps = np.diff(spread)[:, times[1:] > 0.1 * times[-1]]
    _, last = read_pvd(results.directory / "solution.pvd")[-1]
    rim = rim_radius(read_vtu(last, 3).points, run.h)
    return [CASES[run.label]["title"], f"{1e3 * run.h:g}",
            f"{cells[0]:.0f}", f"{times[-1]:.3g}" + state_if_unfinished(results),
            f"{spread[:, -1].mean():.4f}", f"{np.ptp(spread[:, -1]) / run.h:.2f}", f"{results.column('height (m)')[-1]:.4f}",
            f"{rim.std() / run.h:.2f}", f"{jumps.max() / run.h:.2f}" if jumps.size else "–",
            f"{np.median(iterations):.0f} / {iterations.max():.0f}", f"{linear.sum() / iterations.sum():.1f}",
            f"{results.column('Rejected steps')[-1]:.0f}", *worst_changes(results), f"{wall_time:.0f}",
            f"{1e6 * wall_time / (cells * iterations).sum():.1f}", f"{memory:.0f}" if memory else "–"]


def write_results(usable, missing, path):
    header = ["case", "h (mm)", "tetrahedra at the start", "time reached (s)", "spread, mean of four directions (m)",
              "largest difference between directions / h", "height (m)",
              "standard deviation of the rim over the angle / h", "largest jump of the front in a step / h",
              "iterations, median / largest", "linear iterations per solve", "rejected steps", "volume by solver, worst",
              "volume by remeshing, worst", "wall time (s)", "µs per tetrahedron and iteration", "peak memory (MiB)"]
    write_table(header, map(table_row, usable), "Rim: what is farthest from the axis, in sectors 1.5 h wide. Jumps: of the "
                "spread in any of the four directions, after the first tenth of the time. Volume: cumulative, relative to the "
                "initial volume. One thread a run.",
                usable, missing, path)


def draw_spread(name, chosen, in_half_plane, path):
    case = CASES[name]
    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.5 * WIDTH))
    for label, diameter, dash in case["lines"]:
        axes.axhline(diameter, color="0.35", linewidth=1, linestyle=dash, label=label)
    end = max(results.column(TIME)[-1] for results in chosen)
    times = np.linspace(0.02 * end, end, 200)
    for order, label, dash in ((0., "lubrication theory in time", (0, (5, 1.5))), (NEXT_ORDER, "its next order", "-.")):
        axes.plot(times, thin_layer_spread(case["cone"], times, order, n_rings=150, rings_until=2. * case["diameter"]),
                  color="0.15", linewidth=1, linestyle=dash, label=label)
    if case["huppert"]:
        axes.plot(times, case["huppert"] * times**0.125, color="0.65", linewidth=1,
                  label="viscous layer without yield stress (upper bound)")
    for results in in_half_plane:
        axes.plot(results.column(TIME), spreads(results)[0], color="#CC79A7", linewidth=1.2,
                  label=f"Lahar in the half plane, h = {1e3 * results.run.h:g} mm")
    for results in chosen:
        spread = spreads(results)
        line, = axes.plot(results.column(TIME), spread.mean(axis=0), linewidth=1.6,
                          label=f"Lahar, h = {1e3 * results.run.h:g} mm")
        axes.fill_between(results.column(TIME), spread.min(axis=0), spread.max(axis=0), color=line.get_color(), alpha=0.25,
                          linewidth=0)
    finish_axes(axes, "lower right", xlabel="time (s)", ylabel="spread (m)", title=case["title"])
    save(figure, path)
    plt.close(figure)


def report(all_results, doc):
    in_space = [results for results in all_results if is_in_space(results)]
    usable, missing = divide(in_space, CASE)
    if not usable:
        return
    write_results(usable, missing, doc / "benchmarks" / "slump_table.md")
    use_style()
    for name, case in CASES.items():
        chosen = sorted((results for results in usable if results.run.label == name), key=lambda results: -results.run.h)
        in_half_plane = [results for results in all_results
                         if results.is_usable and results.run.label == f"{name} in the half plane"]
        if chosen:
            draw_spread(name, chosen, in_half_plane, doc / "figures" / f"slump_{name}_spread.png")
            draw_views(chosen[-1], case["times"], doc / "figures" / f"slump_{name}_views.png")
