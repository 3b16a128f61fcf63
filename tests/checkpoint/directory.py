#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test what the program `lahar` makes of its output directory when others have it, too, or change what is in it.

lock:      while a run goes on others are refused with its host and process, and nothing happens to its files; --check
           needs no lock; a killed run's lock is taken over, one of another host is not.
overwrite: a new run over an old one needs --overwrite, which removes the old one's files and no others.
removed:   files that are removed in mid-run are there again in the end; a removed directory, too; a renamed one, and
           statistics that others have changed, end the run with status 1 and a reason, from where --resume goes on.
files:     a mesh file that has changed is refused by --resume, one that was moved is not.

Usage: directory.py GROUP LAHAR MESH_FILE
"""
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE, check, failed, fluid, mesh, new_case, parts, walls  # noqa: E402

LAHAR, MESH = os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])

TOP = """
set Output directory = out
set End time         = 0.06
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 0.01
subsection Checkpoint
  set Steps between   = 5
  set Minutes between = 0
end
"""

CASE = TOP + fluid("0, 0 : 0.1, 0.2") + walls("0, 0.4 : 0, 0 : 0.2, 0 : 0.2, 0.4")

# A run that does not end by itself.
ENDLESS = ["--set", "End time=1000", "--set", "Output interval=1000"]


def start(directory, *arguments):
    return subprocess.Popen([LAHAR, *arguments, "case.prm"], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finish(process):
    process.out, process.err = process.communicate(timeout=300)
    return process


def run(directory, *arguments):
    return finish(start(directory, *arguments))


def read(directory, name):
    with open(os.path.join(directory, "out", name), errors="replace") as file:
        return file.read()


def steps(directory):
    """The statistics' lines without wall times, or none."""
    try:
        lines = [line.split()[:-1] for line in read(directory, "statistics").splitlines() if not line.startswith("#")]
    except OSError:
        return []
    return lines


def wait_for_steps(process, directory, number):
    while process.poll() is None and len(steps(directory)) < number:
        time.sleep(0.005)


def are_consecutive(lines):
    return [int(line[0]) for line in lines] == list(range(1, len(lines) + 1))


def all_files(directory):
    """Contents of all files by their names."""
    result = {}
    for folder, _, names in os.walk(directory):
        for name in names:
            with open(os.path.join(folder, name), "rb") as file:
                result[os.path.relpath(os.path.join(folder, name), directory)] = file.read()
    return result


def test_lock(parent):
    case = new_case(parent, "case", CASE)
    lock = os.path.join(case, "out", "lock")
    first = start(case, *ENDLESS)
    wait_for_steps(first, case, 6)
    for arguments in ([], ["--resume", *ENDLESS], ["--overwrite"]):
        second = run(case, *arguments)
        what = " ".join(arguments[:1]) or "a new run"
        check(f"{what} beside another one: status 2", second.returncode == 2, second.returncode, second.err)
        check("... host and process are named",
              f"process {first.pid} on host '{socket.gethostname()}'" in second.err and "'out'" in second.err,
              second.err)
    for arguments in (["--check"], ["--check", "--resume", *ENDLESS], ["--print-parameters", "prm"]):
        second = run(case, *arguments)
        check(f"{arguments[0]} needs no lock: status 0", second.returncode == 0, second.returncode, second.err)
    check("the first one has its lock", os.path.exists(lock))
    first.send_signal(signal.SIGTERM)
    finish(first)
    lines = steps(case)
    check("the first one ends well", first.returncode == 0, first.returncode, first.err)
    check("... all its steps are there, once", len(lines) > 5 and are_consecutive(lines), [line[0] for line in lines])
    check("... and its lock is gone", not os.path.exists(lock))

    pair = [start(case, "--resume", *ENDLESS) for _ in range(2)]
    while all(process.poll() is None for process in pair):
        time.sleep(0.005)
    refused, going = pair if pair[0].poll() is not None else pair[::-1]
    finish(refused)
    check("of two at once one is refused: status 2", refused.returncode == 2, refused.returncode, refused.err)
    wait_for_steps(going, case, len(lines) + 5)
    going.kill()
    finish(going)
    lines = steps(case)
    check("... the other one goes on alone", are_consecutive(lines), [line[0] for line in lines])
    check("... and is killed with its lock", os.path.exists(lock))
    later = ["--resume", "--set", f"End time={float(lines[-1][1]) + 0.01}", "--set", "Output interval=1000"]
    process = run(case, *later)
    check("--resume takes it over: status 0", process.returncode == 0, process.err)

    # A number that another process has by now is no obstacle.
    with open(lock, "w") as file:
        file.write(f"host {socket.gethostname()}\nprocess {os.getpid()}\nsince 2026-01-01 00:00:00 UTC\n")
    process = run(case, *later)
    check("so it does where the process is another one: status 0", process.returncode == 0, process.err)
    with open(lock, "w") as file:
        file.write("host elsewhere\nprocess 1\nsince 2026-01-01 00:00:00 UTC\n")
    before = all_files(case)
    process = run(case, *later)
    check("a lock of another host is kept: status 2", process.returncode == 2, process.returncode, process.err)
    check("... the message names it and says what to do",
          "process 1 on host 'elsewhere' (since 2026-01-01" in process.err and "remove this file" in process.err and
          "out/lock" in process.err, process.err)
    check("... and the files are left alone", all_files(case) == before)
    os.remove(lock)
    check("without it the run goes on", run(case, *later).returncode == 0)


