# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of one case with different settings, several side by side; what is finished is not run again."""

import hashlib
import json
import os
import pathlib
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from lahar_output import OutputError, column, read_parameter, read_statistics, read_text

RECORD = "sweep.json"
SCREEN = "screen"


def digest(case):
    """A number for what stands in a parameter file and in those that it includes."""
    texts, left, seen = [], [pathlib.Path(case)], set()
    while left:
        path = left.pop(0)
        if path in seen:
            continue
        seen.add(path)
        texts.append(read_text(path))
        included = [line.split(None, 1)[1].strip() for line in texts[-1].splitlines()
                    if line.split()[:1] == ["include"] and len(line.split()) > 1]
        left += [pathlib.Path(name) for name in included if pathlib.Path(name).is_file()]
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()


@dataclass
class Run:
    """The run of one value. Its record says with which settings it was begun, and its exit status once it has ended."""

    value: str
    directory: pathlib.Path
    case: pathlib.Path
    case_digest: str
    settings: list

    @property
    def record(self):
        """What is written about a run of the same case and settings; None without one."""
        try:
            record = json.loads((self.directory / RECORD).read_text())
        except (OSError, ValueError):
            return None
        is_same = isinstance(record, dict) and all(record.get(key) == value for key, value in self.identity().items())
        return record if is_same else None

    def identity(self):
        return {"case": self.case_digest, "settings": self.settings}

    def write_record(self, **more):
        temporary = self.directory / (RECORD + ".tmp")
        temporary.write_text(json.dumps({**self.identity(), **more}, indent=1) + "\n")
        temporary.replace(self.directory / RECORD)

    @property
    def status(self):
        """The exit status; None if the run was not there or has not ended."""
        return (self.record or {}).get("exit status")

    @property
    def is_finished(self):
        return self.status == 0 and self.has_reached_end

    @property
    def has_reached_end(self):
        """A run that a signal stops before ends with status 0, too."""
        try:
            end = float(read_parameter(self.directory / "parameters.prm", [], "End time"))
            return column(self.statistics, "Time (s)", self.statistics_path)[-1] > end * (1 - 1e-9)
        except (OutputError, ValueError, IndexError):
            return False

    @property
    def can_resume(self):
        return self.record is not None and self.status is None and (self.directory / "checkpoint" / "state").is_file()

    @property
    def statistics_path(self):
        return self.directory / "statistics"

    @property
    def statistics(self):
        return read_statistics(self.statistics_path)

    @property
    def message(self):
        """The last line on the screen."""
        try:
            lines = (self.directory / SCREEN).read_text(errors="replace").strip().splitlines()
        except OSError:
            lines = []
        return lines[-1] if lines else f"exit status {self.status}"


class Runner:
    """Runs lahar for several values side by side, one thread a run."""

    def __init__(self, lahar, n_jobs):
        self.lahar, self.n_jobs = lahar.resolve(), n_jobs
        self.processes, self.lock, self.is_stopped = set(), threading.Lock(), False

    def run_all(self, runs):
        with ThreadPoolExecutor(self.n_jobs) as pool:
            try:
                list(pool.map(self.run, runs))
            except KeyboardInterrupt:
                self.stop(pool)
                raise OutputError("interrupted; the same command goes on") from None
            except BaseException:
                self.stop(pool)
                raise

    def stop(self, pool):
        with self.lock:
            self.is_stopped = True
            for process in self.processes:
                process.terminate()
        pool.shutdown(cancel_futures=True)

    def run(self, run):
        if run.is_finished:
            print(f"{run.value}: finished already", flush=True)
            return
        is_resumed = run.can_resume
        run.directory.mkdir(parents=True, exist_ok=True)
        run.write_record()
        command = [str(self.lahar), "--set", f"Output directory={run.directory.resolve()}"]
        for setting in run.settings:
            command += ["--set", setting]
        command += ["--resume" if is_resumed else "--overwrite", str(run.case)]
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1"}
        with open(run.directory / SCREEN, "w") as screen:
            with self.lock:
                if self.is_stopped:
                    return
                process = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=screen,
                                           stderr=subprocess.STDOUT)
                self.processes.add(process)
            print(f"{run.value}: {'goes on' if is_resumed else 'started'}", flush=True)
            status = process.wait()
            with self.lock:
                self.processes.discard(process)
        if self.is_stopped:
            return
        if status == 0 and not run.has_reached_end:
            print(f"{run.value}: stopped before its end: {run.message}", flush=True)
            return
        run.write_record(**{"exit status": status})
        if status == 0:
            print(f"{run.value}: finished", flush=True)
        else:
            print(f"{run.value}: FAILED with exit status {status}: {run.message}", flush=True)
