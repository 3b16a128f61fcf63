# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a start, which lahar --write-start has written: what the first mesh is and what the run will take, a
picture of fluid, boundaries and solids with their names, and the entries."""

import pathlib
import re

import report_sections
from case_parameters import CaseParameters
from flow_data import Encoder, read_flow, view_box
from html_tables import escape, items
from lahar_output import OutputError, read_text
from report_page import filled, flow_data, sketches_html, write_atomically
from run_record import Log, Run, read_snapshots
from wall_data import Walls

SCRIPTS = ("data.js", "page.js", "flow_plane.js", "flow_space.js", "sketch.js", "start.js")
REACH = 2.  # of the fluid's size: so far walls are shown beside it


def is_start(directory):
    """Whether there is a start and no run: a run has a lock while it goes on, statistics from its first step on, and the
    lines of its steps if it had them."""
    return ((directory / "parameters.prm").is_file() and (directory / "log").is_file()
            and not (directory / "lock").exists() and not (directory / "statistics").exists()
            and not re.search("^step ", read_text(directory / "log"), re.M))


def write_start_page(argument, arguments):
    """Writes the page of the start in the directory OUTPUT or OUTPUT=NAME to the file arguments.output."""
    directory, name = argument
    run = Run(directory, name or pathlib.Path(directory).resolve().name, CaseParameters(directory / "parameters.prm"), {},
              read_snapshots(directory / "solution.pvd"), Log(), "")
    flow = read_flow(run, 2)
    if not flow.surfaces():
        raise OutputError(f"{directory}/solution.pvd: the snapshot has no cell; allowed: a case with some at its start")
    walls = Walls(run, flow)
    box = view_box(flow, walls.corners(), REACH)
    encoder = Encoder(flow, walls, {})
    head, block = encoder.blocks()[0]
    data = {"dimension": run.dimension,
            "run": flow_data(run, flow, encoder, walls, box, [{**head, "id": "snapshot-0-0"}])}
    kind = run.case.geometry
    write_atomically(arguments.output, filled("start.html", {
        "title": escape(arguments.title or run.name), "subtitle": f"the start, {kind}", "sizes": sizes(directory / "log"),
        "sketch": sketches_html([run]), "materials": report_sections.materials([run]),
        "parameters": report_sections.parameters([run]),
    }, data, {"snapshot-0-0": block}, SCRIPTS))
    print(f"Wrote {arguments.output} ({arguments.output.stat().st_size / 1e6:.1f} MB, the start)")


def sizes(path):
    """What lahar says of the start: lines 'name   value', and warnings."""
    facts, warnings = [], []
    for line in filter(None, read_text(path).splitlines()):
        found = re.match(r"(\S.*?) {2,}(\S.*)", line)
        if found and not line.startswith("Warning"):
            facts.append(f"<div><dt>{escape(found[1])}</dt><dd>{escape(found[2])}</dd></div>")
        else:
            warnings.append(line)
    return '<dl class="facts">' + "".join(facts) + "</dl>" + (items(warnings) if warnings else "")
