# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark of the dam break against an elastic barrier (Franci & Zhang 2018, Section 5.1): its runs, table, figures."""

import pathlib

import numpy as np
from benchmark_table import VOLUME_CHANGES, divide, state_if_unfinished, worst_changes, write_table
from figure_style import WIDTH, finish_axes, plt, save, use_style

REFERENCE = pathlib.Path(__file__).resolve().parents[2] / "prm/dam_break_barrier/reference/elastic_barrier_tip_newtonian.csv"

CASE = "dam_break_elastic"
FILE = "prm/dam_break_barrier/elastic_2d.prm"
TIME, TIP = "Time (s)", "tip x (m)"
COARSE = (0.012, 0.010, 0.008, 0.006)
INSTANTS = (0.05, 0.15, 0.30, 0.50)
# Columns of the reference file, which names the sources.
PUBLISHED = {"kratos": "Kratos PFEM–FEM", "meduri2018": "Meduri et al. 2018", "cerquaglia2019": "Cerquaglia et al. 2019",
             "ryzhakov": "Ryzhakov et al. 2010"}


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""

    def make(tau0, h, degree, suffix="", more=(), label=""):
        step = ("Time step=5e-4",) if h < 0.003 else ()
        return make_run(CASE, f"tau{tau0}-h{h:g}-p{degree}{suffix}", FILE,
                        (f"Fluids/fluid/Bingham/Yield stress={tau0}", f"Mesh size={h}", f"Solids/Degree={degree}", *step, *more),
                        label or f"P{degree}", tau0, h)

    return ([make(0, 0.004, 2), make(0, 0.002, 1)]
            + [make(100, h, degree) for degree in (2, 1) for h in (*COARSE, 0.004)]
            + [make(100, 0.004, 2, f"-m{m:g}", (f"Fluids/fluid/Bingham/Regularization parameter={m}",), f"P2, m = {m:g} s")
               for m in (0.1, 1, 100)]
            + [make(tau0, 0.004, 2) for tau0 in (25, 50)]
            + [make(tau0, 0.002, 2) for tau0 in (100, 50, 25)] + [make(100, 0.002, 1)])


# ------------------------------------------------------------------------------------------------------- reading


def name_of(results):
    return results.run.name


def read_convergence(directory):
    """The increments of all iterations: columns step, time, iteration, velocity, pressure."""
    return np.loadtxt(directory / "convergence", comments="#", ndmin=2)


def read_published():
    """Time and the published tip displacements (m) by name."""
    lines = [line for line in REFERENCE.read_text().splitlines() if line and not line.startswith("#")]
    values = np.array([[float(word) for word in line.split(",")] for line in lines[1:]])
    return dict(zip(lines[0].split(","), values.T))


def peak(results):
    """Largest displacement of the tip (m), and when (s)."""
    tip = results.column(TIP)
    return tip.max(), results.column(TIME)[tip.argmax()]


def passing_time(results, limit=1e-3):
    """When the tip passes @p limit (m) for the first time (s); nan if it does not."""
    tip, times = results.column(TIP), results.column(TIME)
    after = np.argmax(tip > limit)
    return np.interp(limit, tip[after - 1:after + 1], times[after - 1:after + 1]) if tip[after] > limit else np.nan


# --------------------------------------------------------------------------------------------------------- table


def table_row(results):
    run, record, times = results.run, results.record, results.column(TIME)
    iterations, cells = results.column("Nonlinear iterations"), results.column("Fluid cells")
    wall_time, memory = results.column("Wall time (s)")[-1], record.get("peak memory (MiB)")
    largest, when = peak(results)
    changes = [results.column(name) for name in VOLUME_CHANGES]
    return [f"{run.tau0}", f"{run.h:g}", run.label + state_if_unfinished(results),
            f"{results.column('Solid cells')[0]:.0f}", f"{1e3 * largest:.1f}", f"{when:.3f}", f"{passing_time(results):.4f}",
            f"{1e3 * results.column(TIP)[-1]:.1f}", f"{results.column('front (m)')[-1]:.3f}",
            f"{np.median(iterations):.0f} / {iterations.max():.0f}", f"{results.column('Rejected steps')[-1]:.0f}", *worst_changes(results),
            f"{100 * sum(change[-1] for change in changes):+.2f} %",
            f"{results.column('Mended contour facets')[-1]:.0f}", f"{results.column('Particles kept out of solids')[-1]:.0f}",
            f"{wall_time:.0f}", f"{1e6 * wall_time / (cells * iterations).sum():.1f}", f"{memory:.0f}" if memory else "–"]


