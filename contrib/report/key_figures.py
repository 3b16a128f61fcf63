# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers from the statistics of a run: which curves belong together, forces, accounts, values to compare runs by."""

import re
from dataclasses import dataclass, field

import numpy as np

from run_record import STEP_SIZE, TIME

PRESSURE_NOTE = "positive where it pushes"
IN_THE_PLANE = {"N": "N/m", "J": "J/m", "W": "W/m", "N s": "N s/m"}  # forces and energies are those of a slice 1 m thick
NUMERICAL = ("increment", "residual", "iterations", "Held vertices", "Remeshed", "Rejected", "Mended", "kept out", "gap",
             "Time step size")
COUNTS = ("cells", "particles")
SHARES = ("Volume change by solver", "Volume change by remeshing", "Volume left the domain")  # of the initial volume
VOLUME_CHANGES = "Volume changes over the initial volume"
HIDDEN = ("Time step number", TIME)


@dataclass
class Column:
    """A column of the statistics: '<stem> <component> (<unit>)'."""

    name: str
    stem: str
    component: str
    unit: str
    values: np.ndarray

    @property
    def label(self):
        return f"{self.stem} {self.component}".strip()

    @property
    def is_force(self):
        return self.unit in ("N", "N/m") and self.stem.endswith("force") and bool(self.component)

    @property
    def is_mean_force(self):
        return self.is_force and re.search(r" mean (fluid |support )?force$", self.stem) is not None


@dataclass
class Plot:
    """Curves in one frame."""

    section: str
    title: str
    unit: str
    columns: list = field(default_factory=list)  # names of columns
    logarithmic: bool = False
    note: str = ""
    least_extent: float = 0.  # of the axis, so that what does not change looks so


def parse_columns(run):
    """The columns of numbers of a run by name; pressures are positive where they push."""
    columns = {}
    for name, values in run.statistics.items():
        if values.dtype.kind != "f" or name in HIDDEN:
            continue
        label, unit = re.match(r"(.*?)(?: \(([^()]*)\))?$", name).groups()
        component = re.match(r"(.*) ([xyz])$", label)
        stem, component = component.groups() if component else (label, "")
        unit = (unit or "").replace("^dim", "^2" if run.is_plane else "^3").replace("^2", "²").replace("^3", "³")
        if run.is_plane:
            unit = IN_THE_PLANE.get(unit, unit)
        if stem.endswith(" pressure") and unit == "Pa":
            values = -values
        if stem in SHARES:
            values, unit = 100. * values, "%"
        columns[name] = Column(name, stem, component, unit, values)
    return columns


def section_of(column):
    """The section of the report in which a curve stands."""
    if column.is_force:
        return "forces"
    if column.unit.startswith(("J", "N s")) or "olume" in column.stem or column.stem == "Particles left the domain":
        return "accounts"
    if column.stem == "Wall time" or any(word in column.stem for word in NUMERICAL):
        return "numerics"
    if not column.unit and column.stem.endswith(COUNTS):
        return "numerics"
    return "flow"


def frame_of(column):
    """The title of the frame in which a curve stands: components, energies, changes of volume and counts share one."""
    section = section_of(column)
    if section == "accounts":
        if column.unit.startswith("J"):
            return "Energies"
        if column.stem in SHARES:
            return VOLUME_CHANGES
    if section == "numerics":
        for word, title in (("increment", "Last increments"), ("cells", "Cells and particles"),
                            ("particles", "Cells and particles")):
            if column.stem.endswith(word):
                return title
    return column.stem


def plots(columns):
    """The frames of all columns, in the order of the statistics."""
    frames = {}
    for column in columns.values():
        key = (section_of(column), frame_of(column), column.unit)
        plot = frames.setdefault(key, Plot(*key))
        plot.columns.append(column.name)
        plot.logarithmic |= column.stem.endswith(("increment", "residual"))
        if column.stem == "Fluid volume":
            plot.least_extent = 0.01 * np.nanmax(np.abs(column.values), initial=0.)
        if plot.title == VOLUME_CHANGES:
            plot.least_extent = 0.1
        if column.stem.endswith(" pressure"):
            plot.note = PRESSURE_NOTE
    return list(frames.values())


# -------------------------------------------------------------------------------------------------------- forces


def largest_mean(run, components, window):
    """The mean over @p window of largest magnitude, by component, and its end; None for shorter runs. Forces are means
    over steps."""
    edges = np.r_[run.time[0] - run.step_sizes[0], run.time]
    ends = run.time[run.time - edges[0] >= window * (1. - 1e-9)]
    if len(ends) == 0:
        return None
    impulses = [np.r_[0., np.cumsum(force * run.step_sizes)] for force in components]
    means = np.array([np.interp(ends, edges, impulse) - np.interp(ends - window, edges, impulse) for impulse
                      in impulses]) / window
    i = np.linalg.norm(means, axis=0).argmax()
    return means[:, i], ends[i]


