#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a case once for each value of one entry, and write a table and plots of the results over the value.

    sweep.py prm/quickstart.prm "Fluids/fluid/Bingham/Yield stress" 25 50 100 --lahar build/lahar --jobs 2 -o sweep
    sweep.py case.prm "Mesh size" 0.02 0.01 --lahar build/lahar --set "End time=0.5" --column "front (m)" -o meshes

DIRECTORY/VALUE is the output directory of each run, DIRECTORY/sweep.csv the table. A run that is finished is not run
again if case and settings are the same, one that was interrupted goes on from its checkpoint, any other begins anew;
one that fails does not stop the others. Exit status: 0; 1 if a run failed; 2 for wrong input.
"""

import argparse
import os
import pathlib
import re
import sys

from lahar_output import OutputError, run_script
from sweep_runs import Run, Runner, digest
from sweep_table import quantities, print_table, write_plots, write_table


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", type=pathlib.Path, metavar="CASE.prm", help="the case")
    parser.add_argument("entry", metavar="ENTRY", 
                        help="the entry that differs, such as 'Fluids/mud/Bingham/Yield stress'")
    parser.add_argument("values", nargs="+", metavar="VALUE", help="its values, one for each run")
    parser.add_argument("--lahar", type=pathlib.Path, required=True, metavar="PROGRAM", help="the program")
    parser.add_argument("--jobs", type=int, default=1, help="runs side by side (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="ENTRY=VALUE", help="another entry, for all runs")
    parser.add_argument("--column", action="append", default=[], metavar="NAME",
                        help="a column of the statistics for table and plots (default: change of volume, iterations, "
                             "wall time, and all columns of lengths and forces)")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="DIRECTORY",
                        help="for runs, table and plots")
    return parser.parse_args()


def entry_of(setting):
    return "/".join(word.strip() for word in setting.partition("=")[0].split("/"))


def check_arguments(arguments):
    if not arguments.case.is_file():
        raise OutputError(f"{arguments.case}: no such file")
    if not os.access(arguments.lahar, os.X_OK) or arguments.lahar.is_dir():
        raise OutputError(f"no program {arguments.lahar}")
    if arguments.jobs < 1:
        raise OutputError(f"--jobs must be 1 or more, not {arguments.jobs}")
    if not arguments.entry.strip() or "=" in arguments.entry:
        raise OutputError(f"the entry must read 'Section/Entry', not '{arguments.entry}'")
    entries = [entry_of(arguments.entry)] + [entry_of(setting) for setting in arguments.set]
    for setting in arguments.set:
        if "=" not in setting:
            raise OutputError(f"--set must read 'Section/Entry=value', not '{setting}'")
    for entry in entries:
        if entry == "Output directory":
            raise OutputError(f"'{entry}' cannot be set: every value has a directory of its own in {arguments.output}")
    if entries[0] in entries[1:]:
        raise OutputError(f"--set: '{entries[0]}' is the entry whose values differ")


def directory_names(values):
    """A name for a directory from each value; different for different values."""
    names = {}
    for value in values:
        name = re.sub(r"[^\w.+-]+", "_", value.strip())
        name = "_" + name if not name or name.startswith(".") else name
        if name in names:
            raise OutputError(f"the values '{names[name]}' and '{value}' would have the same directory, {name}")
        names[name] = value
    return list(names)


def main():
    arguments = parse_arguments()
    check_arguments(arguments)
    case_digest = digest(arguments.case)
    runs = [Run(value, arguments.output / name, arguments.case, case_digest,
                [*arguments.set, f"{arguments.entry}={value}"])
            for value, name in zip(arguments.values, directory_names(arguments.values))]
    Runner(arguments.lahar, arguments.jobs).run_all(runs)
    finished = [run for run in runs if run.is_finished]
    failed = [run for run in runs if not run.is_finished]
    if failed and all(run.status == 2 for run in runs):
        raise OutputError(f"{arguments.case}: no value of '{arguments.entry}' is right; {failed[0].value}: "
                          f"{failed[0].message}")
    chosen = quantities(finished, arguments.column)
    print_table(arguments.entry, runs, chosen)
    write_table(arguments.entry, runs, chosen, arguments.output / "sweep.csv")
    write_plots(arguments.entry, finished, chosen, arguments.output)
    if failed:
        print(f"{len(failed)} of {len(runs)} runs failed or stopped: {', '.join(run.value for run in failed)}")
        sys.exit(1)


if __name__ == "__main__":
    run_script(main)