def test_overwrite(parent):
    case = new_case(parent, "case", CASE)
    check("the first run succeeds", run(case, "--set", "Output interval=0.002").returncode == 0)
    for name in ("notes.txt", "snapshots.png", "solution-final.vtu", "statistics.old"):
        with open(os.path.join(case, "out", name), "w") as file:
            file.write("mine")
    with open(os.path.join(case, "out", "walls-00042.vtu"), "w") as file:
        file.write("of a run whose walls moved")
    leftover = os.path.join(case, "out", "checkpoint", "state.elsewhere-1.part")
    with open(leftover, "w") as file:
        file.write("part")
    before = all_files(case)
    process = run(case)
    check("a second one: status 2", process.returncode == 2, process.returncode, process.err)
    check("... it names the directory and both ways out",
          all(part in process.err for part in ("'out'", "--resume", "--overwrite")), process.err)
    for arguments in (["--overwrite", "--resume"], ["--overwrite", "--set", "Mesh size=-1"],
                      ["--overwrite", "--set", "Fluids/fluid/box/Corners=0, 0 : 0.001, 0.001"], ["--check", "--overwrite"]):
        process = run(case, *arguments)
        check(f"{' '.join(arguments)}: status {2 if '--check' not in arguments else 0}",
              process.returncode == (0 if "--check" in arguments else 2), process.returncode, process.err)
    check("... and all files are left alone", all_files(case) == before)

    process = run(case, "--overwrite", "--set", "Output interval=0.03", "--set", "End time=0.03")
    check("--overwrite: status 0", process.returncode == 0, process.err)
    expected = ["checkpoint/state", "convergence", "log", "notes.txt", "parameters.prm", "snapshots.png",
                "solution-00000.vtu", "solution-00001.vtu", "solution-final.vtu", "solution.pvd", "statistics",
                "statistics.old", "walls.vtu"]
    check("... leaves its own files and those of others", sorted(all_files(os.path.join(case, "out"))) == expected,
          sorted(all_files(os.path.join(case, "out"))))
    fresh = new_case(parent, "fresh", CASE)
    run(fresh, "--set", "Output interval=0.03", "--set", "End time=0.03")
    check("... and the results of a run in a new directory", steps(case) == steps(fresh) and len(steps(case)) > 5)

    shutil.rmtree(os.path.join(case, "out", "checkpoint"))
    process = run(case)
    check("without a checkpoint the message says so", process.returncode == 2 and "no checkpoint" in process.err,
          process.err)
    only = new_case(parent, "only", CASE)
    os.mkdir(os.path.join(only, "out"))
    shutil.copy(os.path.join(only, "case.prm"), os.path.join(only, "out", "parameters.prm"))
    check("parameters.prm alone is no run", run(only, "--set", "End time=0.004").returncode == 0)


def stopped(directory, action, *arguments):
    """Run, do something to the files while the process is stopped after some steps, and let it end. It is stopped in
    the third or fourth step after a multiple of five, where it writes lines but neither snapshots nor checkpoints."""
    process = start(directory, *arguments)
    number = 12
    while True:
        wait_for_steps(process, directory, number)
        process.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
        number = len(steps(directory))
        if number % 5 in (2, 3) or process.poll() is not None:
            break
        process.send_signal(signal.SIGCONT)
        number += 1
    action()
    process.send_signal(signal.SIGCONT)
    return finish(process)