def force_row(run, stem, component, components, window):
    """One row of the table of forces: of one component the signed values, of several the magnitudes of vectors."""
    def value(vector):
        return float(vector[0] if len(components) == 1 else np.linalg.norm(vector))

    i = np.linalg.norm(components, axis=0).argmax()
    found = largest_mean(run, components, window)
    impulse = (components * run.step_sizes).sum(axis=1)
    return {"force": stem, "component": component, "peak": value(components[:, i]), "time": run.time[i],
            "window": (value(found[0]), found[1]) if found else None, "mean": value(impulse / run.step_sizes.sum()),
            "impulse": value(impulse)}


def force_rows(run, columns, window):
    """For every force, by component and as magnitude: peak, its time, largest mean over the window, mean, impulse."""
    rows = []
    forces = [column for column in columns.values() if column.is_force and not column.is_mean_force]
    for stem in dict.fromkeys(column.stem for column in forces):
        own = [column for column in forces if column.stem == stem]
        vector = np.array([np.nan_to_num(column.values) for column in own])
        rows += [force_row(run, stem, column.component, values[None], window) for column, values in zip(own, vector)]
        if len(own) > 1:
            rows.append(force_row(run, stem, "magnitude", vector, window))
    return (forces[0].unit if forces else ""), rows


# ------------------------------------------------------------------------------------------------------ accounts


def volume_account(columns):
    """Rows (what, value, share of the initial volume) of the fluid's volume; none if the columns are not there."""
    by_stem = {column.stem: column for column in columns.values()}
    if not {"Fluid volume", "Volume change by solver", "Volume change by remeshing"} <= by_stem.keys():
        return "", []
    volume = by_stem["Fluid volume"]
    changes = [(what, 0.01 * by_stem[stem].values[-1] * sign) for what, stem, sign in
               (("by the solver", "Volume change by solver", 1.), ("by remeshing", "Volume change by remeshing", 1.),
                ("left the domain", "Volume left the domain", -1.)) if stem in by_stem]
    first = 1. + 0.01 * sum(by_stem[stem].values[0] for stem in ("Volume change by solver",
                                                                 "Volume change by remeshing"))
    flows = [(what, by_stem[stem].values * sign) for what, stem, sign in
             (("came in", "Inflow volume", 1.), ("went out", "Outflow volume", -1.)) if stem in by_stem]
    came_in, went_out = (sum(values for what, values in flows if what == wanted) + 0. * volume.values
                         for wanted in ("came in", "went out"))
    # The shares are those of what has been there.
    initial = (volume.values[0] - went_out[0]) / first - came_in[0] if first > 0. else volume.values[0]
    if initial <= 0.:
        return "", []
    whole = initial + came_in[-1]
    rows = [("at the start", initial, 1.), *((what, values[-1], values[-1] / initial) for what, values in flows),
            *((what, share * whole, share * whole / initial) for what, share in changes),
            ("at the end", volume.values[-1], volume.values[-1] / initial)]
    return volume.unit, rows


def energy_account(columns):
    """Rows (energy, after the first step, at the end, change) and their sum; none without energies."""
    energies = [column for column in columns.values() if column.unit.startswith("J")]
    rows = [(column.stem, column.values[0], column.values[-1], column.values[-1] - column.values[0]) for column
            in energies]
    if len(rows) > 1:
        rows.append(("Sum", *(sum(row[i] for row in rows) for i in (1, 2, 3))))
    return (energies[0].unit if energies else ""), rows


def momentum_account(columns):
    """Rows (component, largest momentum, at the end, change by remeshing at the end); none without these columns."""
    rows, unit = [], ""
    for column in columns.values():
        other = columns.get(f"Momentum change by remeshing {column.component} (N s)")
        if column.stem == "Momentum" and other is not None:
            i = np.abs(column.values).argmax()
            rows.append((column.component, column.values[i], column.values[-1], other.values[-1]))
            unit = column.unit
    return unit, rows


# --------------------------------------------------------------------------------------------- one value a run


def measures(run, columns):
    """One number a run for comparisons, by (name, unit): the last and the largest value of columns, peaks, impulses."""
    found = {}
    for column in columns.values():
        values = column.values[np.isfinite(column.values)]
        section = section_of(column)
        if len(values) == 0 or column.is_mean_force:
            continue
        if column.is_force:
            found[f"{column.label}: peak", column.unit] = values[np.abs(values).argmax()]
            impulse_unit = column.unit.replace("N", "N s", 1)
            found[f"{column.label}: impulse", impulse_unit] = (np.nan_to_num(column.values) * run.step_sizes).sum()
        elif section in ("flow", "accounts"):
            found[f"{column.label}: at the end", column.unit] = values[-1]
            found[f"{column.label}: largest", column.unit] = values.max()
        elif column.stem == "Wall time":
            found["Wall time", column.unit] = values[-1]
        elif column.stem == "Rejected steps":
            found["Rejected steps", ""] = values[-1]
        elif column.stem in ("Nonlinear iterations", "Fluid cells"):
            found[f"{column.stem}: mean", ""] = values.mean()
    found["Time steps", ""] = len(run.time)
    found["Time step: mean", "s"] = run.statistics[STEP_SIZE].mean()
    return found
