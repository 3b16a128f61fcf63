#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/plot/sweep.py and animate.py on a small column beside a wall that moves.

The table of the sweep has the numbers of the statistics; what is finished is not run again, unless case or settings
differ; a value that fails is said. The film has a frame a snapshot and frames show something. Wrong input is refused in
one line with status 2.

Usage: films.py LAHAR. Exit status 77 (skipped) without numpy, matplotlib or ffmpeg.
"""
import csv
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), HERE]
from program_test import ALONE, check, failed, fluid, new_case, parts, section, wall
from scripts import CONTRIB, SKIPPED, is_drawing, is_refused

CASE = """
set Dimension        = 2
set Output directory = out
set End time         = 8e-3
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 2e-3
"""
ENTRY = "Fluids/fluid/Bingham/Yield stress"


def run_script(directory, name, *arguments, **environment):
    """The finished process of contrib/plot/@p name, run in @p directory."""
    return subprocess.run([sys.executable, "-B", os.path.join(CONTRIB, "plot", name), *arguments], cwd=directory,
                          env=dict(ALONE, **environment), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True)


def statistics(path):
    """The columns of a statistics file by name."""
    with open(path) as file:
        lines = file.read().splitlines()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("#")]
    rows = [map(float, line.split()) for line in lines if line.strip() and not line.startswith("#")]
    return dict(zip(names, map(list, zip(*rows))))


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def is_close(text, number):
    return abs(float(text) - number) <= 1e-8 * abs(number) + 1e-15


def test_sweep(directory, lahar):
    case = ["case.prm", ENTRY]
    options = ["--lahar", lahar, "-o", "sweep"]
    process = run_script(directory, "sweep.py", *case, "50", "-1", "200", *options, "--jobs", "2")
    check("a sweep with a value that is wrong has status 1", process.returncode == 1 and not process.stderr,
          process.stderr)
    check("the value is said, with the program's message", "-1: FAILED with exit status 2" in process.stdout
          and "Yield stress" in process.stdout
          and "1 of 3 runs failed or stopped: -1" in process.stdout, process.stdout)
    rows = table(os.path.join(directory, "sweep", "sweep.csv"))
    check("the table has all values and their states", [(row[ENTRY], row["state"]) for row in rows] ==
          [("50", "finished"), ("-1", "failed"), ("200", "finished")], rows)
    check("a value that failed has no numbers", set(rows[1].values()) == {"-1", "failed", ""}, rows[1])
    for row in (rows[0], rows[2]):
        columns = statistics(os.path.join(directory, "sweep", row[ENTRY], "statistics"))
        change = columns["Volume change by solver"][-1] + columns["Volume change by remeshing"][-1]
        expected = {"Fluid volume change, last": change,
                    "Nonlinear iterations, total": sum(columns["Nonlinear iterations"]),
                    "Wall time (s), last": columns["Wall time (s)"][-1]}
        expected.update({f"{name}, last": values[-1] for name, values in columns.items() if name.endswith(" (m)")})
        expected.update({f"{name}, peak": max(values, key=abs) for name, values in columns.items()
                         if " force " in name})
        check(f"{row[ENTRY]}: the table has these quantities", {ENTRY, "state", *expected} == set(row) and len(row) > 8,
              set(row) ^ set(expected))
        wrong = {name: (row[name], number) for name, number in expected.items() if not is_close(row[name], number)}
        check(f"{row[ENTRY]}: they are those of the statistics", not wrong, wrong)
    check("the values differ", rows[0]["floor force y (N), peak"] != rows[2]["floor force y (N), peak"], rows)
    for picture in ("front-m.png", "floor-force-y-n.png", "fluid-volume-change.png"):
        check(f"{picture} shows something", is_drawing(os.path.join(directory, "sweep", picture)))

    def ends():
        return [os.stat(os.path.join(directory, "sweep", value, "statistics")).st_mtime_ns for value in ("50", "200")]

    before = ends()
    process = run_script(directory, "sweep.py", *case, "50", "200", *options, "--column", "height (m)",
                         "--column", "floor force y (N)")
    check("what is finished is not run again", process.returncode == 0 and ends() == before
          and process.stdout.count("finished already") == 2 and "started" not in process.stdout,
          process.stdout, process.stderr)
    row = table(os.path.join(directory, "sweep", "sweep.csv"))[1]
    columns = statistics(os.path.join(directory, "sweep", "200", "statistics"))
    height, force, steps = columns["height (m)"], columns["floor force y (N)"], columns["Time step size (s)"]
    check("chosen columns have last, largest and mean",
          is_close(row["height (m), last"], height[-1]) and is_close(row["height (m), largest"], max(height))
          and is_close(row["height (m), mean"], sum(h * dt for h, dt in zip(height, steps)) / sum(steps)), row)
    check("forces have peak, last and mean, and there is nothing else",
          is_close(row["floor force y (N), peak"], max(force, key=abs))
          and is_close(row["floor force y (N), last"], force[-1]) and len(row) == 8, row)
    process = run_script(directory, "sweep.py", *case, "50", *options, "--column", "mood")
    check("a column that is not there is refused", is_refused(process, "mood", "statistics"), process.stderr)
    process = run_script(directory, "sweep.py", *case, "50", *options, "--set", "End time=4e-3")
    check("other settings are run anew", process.returncode == 0 and "50: started" in process.stdout, process.stdout)
    times = statistics(os.path.join(directory, "sweep", "50", "statistics"))["Time (s)"]
    check("and hold", abs(times[-1] - 4e-3) < 1e-12, times)

    for what, arguments, word in (
            ("a case that is not there", ["nowhere.prm", ENTRY, "1", *options], "nowhere.prm"),
            ("a program that is not there", [*case, "1", "--lahar", "nowhere", "-o", "sweep"], "nowhere"),
            ("an entry that is not there", ["case.prm", "Fluids/fluid/Mood", "1", *options], "Fluids/fluid/Mood"),
            ("an entry with a value", ["case.prm", "Mesh size=1", "1", *options], "Mesh size=1"),
            ("the output directory", [*case, "1", *options, "--set", "Output directory=a"], "Output directory"),
            ("a setting without value", [*case, "1", *options, "--set", "End time"], "End time"),
            ("a value twice", [*case, "1", "1", *options], "'1'")):
        process = run_script(directory, "sweep.py", *arguments)
        check(f"{what} is refused", is_refused(process, word), process.returncode, process.stderr)


def test_film(directory):
    run = os.path.join("sweep", "200")
    n_moving = len([name for name in os.listdir(os.path.join(directory, run)) if name.startswith("walls-")])
    check("the walls move", n_moving > 1, n_moving)
    for name, *options in (("flow.mp4",), ("flow.gif", "--field", "yielded", "--width", "301", "--fps", "20")):
        process = run_script(directory, "animate.py", run, "-o", name, *options)
        check(f"{name} is made of 5 snapshots", process.returncode == 0 and "5 frames" in process.stdout,
              process.stderr)
        probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                                "stream=nb_read_frames,codec_name,pix_fmt,width,height", "-of", "json", name],
                               cwd=directory, stdout=subprocess.PIPE, text=True)
        stream = (json.loads(probe.stdout).get("streams") or [{}])[0]
        check("and has 5 frames", stream.get("nb_read_frames") == "5", stream)
        if name == "flow.mp4":
            check("as any player reads it", (stream["codec_name"], stream["pix_fmt"]) == ("h264", "yuv420p")
                  and stream["width"] % 2 == 0 == stream["height"] % 2, stream)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-i", name, name + "-%d.png"], cwd=directory,
                       stdin=subprocess.DEVNULL)
        frames = [os.path.join(directory, f"{name}-{i}.png") for i in (1, 5)]
        check("frames show something", all(map(is_drawing, frames)))
        if all(map(os.path.isfile, frames)):
            import matplotlib.image
            first, last = (matplotlib.image.imread(frame)[..., :3] for frame in frames)
            check("and differ", first.shape == last.shape and abs(first - last).max() > 0.2)

    os.makedirs(os.path.join(directory, "space"))
    with open(os.path.join(directory, "space", "parameters.prm"), "w") as file:
        file.write("set Dimension = 3 # default: 2\n")
    os.makedirs(os.path.join(directory, "empty"))
    for name, entries in (("space", '<DataSet timestep="0" part="0" file="solution-00000.vtu"/>'), ("empty", "")):
        with open(os.path.join(directory, name, "solution.pvd"), "w") as file:
            file.write(f'<VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
    for what, arguments, words in (
            ("a run in space", ["space"], ["space", "render.py"]),
            ("a run without snapshot", ["empty"], ["empty", "no snapshot"]),
            ("a run that is not there", ["nowhere"], ["nowhere"]),
            ("a field that is not there", [run, "--field", "mood"], ["mood"]),
            ("another kind of film", [run, "-o", "flow.avi"], ["flow.avi", ".mp4"]),
            ("no speed", [run, "--fps", "0"], ["--fps"])):
        process = run_script(directory, "animate.py", *arguments)
        check(f"{what} is refused", is_refused(process, *words), process.returncode, process.stderr)
    process = run_script(directory, "animate.py", run, PATH="/nowhere")
    check("without ffmpeg the package is named", is_refused(process, "ffmpeg is missing", "apt install ffmpeg"),
          process.stderr)


def main():
    if not importlib.util.find_spec("numpy") or not importlib.util.find_spec("matplotlib") \
            or not shutil.which("ffmpeg") or not shutil.which("ffprobe"):
        print("not tested: numpy, matplotlib or ffmpeg is missing")
        sys.exit(SKIPPED)
    plate = wall("0.14, 0.02 : 0.14, 0.1") + "set Motion = translation\n"
    plate += section("translation", "set Displacement = t; 0")
    with tempfile.TemporaryDirectory() as parent:
        directory = new_case(parent, "films", CASE + fluid("0, 0 : 0.08, 0.1") + parts(
            "Boundaries", {"floor": wall("0, 0.14 : 0, 0 : 0.2, 0"), "plate": plate}))
        test_sweep(directory, os.path.abspath(sys.argv[1]))
        test_film(directory)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
