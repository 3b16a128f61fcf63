# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of the report's sections, for one or several runs."""

import numpy as np

from case_parameters import differing
from html_tables import Html, details, escape, items, number, percent, seconds, short, table, whole
from key_figures import energy_account, force_rows, momentum_account, volume_account

MOST_MESSAGES = 50


def column(run, name):
    """A column of numbers of a run, or None."""
    values = run.statistics.get(name)
    return values if values is not None and values.dtype.kind == "f" else None


def overview(runs, columns):
    """One row a fact, one column a run."""
    rows = []

    def add(what, text_of):
        texts = [text_of(run, own) for run, own in zip(runs, columns)]
        if any(texts):
            rows.append([what, *texts])

    def first_and_last(name):
        def text(run, _):
            values = column(run, name)
            return "" if values is None else f"{whole(values[0])} → {whole(values[-1])}"
        return text

    def peak(stem):
        def text(_, own):
            vector = [c.values for c in own.values() if c.stem == stem]
            if not vector:
                return ""
            return f"{number(np.linalg.norm(np.nan_to_num(vector), axis=0).max(), 3)} {unit_of(own, stem)}"
        return text

    add("State", lambda run, _: run.state())
    add("Reason", lambda run, _: run.log.failure)
    add("Dimension", lambda run, _: run.case.geometry)
    add("Mesh size", lambda run, _: f"{short(run.case.number('Mesh size'))} m")
    add("Time steps", step_sizes)
    add("Fluid cells, first → last", first_and_last("Fluid cells"))
    add("Fluid particles, first → last", first_and_last("Fluid particles"))
    for stem in dict.fromkeys(c.stem for own in columns for c in own.values() if c.is_force and not c.is_mean_force
                              and not c.stem.endswith("support force")):
        add(f"Largest {stem}", peak(stem))
    add("Change of volume", lambda run, own: volume_change(own))
    add("Steps repeated", lambda run, _: "" if column(run, "Rejected steps") is None
        else whole(column(run, "Rejected steps")[-1]))
    add("Wall time", lambda run, _: "" if column(run, "Wall time (s)") is None
        else seconds(column(run, "Wall time (s)")[-1]))
    add("Warnings", lambda run, _: whole(len(run.log.warnings)))
    if len(runs) > 1:
        return table(["", *(run.name for run in runs)], rows, kind="facts")
    return '<dl class="facts">' + "".join(f"<div><dt>{escape(what)}</dt><dd>{escape(text)}</dd></div>" for what, text
                                          in rows) + "</dl>"


def step_sizes(run, _):
    least, largest = short(run.step_sizes.min()), short(run.step_sizes.max())
    return f"{whole(len(run.time))} of " + (f"{least} s" if least == largest else f"{least} to {largest} s")


def unit_of(columns, stem):
    return next(c.unit for c in columns.values() if c.stem == stem)


def volume_change(columns):
    _, rows = volume_account(columns)
    return percent(rows[-1][2] - 1.) if rows else ""


# ----------------------------------------------------------------------------------------------------- parameters


def materials(runs):
    """The parts of the case with shape, law and the law's entries; of runs with the same parts one table."""
    tables = {}
    for run in runs:
        rows = []
        for kind, word in (("Fluids", "fluid"), ("Boundaries", "boundary"), ("Solids", "solid")):
            for name in run.case.names(kind):
                entries = [f"{entry} {value}{' ' + unit if unit else ''}" for entry, value, unit
                           in run.case.law_entries(kind, name)]
                rows.append((name, word, run.case.get(f"{kind}/{name}/Shape"), run.case.law(kind, name),
                             "; ".join(entries)))
        tables.setdefault(tuple(rows), []).append(run.name)
    return "".join(table(["name", "", "shape", "law", "entries of the law"], rows, caption=", ".join(names)
                         if len(tables) > 1 else "",
                         kind="materials") for rows, names in tables.items())



def parameters(runs):
    """Entries that differ from the defaults, in one of the runs at least; those that differ between runs stand out."""
    paths = dict.fromkeys(entry.path for run in runs for entry in run.case.changed())
    marked = set(differing([run.case for run in runs]))
    # An entry that differs between the runs is shown where it has its default in all but one, too.
    rows, last = [], None
    for path in sorted({**paths, **dict.fromkeys(marked)}, key=lambda path: "/" in path):
        section, _, name = path.rpartition("/")
        entries = [run.case.entries.get(path) for run in runs]
        if section != last:
            rows.append([Html(f"<b>{escape(section.replace('/', ' / '))}</b>" if section else "<b>Run</b>"), *[""]
                         * (len(runs) + 1)])
            last = section
        known = next(entry for entry in entries if entry)
        label = Html(f'<span title="{escape(known.documentation)}">{escape(name)}</span>')
        texts = [shortened(entry.value if entry else "–") for entry in entries]
        rows.append([label, *(Html(f'<mark>{text}</mark>') if path in marked else text for text in texts),
                     shortened(known.default)])
    return table(["entry", *(["value"] if len(runs) == 1 else [run.name for run in runs]), "default"], rows,
                 kind="parameters")


def shortened(text, longest=160):
    return Html(escape(text if len(text) <= longest else text[:longest] + " …") or '<span class="none">none</span>')


# --------------------------------------------------------------------------------------------------------- forces


