#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Disturb runs of the program `lahar` at random, for some time.

A trial is a random small case, run on one rank without disturbance, and again in parts that are disturbed
(disturbances.py), each on 1 to 4 ranks, the next one with --resume. Between the parts copies of the directory are
resumed with mutated input or a damaged checkpoint. In the end

* the statistics are those of the undisturbed run: bit for bit if all parts were on one rank, else to TOLERANCE of the
  largest value in each column,
* or a part has said no: with a status that is not 0, and a message.

A difference without a word, an attempt that does not end, a stack frame, and a status or a message that the disturbance
does not explain are failures: they are printed, and the trial's directory is kept.

Usage: chaos.py LAHAR MPIEXEC [--minutes M] [--seed S] [--ranks N] [--skip NAME]... [--keep DIRECTORY]
"""
import argparse
import collections
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "input"))

import disturbances  # noqa: E402
import mutations  # noqa: E402
from attempt import Attempt  # noqa: E402
from cases import Statistics, random_case  # noqa: E402

TOLERANCE = 1e-5
PATIENCE = 300.  # seconds that an attempt may take, beside what others take of the processors; undisturbed less than ten
GRACE = 60.      # seconds until no process is left of one that has ended


class Failure(Exception):
    pass


class Program:
    """What the program can do."""

    def __init__(self, lahar, mpiexec):
        self.lahar, self.mpiexec = lahar, mpiexec
        options = subprocess.run([lahar, "--help"], capture_output=True, text=True).stdout
        self.has_lock = self.has_overwrite = "--overwrite" in options

    def begin(self, directory):
        """The option with which a run goes on, or begins anew where it cannot."""
        if os.path.exists(os.path.join(directory, "out", "checkpoint", "state")):
            return ["--resume"]
        return ["--overwrite"] if self.has_overwrite else []


class Trial:
    def __init__(self, number, program, arguments, parent):
        self.number, self.program, self.arguments = number, program, arguments
        self.random = random.Random("%d-%d" % (arguments.seed, number))
        self.kind, self.text = random_case(self.random)
        self.directory = os.path.join(parent, "trial-%d" % number)
        self.alone = self.random.random() < 0.5
        self.history, self.outcomes, self.has_said_no = [], collections.Counter(), False
        for name in ("whole", "parts"):
            os.makedirs(os.path.join(self.directory, name))
            self.write_case(os.path.join(self.directory, name))

    def write_case(self, directory, text=None):
        with open(os.path.join(directory, "case.prm"), "wb") as file:
            file.write(text if text is not None else self.text.encode())

    def start(self, directory, n_ranks, options):
        attempt = Attempt(self.program.lahar, self.program.mpiexec, directory, n_ranks, options)
        attempt.lahar = self.program.lahar
        self.history.append("%s: %d ranks %s" % (os.path.basename(directory), n_ranks, " ".join(options)))
        return attempt

    def finish(self, attempt, disturbance):
        """Wait for the end. @return the status. @throws Failure"""
        try:
            if not attempt.wait_patiently(PATIENCE) or not attempt.wait_for_others(GRACE):
                raise Failure("hang: no end after '%s'" % disturbance.name)
            status = attempt.process.returncode
            self.history[-1] += ", %s: status %d %s" % (disturbance.name, status, attempt.message())
            if attempt.frames():
                raise Failure("frame: %s after '%s'" % (attempt.frames(), disturbance.name))
            complaint = disturbance.judge(attempt, status)
            if complaint:
                raise Failure("status or message: after '%s': %s" % (disturbance.name, complaint))
            return status
        finally:
            attempt.kill()
            attempt.close()

    def run(self):
        """@return counts of what was done. @throws Failure"""
        whole, parts = os.path.join(self.directory, "whole"), os.path.join(self.directory, "parts")
        nothing = disturbances.Nothing(self.random)
        attempt = self.start(whole, 1, [])
        self.finish(attempt, nothing)
        self.duration = time.monotonic() - attempt.begin

        for _ in range(self.random.randint(1, 5)):
            if self.disturb(parts):
                break
        else:
            while not self.disturb(parts, nothing):
                pass
        if self.has_said_no:
            self.outcomes["said no"] += 1
            return self.outcomes
        if not os.path.exists(os.path.join(parts, "out")):
            self.outcomes["removed as a whole after the last step"] += 1  # there is nothing that could be taken for a result
            return self.outcomes
        expected, found = Statistics(whole), Statistics(parts)
        if self.alone:
            difference = expected.difference(found)
        else:
            distance, column = expected.distance(found)
            difference = "%s differs by %g" % (column, distance) if distance > TOLERANCE else ""
        if difference:
            raise Failure("silent difference: " + difference)
        self.outcomes["the same"] += 1
        return self.outcomes

    def disturb(self, directory, disturbance=None):
        """One part. @return whether it was the last one."""
        if disturbance is None:
            kinds = [kind for kind in disturbances.ALL
                     if kind.enabled(self.program) and kind.name not in self.arguments.skip]
            disturbance = self.random.choice(kinds)(self.random)
        n_ranks = 1 if self.alone else self.random.randint(1, self.arguments.ranks)
        options = self.program.begin(directory)
        attempt = self.start(directory, n_ranks, options)
        end = time.monotonic() + PATIENCE
        while disturbance.after_start and disturbances.BEGUN not in attempt.text() and time.monotonic() < end:
            if attempt.wait(0.02):
                break
        if attempt.wait(self.random.random() * self.duration * (0.8 if disturbance.after_start else 1.2)):
            disturbance = disturbances.Nothing(self.random)  # too late
        else:
            disturbance.strike(attempt)
        self.outcomes[disturbance.name] += 1
        was_removed = any("files removed" in line for line in self.history)
        status = self.finish(attempt, disturbance)
        if status == 2 and was_removed:  # no way to go on, and it says so
            self.has_said_no = True
            return True
        if status == 2:
            raise Failure("status or message: refused after '%s': %s" % (disturbance.name, attempt.message()))
        if status == 0 and "stopped after step" not in attempt.text():
            return True
        self.resume_copy(directory)
        return False

    def resume_copy(self, directory):
        """Resume a copy with wrong input or a damaged checkpoint."""
        state = os.path.join("out", "checkpoint", "state")
        if self.random.random() < 0.5 or not os.path.exists(os.path.join(directory, state)):
            return
        copy = os.path.join(self.directory, "copy")
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(directory, copy, ignore=shutil.ignore_patterns("mpi"))  # sessions of mpirun's
        damaged = self.random.random() < 0.5
        if damaged:
            files = [path for path in pathlib.Path(copy, "out", "checkpoint").iterdir() if path.is_file()]
            path = self.random.choice([path for path in files if ".part" not in path.name])
            data = bytearray(path.read_bytes())
            place = self.random.randrange(len(data))
            data[place] ^= 1 << self.random.randrange(8)
            path.write_bytes(data)
        else:
            self.write_case(copy, self.mutate(self.text.encode()))
        attempt = self.start(copy, 1 if self.alone else self.random.randint(1, self.arguments.ranks),
                             ["--resume"] if damaged else ["--resume", "--check"])
        disturbance = disturbances.Disturbance(self.random)
        disturbance.name = "damaged checkpoint" if damaged else "mutated input"
        self.outcomes[disturbance.name] += 1
        if self.finish(attempt, disturbance) == 0 and damaged:
            raise Failure("silent difference: a damaged checkpoint is resumed")

    def mutate(self, text):
        lines = text.split(b"\n")
        words = sorted({match.encode() for match in mutations.WORD.findall(text.decode())})
        random.seed(self.random.random())  # of mutations.py
        return mutations.Mutator(words, lines).mutate(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lahar", type=os.path.abspath)
    parser.add_argument("mpiexec")
    parser.add_argument("--minutes", type=float, default=60., help="after which no trial begins (%(default)g)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (%(default)s)")
    parser.add_argument("--first", type=int, default=1, help="number of the first trial (%(default)s)")
    parser.add_argument("--ranks", type=int, default=4, help="at most (%(default)s)")
    parser.add_argument("--skip", action="append", default=[], help="a disturbance by its name; repeatable")
    parser.add_argument("--keep", help="where directories of failed trials are kept (a temporary directory)")
    arguments = parser.parse_args()
    parent = arguments.keep or tempfile.mkdtemp(prefix="chaos-")
    os.makedirs(parent, exist_ok=True)
    program = Program(arguments.lahar, arguments.mpiexec)

    end, number = time.monotonic() + 60. * arguments.minutes, arguments.first
    counts, failures = collections.Counter(), collections.Counter()
    while time.monotonic() < end:
        trial = Trial(number, program, arguments, parent)
        try:
            counts += trial.run()
            shutil.rmtree(trial.directory)
        except Failure as failure:
            counts += trial.outcomes
            failures[str(failure).split(":", 1)[0]] += 1
            print("FAILED: seed %d, trial %d (%s, %s): %s\n    kept: %s\n    %s" % (
                arguments.seed, number, trial.kind, "one rank" if trial.alone else "ranks", failure, trial.directory,
                "\n    ".join(trial.history)), flush=True)
        number += 1
    print("%d trials, seed %d: %s" % (number - arguments.first, arguments.seed,
                                      ", ".join("%d %s" % (count, name) for name, count in counts.most_common())))
    print("%d failed%s" % (sum(failures.values()), "".join(", %d %s" % (count, name)
                                                           for name, count in failures.most_common())))
    if not failures and not arguments.keep:
        shutil.rmtree(parent)
    sys.exit(1 if failures or not counts["the same"] else 0)


main()
