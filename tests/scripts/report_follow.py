#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/report/lahar-report --follow on a directory that grows like that of a run which goes on, with files that are
half written: the page has what is there, takes over what comes without a reload, and ends with the run.

Usage: report_follow.py LAHAR CHROMIUM. Exit status 77 (skipped) without numpy or plotly; without Chromium only what the
server says is tested.
"""
import json
import os
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import time
import urllib.error
import urllib.request

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, HERE)
from report import PLANE, REPORT, Page, compute, run_tests, show, write_report  # noqa: E402
from program_test import check  # noqa: E402
from scripts import is_refused, run_script  # noqa: E402

PATIENCE = 120.  # s, on a busy machine


def start(directory, *arguments):
    """lahar-report --follow as a process, and the address that it says."""
    process = subprocess.Popen([sys.executable, "-B", os.path.join(ROOT, "contrib", REPORT), "--follow", *arguments],
                               cwd=directory, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    line = process.stdout.readline()
    found = re.match(r"(http://127\.0\.0\.1:(\d+)/) shows ", line)
    check("it says where the page is", found is not None, line, "" if found else process.stderr.read())
    return process, found[1]


def ask(address, **headers):
    with urllib.request.urlopen(urllib.request.Request(address, headers=headers), timeout=PATIENCE) as reply:
        return reply.read().decode()


def wait_for(address, condition):
    """Waits until the condition holds for the server's state; the state."""
    end = time.monotonic() + PATIENCE
    while True:
        state = json.loads(ask(address + "version"))
        if condition(state) or time.monotonic() > end:
            return state
        time.sleep(0.1)


def wait_for_version(address, least):
    """Waits for this version of the page or a later one; the server's state."""
    return wait_for(address, lambda state: state["version"] >= least)


def leave(address):
    """What a browser does that asks for the page and is closed at once: it resets the connection."""
    host, port = re.match(r"http://(.*):(\d+)/", address).groups()
    for request in (b"", f"GET / HTTP/1.1\r\nHost: {host}:{port}\r\n\r\n".encode(), b"GET /nothing HTTP/1.1\r\n\r\n"):
        with socket.create_connection((host, int(port))) as connection:
            connection.sendall(request)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))


class GrowingRun:
    """The files of a finished run, put into a directory bit by bit."""

    def __init__(self, whole, directory):
        self.whole, self.directory = whole, directory
        os.mkdir(directory)
        shutil.copy(os.path.join(whole, "parameters.prm"), directory)
        self.write("lock", f"host {socket.gethostname()}\nprocess {os.getpid()}\nsince 2026-01-01 00:00:00 UTC\n")
        self.write("log", self.read("log").split("step ")[0])

    def read(self, name):
        with open(os.path.join(self.whole, name)) as file:
            return file.read()

    def write(self, name, text):
        with open(os.path.join(self.directory, name), "w") as file:
            file.write(text)

    def grow(self, n_steps, n_snapshots):
        """So many steps and snapshots, and the half of the next lines."""
        for k in range(n_snapshots):
            for name in ("solution", "solid"):
                shutil.copy(os.path.join(self.whole, f"{name}-{k:05}.vtu"), self.directory)
        shutil.copy(os.path.join(self.whole, "walls.vtu"), self.directory)
        records = self.read("solution.pvd").splitlines(keepends=True)
        n_sets = [i for i, line in enumerate(records) if f"solution-{n_snapshots - 1:05}" in line][0] + 3
        self.write("solution.pvd", "".join(records[:n_sets] + records[-2:]))
        for name in ("statistics", "log"):
            lines = self.read(name).splitlines(keepends=True)
            first = next(i for i, line in enumerate(lines) if re.match(r" *1 |step +1 ", line))
            rest = "".join(lines[first + n_steps:])
            self.write(name, "".join(lines[:first + n_steps]) + rest[:len(lines[first]) - 3])

    def end(self):
        for name in os.listdir(self.whole):
            if name != "checkpoint":
                shutil.copy(os.path.join(self.whole, name), self.directory)
        os.remove(os.path.join(self.directory, "lock"))


