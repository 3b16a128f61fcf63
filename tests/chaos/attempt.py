# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of the program `lahar` on some ranks, and what chaos.py wants to know of its processes."""
import glob
import os
import re
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import on_ranks  # noqa: E402

FRAMES = ["Stacktrace", "An error occurred in line", "terminate called", "Backtrace", "Segmentation fault", "[ 0] ",
          "std::", "Lahar::", "dealii::", "Process received signal"]

MARK = "LAHAR_CHAOS"  # the environment variable by which the processes of an attempt are known


def status_word(text):
    """The state of a process in /proc."""
    return text.rsplit(")", 1)[1].split()[0]


def queue_delay(pid):
    """How long a process could have run, but had no processor, s."""
    try:
        with open("/proc/%d/schedstat" % pid) as file:
            return int(file.read().split()[1]) * 1e-9
    except (OSError, IndexError):
        return 0.


class Attempt:
    number = 0

    def __init__(self, lahar, mpiexec, directory, n_ranks, arguments):
        Attempt.number += 1
        self.directory, self.n_ranks, self.arguments = directory, n_ranks, arguments
        self.mark = "%s=%d-%d" % (MARK, os.getpid(), Attempt.number)
        command, environment = on_ranks([lahar, *arguments, "case.prm"], mpiexec, n_ranks)
        # Open MPI's single ranks share a directory that goes with the first one that ends.
        session = os.path.join(directory, "mpi")
        os.makedirs(session, exist_ok=True)
        environment = dict(environment, OMPI_MCA_orte_tmpdir_base=session, **dict([self.mark.split("=")]))
        self.begin = time.monotonic()
        self.process = subprocess.Popen(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True,
                                        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
        # Not a file of the attempt's own, which could not hold its message when files cannot grow.
        self.screen = os.path.join(directory, "screen")
        self.reader = threading.Thread(target=self.copy_output, args=(open(self.screen, "wb"),), daemon=True)
        self.reader.start()

    def copy_output(self, file):
        with file:
            while True:
                data = self.process.stdout.read1(65536)
                if not data:
                    return
                file.write(data)
                file.flush()

    def pids(self, of_ranks=True):
        """Of the ranks that run, or of all processes."""
        result = []
        for path in glob.glob("/proc/[0-9]*"):
            try:
                with open(path + "/environ", "rb") as file:
                    if self.mark.encode() not in file.read().split(b"\0"):
                        continue
                with open(path + "/stat") as file:
                    ended = status_word(file.read()) in "ZX"
                is_rank = os.path.basename(os.readlink(path + "/exe")) == "lahar"
                if not ended and (is_rank or not of_ranks):
                    result.append(int(os.path.basename(path)))
            except (OSError, IndexError):
                continue
        return sorted(result)

    def wait(self, seconds):
        """Whether it ends in that time."""
        try:
            self.process.wait(max(0., seconds))
            return True
        except subprocess.TimeoutExpired:
            return False

    def wait_patiently(self, seconds):
        """Whether it ends in that time, without what its ranks wait for a processor that others have; ten times as long
        at most."""
        begin, delays = time.monotonic(), {}
        while not self.wait(2.):
            for pid in self.pids():
                delays[pid] = queue_delay(pid)
            elapsed = time.monotonic() - begin
            if elapsed - max(delays.values(), default=0.) > seconds or elapsed > 10. * seconds:
                return False
        return True

    def wait_for_others(self, seconds):
        """Whether no process is left of it after that time."""
        end = time.monotonic() + seconds
        while self.pids(False):
            if time.monotonic() > end:
                return False
            time.sleep(0.05)
        return True

    def kill(self):
        for pid in self.pids(False):
            send(pid, signal.SIGKILL)
        self.process.wait()

    def text(self):
        if self.process.poll() is not None:
            self.reader.join(10.)  # until nothing is in the pipe
        with open(self.screen, errors="replace") as file:
            return file.read()

    def message(self):
        """The reasons that it gives for its end."""
        return "\n".join(re.findall("^lahar: .*$", self.text(), re.M))

    def frames(self):
        text = self.text()
        return [frame for frame in FRAMES if frame in text]

    def close(self):
        self.reader.join(10.)
        self.process.stdout.close()


def send(pid, number):
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass
