# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark of bentonite on a slope (Franci & Zhang 2018, Section 5.3): its runs, table, figures."""

import numpy as np
from benchmark_table import divide, state_if_unfinished, worst_changes, write_table
from figure_style import WIDTH, finish_axes, plt, save, use_style

CASE = "bentonite_slope"
TIME, FRONT = "Time (s)", "front (m)"
GRAVITY = 9.81

# Reservoir L0, H0 (m), yield stresses (Pa): unloading, mean, loading.
CASES = {"a": (0.3024, 0.0756, (21.1, 93.05, 165)), "b": (0.2928, 0.0732, (14, 32, 50))}
# Arrested fronts X/H0 by lubrication theory for the whole pile, where it gives one: a guide only, the piles are not thin.
LUBRICATION = {("a", "block", 93.05): 5.786, ("a", "block", 165): 2.400, ("a", "wedge", 93.05): 1.284,
               ("b", "wedge", 50): 4.529, ("b", "wedge", 32): 8.900, ("b", "block", 50): 12.596}


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""
    result = []
    for case, (length, _, yield_stresses) in CASES.items():
        height = CASES[case][1]
        wedge = ("Fluids/fluid/Shape=polygon", f"Fluids/fluid/polygon/Corners=-{length}, 0 : 0, 0 : 0, {height}")
        for shape, settings in (("block", ()), ("wedge", wedge)):
            for tau0 in yield_stresses:
                result.append(make_run(CASE, f"{case}-{shape}-tau{tau0}", f"prm/bentonite_slope/case_{case}_2d.prm",
                                       (f"Fluids/fluid/Bingham/Yield stress={tau0}", *settings), f"{case} {shape}", tau0, 0.006))
    for m in (1, 100):
        result.append(make_run(CASE, f"a-block-tau93.05-m{m}", "prm/bentonite_slope/case_a_2d.prm",
                               ("Fluids/fluid/Bingham/Yield stress=93.05", f"Fluids/fluid/Bingham/Regularization parameter={m}"),
                               f"a m{m}", 93.05, 0.006))
    return result


def scaled(results):
    """Dimensionless time t sqrt(g/H0) and front X/H0."""
    height = CASES[results.run.label[0]][1]
    return results.column(TIME) * np.sqrt(GRAVITY / height), results.column(FRONT) / height


def speed_at_end(results):
    time, front = results.column(TIME), results.column(FRONT)
    late = time > time[-1] - 0.1
    return np.polyfit(time[late], front[late], 1)[0]


def table_row(results):
    run, time = results.run, results.column(TIME)
    case, shape = run.label.split()
    times, front = scaled(results)
    iterations = results.column("Nonlinear iterations")
    guide = LUBRICATION.get((case, shape, run.tau0))
    shape = f"block, m = {shape[1:]} s" if shape.startswith("m") else shape
    return [case.upper(), shape, f"{run.tau0:g}", f"{time[-1]:.3g}" + state_if_unfinished(results),
            *(f"{np.interp(t, times, front):.2f}" if t <= times[-1] else "–" for t in (2, 4, 6, 10)), f"{front[-1]:.2f}",
            f"{1e3 * speed_at_end(results):.0f}", f"{guide:.2f}" if guide else "–",
            f"{np.median(iterations):.0f} / {iterations.max():.0f}", f"{results.column('Rejected steps')[-1]:.0f}", *worst_changes(results),
            f"{results.column('Wall time (s)')[-1]:.0f}"]


def write_results(usable, missing, path):
    header = ["case", "reservoir", "τ0 (Pa)", "time reached (s)", "front X/H0 at t* = 2", "4", "6", "10", "at the end",
              "speed of the front there (mm/s)", "arrested, lubrication theory", "iterations, median / largest",
              "rejected steps", "volume by solver, worst", "volume by remeshing, worst", "wall time (s)"]
    write_table(header, map(table_row, usable), "h = 0.006 m, time step 1e-3 s, t* = t sqrt(g/H0). Volume: cumulative, "
                "relative to the initial volume.", usable, missing, path)


def draw_fronts(usable, path):
    figure, panels = plt.subplots(1, 2, figsize=(1.25 * WIDTH, 0.5 * WIDTH))
    for axes, (case, (_, _, yield_stresses)) in zip(panels, CASES.items()):
        for tau0, color in zip(yield_stresses, ("#56B4E9", "#009E73", "#D55E00")):
            for shape, dash in (("block", "-"), ("wedge", (0, (4, 1.5)))):
                for results in usable:
                    if results.run.label == f"{case} {shape}" and results.run.tau0 == tau0:
                        axes.plot(*scaled(results), color=color, linestyle=dash, label=f"$\\tau_0$ = {tau0:g} Pa, {shape}")
        finish_axes(axes, xlabel="$t\\,\\sqrt{g/H_0}$", ylabel="front $X/H_0$", title=f"case {case.upper()}")
    save(figure, path)
    plt.close(figure)


def draw_regularization(usable, path):
    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.45 * WIDTH))
    for label, m in (("a m1", 1), ("a m100", 100), ("a block", 1000)):
        for results in usable:
            if results.run.label == label and results.run.tau0 == 93.05:
                axes.plot(*scaled(results), label=f"m = {m} s")
    if axes.lines:
        finish_axes(axes, xlabel="$t\\,\\sqrt{g/H_0}$", ylabel="front $X/H_0$",
                    title="case A, block, $\\tau_0$ = 93.05 Pa")
        save(figure, path)
    plt.close(figure)


def report(all_results, doc, draw_snapshots):
    usable, missing = divide(all_results, CASE)
    if not usable:
        return
    write_results(usable, missing, doc / "benchmarks" / "bentonite_slope_table.md")
    use_style()
    draw_fronts(usable, doc / "figures" / "bentonite_slope_front.png")
    draw_regularization(usable, doc / "figures" / "bentonite_slope_regularization.png")
    for results in usable:
        if results.run.name == "a-block-tau93.05":
            draw_snapshots(results, doc / "figures" / "bentonite_slope_snapshots.png", "--times", "0", "0.15", "0.3", "0.6",
                           "1.5", "--columns", "1", "--limits", "-0.32", "0.6", "-0.02", "0.1")
