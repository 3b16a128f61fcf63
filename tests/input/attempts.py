# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the program from outside share: a small case that is right, and attempts that must be refused.

The scripts are called GROUP LAHAR MESH_FILE MESH_FILE_IN_SPACE SERVER; the last is check_server.cc.
"""
import argparse
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE, check, fluid, new_case, section, walls  # noqa: E402
from readers import Server  # noqa: E402

GROUP = sys.argv[1]
LAHAR, MESH, MESH_IN_SPACE, SERVER = [os.path.abspath(path) for path in sys.argv[2:6]]

TOP = """
set Output directory = out
set End time         = 4e-3
set Time step        = 1e-3
set Mesh size        = 0.03
set Output interval  = 2e-3
"""
COLUMN = fluid("0, 0 : 0.146, 0.292")
GOOD = TOP + COLUMN + walls("0, 0.4 : 0, 0 : 0.5, 0")

# What the entries of fluid and walls begin with.
FLUID, WALLS = "Fluids/fluid/", "Boundaries/walls/"

FRAMES = ["Stacktrace", "An error occurred in line", "terminate called", "Aborting", "exception", "Exception",
          "std::", "Lahar::", "dealii::", "Backtrace", "Segmentation", "parameter_handler.cc"]


def run(directory, *arguments, text=GOOD):
    if text is not None:
        with open(os.path.join(directory, "case.prm"), "w", encoding="utf-8") as file:
            file.write(text)
    try:
        return subprocess.run([LAHAR, *arguments], cwd=directory, env=ALONE, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300, text=True)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(arguments, 124, "", "no end within 300 s")


def check_refusal(what, parts, status, message, screen, before, after):
    """The run must have ended with status 2, a message that holds all parts, and left nothing."""
    check(what + ": status 2", status == 2, status, message)
    missing = [part for part in parts if part not in message]
    check(what + ": message", message.strip() and not missing, "missing: %s" % missing, message)
    frames = [frame for frame in FRAMES if frame in message + screen]
    check(what + ": no frame", not frames and message.count("\n") <= 6, frames, message)
    check(what + ": nothing left behind", before == after, after)


def refused(what, parts, *arguments, text=GOOD, case="case.prm", prepare=None):
    """The program must refuse the case."""
    with tempfile.TemporaryDirectory() as directory:
        if prepare:
            prepare(directory)
        before = sorted(os.listdir(directory) + (["case.prm"] if text is not None else []))
        result = run(directory, *([case] if case else []), *arguments, text=text)
        after = sorted(os.listdir(directory))
    check_refusal(what, parts, result.returncode, result.stderr, result.stdout, before, after)


def set_entry(entry, value):
    return ["--set", "%s=%s" % (entry, value)]


def as_text(settings):
    """What --set Section/Entry=value is in a parameter file."""
    text = ""
    for setting in settings:
        path, value = setting.split("=", 1)
        *sections, entry = path.split("/")
        lines = "set %s = %s\n" % (entry, value)
        for name in reversed(sections):
            lines = section(name, lines)
        text += lines
    return text


class Started:
    """Programs that have started already: a start takes longer than reading a case."""
    servers = []

    @classmethod
    def read(cls, directory):
        if not cls.servers:
            limits = argparse.Namespace(lahar=LAHAR, server=SERVER, seconds=300, memory=0, batch=50, largest=10000000)
            cls.servers.append(Server(limits))
        return cls.servers[0].read(directory)


def wrong(entry, value, *parts, more=()):
    """A wrong value of one entry must be named by its path; @p more are further settings as for --set."""
    with tempfile.TemporaryDirectory() as parent:
        directory = new_case(parent, "case", GOOD + as_text([*more[1::2], "%s=%s" % (entry, value)]))
        status, out, err = Started.read(directory)
        after = os.listdir(directory)
    check_refusal("%s = %s" % (entry, value), ["'%s'" % entry, value, "llowed", *parts], status,
                  err.decode(errors="replace"), out.decode(errors="replace"), ["case.prm"], after)


def write_spike(directory):
    """The mesh in space with one corner far away: little volume in a box of 10^8 cubes of the mesh size."""
    with open(MESH_IN_SPACE) as mesh, open(os.path.join(directory, "spike.msh"), "w") as spike:
        spike.write(mesh.read().replace("\n1 0 0 0\n", "\n1 -1500 -325 -324\n", 1))


def in_spike():
    return [*set_entry("Mesh size", "0.9"), *set_entry(FLUID + "Shape", "mesh"), *set_entry(FLUID + "mesh/File", "spike.msh"),
            *set_entry(FLUID + "mesh/Groups", "fluid")]
