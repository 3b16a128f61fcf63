#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Feed the program `lahar` mutated input, from outside.

The parameter files of prm/ and tests/rough but those of geometries that gmsh meshes, and the gmsh files of prm/ and tests/geometry, with coarser meshes, are
mutated at random (mutations.py) and read by `lahar --check`, which builds the first mesh. Each run must end

* with status 0 and no message on stderr, or with 1 or 2 and one on stderr that shows no C++ or deal.II frame,
* never by a signal,
* within --seconds, or if that is missed, when it is tried once more, and with --memory of address space,
* without a file left behind.

More particles or nodes than --largest are refused, so that no input takes long. Inputs that miss this are printed, and
kept in the directory --keep. Each input depends on seed and number only: --first is the number to begin with.

With --server the inputs are read by children of that program (check_server.cc), which does not start anew for each one.
What fails there is read by `lahar`, too, and so is every input whose number is a multiple of --compare; both must print
the same.

Usage: fuzz.py LAHAR [--server CHECK_SERVER] [--number N] [--seed S] [--seconds T] [--memory GIB] [--keep DIRECTORY] ...
"""
import argparse
import collections
import os
import pathlib
import random
import re
import shutil
import sys
import tempfile
import time

from mutations import WORD, Mutator
from readers import Program, Server

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from program_test import mesh, parts  # noqa: E402

FRAMES = ["Stacktrace", "An error occurred in line", "terminate called", "Aborting", "exception", "Exception",
          "std::", "Lahar::", "dealii::", "Backtrace", "Segmentation", "parameter_handler.cc", "CGAL"]


class Case:
    """A parameter file and the mesh files that it names, as bytes by their names."""

    def __init__(self, name, files):
        self.name, self.files, self.is_ready = name, files, False

    def coarsen(self, reader):
        """Make the mesh size the largest one that works, so that runs are short."""
        text = self.files["case.prm"]
        for factor in (6., 4., 3., 2., 1.):
            self.files["case.prm"] = re.sub(
                rb"(set Mesh size *= *)([-0-9.e]+)", lambda m: m[1] + b"%g" % (factor * float(m[2])), text)
            if run(reader, self.files).status == 0:
                self.is_ready = True
                return
        sys.exit("%s: does not work unchanged" % self.name)

    def mutated(self, mutator):
        """The files, one of them changed, and its name."""
        files = dict(self.files)
        meshes = [name for name in files if name != "case.prm"]
        name = random.choice(meshes) if meshes and random.random() < 0.8 else "case.prm"
        files[name] = mutator.mutate(files[name])
        return files, name


def find_cases():
    cases = []
    for path in sorted([*ROOT.glob("prm/**/*.prm"), *ROOT.glob("tests/rough/*.prm")]):
        text = path.read_bytes()
        if re.search(rb"= *\S+\.geo", text):
            continue  # gmsh's own library meshes it
        files = {name.decode(): (path.parent / name.decode()).read_bytes()
                 for name in re.findall(rb"= *(\S+\.(?:msh|asc|csv|stl|off))", text)}
        cases.append(Case(str(path.relative_to(ROOT)), dict({"case.prm": text}, **files)))
    # The column lies in the plane, the basin in space; the first attempt of coarsen() works with these sizes.
    for pattern, dimension, size, floor in (("column*", "2", "0.02", "0, 0 : 1, 0"),
                                            ("basin*", "3", "0.06", "0, 0, 0 : 1, 1, 0")):
        for path in sorted(ROOT.glob("tests/geometry/%s.msh" % pattern)):
            data = path.read_bytes()
            for use, text in [
                    ("fluid", parts("Fluids", {"fluid": mesh("case.msh", "fluid")}) +
                              parts("Boundaries", {"walls": mesh("case.msh", "walls")})),
                    ("solid", parts("Solids", {"solid": mesh("case.msh", "fluid") + "set Clamped = " + floor}))]:
                text = "set Dimension = " + dimension + "\nset Mesh size = " + size + "\n" + text
                cases += 2 * [Case("%s as %s" % (path.relative_to(ROOT), use),
                                   {"case.prm": text.encode(), "case.msh": data})]
    return cases


class Result:
    def __init__(self, status, out, err, left_behind, seconds):
        self.status, self.out, self.err, self.left_behind, self.seconds = status, out, err, left_behind, seconds

    def wrong(self):
        """What must not be, or None."""
        if self.status is None:
            return "no end within the time allowed"
        if self.status not in (0, 1, 2):
            return "ended by signal %d" % -self.status if self.status < 0 else "status %d" % self.status
        if self.status == 0 and self.err:
            return "status 0 with a message on stderr"
        if self.status == 0 and " particles" not in self.out:
            return "status 0 without sizes"
        if self.status != 0 and not re.search("^lahar: ", self.err, re.MULTILINE):
            return "status %d without a message" % self.status
        if [frame for frame in FRAMES if frame in self.err]:
            return "a frame in the message"
        if self.err.count("\n") > 10 or len(self.err) > 4000:
            return "a message too long"
        if self.left_behind:
            return "files left behind: %s" % self.left_behind
        return None


def run(reader, files):
    """Let the reader have the files in a directory of their own."""
    directory = tempfile.mkdtemp()
    try:
        names = set()
        for name, data in files.items():
            path = os.path.join(directory, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data)
            names.add(name.split("/")[0])
        begin = time.monotonic()
        status, out, err = reader.read(directory)
        out, err = (data.decode(errors="replace").replace(directory + "/", "") for data in (out, err))
        return Result(status, out, err,
                      sorted(set(os.listdir(directory)) - names), time.monotonic() - begin)
    finally:
        shutil.rmtree(directory)


def patiently(reader, files):
    """The result, the second one if the first one came too late, since the machine may have been busy; and whether."""
    result = run(reader, files)
    return (run(reader, files), True) if result.status is None else (result, False)


def difference(result, other):
    """What the server's child has said in another way than the program, or None."""
    for what in ("status", "err", "out"):
        if getattr(result, what) != getattr(other, what):
            return "%s of lahar: %s" % (what, getattr(other, what))
    return None


