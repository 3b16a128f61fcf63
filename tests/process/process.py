#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test the program `lahar` as a process among others, each run in a directory of its own.

signals:  every signal that asks for a stop is named and leaves a checkpoint; a step that would go on for long is given up
          between two nonlinear iterations; what is resumed leaves the statistics of a run that is not stopped, bit for bit.
          SIGHUP is ignored under nohup.
output:   the standard output has gone, is closed or full.
input:    parameter files from pipes, on one rank and on two; endless and huge ones are refused.
memory:   limits of the address space, from too little for the libraries to too little for the case.
full:     on three ranks files cannot grow, on all of them or on one.
alone:    one rank of two runs out of memory in the middle of a run, or crashes: the log tells it.
launcher: SIGUSR1 to mpirun stops the ranks; after SIGINT, which kills them, a checkpoint is there.

Usage: process.py GROUP LAHAR MPIEXEC
"""
import glob
import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, ROOT)
sys.path.insert(0, os.path.join(ROOT, "chaos"))

from attempt import Attempt, send  # noqa: E402
from cases import Statistics  # noqa: E402
from program_test import ALONE, check, failed, fluid, new_case, on_ranks, section, walls  # noqa: E402

LAHAR, MPIEXEC = os.path.abspath(sys.argv[2]), sys.argv[3]
PATIENCE = 300.  # s, on a busy machine

CASE = """
set Output directory = out
set End time         = 0.04
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 0
subsection Checkpoint
  set Minutes between = 0
end
""" + fluid("0, 0 : 0.146, 0.292", section("Bingham", "set Yield stress = 20")) + walls("0, 0.4 : 0, 0 : 0.5, 0")

# Appended to a case for several ranks: rounding is all that may differ.
TIGHT = """
subsection Nonlinear solver
  set Tolerance = 1e-8
end
subsection Linear solver
  subsection Direct
    set Tolerance = 1e-8
  end
