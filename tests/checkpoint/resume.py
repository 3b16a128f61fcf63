#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test checkpoints and --resume of the program `lahar` from outside, each run in a directory of its own.

column, barrier, refined, rotational, space: a run that is stopped by signals and resumed leaves, bit for bit, the files
          of one that is not (all but wall times): fluid in the plane, with an elastic barrier, through a refined box, with
          rotational symmetry, in space.
exact, chosen, thixotropic: the same of a fluid whose yield stress is exact, which begins to flow and stops; with a parameter
          of the multipliers that the program chooses; and builds up.
rejected, rejected_space: a step that is given up and repeated with half its length leaves, bit for bit, the files of a
          run that begins with the length that succeeds.
means:    a run that ends between two snapshots and goes on has the means over the whole interval; where the interval is
          another one then, they begin anew.
counts:   what a run says of the cells in which the equations of grains are ill-posed holds for all of its parts together.
changed:  harmless parameters may change between the two, others are refused by name; numbers may be written otherwise.
damaged:  no checkpoint, a truncated, a corrupted, a foreign one, one of another format: status 2, files left alone.
          Statistics that are shorter than they were: status 2; none: a warning, and they begin anew.
killed:   SIGKILL at random moments; the next --resume works, and no file is there in part.
full:     files cannot grow (as on a full disk): status 1, the file's name, and the checkpoint before stays valid.

Usage: resume.py GROUP LAHAR
"""
import glob
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE, barrier, check, failed, fluid, new_case, section, walls  # noqa: E402

LAHAR = os.path.abspath(sys.argv[2])

COLLAPSE = """
set Output directory = out
set End time         = 0.12
set Time step        = 2e-3
set Mesh size        = 0.015
set Output interval  = 0.03
subsection Checkpoint
  set Steps between   = 7
  set Minutes between = 0
end
""" + fluid("0, 0 : 0.146, 0.292", section("Bingham", "set Yield stress = 20"))

COLUMN = COLLAPSE + walls("0, 0.4 : 0, 0 : 0.2, 0 : 0.2, 0.4")

BARRIER = COLLAPSE + walls("0, 0.4 : 0, 0 : 0.5, 0") + barrier(0.17, 0.185)

REFINED = COLUMN + """
subsection Remeshing
  set Refined boxes = 0.1, 0 : 0.17, 0.05 : 0.0075
end
"""

ROTATIONAL = COLLAPSE + walls("0, 0 : 0.2, 0 : 0.2, 0.4") + "set Geometry = rotational symmetry\n"
# It stands after about half of the time.
EXACT = COLUMN.replace("set Yield stress = 20", "set Yield stress = 500\nset Plastic viscosity = 1\nset Yield = exact").replace(
    "0, 0 : 0.146, 0.292", "0, 0 : 0.1, 0.15") + """
set Time integration = backward Euler
"""

CHOSEN = EXACT.replace("set Yield = exact", "set Yield = exact\nset Augmentation parameter = auto")

THIXOTROPIC = EXACT.replace("set Yield = exact", "set Yield = exact\nset Flocculation time = 0.1\nset Initial structure = 0.2")

GRAINS = COLLAPSE.replace("subsection Bingham", "set Law = mu(I)\nsubsection Bingham").replace(
    "set End time         = 0.12", "set End time         = 0.06") + walls("0, 0.4 : 0, 0 : 0.5, 0")

PLAIN = """
subsection Remeshing
  subsection Alpha shape
    set Rule = plain
  end
