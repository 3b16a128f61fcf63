# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the report together: one HTML file with its data, its scripts and plotly in it."""

import base64
import functools
import gzip
import json
import os
import pathlib

import numpy as np

import report_sections
from case_parameters import differing
from case_sketch import labels
from flow_data import Encoder, field_ranges, read_flow, thinned, view_box
from html_tables import escape, short
from key_figures import measures, parse_columns, plots
from lahar_output import OutputError
from plotly_bundle import plotly_script
from wall_data import Walls

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ("data.js", "page.js", "colours.js", "flow_plane.js", "flow_space.js", "flow.js", "curves.js", "sketch.js",
           "follow.js", "report.js")
MOST_POINTS = 2000  # of a curve; of longer ones the smallest and the largest value of every piece are kept
MOST_ENLARGED = 2.5
SECTIONS = ("forces", "flow", "accounts", "numerics")


def write_report(runs, arguments):
    """Writes the report to the file arguments.output, and says what is in it."""
    text, n_drawn = make_report(runs, arguments)
    write_atomically(arguments.output, text)
    n_snapshots = sum(len({time for part in run.snapshots.values() for time, _ in part}) for run in runs)
    print(f"Wrote {arguments.output} ({arguments.output.stat().st_size / 1e6:.1f} MB, {n_drawn} of {n_snapshots} "
          "snapshots)")


def make_report(runs, arguments, version=None):
    """The page, and how many snapshots are in it. With a version it asks its server for later ones."""
    columns = [parse_columns(run) for run in runs]
    flows = [read_flow(run, arguments.snapshots) for run in runs]
    for run, flow in zip(runs, flows):
        if not flow.surfaces():
            raise OutputError(f"{run.directory}/solution.pvd: no snapshot has a cell; allowed: a run with some")
    ranges = field_ranges(flows)
    walls = [Walls(run, flow) for run, flow in zip(runs, flows)]
    boxes = common_boxes([view_box(flow, own.corners()) for flow, own in zip(flows, walls)])
    encoders = [Encoder(flow, own, ranges) for flow, own in zip(flows, walls)]
    blocks = thinned([encoder.blocks() for encoder in encoders])
    frames, constant = all_plots(columns)
    data = {"dimension": runs[0].dimension, "fields": ranges, "plots": [vars(plot) for plot in frames], "runs": [],
            "sweep": sweep(runs, columns), "version": version}
    stored = {}
    for r, own_blocks in enumerate(blocks):
        heads = []
        for k, (head, block) in enumerate(own_blocks):
            stored[f"snapshot-{r}-{k}"] = block
            heads.append({**head, "id": f"snapshot-{r}-{k}"})
        data["runs"].append({**flow_data(runs[r], flows[r], encoders[r], walls[r], boxes[r], heads),
                             **curves_data(runs[r], columns[r])})
    return page(runs, columns, frames, constant, data, stored, arguments), sum(map(len, blocks))


@functools.lru_cache(maxsize=1)
def plotly_block():
    """plotly's script, compressed, in base64."""
    return in_base64(gzip.compress(plotly_script().encode(), 9, mtime=0))


