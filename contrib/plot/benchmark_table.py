# SPDX-License-Identifier: GPL-3.0-or-later
"""What the reports of the benchmarks share: which runs can be reported, and tables in Markdown."""

import numpy as np

VOLUME_CHANGES = ("Volume change by solver", "Volume change by remeshing")


def divide(all_results, case):
    """The runs that can be reported and the others; a message if there is none of the first."""
    usable = [results for results in all_results if results.is_usable]
    if not usable:
        print(f"{case}: no run to report")
    return usable, [results for results in all_results if not results.is_usable]


def worst_changes(results):
    """The largest cumulative volume changes by solver and remeshing, as texts."""
    changes = [results.column(name) for name in VOLUME_CHANGES]
    percents = [100 * change[np.abs(change).argmax()] for change in changes]
    return [f"{value:+.2f} %" if abs(value) >= 0.01 else f"{value:+.0e} %" for value in percents]


def state_if_unfinished(results):
    return "" if results.is_finished else f" ({results.state})"


def write_table(header, rows, remarks, usable, missing, path):
    """Write a table of texts with @p remarks, the revisions of the runs @p usable, and the runs that are @p missing."""
    revisions = ", ".join(sorted({results.record["revision"] for results in usable}))
    lines = ["<!-- Written by contrib/benchmarks; do not edit. -->", "",
             "| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    lines += ["", f"{remarks} Revision: {revisions}.", ""]
    if missing:
        lines += ["Not in the table: " + "; ".join(f"`{results.run.name}` ({results.state})" for results in missing) + ".", ""]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines))
    print(f"Wrote {path}")