def write_results(usable, missing, path):
    header = ["τ0 (Pa)", "h (m)", "solid", "solid cells", "largest deflection (mm)", "at (s)", "passes 1 mm at (s)",
              "at the end (mm)", "front at the end (m)", "iterations, median / largest", "rejected steps",
              "volume by solver, worst", "volume by remeshing, worst", "volume at the end", "contour facets mended",
              "particles kept out", "wall time (s)", "µs per triangle and iteration", "peak memory (MiB)"]
    write_table(header, map(table_row, usable), "Time step 1e-3 s, 5e-4 s for h = 0.002 m. Volume: cumulative, relative to "
                "the initial volume. One thread a run, two runs side by side on two cores.", usable, missing, path)


# ------------------------------------------------------------------------------------------------------- figures


def tip_axes(axes):
    finish_axes(axes, xlabel="time (s)", ylabel="tip displacement (mm)")


def plot_tip(axes, results, **style):
    axes.plot(results.column(TIME), 1e3 * results.column(TIP), **style)


def draw_published(chosen, path):
    """A7: the Newtonian fluid beside the literature."""
    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 0.5 * WIDTH))
    published = read_published()
    for (name, label), color in zip(PUBLISHED.items(), ("0.35", "0.5", "0.62", "0.75")):
        axes.plot(published["t"], 1e3 * published[name], color=color, linewidth=1, label=label)
    for results in chosen:
        step = 0.5 if results.run.h < 0.003 else 1
        plot_tip(axes, results, linewidth=1.8,
                 label=f"Lahar, h = {1e3 * results.run.h:g} mm, {results.run.label}, Δt = {step:g} ms")
    axes.add_patch(plt.Rectangle((0.21, 41), 0.05, 8, facecolor="none", edgecolor="0.4", linewidth=0.7, linestyle=":"))
    tip_axes(axes)
    save(figure, path)
    plt.close(figure)


def draw_mesh_convergence(series, finest, path):
    """A1: deflection against time for all meshes, and the difference of its maximum from the finest mesh's."""
    figure, panels = plt.subplots(1, len(series) + 1, figsize=(1.35 * WIDTH, 0.42 * WIDTH))
    figure.subplots_adjust(wspace=0.3)
    for axes, (label, all_results), color in zip(panels, series.items(), ("#0072B2", "#D55E00")):
        for results in all_results:
            shade = 0.25 + 0.75 * np.log(results.run.h / 0.0018) / np.log(0.013 / 0.0018)
            plot_tip(axes, results, linewidth=1.1, color=plt.cm.viridis(1. - shade), label=f"h = {1e3 * results.run.h:g} mm")
        tip_axes(axes)
        axes.set(title=label, ylim=(-2, 68))
        axes.legend(ncol=2, loc="upper left", fontsize=7, columnspacing=1)
        h = [results.run.h for results in all_results if results is not finest]
        error = [100 * abs(peak(results)[0] / peak(finest)[0] - 1) for results in all_results if results is not finest]
        panels[-1].plot(1e3 * np.array(h), error, "o-", color=color, label=label)
    panels[-1].axhline(10, color="0.6", linewidth=0.8, linestyle=":")
    panels[-1].text(0.98, 10.5, "the paper at h = 4 mm", transform=panels[-1].get_yaxis_transform(), fontsize=7, color="0.4",
                    horizontalalignment="right")
    panels[-1].set(xlabel="h (mm)", ylabel=f"difference from {finest.run.label}, {1e3 * finest.run.h:g} mm (%)",
                   title="largest deflection", ylim=(0, None))
    panels[-1].legend(loc="upper left")
    save(figure, path)
    plt.close(figure)