def test_removed(parent):
    long = CASE.replace("= 0.06", "= 0.2")  # as many steps as wait_for_steps() may miss
    whole = new_case(parent, "whole", long)
    check("the run that is left alone succeeds", run(whole).returncode == 0)
    expected = sorted(all_files(os.path.join(whole, "out")))

    names = ("statistics", "convergence", "log", "parameters.prm", "solution.pvd", "checkpoint/state", "lock", "walls.vtu")
    case = new_case(parent, "files", long)
    out = os.path.join(case, "out")
    process = stopped(case, lambda: [os.remove(os.path.join(out, name)) for name in (*names, "solution-00001.vtu")])
    check("files are removed: status 0", process.returncode == 0, process.returncode, process.err)
    log = read(case, "log")
    for name in ("statistics", "convergence", "log", "parameters.prm", "lock", "walls.vtu", "solution-00001.vtu"):
        check(f"... the log tells of {name}", re.search(f"^Warning: .*out/{name}'", log, re.M), log)
    check("... and of the checkpoint", "Warning: the checkpoint in 'out' was removed" in log, log)
    check("... all are there again but the snapshot", sorted([*all_files(out), "solution-00001.vtu"]) == expected,
          sorted(all_files(out)))
    check("... as they should be", steps(case) == steps(whole) and
          read(case, "convergence") == read(whole, "convergence"))
    check("... the list of snapshots leaves one out", read(case, "solution.pvd").count("<DataSet") ==
          read(whole, "solution.pvd").count("<DataSet") - 1)

    case = new_case(parent, "removed", long)
    process = stopped(case, lambda: shutil.rmtree(os.path.join(case, "out")))
    check("the directory is removed: status 0", process.returncode == 0, process.returncode, process.err)
    check("... the log tells of it", "directory 'out' was removed" in read(case, "log"), read(case, "log"))
    check("... the statistics are whole", steps(case) == steps(whole))
    again, before = (read(directory, "walls.vtu").split("<VTKFile", 1)[1] for directory in (case, whole))  # without the date
    check("... the walls are there again", again == before and "<Piece" in again, again)
    check("... and in the list", 0 < read(case, "solution.pvd").count("walls.vtu") == len(read(whole, "solution.pvd").split(
        "walls.vtu")) - 1, read(case, "solution.pvd"))
    check("... there is a checkpoint", run(case, "--resume", "--set", "End time=0.21").returncode == 0)

    case = new_case(parent, "renamed", long)
    out = os.path.join(case, "out")
    process = stopped(case, lambda: os.rename(out, out + "-renamed"))
    check("the directory is renamed: status 1", process.returncode == 1, process.returncode, process.err)
    check("... the message has both names and the remedy", all(
        part in process.err for part in ("'out'", "out-renamed'", "--resume")), process.err)
    check("... nothing is made beside it", not os.path.exists(out))
    os.rename(out + "-renamed", out)
    check("... it stands in the log", "The run failed. " in read(case, "log") and "renamed" in read(case, "log"))
    process = run(case, "--resume")
    check("... and the run goes on", process.returncode == 0 and steps(case) == steps(whole), process.err)

    case = new_case(parent, "changed", long)
    process = stopped(case, lambda: os.truncate(os.path.join(case, "out", "statistics"), 100))
    check("statistics are cut off: status 1", process.returncode == 1, process.returncode, process.err)
    check("... the message says so", re.search(r"'out/statistics' holds \d+ bytes", process.err), process.err)
    check("... and the log", "'out/statistics' holds " in read(case, "log"))
    os.remove(os.path.join(case, "out", "statistics"))
    process = run(case, "--resume")
    check("... without them the run goes on", process.returncode == 0, process.err)

    case = new_case(parent, "log", long)
    os.makedirs(os.path.join(case, "out", "log"))
    process = run(case)
    check("a log that cannot be written: status 1", process.returncode == 1, process.returncode, process.err)
    check("... is named", "Cannot write 'out/log'" in process.err, process.err)


def test_files(parent):
    text = TOP + parts("Fluids", {"fluid": mesh("column.msh", "fluid")}) + \
        parts("Boundaries", {"walls": mesh("column.msh", "walls")})
    case = new_case(parent, "case", text)
    file_name = os.path.join(case, "column.msh")
    shutil.copy(MESH, file_name)
    process = run(case, "--set", "End time=0.01")
    check("a run with a mesh file succeeds", process.returncode == 0, process.err)
    with open(file_name) as file:
        good = file.read()
    place = good.index("$Nodes")
    with open(file_name, "w") as file:
        file.write(good[:place] + good[place:].replace("0.146 0.292 0", "0.1461 0.292 0", 1))
    before = all_files(os.path.join(case, "out"))
    process = run(case, "--resume")
    check("a changed one: status 2", process.returncode == 2, process.returncode, process.err)
    check("... entry and file are named", "/mesh/File'" in process.err and "column.msh" in process.err
          and "changed" in process.err, process.err)
    check("... files are left alone", before == all_files(os.path.join(case, "out")))
    os.remove(file_name)
    os.mkdir(os.path.join(case, "meshes"))
    with open(os.path.join(case, "meshes", "column.msh"), "w") as file:
        file.write(good)
    process = run(case, "--resume", "--set", "Fluids/fluid/mesh/File=meshes/column.msh", "--set",
                  "Boundaries/walls/mesh/File=meshes/column.msh")
    check("the good one in another place: status 0", process.returncode == 0, process.err)


def main():
    parent = tempfile.mkdtemp()
    try:
        tests = {"lock": test_lock, "overwrite": test_overwrite, "removed": test_removed, "files": test_files}
        tests[sys.argv[1]](parent)
    finally:
        shutil.rmtree(parent)
    sys.exit(1 if failed else 0)


main()