def forces(runs, columns, window):
    parts = []
    for run, own in zip(runs, columns):
        rows = []
        unit, found = force_rows(run, own, window)
        for row in found:
            mean = row["window"]
            rows.append([row["force"] if row["component"] == found[0]["component"] else "", row["component"],
                         number(row["peak"]), number(row["time"]),
                         *((number(mean[0]), number(mean[1])) if mean else ("–", "–")), number(row["mean"]),
                         number(row["impulse"])])
        if rows:
            head = ["force", "", f"peak ({unit})", "at (s)", f"largest mean over {short(window)} s ({unit})",
                    "until (s)", f"mean ({unit})",
                    f"impulse ({unit.replace('N', 'N s', 1)})"]
            parts.append(table(head, rows, range(2, 8), run.name if len(runs) > 1 else ""))
    return "".join(parts)


# ------------------------------------------------------------------------------------------------------- accounts


def accounts(runs, columns):
    parts = []
    for run, own in zip(runs, columns):
        tables = [*volume_tables(own), *energy_tables(own), *momentum_tables(own)]
        if tables:
            title = f"<h4>{escape(run.name)}</h4>" if len(runs) > 1 else ""
            parts.append(title + '<div class="tables">' + "".join(tables) + "</div>")
    return "".join(parts)


def volume_tables(columns):
    unit, rows = volume_account(columns)
    if not rows:
        return []
    shown = [[rows[0][0], number(rows[0][1], 5), ""], *([what, signed(value), percent(share)] for what, value, share
                                                        in rows[1:-1]),
             [rows[-1][0], number(rows[-1][1], 5), percent(rows[-1][2] - 1.)]]
    return [table(["fluid", unit, "of the initial volume"], shown, (1, 2), "Volume")]


def signed(value, digits=3):
    return ("+" if value > 0. else "") + number(value, digits)


def energy_tables(columns):
    unit, rows = energy_account(columns)
    shown = [[what, number(first), number(last), signed(change, 4)] for what, first, last, change in rows]
    return [table([unit, "after the first step", "at the end", "change"], shown, (1, 2, 3), "Energy")] if shown else []


def momentum_tables(columns):
    unit, rows = momentum_account(columns)
    shown = [[component, number(largest), number(last), signed(change)] for component, largest, last, change in rows]
    return [table([unit, "largest", "at the end", "by remeshing"], shown, (1, 2, 3),
                  "Momentum of the fluid")] if shown else []


# -------------------------------------------------------------------------------------------------------- numbers


def constants(columns, names):
    """A sentence about columns that do not change, for which curves would be straight lines."""
    texts = []
    for name in names:
        own = [by_name[name] for by_name in columns if name in by_name]
        values = dict.fromkeys(short(column.values[0], 6) + (f" {column.unit}" if column.unit else "") for column
                               in own)
        texts.append(f"{own[0].label} {', '.join(values)}")
    return f'<p class="note">Constant: {escape("; ".join(texts))}.</p>' if texts else ""



def numerics(runs):
    head, rows = ["", *(run.name for run in runs)], []
    for what, name, summary in (("Nonlinear iterations a step, mean", "Nonlinear iterations", np.mean),
                                ("… largest", "Nonlinear iterations", np.max),
                                ("… all", "Nonlinear iterations", np.sum),
                                ("Linear iterations a step, mean", "Linear iterations", np.mean),
                                ("Steps repeated", "Rejected steps", lambda values: values[-1])):
        values = [column(run, name) for run in runs]
        if any(v is not None for v in values):
            digits = number if summary is np.mean else lambda value, _: whole(value)
            rows.append([what, *("" if v is None else digits(summary(v), 3) for v in values)])
    tables = [table(head if len(runs) > 1 else ["", ""], rows, range(1, 1 + len(runs)), "Iterations")]
    phases = dict.fromkeys(phase for run in runs for phase in run.log.phases)
    if phases:
        sums = [sum(run.log.phases.values()) for run in runs]
        rows = [[phase, *(phase_cell(run.log.phases.get(phase), total) for run, total in zip(runs, sums))] for phase
                in phases]
        rows.append(["All", *(phase_cell(total or None, 0.) for total in sums)])
        tables.append(table(head if len(runs) > 1 else ["", ""], rows, range(1, 1 + len(runs)), "Wall time by phase"))
    return '<div class="tables">' + "".join(tables) + "</div>"


def phase_cell(value, total):
    if value is None:
        return "–"
    share = f' style="--share:{100 * value / total:.1f}%">{100 * value / total:.0f} %' if total > 0. else ">"
    return Html(f'{seconds(value)} <span class="share{"" if total > 0. else " none"}"{share}</span>')


def messages(runs):
    parts = []
    for run in runs:
        log, texts = run.log, []
        if log.failure:
            texts.append(f'<p class="failure">The run failed. {escape(log.failure)}</p>')
        if log.stop:
            texts.append(f"<p>{escape(log.stop)}</p>")
        if run.lock:
            words = {"held": "goes on", "left": "was killed"}.get(run.lock, "goes on, or was killed")
            texts.append(f"<p>The run {words}: the report has what it had written so far.</p>")
        if log.n_resumed:
            texts.append(f"<p>Resumed {log.n_resumed} time{'s' if log.n_resumed > 1 else ''} from a checkpoint.</p>")
        texts.append(listed("Warnings", log.warnings) if log.warnings else "<p>No warnings.</p>")
        if log.repeated:
            texts.append(details(f"Steps that were repeated with half the length: {len(log.repeated)}",
                                 listed("", log.repeated)))
        parts.append((f"<h4>{escape(run.name)}</h4>" if len(runs) > 1 else "") + "".join(texts))
    return "".join(parts)


def listed(title, texts):
    more = f"<p>… and {len(texts) - MOST_MESSAGES} more in the log</p>" if len(texts) > MOST_MESSAGES else ""
    return (f"<p>{escape(title)}:</p>" if title else "") + items(texts[:MOST_MESSAGES]) + more