def draw_iterations(results, path):
    """A2: increments against the iteration at four instants."""
    figure, panels = plt.subplots(1, 2, figsize=(WIDTH, 0.42 * WIDTH), sharey=True)
    rows = read_convergence(results.directory)
    for instant in INSTANTS:
        times = np.unique(rows[:, 1])
        chosen = rows[rows[:, 1] == times[np.argmin(np.abs(times - instant))]]
        for axes, increments in zip(panels, (chosen[:, 3], chosen[:, 4])):
            axes.semilogy(chosen[:, 2], increments, "o-", markersize=3, label=f"t = {instant:g} s")
    for axes, title in zip(panels, ("velocity", "pressure")):
        axes.axhline(1e-4, color="0.6", linewidth=0.8)
        axes.set(xlabel="iteration", title=title)
        axes.grid(linewidth=0.4, color="0.88")
        axes.legend()
    panels[0].set_ylabel("relative increment")
    save(figure, path)
    plt.close(figure)


def draw_family(all_results, labels, path):
    figure, axes = plt.subplots(figsize=(0.75 * WIDTH, 0.48 * WIDTH))
    for results, label in zip(all_results, labels):
        plot_tip(axes, results, label=label, linewidth=1.4)
    tip_axes(axes)
    save(figure, path)
    plt.close(figure)


def draw_beside_rigid(results, path, draw_snapshots):
    """A5: yielded fluid, with the elastic barrier and with the rigid one."""
    rigid = results.directory.parents[1] / "dam_break_rigid" / f"tau{results.run.tau0}-h{results.run.h:g}"
    if not (rigid / "solution.pvd").exists():
        print(f"Left out: {path.name} (no run {rigid})")
        return
    draw_snapshots(results, path, "--labels", "elastic", "rigid", "--field", "yielded", "--times", "0.1", "0.2", "0.3",
                   "0.4", "0.5", "--limits", "-0.02", "0.82", "-0.02", "0.4", beside=[rigid])


def report(all_results, doc, draw_snapshots):
    usable, missing = divide(all_results, CASE)
    if not usable:
        return
    write_results(usable, missing, doc / "benchmarks" / f"{CASE}_table.md")

    use_style()
    figures = doc / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    by_name = {name_of(results): results for results in usable}

    def present(*names):
        return [by_name[name] for name in names if name in by_name]

    newtonian = present("tau0-h0.002-p1", "tau0-h0.004-p2")
    if newtonian:
        draw_published(newtonian, figures / f"{CASE}_published.png")
    series = {f"P{degree} solid": present(*(f"tau100-h{h:g}-p{degree}" for h in (*COARSE, 0.004, 0.002)))
              for degree in (2, 1)}
    finest = [results for results in series["P2 solid"]][-1:]
    if finest and all(series.values()):
        draw_mesh_convergence(series, finest[0], figures / f"{CASE}_meshes.png")
    if finest:
        draw_iterations(finest[0], figures / f"{CASE}_iterations.png")
        draw_snapshots(finest[0], figures / f"{CASE}_snapshots.png", "--times", "0.1", "0.2", "0.3", "0.4", "0.5", "0",
                       "--columns", "2", "--limits", "-0.02", "0.82", "-0.02", "0.4")
        draw_beside_rigid(finest[0], figures / f"{CASE}_yielded.png", draw_snapshots)
    regularized = [("tau100-h0.004-p2-m0.1", 0.1), ("tau100-h0.004-p2-m1", 1), ("tau100-h0.004-p2-m100", 100),
                   ("tau100-h0.004-p2", 1000)]
    regularized = [(by_name[name], f"m = {m:g} s") for name, m in regularized if name in by_name]
    if len(regularized) > 1:
        draw_family(*zip(*regularized), figures / f"{CASE}_regularization.png")
    for h in (0.004, 0.002):
        stresses = [(by_name[name], f"τ0 = {tau0} Pa") for tau0 in (0, 25, 50, 100)
                    for name in (f"tau{tau0}-h{h:g}-p2",) if name in by_name]
        if len(stresses) > 2:
            draw_family(*zip(*stresses), figures / f"{CASE}_yield_stress_h{h:g}.png")
