# SPDX-License-Identifier: GPL-3.0-or-later
"""A run as its output directory tells it: parameters, statistics, snapshots, and what the log says."""

import os
import pathlib
import re
import socket
from dataclasses import dataclass, field

import numpy as np

from case_parameters import CaseParameters
from html_tables import seconds
from lahar_output import OutputError, read_pvd, read_statistics, read_text

TIME, STEP_SIZE = "Time (s)", "Time step size (s)"
PARTS = {"fluid": 0, "solid": 1}
LONGEST_MESSAGE = 600  # characters


@dataclass
class Log:
    """What the log says besides the lines of the steps."""

    warnings: list = field(default_factory=list)
    repeated: list = field(default_factory=list)  # steps that were repeated, why
    failure: str = ""
    stop: str = ""
    n_resumed: int = 0
    phases: dict = field(default_factory=dict)    # wall time in s by name, summed over resumed runs


@dataclass
class Run:
    directory: pathlib.Path
    name: str
    case: CaseParameters
    statistics: dict
    snapshots: dict  # by part a list of (time, path)
    log: Log
    lock: str  # "": none; "held" by a process that goes on; "left" by one that was killed; "elsewhere": nobody knows

    @property
    def dimension(self):
        return self.case.dimension

    @property
    def is_plane(self):
        return self.case.geometry == "plane strain"

    @property
    def time(self):
        return self.statistics[TIME]

    @property
    def step_sizes(self):
        return self.statistics[STEP_SIZE]

    def state(self):
        """How the run ended, in words."""
        end = self.case.number("End time")
        reached = f"{self.time[-1]:.6g} of {end:.6g} s"
        if self.lock == "held":
            return f"goes on, {reached}{self.time_left()}"
        if self.lock == "left":
            return f"was killed at {reached}"
        if self.lock:
            return f"unfinished (its lock is there: it goes on, or was killed), {reached}"
        if self.log.failure:
            return f"failed at {reached}"
        if self.time[-1] < end - 1e-9 * max(abs(end), 1.):
            return f"stopped at {reached}"
        return f"finished, {end:.6g} s"

    def time_left(self):
        """How long a run that goes on takes if it goes on as fast as so far."""
        start, end = self.case.number("Start time"), self.case.number("End time")
        walls = self.statistics.get("Wall time (s)")
        if walls is None or walls.dtype.kind != "f" or not start < self.time[-1] < end:
            return ""
        share = (self.time[-1] - start) / (end - start)
        return f", {100. * share:.0f} %, about {seconds(walls[-1] * (1. - share) / share)} left"


def read_runs(arguments):
    """The runs that the arguments OUTPUT or OUTPUT=NAME name; all of one dimension."""
    runs = []
    for argument in arguments:
        runs.append(read_run(*split_argument(argument)))
    if len({run.dimension for run in runs}) > 1:
        raise OutputError("; ".join(f"{run.directory}: 'Dimension' is {run.dimension}" for run in runs)
                          + "; allowed: runs of one dimension in a report")
    # Without a name a run is called by its directory, or by the whole path where two directories have one name.
    folders = [run.directory.resolve().name for run in runs]
    for run, folder in zip(runs, folders):
        run.name = run.name or (folder if folders.count(folder) == 1 else str(run.directory))
    for i, run in enumerate(runs):
        if run.name in [other.name for other in runs[:i]]:
            raise OutputError(f"{run.directory}: two runs are called '{run.name}'; allowed: different names, as "
                              "OUTPUT=NAME")
    return runs


def split_argument(argument):
    """The directory and the name in OUTPUT or OUTPUT=NAME."""
    directory, _, name = argument.partition("=")
    if not pathlib.Path(directory).is_dir() and pathlib.Path(argument).is_dir():
        directory, name = argument, ""
    return pathlib.Path(directory), name


def read_run(directory, name):
    if not directory.is_dir():
        raise OutputError(f"{directory}: no such directory; allowed: the output directory of a run")
    if not (directory / "parameters.prm").is_file():
        raise OutputError(f"{directory}: no parameters.prm in it; allowed: the output directory of a run")
    case = CaseParameters(directory / "parameters.prm")
    statistics = read_run_statistics(directory / "statistics")
    snapshots = read_snapshots(directory / "solution.pvd")
    log = directory / "log"
    return Run(directory, name, case, statistics, snapshots, parse_log(read_text(log)) if log.is_file() else Log(),
               lock_of(directory))


def lock_of(directory):
    """Whether a run goes on in a directory, see Run.lock."""
    try:
        text = (directory / "lock").read_text()
    except OSError:
        return ""
    holder = re.match(r"host (\S+)\s+process (\d+)\s+since ", text)
    if not holder or holder[1] != socket.gethostname():
        return "elsewhere"
    try:
        os.kill(int(holder[2]), 0)
    except ProcessLookupError:
        return "left"
    except OSError:
        pass  # a process of somebody else
    return "held"


def read_run_statistics(path):
    """The statistics of at least one step, with the times in order."""
    if path.is_file() and not read_text(path).strip():
        raise OutputError(f"{path}: no time step yet; allowed: a run of one step or more")
    statistics = read_statistics(path)
    for name in (TIME, STEP_SIZE):
        if name not in statistics or statistics[name].dtype.kind != "f":
            raise OutputError(f"{path}: no column '{name}' of numbers; allowed: the statistics that a run has written")
    if len(statistics[TIME]) == 0:
        raise OutputError(f"{path}: no time step yet; allowed: a run of one step or more")
    if not (np.diff(statistics[TIME]) > 0.).all():
        raise OutputError(f"{path}: the times do not increase; allowed: the statistics of one run")
    return statistics


def read_snapshots(path):
    """The snapshots by part: those of the fluid, or of solids where there are no fluids."""
    snapshots = {part: read_pvd(path, number) for part, number in PARTS.items()}
    if not any(snapshots.values()):
        raise OutputError(f"{path}: no snapshot; allowed: a run with one snapshot or more")
    return snapshots


def parse_log(text):
    log = Log()
    in_phases = False
    for line in text.splitlines():
        phase = re.match(r"  (.*?)\s+([0-9.]+) s\s+\S+ us per cell and step", line)
        if line.startswith("Times by phase"):
            in_phases = True
        elif in_phases and phase:
            if phase[1] != "All":
                log.phases[phase[1]] = log.phases.get(phase[1], 0.) + float(phase[2])
        else:
            in_phases = False
            read_line(log, line)
    return log


def read_line(log, line):
    text = line if len(line) <= LONGEST_MESSAGE else line[:LONGEST_MESSAGE] + " ..."
    if line.startswith("Warning: "):
        log.warnings.append(text[len("Warning: "):])
    elif line.endswith("; repeated with half the step"):
        log.repeated.append(text)
    elif line.startswith("The run failed. "):
        log.failure = text[len("The run failed. "):]
    elif ": stopped after step " in line:
        log.stop = text
    elif line.startswith("Resumed after step "):
        log.n_resumed += 1
        log.failure = log.stop = ""
