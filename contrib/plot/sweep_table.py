# SPDX-License-Identifier: GPL-3.0-or-later
"""Table and plots of a sweep: quantities of runs over the value of an entry."""

import csv
import re
from dataclasses import dataclass

import numpy as np

from figure_style import WIDTH, finish_axes, plt, save, use_style
from lahar_output import column

TIME, STEP = "Time (s)", "Time step size (s)"
VOLUME = "Fluid volume change"
ITERATIONS, WALL_TIME = "Nonlinear iterations", "Wall time (s)"
VOLUME_PARTS = ("Volume change by solver", "Volume change by remeshing")


def peak(values, _):
    """The value whose magnitude is largest, with its sign."""
    return values[np.argmax(np.abs(values))]


# What is made of a column: from its values and the lengths of the steps.
SUMMARIES = {
    "last": lambda values, _: values[-1],
    "largest": lambda values, _: values.max(),
    "peak": peak,
    "mean": lambda values, steps: (values * steps).sum() / steps.sum(),
    "total": lambda values, _: values.sum(),
}


@dataclass(frozen=True)
class Quantity:
    """A column and what the table has of it; the first of the summaries is drawn over the parameter."""

    name: str
    summaries: tuple

    def values(self, run):
        """The column; the change of volume is the sum of its two parts."""
        statistics = run.statistics
        names = VOLUME_PARTS if self.name == VOLUME else (self.name,)
        return sum(column(statistics, name, run.statistics_path) for name in names)

    def summarize(self, run, summary):
        return float(SUMMARIES[summary](self.values(run), column(run.statistics, STEP, run.statistics_path)))

    @property
    def titles(self):
        return [f"{self.name}, {summary}" for summary in self.summaries]


def is_force(name):
    return re.search(r"\bforce\b", name) is not None


def quantities(runs, names):
    """Those of the columns @p names, or the usual ones that all runs have."""
    if not runs:
        return []
    if names:
        for run in runs:
            for name in names:
                if name != VOLUME:
                    column(run.statistics, name, run.statistics_path)
        return [Quantity(name, ("peak", "last", "mean") if is_force(name) else ("last", "largest", "mean"))
                for name in dict.fromkeys(names)]
    all_columns = [run.statistics for run in runs]
    common = [name for name in all_columns[0]
              if all(name in columns and columns[name].dtype.kind == "f" for columns in all_columns)]
    chosen = [Quantity(VOLUME, ("last",))] if all(part in common for part in VOLUME_PARTS) else []
    chosen += [Quantity(ITERATIONS, ("total",)), Quantity(WALL_TIME, ("last",))]
    chosen += [Quantity(name, ("last",)) for name in common if name.endswith(" (m)")]
    chosen += [Quantity(name, ("peak",)) for name in common if is_force(name)]
    return [quantity for quantity in chosen if quantity.name == VOLUME or quantity.name in common]


# --------------------------------------------------------------------------------------------------------- table


def write_table(entry, runs, chosen, path):
    """One line a value; a run that is not finished has its state only."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([entry, "state", *(title for quantity in chosen for title in quantity.titles)])
        for run in runs:
            state = "finished" if run.is_finished else "stopped" if run.status is None else "failed"
            writer.writerow([run.value, state,
                             *(f"{number:.10g}" if number is not None else "" for number in numbers(run, chosen))])
    print(f"Wrote {path}")


def numbers(run, chosen):
    return [quantity.summarize(run, summary) if run.is_finished else None
            for quantity in chosen for summary in quantity.summaries]


def print_table(entry, runs, chosen):
    """One column a value: there are more quantities than values."""
    rows = [[entry, *(run.value for run in runs)]]
    by_run = [numbers(run, chosen) for run in runs]
    for i, title in enumerate(title for quantity in chosen for title in quantity.titles):
        rows.append([title, *("-" if row[i] is None else f"{row[i]:.5g}" for row in by_run)])
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        words = [word.rjust(width) for word, width in zip(row[1:], widths[1:])]
        print("  ".join([row[0].ljust(widths[0]), *words]).rstrip())


# --------------------------------------------------------------------------------------------------------- plots


def write_plots(entry, runs, chosen, directory):
    use_style()
    for name, quantity in zip(file_names(chosen), chosen):
        figure = draw(entry, runs, quantity)
        save(figure, directory / f"{name}.png")
        plt.close(figure)


def file_names(chosen):
    names = []
    for quantity in chosen:
        name = re.sub(r"[^\w]+", "-", quantity.name).strip("-").lower() or "column"
        names.append(name if name not in names else f"{name}-{len(names)}")
    return names


def draw(entry, runs, quantity):
    """The column over time, one line a value, and beside it its first summary over the value."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 0.4 * WIDTH), layout="constrained")
    colors = line_colors(len(runs))
    for run, color in zip(runs, colors):
        left.plot(column(run.statistics, TIME, run.statistics_path), quantity.values(run), color=color, linewidth=1.2,
                  label=run.value)
    finish_axes(left, legend="best", xlabel="time (s)", ylabel=quantity.name)
    if left.get_legend() is not None:
        left.get_legend().set_title(entry.rpartition("/")[2])

    results = [quantity.summarize(run, quantity.summaries[0]) for run in runs]
    places, labels = parameter_axis([run.value for run in runs])
    order = np.argsort(places)
    right.plot(np.array(places)[order], np.array(results)[order], color="0.7", linewidth=1, zorder=1)
    right.scatter(places, results, color=colors, zorder=2)
    finish_axes(right, xlabel=entry.rpartition("/")[2], ylabel=quantity.titles[0])
    right.margins(x=0.08)
    if labels:
        right.set_xticks(places, labels)
    elif min(places) > 0 and max(places) >= 30 * min(places):
        right.set_xscale("log")
    return figure


def line_colors(n):
    cycle = plt.rcParams["axes.prop_cycle"].by_key()["color"]
    return cycle[:n] if n <= len(cycle) else list(plt.get_cmap("viridis")(np.linspace(0, 0.95, n)))


def parameter_axis(values):
    """Numbers as they are; other values side by side, with their names."""
    try:
        places = [float(value) for value in values]
        if np.isfinite(places).all():
            return places, None
    except ValueError:
        pass
    return list(range(len(values))), values