def write_atomically(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(text, encoding="utf-8")
    os.replace(part, path)


# ----------------------------------------------------------------------------------------------------------- data


def in_base64(data):
    return base64.b64encode(data).decode()


def floats(values):
    return in_base64(np.ascontiguousarray(values, dtype="<f4").tobytes())


def numbers(values):
    return in_base64(np.ascontiguousarray(values, dtype="<u4").tobytes())


def common_boxes(boxes):
    """One box for all runs, so that they can be compared, unless it were much larger than the largest of them."""
    lower, upper = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    largest = max(np.prod(box[1] - box[0]) for box in boxes)
    return [(lower, upper)] * len(boxes) if np.prod(upper - lower) <= MOST_ENLARGED * largest else boxes


def curves_data(run, columns):
    times, kept = thinned_times(run.time)
    return {"times": floats(times), "columns": {name: {"label": column.label, "y": floats(kept(column.values))}
                                                for name, column in columns.items()}}


def flow_data(run, flow, encoder, walls, box, heads):
    """What the page needs to draw the flow and a sketch of the case."""
    gravity = run.case.gravity()
    return {
        "name": run.name, "gravity": [0.] * run.dimension if gravity is None else gravity.tolist(),
        "labels": labels(run, flow, walls, np.array(box)),
        "walls": {"points": floats(walls.states[0].T), "lines": [line.tolist() for line in walls.lines],
                  "filled": [bool(filled) for filled in walls.filled], "triangles": numbers(walls.triangles.T),
                  "edges": numbers(walls.edges.T)},
        "flow": {"lower": encoder.lower.tolist(), "size": encoder.size.tolist(),
                 "box": [list(map(float, end)) for end in box],
                 "snapshots": heads},
    }


def thinned_times(times):
    """The times of a curve's points, and a function that gives its values there: of long ones two for every piece."""
    if len(times) <= MOST_POINTS:
        return times, lambda values: values
    starts = np.linspace(0, len(times), MOST_POINTS // 2 + 1).astype(int)
    pieces = list(zip(starts[:-1], starts[1:]))
    shown = np.ravel([(times[a], times[(a + b) // 2]) for a, b in pieces])

    def kept(values):
        result = []
        for a, b in pieces:
            piece = values[a:b]
            if np.isnan(piece).all():
                result += [np.nan, np.nan]
                continue
            low, high = np.nanargmin(piece), np.nanargmax(piece)
            result += [piece[min(low, high)], piece[max(low, high)]]
        return np.array(result)
    return shown, kept


def all_plots(columns):
    """The frames of all runs, those of the same title with the columns of all of them; and names of constant columns by
    section, which have none."""
    frames = {}
    for own in columns:
        for plot in plots(own):
            known = frames.setdefault((plot.section, plot.title, plot.unit), plot)
            known.columns += [name for name in plot.columns if name not in known.columns]

    def is_constant(plot):
        return all(np.ptp(own[name].values) == 0. for own in columns for name in plot.columns if name in own)

    constant = {section: [name for plot in frames.values() if plot.section == section and is_constant(plot)
                          for name in plot.columns] for section in SECTIONS}
    return [plot for plot in frames.values() if not is_constant(plot)], constant


def sweep(runs, columns):
    """Values of the runs over the entries in which they differ; None for a single run."""
    if len(runs) == 1:
        return None
    parameters = [{"name": path, "values": [run.case.get(path) for run in runs]}
                  for path in differing([run.case for run in runs])]
    # Entries that are numbers, and other ones in every run, first.
    parameters.sort(key=lambda parameter: (not all(is_number(value) for value in parameter["values"]),
                                           -len(set(parameter["values"]))))
    parameters.append({"name": "run", "values": [run.name for run in runs]})
    found = [measures(run, own) for run, own in zip(runs, columns)]
    keys = dict.fromkeys(key for values in found for key in values)
    finite = lambda value: None if value is None or not np.isfinite(value) else float(value)  # noqa: E731
    listed = [{"name": name, "unit": unit, "values": [finite(values.get((name, unit))) for values in found]}
              for name, unit in keys]
    first = next((i for i, measure in enumerate(listed) if measure["unit"] == "m"
                  and measure["name"].endswith("at the end")), 0)
    return {"parameters": parameters, "measures": listed, "first": first}


def is_number(text):
    try:
        return np.isfinite(float(text))
    except ValueError:
        return False


# ----------------------------------------------------------------------------------------------------------- page


def page(runs, columns, frames, constant, data, stored, arguments):
    title = arguments.title or ", ".join(run.name for run in runs)
    return filled("report.html", {
        "title": escape(title), "subtitle": escape(subtitle(runs)),
        "overview": report_sections.overview(runs, columns), "sweep": sweep_html(data["sweep"]),
        "flows": flows_html(runs),
        "sketches": sketches_html(runs), "materials": report_sections.materials(runs),
        "parameters": report_sections.parameters(runs),
        **{f"{name}_frames": frames_html(frames, name) + report_sections.constants(columns, constant[name]) for name
           in SECTIONS},
        "forces": report_sections.forces(runs, columns, arguments.window),
        "accounts": report_sections.accounts(runs, columns),
        "numerics": report_sections.numerics(runs), "messages": report_sections.messages(runs),
        "plane_note": (HERE / "plane_note.html").read_text(encoding="utf-8") if runs[0].is_plane else "",
    }, data, stored, SCRIPTS)


def filled(template, sections, data, stored, scripts):
    """The page with its sections, the data, the compressed blocks @p stored, and the scripts."""
    sections = {
        **sections, "style": (HERE / "report.css").read_text(encoding="utf-8"), "plotly": plotly_block(),
        "blocks": "\n".join(f'<script type="text/plain" id="{name}">{in_base64(content)}</script>' for name, content
                            in stored.items()),
        "data": json.dumps(data, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c"),
        "scripts": "\n".join((HERE / name).read_text(encoding="utf-8") for name in scripts),
    }
    parts = (HERE / template).read_text(encoding="utf-8").split("{{")
    return parts[0] + "".join(sections[name] + rest for name, rest in (part.split("}}", 1) for part in parts[1:]))


def subtitle(runs):
    kind = runs[0].case.geometry
    if len(runs) > 1:
        return f"{len(runs)} runs, {kind}"
    return f"{runs[0].state()} · {kind} · mesh size {short(runs[0].case.number('Mesh size'))} m"


def sweep_html(sweep_data):
    if sweep_data is None:
        return ""
    return ('<section id="comparison"><h2>Comparison</h2><div class="controls">'
            '<label>Value <select id="sweep-measure"></select></label>'
            '<label>over <select id="sweep-parameter"></select></label></div>'
            '<div id="sweep" class="frame wide"></div></section>')


def flows_html(runs):
    return "".join(
        '<figure class="flow">' + (f"<figcaption>{escape(run.name)}</figcaption>" if len(runs) > 1 else "")
        + f'<div id="flow-{r}"></div><p class="readout" id="readout-{r}">&nbsp;</p></figure>'
        for r, run in enumerate(runs))


def sketches_html(runs):
    """A sketch of every case: of runs with the same parts at the same places one."""
    seen, parts = {}, []
    for r, run in enumerate(runs):
        key = tuple((entry.path, entry.value) for entry in run.case.entries.values()
                    if entry.section[:1] in (("Fluids",), ("Boundaries",), ("Solids",)) and entry.section[2:]
                    and entry.section[2] == run.case.get(f"{entry.section[0]}/{entry.section[1]}/Shape"))
        seen.setdefault(key, []).append(r)
    for numbers in seen.values():
        caption = ", ".join(runs[r].name for r in numbers) if len(seen) > 1 else ""
        parts.append(f'<figure class="flow"><figcaption>{escape(caption)}</figcaption>'
                     f'<div class="sketch" data-run="{numbers[0]}"></div></figure>')
    return "".join(parts)


def frames_html(frames, section):
    parts = [f'<div class="frame"><h4>{escape(plot.title)}{f" <span>({escape(plot.unit)})</span>" if plot.unit else ""}'
             + (f" <em>{escape(plot.note)}</em>" if plot.note else "") + f'</h4><div data-plot="{i}"></div></div>'
             for i, plot in enumerate(frames) if plot.section == section]
    return '<div class="frames">' + "".join(parts) + "</div>" if parts else ""