def skeleton(message):
    """The message without what it quotes."""
    return re.sub(r"[-+]?\d[-+.e\d]*", "N", re.sub(r"'[^']*'", "''", message)).strip()[:160]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lahar", type=os.path.abspath)
    parser.add_argument("--server", type=os.path.abspath, help="the program that reads the inputs instead")
    parser.add_argument("--compare", type=int, default=100,
                        help="with --server: lahar reads every so many inputs (%(default)s)")
    parser.add_argument("--batch", type=int, default=50,
                        help="how many inputs a child of the server reads (%(default)s)")
    parser.add_argument("--number", type=int, default=70, help="of mutated inputs (%(default)s)")
    parser.add_argument("--minutes", type=float, help="after which no other input is read")
    parser.add_argument("--first", type=int, default=0, help="number of the first one (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (%(default)s)")
    parser.add_argument("--seconds", type=float, default=60., help="that one run may take (%(default)g)")
    parser.add_argument("--memory", type=float, default=4.,
                        help="address space of one run in GiB, 0: unlimited (%(default)g)")
    parser.add_argument("--largest", type=int, default=30000,
                        help="number of particles, and of solids' nodes (%(default)s)")
    parser.add_argument("--keep", type=pathlib.Path, help="directory for the inputs that fail")
    parser.add_argument("--messages", action="store_true", help="print how often each kind of message appears")
    return parser.parse_args()


def keep(directory, files):
    for name, data in files.items():
        path = directory / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def new_mutator(cases):
    lines = {line for case in cases for line in case.files["case.prm"].split(b"\n")}
    # Of meshes the keywords, and some others.
    of_meshes = sorted({line for case in cases for name, data in case.files.items() if name != "case.prm"
                        for line in data.split(b"\n") if len(line) < 80})
    lines.update(line for i, line in enumerate(of_meshes) if line.startswith(b"$") or i % 50 == 0)
    words = sorted({word.encode() for case in cases
                    for word in WORD.findall(case.files["case.prm"].decode(errors="replace"))})
    return Mutator(words, sorted(lines))


def main():
    arguments = parse_arguments()
    program = Program(arguments)
    reader = Server(arguments) if arguments.server else program
    cases = find_cases()
    mutator = new_mutator(cases)

    n_wrong, n_slow, n_compared = 0, 0, 0
    statuses, messages = collections.Counter(), collections.Counter()
    longest, begin, n_read = (0., ""), time.monotonic(), 0
    for number in range(arguments.first, arguments.first + arguments.number):
        if arguments.minutes and time.monotonic() - begin > 60. * arguments.minutes:
            break
        n_read += 1
        random.seed("%d-%d" % (arguments.seed, number))
        case = random.choice(cases)
        if not case.is_ready:
            case.coarsen(reader)
        files, name = case.mutated(mutator)
        result, was_slow = patiently(reader, files)
        n_slow += was_slow
        statuses[result.status] += 1
        if result.status != 0:
            messages["%s: %s" % (result.status, skeleton(result.err))] += 1
        longest = max(longest, (result.seconds, "number %d, %s" % (number, case.name)))
        wrong, other = result.wrong(), ""
        if reader is not program and (wrong or number % arguments.compare == 0):
            n_compared += 1
            other = difference(result, patiently(program, files)[0])
        if wrong or other:
            n_wrong += 1
            print("FAILED: seed %d, number %d, %s of %s: %s" % (
                arguments.seed, number, name, case.name, wrong or other))
            print("    " + result.err[:600].replace("\n", "\n    "), flush=True)
            if wrong and other:
                print("    not with lahar itself: %s" % other, flush=True)
            if arguments.keep:
                keep(arguments.keep / ("%d-%d" % (arguments.seed, number)), files)

    if arguments.messages:
        for message, count in messages.most_common():
            print("%6d  %s" % (count, message))
    seconds = time.monotonic() - begin
    reader.close()
    print("%d inputs, seed %d, in %.0f s (%.1f a second): %s; the longest run took %.1f s (%s)" % (
        n_read, arguments.seed, seconds, n_read / seconds,
        ", ".join("%d with status %s" % (statuses[status], status) for status in sorted(statuses, key=str)), *longest))
    if n_compared > 0:
        print("%d compared with lahar itself" % n_compared)
    if n_slow > 0:
        print("%d tried again after %g s" % (n_slow, arguments.seconds))
    print("%d failed" % n_wrong)
    sys.exit(n_wrong > 0)


if __name__ == "__main__":
    main()