WIDTHS = """[...document.querySelectorAll("[data-plot][data-drawn]")].map(div => [div.clientWidth, div._fullLayout.width])"""
FRONT = """[...document.querySelectorAll("[data-plot]")].map(div => div.data && div.data[0].x.length || 0)
  .reduce((a, b) => Math.max(a, b), 0)"""
SLIDER = 'document.getElementById("slider").value + " of " + document.getElementById("slider").max'


def test_following(directory, whole, browser):
    run = GrowingRun(os.path.join(directory, whole), os.path.join(directory, "growing"))
    process, address = start(directory, "growing", "-o", "end.html")
    state = wait_for(address, lambda state: state["complaint"])
    check("before the first step the page says so", "statistics" in ask(address) and state["version"] == 0,
          ask(address), state)
    for _ in range(5):
        leave(address)
    run.grow(4, 2)
    state = wait_for_version(address, 1)
    check("then there is a page", state == {"version": 1, "ended": False, "complaint": ""}, state)
    check("that says how far the run is", re.search(r'class="subtitle">goes on, 0\.016 of 0\.048 s, 33 %, about .* left',
                                                    ask(address)), ask(address)[:3000])
    check("the news come without plotly", len(ask(address + "news")) < len(ask(address)) / 2)
    for host in ("example.org", "127.0.0.1"):
        try:
            check(f"a page of {host} learns nothing", not ask(address, Host=host))
        except urllib.error.HTTPError as error:
            check(f"a page of {host} learns nothing", error.code == 404)

    if browser:
        browser.allowed += (address,)
        check("the page opens", browser.open(address) is not None, browser.errors)
        check("with the last snapshot", browser.evaluate(SLIDER) == "1 of 1", browser.evaluate(SLIDER))
        browser.evaluate('document.getElementById("curves").scrollIntoView()')
        check("its curves have the whole steps", browser.wait_for(f"{FRONT} === 4"), browser.evaluate(FRONT))
        browser.evaluate("window.here = true")
    run.grow(10, 4)
    state = wait_for_version(address, 2)
    if browser:
        version = state["version"]
        check("the page takes over what is new", browser.wait_for(f'document.body.dataset.version >= {version}'))
        check("without a reload", browser.evaluate("window.here") is True)
        check("its curves go on", browser.wait_for(f"{FRONT} === 10"), browser.evaluate(FRONT))
        check("every frame is as wide as its place", browser.wait_for(
            f"{WIDTHS}.every(([place, frame]) => Math.abs(place - frame) < 1)"), browser.evaluate(WIDTHS))
        check("it stays with the last snapshot", browser.wait_for(f'{SLIDER} === "3 of 3"'), browser.evaluate(SLIDER))
        check("the state is new", browser.wait_for(
            'document.querySelector(".subtitle").textContent.includes("83 %")'))
        show(browser, 1, "pressure")

    records = os.path.join(run.directory, "solution.pvd")
    with open(records) as file:
        text = file.read()
    run.write("solution.pvd", text[:len(text) // 2])
    state = wait_for(address, lambda state: state["complaint"])
    check("files that cannot be read are complained about, and the page stays", "solution.pvd" in state["complaint"]
          and "goes on" in ask(address), state)
    if browser:
        check("in the page, too", browser.wait_for(
            'document.getElementById("follow").textContent.includes("solution.pvd")'))
    run.end()
    if browser:
        check("the page says that the run has ended", browser.wait_for(
            'document.getElementById("follow").textContent === "The run has ended."'))
        check("it has all snapshots, and stays with the one that was chosen", browser.evaluate(SLIDER) == "1 of 4"
              and browser.evaluate('document.getElementById("field").value') == "pressure", browser.evaluate(SLIDER))
        check("and what the run ended with", browser.evaluate(
            'document.querySelector(".subtitle").textContent').startswith("finished, 0.048 s"))
        check("nobody complains", not browser.errors
              and browser.evaluate('document.getElementById("complaint").hidden'), browser.errors)
    text, errors = process.communicate(timeout=PATIENCE)
    check("it ends with the run", process.returncode == 0 and not errors and "The run has ended." in text, text, errors)
    page = Page(os.path.join(directory, "end.html"))
    other = write_report(directory, "other.html", "growing")
    check("and leaves the report of the whole run", page.data == other.data)


def test_unreadable_ends(directory, whole, browser):
    run = GrowingRun(os.path.join(directory, whole), os.path.join(directory, "nothing"))
    process, address = start(directory, "nothing")
    wait_for(address, lambda state: state["complaint"])
    os.remove(os.path.join(run.directory, "lock"))
    wait_for(address, lambda state: state["ended"])
    text = ask(address)
    check("the page of a run that ends without a step says so, and asks no more", "statistics" in text
          and "has ended" in text and "refresh" not in text, text)
    text, errors = process.communicate(timeout=PATIENCE)
    check("and lahar-report ends with the reason and status 2", process.returncode == 2 and "statistics" in errors
          and len(errors.splitlines()) == 1 and "has ended" not in text, process.returncode, text, errors)

    run = GrowingRun(os.path.join(directory, whole), os.path.join(directory, "damaged"))
    run.grow(4, 2)
    process, address = start(directory, "damaged")
    wait_for_version(address, 1)
    if browser:
        browser.allowed += (address,)
        browser.open(address)
    run.write("solution.pvd", "<VTKFile")
    os.remove(os.path.join(run.directory, "lock"))
    state = wait_for(address, lambda state: state["ended"])
    check("a run whose files cannot be read at the end", "solution.pvd" in state["complaint"], state)
    if browser:
        line = 'document.getElementById("follow").textContent'
        check("has a page that says it", browser.wait_for(f'{line}.includes("has ended")') and browser.evaluate(
            f'/^Not up to date: .*solution.pvd/.test({line})'), browser.evaluate(line))
    else:
        ask(f"{address}version?{state['version']}")
    text, errors = process.communicate(timeout=PATIENCE)
    check("and lahar-report says it", process.returncode == 0 and not errors and re.search(
        "^Not up to date: .*solution.pvd", text, re.M), process.returncode, text, errors)


def test_ends(directory, whole):
    run = GrowingRun(os.path.join(directory, whole), os.path.join(directory, "stopped"))
    run.grow(4, 2)
    process, address = start(directory, "stopped")
    wait_for_version(address, 1)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=PATIENCE)
    check("Ctrl-C ends it", process.returncode == 0 and not errors, errors)
    result = run_script(directory, REPORT, "--follow", whole)
    check("a run that has ended is refused", is_refused(result, "no run goes on", "-o"), result.stderr)
    dead = subprocess.Popen(["true"])
    dead.wait()
    run.write("lock", f"host {socket.gethostname()}\nprocess {dead.pid}\nsince 2026-01-01 00:00:00 UTC\n")
    result = run_script(directory, REPORT, "--follow", "stopped")
    check("and one that was killed", is_refused(result, "no run goes on"), result.stderr)
    check("which its report says", "was killed at 0.016" in write_report(directory, "killed.html", "stopped").text)
    run.write("lock", f"host {socket.gethostname()}\nprocess {os.getpid()}\nsince 2026-01-01 00:00:00 UTC\n")
    for port in ("70000", "-3"):
        result = run_script(directory, REPORT, "--follow", "stopped", "--port", port)
        check(f"port {port} is refused", is_refused(result, "--port", "allowed"), result.stderr)
    result = run_script(directory, REPORT, "stopped")
    check("neither -o nor --follow is refused", is_refused(result, "-o", "--follow"), result.stderr)


def test_all(lahar, directory, browser):
    whole = compute(lahar, directory, "whole", PLANE)
    test_following(directory, whole, browser)
    test_unreadable_ends(directory, whole, browser)
    test_ends(directory, whole)


def main():
    lahar, chromium = os.path.abspath(sys.argv[1]), sys.argv[2]
    run_tests(lambda directory, browser: test_all(lahar, directory, browser), chromium, "numpy", "plotly")


if __name__ == "__main__":
    main()
