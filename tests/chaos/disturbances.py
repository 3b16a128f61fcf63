# SPDX-License-Identifier: GPL-3.0-or-later
"""What chaos.py does to a run. A disturbance is a class with

    name        for the summary
    after_start whether it waits until the run has begun to compute
    strike()    disturbs an attempt that runs
    judge()     what is wrong with how the attempt has ended, or None

A new one is added to ALL; `enabled(program)` says whether the program can do what it asks for.
"""
import glob
import os
import resource
import shutil
import signal
import subprocess
import time

from attempt import send
from program_test import on_ranks

BEGUN = "Fluid particles"  # what a run prints when it begins to compute


def left_in_part(directory):
    return glob.glob(os.path.join(directory, "out", "**", "*.part*"), recursive=True)


class Disturbance:
    after_start = False

    def __init__(self, random):
        self.random = random

    @staticmethod
    def enabled(program):
        return True

    def strike(self, attempt):
        pass

    def judge(self, attempt, status):
        """A run ends with status 0, or with another one and a message."""
        if status not in (0, 1, 2):
            return "status %s" % status
        if status != 0 and not attempt.message():
            return "status %d without a message" % status
        return None


class Nothing(Disturbance):
    name = "nothing"

    def judge(self, attempt, status):
        return super().judge(attempt, status) or (
            "status %d though nothing was done: %s" % (status, attempt.message()) if status != 0 else None)


class Pause(Nothing):
    name = "stop and continue"

    def strike(self, attempt):
        ranks = attempt.pids()
        ranks = ranks if self.random.random() < 0.3 else self.random.sample(ranks, min(1, len(ranks)))
        for pid in ranks:
            send(pid, signal.SIGSTOP)
        time.sleep(self.random.uniform(0.1, 2.))
        for pid in ranks:
            send(pid, signal.SIGCONT)


class Kill(Disturbance):
    name = "kill -9"

    def strike(self, attempt):
        which = self.random.choice(["a rank", "the launcher", "all"])
        pids = {"a rank": attempt.pids(), "the launcher": [attempt.process.pid], "all": attempt.pids(False)}[which]
        for pid in pids if which == "all" else self.random.sample(pids, min(1, len(pids))):
            send(pid, signal.SIGKILL)

    def judge(self, attempt, status):
        return None


class StopSignal(Disturbance):
    name = "signal to a rank"
    after_start = True

    def strike(self, attempt):
        self.signal = self.random.choice(["TERM", "INT", "HUP", "USR1", "USR2", "XCPU"])
        for pid in self.random.sample(attempt.pids(), min(1, len(attempt.pids()))):
            send(pid, getattr(signal, "SIG" + self.signal))

    def judge(self, attempt, status):
        stopped = "stopped after step" in attempt.text()
        if stopped and "SIG" + self.signal + ": stopped" not in attempt.text():
            return "another signal's name than SIG" + self.signal
        return "status %d after SIG%s" % (status, self.signal) if status != 0 else None


class SignalToLauncher(Disturbance):
    """mpirun hands SIGUSR1 and SIGUSR2 on, and kills its ranks a moment after the others."""
    name = "signal to mpirun"
    after_start = True

    def strike(self, attempt):
        self.signal = self.random.choice(["TERM", "INT", "HUP", "USR1", "USR2"])
        send(attempt.process.pid, getattr(signal, "SIG" + self.signal))

    def judge(self, attempt, status):
        if self.signal.startswith("USR") or attempt.n_ranks == 1:
            return "status %d after SIG%s" % (status, self.signal) if status != 0 else None
        return None


class TwoSignals(Disturbance):
    name = "two signals"

    def strike(self, attempt):
        for pause in (self.random.uniform(0., 0.1), 0.):
            for pid in attempt.pids():
                send(pid, signal.SIGTERM)
            time.sleep(pause)

    def judge(self, attempt, status):
        return None


class FullDisk(Disturbance):
    """Files cannot grow beyond a size, on one rank or all."""
    name = "full disk"
    after_start = True

    def strike(self, attempt):
        size = self.random.choice([0, 1000, 5000, 20000, 50000])
        pids = attempt.pids()
        for pid in pids if self.random.random() < 0.5 else self.random.sample(pids, min(1, len(pids))):
            try:
                resource.prlimit(pid, resource.RLIMIT_FSIZE, (size, size))
            except ProcessLookupError:
                pass

    def judge(self, attempt, status):
        complaint = super().judge(attempt, status)
        if complaint or status == 0:
            return complaint
        if "Cannot write" not in attempt.message():
            return "a message that does not say what cannot be written: " + attempt.message()
        return "a file in part" if left_in_part(attempt.directory) else None


class NoMemory(Disturbance):
    """One rank or all get little more memory."""
    name = "no memory"
    after_start = True

    def strike(self, attempt):
        pids = attempt.pids()
        for pid in pids if self.random.random() < 0.5 else self.random.sample(pids, min(1, len(pids))):
            try:
                with open("/proc/%d/statm" % pid) as file:
                    used = int(file.read().split()[0]) * resource.getpagesize()
                limit = used + self.random.choice([0, 0, 1, 10, 50]) * 2**20
                resource.prlimit(pid, resource.RLIMIT_AS, (limit, limit))
            except (OSError, IndexError):
                pass


class Removed(Disturbance):
    """Files of the output directory, or all of it, are removed while the run goes on."""
    name = "files removed"
    after_start = True

    def strike(self, attempt):
        out = os.path.join(attempt.directory, "out")
        if self.random.random() < 0.1:
            shutil.rmtree(out, ignore_errors=True)
            return
        files = [path for path in glob.glob(os.path.join(out, "**", "*"), recursive=True) if os.path.isfile(path)]
        for path in self.random.sample(files, min(self.random.choice([1, 1, 3]), len(files))):
            try:
                os.remove(path)
            except OSError:
                pass


class SecondRun(Nothing):
    """Another run wants the same directory: it is refused, and the first one notices nothing."""
    name = "second run"
    after_start = True

    @staticmethod
    def enabled(program):
        return program.has_lock

    def strike(self, attempt):
        command, environment = on_ranks([attempt.lahar, "--resume", "case.prm"], "", 1)
        second = subprocess.run(command, cwd=attempt.directory, env=environment, stdin=subprocess.DEVNULL,
                                capture_output=True, text=True, timeout=300)
        # The first one may have ended meanwhile.
        self.complaint = ("a second run ended with status %d" % second.returncode
                          if second.returncode != 2 and attempt.process.poll() is None else None)

    def judge(self, attempt, status):
        return super().judge(attempt, status) or self.complaint


ALL = [Nothing, Pause, Kill, StopSignal, SignalToLauncher, TwoSignals, FullDisk, NoMemory, Removed, SecondRun]
