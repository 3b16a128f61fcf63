#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `lahar` shows on a terminal: one line that rewrites itself, narrower than the terminal, with messages above it and
the last step at the end; where the terminal has no width or cannot erase, a line a step; none in a pipe.

Usage: terminal.py LAHAR
"""
import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program_test import ALONE, check, failed, fluid, new_case, section, walls  # noqa: E402

LAHAR = os.path.abspath(sys.argv[1])
N_STEPS, END, ENDLESS = 20, 0.04, 40.  # s
CASE = f"""
set Output directory = out
set End time         = {END}
set Time step        = 2e-3
set Mesh size        = 0.02
set Output interval  = 0
""" + fluid("0, 0 : 0.146, 0.292", section("Bingham", "set Yield stress = 20")) + walls("0, 0.4 : 0, 0 : 0.5, 0")
PATIENCE = 200.  # s, for a run on a busy machine
LINE = re.compile(r" *(\d+) %  t = (\S+) of (\S+) s  step (\d+)  iterations +\d+  volume [+-]\d+\.\d+ %  "
                  r"left \d+:\d\d:\d\d")


def run_on_terminal(directory, width, *options, terminal="xterm", meanwhile=None):
    """What the program writes to a terminal, on both streams; its status and the seconds that it took. @p meanwhile is
    called with the process while it runs."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24 if width else 0, width, 0, 0))
    begin = time.monotonic()
    process = subprocess.Popen([LAHAR, *options, "case.prm"], cwd=directory, env=dict(ALONE, TERM=terminal),
                               stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs)
    os.close(theirs)
    thread = threading.Thread(target=meanwhile or (lambda process: None), args=(process,))
    thread.start()
    text = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # nobody writes any more
            piece = b""
        if not piece:
            break
        text += piece
    os.close(ours)
    thread.join()
    return text.decode(), process.wait(), time.monotonic() - begin


def screen(text):
    """The lines that stand on a terminal in the end."""
    lines, column = [""], 0
    for part in re.findall(r"\x1b\[K|\r|\n|[^\r\n\x1b]+|\x1b", text):
        if part == "\n":
            lines.append("")
        elif part == "\r":
            column = 0
        elif part == "\x1b[K":
            lines[-1] = lines[-1][:column]
        else:
            lines[-1] = lines[-1][:column].ljust(column) + part + lines[-1][column + len(part):]
            column += len(part)
    return lines


def logged(directory):
    """The lines of the log: those of steps, and all others."""
    with open(os.path.join(directory, "out", "log")) as file:
        lines = file.read().splitlines()
    return ([line for line in lines if line.startswith("step ")],
            [line for line in lines if not line.startswith("step ") and not line.startswith("The run failed. ")])


def test_wide(parent):
    directory = new_case(parent, "wide", CASE)
    text, status, seconds = run_on_terminal(directory, 100)
    steps, messages = logged(directory)
    lines = screen(text)
    check("a run on a terminal", status == 0 and len(steps) == N_STEPS, status, text)
    last = [LINE.fullmatch(line) for line in lines if " left " in line]
    check("there is one line of steps", len(last) == 1 and last[0], lines)
    check("it is that of the last one", last[0].groups() == ("100", "0.04", "0.04", str(N_STEPS)), last[0][0])
    check("all messages stand above and below it, whole", [line for line in lines if " left " not in line]
          == messages + [""], lines, messages)
    check("it stands between the sizes and the times", lines.index(last[0][0]) == messages.index("Times by phase") - 1,
          lines)
    n_drawn = text.count(" left ")
    check("it is rewritten, and ten times a second at most", 2 <= n_drawn <= 10. * seconds + 3, n_drawn, seconds)


def test_narrow(parent):
    for width in (60, 30, 12, 4):
        directory = new_case(parent, f"narrow{width}", CASE)
        text, status, _ = run_on_terminal(directory, width)
        drawn = re.findall(r"\r\x1b\[K([^\r\n]+)", text)
        check(f"in {width} columns the line is shorter", status == 0 and drawn
              and all(len(line) < width for line in drawn), drawn)
        if width >= 30:
            check("... and says what is left", all("left 0:0" in line and " %" in line for line in drawn), drawn)


def during_a_run(directory, action):
    """Runs without end on a terminal, and calls the action, which ends the run, with the output directory, the process
    and a function that waits for a condition, once there are some steps."""
    output = os.path.join(directory, "out")
    end = time.monotonic() + PATIENCE

    def act(process):
        def wait_for(condition):
            while process.poll() is None and time.monotonic() < end and not condition():
                time.sleep(0.005)

        wait_for(lambda: os.path.exists(os.path.join(output, "log")) and len(logged(directory)[0]) >= 3)
        try:
            action(output, process, wait_for)
        finally:
            wait_for(lambda: False)
            process.kill()

    text, status, _ = run_on_terminal(directory, 100, "--set", f"End time={ENDLESS}", meanwhile=act)
    return screen(text), status


def test_messages(parent):
    directory = new_case(parent, "messages", CASE)

    def remove(output, process, wait_for):
        path = os.path.join(output, "parameters.prm")
        for _ in range(3):
            os.remove(path)
            wait_for(lambda: os.path.exists(path))
        process.terminate()

    lines, status = during_a_run(directory, remove)
    messages = logged(directory)[1]
    warnings = [line for line in messages if "parameters.prm' was removed" in line]
    check("a run whose parameters others remove warns", status == 0 and len(warnings) == 3, status, lines)
    check("every message stands on a line of its own", [line for line in lines if " left " not in line]
          == messages + [""], lines, messages)
    check("... and one line of steps remains, after them", sum(" left " in line for line in lines) == 1
          and lines.index(next(line for line in lines if " left " in line)) == messages.index("Times by phase") - 1, lines)


def test_failure(parent):
    directory = new_case(parent, "failure", CASE)
    lines, status = during_a_run(directory, lambda output, *_: os.rename(output, output + "-renamed"))
    check("a run that fails says so on a line of its own, below that of the last step", status == 1
          and LINE.fullmatch(lines[-3]) and lines[-2].startswith("lahar: the run failed. ") and lines[-1] == "", status,
          lines)


def test_plain(parent):
    for what, width, terminal in (("without a width", 0, "xterm"), ("that cannot erase", 100, "dumb")):
        directory = new_case(parent, what.replace(" ", "_"), CASE)
        text, status, _ = run_on_terminal(directory, width, terminal=terminal)
        steps, _ = logged(directory)
        shown = text.replace("\r\n", "\n").splitlines()
        check(f"a terminal {what} has a line a step", status == 0 and [line for line in shown if line.startswith("step ")]
              == steps and len(steps) == N_STEPS, text)
        check("... and no other sign", "\r" not in text.replace("\r\n", "") and "\x1b" not in text, text)
    directory = new_case(parent, "pipe", CASE)
    process = subprocess.run([LAHAR, "case.prm"], cwd=directory, env=dict(ALONE, TERM="xterm"), stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, text=True)
    check("a pipe has the messages only", process.stdout.splitlines() == logged(directory)[1]
          and "\x1b" not in process.stdout, process.stdout)


def main():
    with tempfile.TemporaryDirectory() as parent:
        test_wide(parent)
        test_narrow(parent)
        test_messages(parent)
        test_failure(parent)
        test_plain(parent)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
