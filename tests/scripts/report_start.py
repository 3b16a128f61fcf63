#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lahar --write-start and the page that contrib/report/lahar-report makes of what it writes: the first mesh, names, sizes
and estimate, in the plane and in space; a run's directory is left alone.

Usage: report_start.py LAHAR CHROMIUM. Exit status 77 (skipped) without numpy or plotly; without Chromium the pages are
not opened.
"""
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from report import PLANE, REPORT, SPACE, Page, area, compute, run_tests, write_report  # noqa: E402
from program_test import ENVIRONMENT, check, new_case  # noqa: E402
from scripts import is_refused, run_script  # noqa: E402

FILES = {"parameters.prm", "log", "solution.pvd", "solution-00000.vtu", "walls.vtu"}


def lahar_start(lahar, directory, *arguments):
    return subprocess.run([lahar, *arguments, "case.prm"], cwd=directory, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def content(directory):
    return {name: os.stat(os.path.join(directory, name)).st_mtime_ns for name in os.listdir(directory)}


def test_files(lahar, directory, text, files):
    folder = new_case(*os.path.split(directory), text)
    start = os.path.join(folder, "start")
    printed = lahar_start(lahar, folder, "--check").stdout
    for again in ("", " again"):
        process = lahar_start(lahar, folder, "--write-start", "start")
        check(f"it writes the start{again}", process.returncode == 0 and set(os.listdir(start)) == files,
              process.stderr, os.listdir(start))
    check("it prints what --check prints, and keeps it", printed and process.stdout == printed
          and open(os.path.join(start, "log")).read() == printed, process.stdout, printed)
    check("the case's own output directory is not made", sorted(os.listdir(folder)) == ["case.prm", "start"],
          os.listdir(folder))
    return printed


def test_refused(lahar, directory):
    output = os.path.join(directory, compute(lahar, directory, "run", PLANE, "--set", "End time=0.004"))
    before = content(output)
    process = lahar_start(lahar, os.path.join(directory, "run"), "--write-start", "out")
    check("a directory with a run is refused", process.returncode == 2 and all(
        word in process.stderr for word in ("--write-start", "'out'", "statistics", "Allowed")), process.stderr)
    check("and stays as it is", content(output) == before, before, content(output))
    # Runs that have lost files, and what is said of them.
    for left, said in (({"checkpoint/state": ""}, "checkpoint/state"), ({"log": ""}, "log"),
                       ({"solution-00000.vtu": "", "parameters.prm": ""}, "solution-00000.vtu"),
                       ({"solution-00007.vtu": "", "parameters.prm": "", "log": ""}, "solution-00007.vtu"),
                       ({"parameters.prm": "", "log": "step      1  t = 0.002\n"}, "log")):
        with tempfile.TemporaryDirectory(dir=os.path.join(directory, "run")) as lost:
            for name, text in left.items():
                path = os.path.join(lost, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w") as file:
                    file.write(text)
            before = content(lost)
            process = lahar_start(lahar, os.path.join(directory, "run"), "--write-start", lost)
            check(f"a directory with {', '.join(left)} is refused and stays as it is", process.returncode == 2
                  and f"'{os.path.join(lost, said)}'" in process.stderr and content(lost) == before,
                  process.stderr, before, content(lost))
    for option in ("--resume", "--overwrite"):
        process = lahar_start(lahar, os.path.join(directory, "run"), "--write-start", "start", option)
        check(f"{option} is refused beside it", process.returncode == 2 and option in process.stderr, process.stderr)
    for arguments in (("plane/start", "run/out"), ("plane/start", "space/start"), ("plane/start", "--follow")):
        process = run_script(directory, REPORT, *arguments, "-o", "refused.html")
        check(f"a report of {' '.join(arguments)} is refused", is_refused(process, "a start", "allowed"), process.stderr)


def test_page(directory, name, printed, browser):
    path = os.path.join(directory, name + ".html")
    write_report(directory, name + ".html", f"{name}/start=The case")
    page = Page(path)
    facts = {key: value for key, value in re.findall(r"<div><dt>(.*?)</dt><dd>(.*?)</dd></div>", page.text)}
    told = dict(re.match(r"(.*?)  +(.*)", line).groups() for line in printed.splitlines() if not line.startswith("Warning"))
    check(f"{name}: the page has the sizes and the estimate", facts == told and "Estimate" in facts
          and "Time steps" in facts, facts, told)
    run = page.data["run"]
    check(f"{name}: and one snapshot", [s["time"] for s in run["flow"]["snapshots"]] == [0.])
    head = run["flow"]["snapshots"][0]["fluid"]
    if name == "plane":
        page.data["runs"] = [run]
        check("the triangles cover the volume", abs(area(page, 0, 0) / float(facts["Fluid volume"].split()[0]) - 1.) < 1e-3)
        check("they are the fluid's cells", head["triangles"] == int(facts["Fluid cells"]), head, facts)
    if browser is None:
        return
    check(f"{name}: it opens", browser.open(path) is not None and not browser.errors, browser.errors)
    lines = browser.evaluate("""Math.max(...document.querySelector(".sketch").data.map(
      trace => Array.from(trace.x || []).filter(x => x === null).length))""")
    check(f"{name}: it draws every triangle", lines == head["triangles"], lines, head)
    check(f"{name}: with names", browser.wait_for(
        '[...document.querySelectorAll(".sketch .annotation-text, .sketch .annotation text")]'
        '.some(text => text.textContent.includes("no slip"))'))


def test_start(lahar, directory, browser):
    for name, text, files in (("plane", PLANE, FILES | {"solid-00000.vtu"}), ("space", SPACE, FILES)):
        test_page(directory, name, test_files(lahar, os.path.join(directory, name), text, files), browser)
    test_refused(lahar, directory)


def main():
    lahar, chromium = os.path.abspath(sys.argv[1]), sys.argv[2]
    run_tests(lambda directory, browser: test_start(lahar, directory, browser), chromium, "numpy", "plotly")


if __name__ == "__main__":
    main()