end
"""

# A step that does not end for a thousand iterations.
ENDLESS = ["--set", "Nonlinear solver/Tolerance=1e-300", "--set", "Nonlinear solver/Maximum iterations=1000"]


def start(directory, n_ranks, *options):
    return Attempt(LAHAR, MPIEXEC, directory, n_ranks, list(options))


def wait_for(attempt, condition):
    """Wait until the condition holds or the attempt has ended. @return whether it runs."""
    end = time.monotonic() + PATIENCE
    while not attempt.wait(0.02) and time.monotonic() < end:
        if condition():
            return True
    return False


def n_rows(directory):
    return len(Statistics(directory).rows)


def end_of(attempt, what, status, *words):
    """The attempt must end with that status and say these words, without frames. @return what it printed."""
    ended = attempt.wait(PATIENCE)
    text, frames = attempt.text(), attempt.frames()
    attempt.kill()
    attempt.close()
    check(what + ": it ends", ended, text)
    check("%s: status %s" % (what, status), attempt.process.returncode == status, attempt.process.returncode, text)
    missing = [word for word in words if word not in text]
    check(what + ": the message", not missing, "missing: %s" % missing, text)
    check(what + ": no frames", not frames, frames, text)
    return text


def run(directory, *options, n_ranks=1, **keywords):
    command, environment = on_ranks([LAHAR, *options], MPIEXEC, n_ranks)
    return subprocess.run(command, cwd=directory, env=environment, capture_output=True, text=True, timeout=PATIENCE,
                          **keywords)


def signals(parent):
    whole, stopped = (new_case(parent, name, CASE) for name in ("whole", "stopped"))
    end_of(start(whole, 1), "whole", 0)
    for number, name in enumerate(["HUP", "USR1", "USR2", "XCPU", "TERM"]):
        before = n_rows(stopped)
        attempt = start(stopped, 1, *(["--resume"] if number else []))
        wait_for(attempt, lambda: n_rows(stopped) >= before + 2)
        attempt.process.send_signal(getattr(signal, "SIG" + name))
        end_of(attempt, "SIG" + name, 0, "SIG" + name + ": stopped after step")
    before = n_rows(stopped)
    check("steps are left", 10 <= before < len(Statistics(whole).rows), before)
    for name in ("INT", "USR1"):
        attempt = start(stopped, 1, "--resume", *ENDLESS)
        wait_for(attempt, lambda: "Resumed after" in attempt.text())
        time.sleep(1.)  # into the step; were it not so the test would be weaker, not wrong
        attempt.process.send_signal(getattr(signal, "SIG" + name))
        end_of(attempt, "SIG%s in the middle of a step" % name, 0, "SIG%s: stopped after step %d" % (name, before))
    end_of(start(stopped, 1, "--resume"), "the rest", 0)
    check("statistics as of the whole run", Statistics(whole).difference(Statistics(stopped)) == "",
          Statistics(whole).difference(Statistics(stopped)))

    hung_up = new_case(parent, "hung_up", CASE)
    process = subprocess.Popen([LAHAR, "case.prm"], cwd=hung_up, env=ALONE, stdout=subprocess.PIPE, text=True,
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    while process.poll() is None and n_rows(hung_up) < 2:
        time.sleep(0.02)
    process.send_signal(signal.SIGHUP)
    text = process.communicate(timeout=PATIENCE)[0]
    check("nohup: SIGHUP is ignored", process.returncode == 0 and "stopped" not in text, process.returncode, text)


def output(parent):
    case = new_case(parent, "case", CASE)
    for what in (["--help"], ["--version"], ["--print-parameters", "prm"], ["--print-parameters", "json"],
                 ["--print-parameters", "latex"], ["--check", "case.prm"]):
        with open("/dev/full", "w") as full:
            result = subprocess.run([LAHAR, *what], cwd=case, env=ALONE, stdout=full, stderr=subprocess.PIPE,
                                    text=True, timeout=PATIENCE)
        check("%s to a full device: status 1" % what[0], result.returncode == 1, result.returncode)
        check("... one line says why", result.stderr == "lahar: the run failed. Cannot write to the standard output: "
              "No space left on device.\n", result.stderr)
    process = subprocess.Popen([LAHAR, "--print-parameters", "prm"], env=ALONE, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    process.stdout.close()
    error = process.stderr.read()
    check("--print-parameters to a reader that has gone: status 0", process.wait(PATIENCE) == 0 and not error, error)

    whole = Statistics(case)
    for name, options in (("gone", {"stdout": subprocess.PIPE}), ("closed", {"preexec_fn": lambda: os.closerange(0, 3)}),
                          ("full", {"stdout": open("/dev/full", "w")})):
        directory = new_case(parent, name, CASE)
        process = subprocess.Popen([LAHAR, "case.prm"], cwd=directory, env=ALONE, **options)
        if name == "gone":
            process.stdout.readline()
            process.stdout.close()
        check("standard output %s: the run reaches its end" % name, process.wait(PATIENCE) == 0, process.returncode)
        statistics = Statistics(directory)
        whole = whole if whole.rows else statistics
        check("... with all steps, and nothing else in the files", len(statistics.rows) == 20 and
              whole.difference(statistics) == "", whole.difference(statistics))


def feed(path, text):
    """Write into a pipe as long as someone reads."""
    def write():
        try:
            with open(path, "w") as pipe:
                pipe.write(text)
        except BrokenPipeError:
            pass
    threading.Thread(target=write, daemon=True).start()


def input_(parent):
    case = new_case(parent, "case", CASE)
    expected = run(case, "--check", "case.prm").stdout
    check("a file", "Fluid particles" in expected, expected)
    for n_ranks in (1, 2):
        fifo = os.path.join(parent, "fifo-%d" % n_ranks)
        os.mkfifo(fifo)
        feed(fifo, CASE)
        result = run(case, "--check", fifo, n_ranks=n_ranks)
        check("a named pipe on %d ranks" % n_ranks, result.returncode == 0 and
              expected.split("\n")[:4] == result.stdout.split("\n")[:4], result.stdout, result.stderr)
        result = run(case, "--check", "/dev/stdin", n_ranks=n_ranks, input=CASE)
        check("/dev/stdin on %d ranks" % n_ranks, result.returncode == 0 and
              expected.split("\n")[:4] == result.stdout.split("\n")[:4], result.stdout, result.stderr)
    result = subprocess.run(["bash", "-c", '"$0" --check <(cat case.prm)', LAHAR], cwd=case, env=ALONE,
                            capture_output=True, text=True, timeout=PATIENCE)
    check("<(cat case.prm)", (result.returncode, result.stdout) == (0, expected), result.stdout, result.stderr)

    huge = os.path.join(parent, "huge")
    with open(huge, "w") as file:
        file.truncate(2 * 10**9)
    doubling = new_case(parent, "doubling", "include case.prm\ninclude case.prm\n" + "#" * 1000 + "\n")
    fifo = os.path.join(parent, "mesh.msh")
    os.mkfifo(fifo)
    mesh = ["--set", "Fluids/fluid/Shape=mesh", "--set", "Fluids/fluid/mesh/Groups=fluid"]
    for what, command, words in (
            ("yes | lahar /dev/stdin", 'yes "# yes" | "$0" /dev/stdin', "longer than 10000000 bytes"),
            ("yes without line ends", "yes | tr -d '\\n' | \"$0\" /dev/stdin", "longer than 10000000 bytes"),
            ("/dev/zero", '"$0" /dev/zero', "is a device"),
            ("2 GB", '"$0" ' + huge, "longer than 10000000 bytes"),
            ("files that include themselves twice", '"$0" ' + os.path.join(doubling, "case.prm"), "include each other"),
            ("a mesh of 2 GB", " ".join(['"$0" case.prm'] + ["'%s'" % word for word in mesh] +
                                        ["--set 'Fluids/fluid/mesh/File=%s'" % huge]), "500000000"),
            ("a pipe as a mesh", " ".join(['"$0" case.prm'] + ["'%s'" % word for word in mesh] +
                                          ["--set 'Fluids/fluid/mesh/File=%s'" % fifo]), "is a pipe")):
        begin = time.monotonic()
        result = subprocess.run(["bash", "-c", command, LAHAR], cwd=case, env=ALONE, capture_output=True, text=True,
                                timeout=PATIENCE)
        check("%s: status 2" % what, result.returncode == 2, result.returncode, result.stderr)
        check("... the message (after %.1f s)" % (time.monotonic() - begin), words in result.stderr and
              result.stderr.count("\n") == 1, result.stderr)


def memory(parent):
    case = new_case(parent, "case", CASE.replace("0.02", "0.005").replace("End time         = 0.04", "End time = 0.004"))
    n_done = 0
    for limit in (500, 550, 600, 650, 700, 800, 900, 1000, 2000):
        result = run(case, "case.prm", preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_AS, (limit * 1024 * 1000, limit * 1024 * 1000)))
        n_done += result.returncode == 0
        # Below some size the loader cannot load the libraries; it says which.
        says_why = {0: True, 1: "ulimit -v" in result.stderr, 127: "error while loading shared libraries" in result.stderr}
        check("%d000 kB: status %d and the reason" % (limit, result.returncode), says_why.get(result.returncode, False),
              result.returncode, result.stdout, result.stderr)
    check("the largest limit is enough, the smallest one is not", 0 < n_done < 9, n_done)


def limit(attempt, what, values):
    """Limit the ranks, so many as there are values."""
    for pid, value in zip(attempt.pids(), values):
        resource.prlimit(pid, what, (value, value))


def check_log(what, directory, *words):
    """The log must end with the reason, which is said once."""
    with open(os.path.join(directory, "out", "log")) as file:
        text = file.read()
    reasons = [line for line in text.splitlines() if line.startswith("The run failed. ")]
    check(what + " the log tells it", len(reasons) == 1 and all(word in reasons[0] for word in words), text)


def full(parent):
    for n_limited in (3, 1):
        directory = new_case(parent, "full-%d" % n_limited, CASE)
        attempt = start(directory, 3)
        wait_for(attempt, lambda: n_rows(directory) >= 3)
        # Not on the first rank if on one only. Small enough for snapshots, which are due after each step.
        for pid in attempt.pids()[-n_limited:]:
            resource.prlimit(pid, resource.RLIMIT_FSIZE, (1000, 1000))
        struck = time.monotonic()
        text = end_of(attempt, "full on %d of 3 ranks" % n_limited, 1, "Cannot write", "File too large")
        check("... within seconds", time.monotonic() - struck < 30., time.monotonic() - struck)
        check("... said once", text.count("lahar: the run failed") == 1, text)
        parts = glob.glob(os.path.join(directory, "out", "**", "*.part*"), recursive=True)
        check("... no file in part", not parts, parts)
        if n_limited == 1:  # not the one with the log
            check_log("...", directory, "Cannot write", "File too large")


def lacks_memory(parent):
    """A factorisation without memory, of which no shorter step needs less, ends the run."""
    directory = new_case(parent, "lacks-memory", CASE.replace("0.02", "0.006"))
    attempt = start(directory, 1, "--set", "Output interval=1")  # zlib has no message of its own for a lack of memory
    wait_for(attempt, lambda: n_rows(directory) >= 1)
    with open("/proc/%d/statm" % attempt.pids()[0]) as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    resource.prlimit(attempt.pids()[0], resource.RLIMIT_AS, (used, used))
    text = end_of(attempt, "a run without memory", 1, "lahar: the run failed. ", "not enough memory")
    check("... repeats no step", "repeated" not in text, text)
    check_log("...", directory, "not enough memory")


def alone(parent):
    lacks_memory(parent)
    directory = new_case(parent, "alone", CASE.replace("0.02", "0.006"))
    attempt = start(directory, 2, "--set", "Checkpoint/Steps between=1")
    wait_for(attempt, lambda: n_rows(directory) >= 1)
    for pid in attempt.pids()[-1:]:
        with open("/proc/%d/statm" % pid) as file:
            used = int(file.read().split()[0]) * resource.getpagesize()
        resource.prlimit(pid, resource.RLIMIT_AS, (used, used))
    struck = time.monotonic()
    end_of(attempt, "one rank without memory", 1, "lahar: the run failed. ", "not enough memory")
    print("    after %.1f s" % (time.monotonic() - struck))
    check_log("...", directory, "not enough memory")
    # The last step may be lost.
    before = [float(row[1]) for row in Statistics(directory).rows]  # times
    end_time = before[-1] + 4e-3
    end_of(start(directory, 2, "--resume", "--set", "End time=%.12g" % end_time), "... it goes on", 0, "Resumed after step")
    after = [float(row[1]) for row in Statistics(directory).rows]
    check("... from its last checkpoint", after[:len(before) - 1] == before[:-1] and abs(after[-1] - end_time) < 1e-9,
          before, after)

    for n_ranks, number, is_limited in ((1, signal.SIGSEGV, False), (2, signal.SIGSEGV, False), (2, signal.SIGABRT, True)):
        directory = new_case(parent, "crash-%d-%d" % (n_ranks, number), CASE)
        attempt = start(directory, n_ranks)
        wait_for(attempt, lambda: n_rows(directory) >= 2)
        if is_limited:
            limit(attempt, resource.RLIMIT_AS, [2**40, 2**40])
        send(attempt.pids()[-1], number)
        ended, words = attempt.wait(PATIENCE), "a library has crashed" if is_limited else "The program has crashed"
        check("a crash of one of %d by %s: it ends" % (n_ranks, number.name), ended and (
            attempt.process.returncode == 1 if is_limited else attempt.process.returncode != 0), attempt.process.returncode)
        check("... and says so, without frames", "lahar: the run failed. " in attempt.text() and words in attempt.text() and
              not set(attempt.frames()) - {"Segmentation fault"}, attempt.text())  # so mpirun calls the signal
        attempt.kill()
        attempt.close()
        check_log("...", directory, words)


def launcher(parent):
    whole, stopped = (new_case(parent, name, CASE + TIGHT) for name in ("whole", "stopped"))
    end_of(start(whole, 2), "whole", 0)
    attempt = start(stopped, 2)
    wait_for(attempt, lambda: n_rows(stopped) >= 3)
    send(attempt.process.pid, signal.SIGUSR1)
    end_of(attempt, "SIGUSR1 to mpirun", 0, "SIGUSR1: stopped after step")
    before = n_rows(stopped)
    # Open MPI may leave the ranks time to stop, or kill them.
    attempt = start(stopped, 2, "--resume", "--set", "Checkpoint/Steps between=1")
    wait_for(attempt, lambda: n_rows(stopped) >= before + 3)
    send(attempt.process.pid, signal.SIGINT)
    check("SIGINT to mpirun: it ends", attempt.wait(PATIENCE))
    check("... and so do the ranks", attempt.wait_for_others(60.), attempt.pids(False))
    print("    status %s" % attempt.process.returncode)
    attempt.kill()
    attempt.close()
    text = end_of(start(stopped, 2, "--resume"), "the rest", 0, "Resumed after step")
    resumed = int(text.split("Resumed after step", 1)[1].split()[0])
    check("... from the last step", resumed >= before + 2, resumed, before)
    distance = Statistics(whole).distance(Statistics(stopped))
    check("statistics as of the whole run", distance[0] <= 1e-6, distance)


if __name__ == "__main__":
    group = {"signals": signals, "output": output, "input": input_, "memory": memory, "full": full, "alone": alone,
             "launcher": launcher}[sys.argv[1]]
    with tempfile.TemporaryDirectory() as temporary:
        group(temporary)
    sys.exit(1 if failed else 0)