end
"""

SPACE = """
set Dimension        = 3
set Output directory = out
set End time         = 0.08
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 0.02
""" + fluid("0, 0, 0 : 0.1, 0.1, 0.15") + walls("-0.2, -0.2, 0 : 0.3, -0.2, 0 : 0.3, 0.3, 0 : -0.2, 0.3, 0")

def start(directory, *arguments, **options):
    return subprocess.Popen([LAHAR, *arguments, "case.prm"], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def run(directory, *arguments, **options):
    process = start(directory, *arguments, **options)
    process.out, process.err = process.communicate(timeout=500)
    return process


def log_size(directory):
    try:
        return len(open(os.path.join(directory, "out", "log")).readlines())
    except OSError:
        return 0


def wait_for_steps(process, directory, n_lines):
    """Wait until the log has so many lines, or the run has ended."""
    while process.poll() is None and log_size(directory) < n_lines:
        time.sleep(0.01)


def contents(directory):
    """What the files of an output directory say, by name, without wall times and dates."""
    result = {}
    for path in sorted(glob.glob(os.path.join(directory, "out", "*"))):
        name = os.path.basename(path)
        if os.path.isfile(path) and name not in ("log", "parameters.prm"):
            text = open(path, errors="replace").read()
            if name == "statistics":
                columns = re.findall(r"^# \d+: (.*)$", text, re.M)
                wall = columns.index("Wall time (s)")
                lines = [line.split() for line in text.splitlines() if not line.startswith("#")]
                result[name] = [line[:wall] + line[wall + 1:] for line in lines]
            else:
                result[name] = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    return result


def compare(what, expected, found):
    check(what + ": the same files", list(expected) == list(found), list(expected), list(found))
    for name in expected:
        check(f"{what}: {name} is the same", expected[name] == found.get(name))


def test_stopped(parent, text):
    """Stop a run three times, by signals, and resume it."""
    whole = new_case(parent, "whole", text)
    process = run(whole)
    check("the run that is not stopped succeeds", process.returncode == 0, process.out, process.err)
    n_steps = len(contents(whole)["statistics"])

    stopped = new_case(parent, "stopped", text)
    for which, name in enumerate(["SIGTERM", "SIGINT", "SIGTERM"]):
        # The lines so far, those about the start, and the steps to go.
        lines = log_size(stopped) + 8 + int(0.2 * n_steps)
        process = start(stopped, *(["--resume"] if which else []))
        wait_for_steps(process, stopped, lines)
        process.send_signal(getattr(signal, name))
        process.out, process.err = process.communicate(timeout=500)
        check(f"{name} ends the run with status 0", process.returncode == 0, process.returncode, process.err)
        check(f"{name} is reported", f"{name}: stopped after step" in process.out, process.out)
        n_lines = len(contents(stopped)["statistics"])
        check(f"{name}: statistics of the steps so far", 0 < n_lines < n_steps, n_lines, n_steps)
    process = run(stopped, "--resume")
    check("the last part succeeds", process.returncode == 0, process.out, process.err)
    compare("stopped and resumed", contents(whole), contents(stopped))


def test_rejected(parent, text):
    """Resume a run with steps in which particles move too far, and with the length that they end up with. The plain alpha
    shape, because the other one looks ahead by the step that is tried first."""
    first = new_case(parent, "first", text + PLAIN)
    check("the first part succeeds", run(first, "--set", "End time=0.002").returncode == 0)
    n_steps = len(contents(first)["statistics"])

    options = ["--resume", "--set", "End time=0.034", "--set", "Output interval=1", "--set", "Largest movement=0.08"]
    files, n_rejected = {}, {}
    for name in ["rejected", "shorter"]:
        case = os.path.join(parent, name)
        shutil.copytree(first, case)
        time_step = "32e-3" if name == "rejected" else files["rejected"]["statistics"][n_steps][2]
        process = run(case, *options, "--set", f"Time step={time_step}")
        check(f"{name}: status 0", process.returncode == 0, process.out, process.err)
        files[name] = contents(case)
        columns = re.findall(r"^# \d+: (.*)$", open(os.path.join(case, "out", "statistics")).read(), re.M)
        column  = columns.index("Rejected steps")
        n_rejected[name] = [int(line.pop(column)) for line in files[name]["statistics"][n_steps:]]
    halvings = n_rejected["rejected"][0] - n_rejected["shorter"][0]
    check("the first step is given up", halvings > 0, n_rejected)
    check("no other one more often than in the run with shorter steps",
          n_rejected["rejected"] == [n + halvings for n in n_rejected["shorter"]], n_rejected)
    compare("given up", files["shorter"], files["rejected"])


def test_means(parent):
    parts = new_case(parent, "parts", COLUMN)
    for first, interval in (("0.05", "0.03"), ("0.038", "0.004")):
        process = run(parts, "--overwrite", "--set", f"End time={first}")
        check("the first part succeeds", process.returncode == 0, process.out, process.err)
        process = run(parts, "--resume", "--set", f"Output interval={interval}")
        check("the second part succeeds", process.returncode == 0, process.out, process.err)
        found = contents(parts)["statistics"]
        columns = re.findall(r"^# \d+: (.*)$", open(os.path.join(parts, "out", "statistics")).read(), re.M)
        step, force = columns.index("Time step size (s)"), columns.index("walls force y (N)")
        end = 0.06 if interval == "0.03" else 0.042  # of the first interval after the resumption
        of_steps = [(float(line[step]), float(line[force])) for line in found
                    if end - float(interval) + 1e-6 < float(line[1]) < end + 1e-6]
        value = sum(dt * f for dt, f in of_steps) / sum(dt for dt, f in of_steps)
        mean = [float(line[columns.index("walls mean force y (N)")]) for line in found if abs(float(line[1]) - end) < 1e-6]
        check(f"the mean at {end} s is over the whole interval", abs(mean[0] - value) < 1e-8 * abs(value), mean, value)


def test_counts(parent):
    def warning(process):
        found = re.findall(r"Warning: in ([0-9.e-]+) % of the cells that flowed", process.out)
        return found[-1] if found else None

    whole = new_case(parent, "whole", GRAINS)
    expected = warning(run(whole))
    check("the run tells of ill-posed cells", expected is not None)
    parts = new_case(parent, "parts", GRAINS)
    first = run(parts, "--set", "End time=0.03")
    check("the first part succeeds", first.returncode == 0, first.out, first.err)
    found = warning(run(parts, "--resume"))
    check("the resumed run counts those of both parts", found == expected, expected, found)
    check("which is not what the first one has", warning(first) != expected, expected, warning(first))


def test_changed(parent):
    short = new_case(parent, "case", COLUMN.replace("set End time         = 0.12", "set End time         = 0.02"))
    process = run(short)
    check("the first part succeeds", process.returncode == 0, process.err)
    process = run(short, "--resume")
    check("without a later end time there is nothing to do: status 0", process.returncode == 0, process.err)
    process = run(short, "--resume", "--set", "End time=0.01")
    check("an earlier end time is refused: status 2", process.returncode == 2, process.returncode)
    check("... and the entry is named", "'End time' is '0.01'" in process.err, process.err)

    for entry, value, earlier in [("Mesh size", "0.01", "0.015"), ("Fluids/fluid/Bingham/Yield stress", "21", "20"),
                                  ("Fluids/fluid/box/Corners", "0, 0 : 0.1, 0.2", "0, 0 : 0.146, 0.292"),
                                  ("Remeshing/Keep volume", "false", "true"),
                                  ("Remeshing/Refined boxes", "0, 0 : 0.1, 0.1 : 0.01", "")]:
        before = contents(short)
        process = run(short, "--resume", "--set", f"{entry}={value}", "--set", "End time=0.03")
        check(f"another {entry} is refused: status 2", process.returncode == 2, process.returncode)
        check("... its path and both values are named",
              f"'{entry}' is '{value}'" in process.err and f"'{earlier}'" in process.err, process.err)
        check("... and the files are left alone", before == contents(short))
    process = run(short, "--resume", "--set", "End time=0.03", "--set", "Output interval=0.005", "--set",
                  "Time step=1e-3", "--set", "Nonlinear solver/Tolerance=1e-5", "--set", "Checkpoint/Steps between=3")
    check("end time, output interval, time step and solver may change", process.returncode == 0, process.err)
    lines = contents(short)["statistics"]
    check("... and the run goes on to the new end time", abs(float(lines[-1][1]) - 0.03) < 1e-9, lines[-1])
    check("... with the new time step", abs(float(lines[-1][2]) - 1e-3) < 1e-9, lines[-1])
    pvd = contents(short)["solution.pvd"]
    times = [float(t) for t in re.findall(r'timestep="([^"]*)" group="" part="0"', pvd)]
    check("... with the new output interval", times == [0., 0.02, 0.025, 0.03], times)
    check("--check reports the resumed sizes", run(short, "--resume", "--check", "--set", "End time=0.04").returncode == 0)

    for entry, value in [("Mesh size", "1.5e-2"), ("Fluids/fluid/Bingham/Yield stress", "20.0"), ("Gravity", "0,-981e-2"),
                         ("Fluids/fluid/box/Corners", "0,0:1.46e-1 , 0.2920")]:
        process = run(short, "--resume", "--set", f"{entry}={value}", "--set", "End time=0.03")
        check(f"{entry} = {value} is the same number: status 0", process.returncode == 0, process.err)


def test_damaged(parent):
    case = new_case(parent, "case", COLUMN.replace("set End time         = 0.12", "set End time         = 0.004"))
    process = run(case, "--resume")
    check("no checkpoint: status 2", process.returncode == 2, process.returncode)
    check("... the file is named", "out/checkpoint/state' is not there" in process.err, process.err)
    check("... nothing is made", os.listdir(case) == ["case.prm"], os.listdir(case))
    check("the first part succeeds", run(case).returncode == 0)
    state = os.path.join(case, "out", "checkpoint", "state")
    good = open(state, "rb").read()
    middle = len(good) // 2
    flipped = good[:middle] + bytes([good[middle] ^ 1]) + good[middle + 1:]
    for what, data, words in [
            ("truncated", good[:middle], "bytes of data"), ("cut in its header", good[:30], "truncated or corrupted"),
            ("with a byte changed", flipped, "checksum is wrong"), ("empty", b"", "is no checkpoint"),
            ("foreign", b"something else\n" * 100, "is no checkpoint"),
            ("of an older format", re.sub(rb"version \d+", b"version 4", good, count=1), "format version 4"),
            ("of another run by its header", good.replace(b"run ", b"run 0", 1), "checksum is wrong"),
            ("too long", good + b"x", "bytes of data")]:
        with open(state, "wb") as file:
            file.write(data)
        before = contents(case)
        process = run(case, "--resume", "--set", "End time=0.01")
        check(f"a checkpoint {what}: status 2", process.returncode == 2, process.returncode, process.err)
        check("... the message says so and names it", words in process.err and "checkpoint/state" in process.err, process.err)
        check("... files are left alone", before == contents(case) and open(state, "rb").read() == data)
    with open(state, "wb") as file:
        file.write(good)
    for name in ["statistics", "convergence"]:
        path = os.path.join(case, "out", name)
        good = open(path, "rb").read()
        with open(path, "wb") as file:
            file.write(good[:-1])
        before = contents(case)
        process = run(case, "--resume", "--set", "End time=0.01")
        check(f"{name} shortened: status 2", process.returncode == 2, process.returncode, process.err)
        check("... the message names it and both sizes", f"out/{name}' holds {len(good) - 1} bytes, {len(good)}" in process.err, process.err)
        check("... files are left alone", before == contents(case))
        with open(path, "wb") as file:
            file.write(good + b"half a lin")
    check("the good one works", run(case, "--resume", "--set", "End time=0.01").returncode == 0)
    lines = contents(case)["statistics"]
    check("... what stood behind the statistics' last line is gone", [line[0] for line in lines] == ["1", "2", "3", "4", "5"], lines)
    os.remove(os.path.join(case, "out", "statistics"))
    process = run(case, "--resume", "--set", "End time=0.014")
    check("no statistics: status 0", process.returncode == 0, process.err)
    check("... a warning says so", "Warning: 'out/statistics' is not there" in process.out, process.out)
    lines = contents(case)["statistics"]
    check("... and they begin anew with the next step", [line[0] for line in lines] == ["6", "7"], lines)


def n_steps_in_log(directory):
    try:
        return sum(line.startswith("step ") for line in open(os.path.join(directory, "out", "log")))
    except OSError:
        return 0


def kill_at_random(process, directory, n_steps, before):
    """Kill the process at a random moment: with n_steps None a part of the @p before seconds that the last one took to its
    first step, else within the step after as many. Return how long the first step took to come."""
    def wait(n):
        while process.poll() is None and n_steps_in_log(directory) < n:
            time.sleep(0.002)

    began = time.time()
    n_old = n_steps_in_log(directory)
    if n_steps is None:
        time.sleep(random.uniform(0., before))
    else:
        wait(n_old + 1)
        first = time.time()
        before = first - began
        wait(n_old + n_steps)
        # As long as this process's own steps took, which other work of the machine makes long as well.
        time.sleep(random.uniform(0., (time.time() - first) / (n_steps - 1)))
    process.kill()
    process.communicate()
    return before


def test_killed(parent):
    """However slow the machine is the runs get on, because they are killed after so many steps, a third of them before they
    begin; the last one is left alone, up to an end that none has reached before."""
    text = COLUMN.replace("Steps between   = 7", "Steps between   = 2")
    killed = new_case(parent, "killed", text)
    state = os.path.join(killed, "out", "checkpoint", "state")
    random.seed(1)
    before, n_resumed = 0., 0
    for n in range(24):
        is_resumed = os.path.exists(state)
        n_resumed += is_resumed
        process = start(killed, "--resume" if is_resumed else "--overwrite", "--set", "End time=1000")
        before = kill_at_random(process, killed, random.randint(2, 5) if n % 3 < 2 else None, before)
        for path in glob.glob(os.path.join(killed, "out", "*.vtu")) + glob.glob(os.path.join(killed, "out", "*.pvd")):
            ElementTree.parse(path)
    check("runs that had been resumed were killed", n_resumed >= 15, n_resumed)
    last_time = float(contents(killed)["statistics"][-1][1])
    end = f"End time={0.03 * (int(last_time / 0.03) + 1):.2f}"
    process = run(killed, "--resume", "--set", end)
    check("the last run succeeds", process.returncode == 0, process.out, process.err)
    check("... and leaves nothing in part", not glob.glob(os.path.join(killed, "out", "**", "*.part"), recursive=True))
    whole = new_case(parent, "whole", text)
    check("the run that is not killed succeeds", run(whole, "--set", end).returncode == 0)
    compare("killed 24 times", contents(whole), contents(killed))


def test_full(parent):
    text = COLUMN.replace("set End time         = 0.12", "set End time         = 0.03")
    case = new_case(parent, "case", text)
    check("the first part succeeds", run(case).returncode == 0)

    # Only once the run goes on, since MPI's start writes files of its own.
    process = start(case, "--resume", "--set", "End time=0.12", restore_signals=False,
                    preexec_fn=lambda: signal.signal(signal.SIGXFSZ, signal.SIG_IGN))
    wait_for_steps(process, case, log_size(case) + 8)
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (1000, 1000))
    process.out, process.err = process.communicate(timeout=500)
    check("files that cannot grow: status 1", process.returncode == 1, process.returncode, process.err)
    check("... the file and the reason are named", "Cannot write" in process.err and "large" in process.err, process.err)
    check("... no file is left in part", not glob.glob(os.path.join(case, "out", "**", "*.part"), recursive=True))
    with open(os.path.join(case, "out", "statistics")) as file:
        lines = file.read().split("\n")
    n_columns = sum(line.startswith("#") for line in lines)
    check("... the statistics end with a whole line", lines[-1] == "" and len(lines[-2].split()) == n_columns, lines[-2:])
    process = run(case, "--resume", "--set", "End time=0.05")
    check("with room again the run goes on from the checkpoint before", process.returncode == 0, process.err)


def main():
    group = sys.argv[1]
    parent = tempfile.mkdtemp()
    try:
        cases = {"column": COLUMN, "barrier": BARRIER, "refined": REFINED, "rotational": ROTATIONAL, "space": SPACE,
                 "exact": EXACT, "chosen": CHOSEN, "thixotropic": THIXOTROPIC}
        if group in cases:
            test_stopped(parent, cases[group])
        elif group in ("rejected", "rejected_space"):
            test_rejected(parent, {"rejected": BARRIER, "rejected_space": SPACE}[group])
        else:
            {"means": test_means, "counts": test_counts, "changed": test_changed, "damaged": test_damaged, "killed": test_killed,
             "full": test_full}[group](parent)
    finally:
        shutil.rmtree(parent)
    sys.exit(1 if failed else 0)


main()
