#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Feed the program `lahar` mutated input, from outside.

The parameter files of prm/ and the gmsh files of prm/ and tests/geometry, with coarser meshes, are mutated at random
and read by `lahar --check`, which builds the first mesh. Each run must end

* with status 0 and no message on stderr, or with 1 or 2 and one on stderr that shows no C++ or deal.II frame,
* never by a signal,
* within --seconds, or if that is missed, when it is tried once more, and with --memory of address space,
* without a file left behind.

More particles or nodes than LIMITS are refused, so that no input takes long.
Inputs that miss this are printed, and kept in the directory --keep.

Usage: fuzz.py LAHAR [--number N] [--seed S] [--seconds T] [--memory GIB] [--keep DIRECTORY] [--messages]
"""
import argparse
import collections
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from program_test import mesh, parts  # noqa: E402

FRAMES = ["Stacktrace", "An error occurred in line", "terminate called", "Aborting", "exception", "Exception",
          "std::", "Lahar::", "dealii::", "Backtrace", "Segmentation", "parameter_handler.cc", "CGAL"]

LIMITS = ["--set", "Largest number of particles=30000", "--set", "Solids/Largest number of nodes=30000"]

# Values that stand for a number.
NUMBERS = ["0", "-1", "1", "-0", "1e308", "-1e308", "1e-308", "5e-324", "1e400", "nan", "inf", "-inf", "", "1e-9", "1e9", "1e12",
           "2147483647", "2147483648", "4294967295", "4294967296", "-2147483649", "18446744073709551615",
           "99999999999999999999", "0x10", "1e", "1.5.2", "--1", "1,5", "0.1", "3", "100", "1e-3", "1e5"]

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z$][A-Za-z'$-]*")


class Mutator:
    """Changes of a text; @p words are those of all texts, @p lines too."""

    def __init__(self, words, lines):
        self.words, self.lines = words, lines

    def mutate(self, text):
        for _ in range(random.choice([1, 1, 1, 2, 2, 3, 5])):
            text = random.choice(self.CHANGES)(self, text)
        return text

    def change_lines(self, text):
        lines = text.split(b"\n")
        i, j = random.randrange(len(lines)), random.randrange(len(lines))
        kind = random.randrange(6)
        if kind == 0:
            del lines[i]
        elif kind == 1:
            lines.insert(i, lines[i])
        elif kind == 2:
            lines[i], lines[j] = lines[j], lines[i]
        elif kind == 3:
            lines.insert(i, random.choice(self.lines))
        elif kind == 4:
            lines[i] = random.choice(self.lines)
        else:
            del lines[min(i, j):max(i, j)]
        return b"\n".join(lines)

    def change_match(self, pattern, replacements, text):
        matches = list(re.finditer(pattern.pattern.encode(), text))
        if not matches:
            return text
        match = random.choice(matches)
        return text[:match.start()] + random.choice(replacements) + text[match.end():]

    def change_number(self, text):
        return self.change_match(NUMBER, [number.encode() for number in NUMBERS], text)

    def scale_number(self, text):
        matches = list(re.finditer(NUMBER.pattern.encode(), text))
        if not matches:
            return text
        match = random.choice(matches)
        value = float(match.group()) * random.choice([-1., 0.5, 1.001, 2., 10., 1e3, 1e-3, 1e6, 1e-6])
        return text[:match.start()] + b"%.12g" % value + text[match.end():]

    def change_word(self, text):
        return self.change_match(WORD, self.words, text)

    def change_bytes(self, text):
        data = bytearray(text)
        for _ in range(random.choice([1, 1, 4, 50])):
            place = random.randrange(len(data) + 1)
            data[place:place + random.randrange(3)] = random.randbytes(random.randrange(3))
        return bytes(data)

    def change_separator(self, text):
        return self.change_match(re.compile("[,:;=#\"/ ]"), [b",", b":", b";", b"=", b"#", b" ", b"", b"\"", b"\0", b"\\", b"\r\n", b"/"], text)

    def truncate(self, text):
        return text[:random.randrange(len(text) + 1)]

    def change_structure(self, text):
        lines = text.split(b"\n")
        lines.insert(random.randrange(len(lines) + 1), random.choice([
            b"end", b"end\nend", b"subsection", b"subsection " + random.choice(self.words), b"subsection a\n" * 2000, b"set",
            b"set " + random.choice(self.words) + b" = 1", b"include case.prm", b"include", b"x" * 100000, b"$Elements",
            b"set Gravity = " + b"1, " * 50000, b"set Solids = " + b", ".join(b"solid %d" % i for i in range(100)), b"set Fluids = fluid, other",
            b"set Boundaries = walls, walls", b"set Dimension = 3",
            b"set Corners = " + b"0, 0 : 1, 1; " * 30]))
        return b"\n".join(lines)

    CHANGES = [change_lines, change_number, change_number, change_number, scale_number, change_word, change_word,
               change_bytes, change_separator, truncate, change_structure]


class Case:
    """A parameter file and the mesh files that it names, as bytes by their names."""

    def __init__(self, name, files):
        self.name, self.files, self.is_ready = name, files, False

    def coarsen(self, lahar, arguments):
        """Make the mesh size the largest one that works, so that runs are short."""
        text = self.files["case.prm"]
        for factor in (6., 4., 3., 2., 1.):
            self.files["case.prm"] = re.sub(
                rb"(set Mesh size *= *)([-0-9.e]+)", lambda m: m[1] + b"%g" % (factor * float(m[2])), text)
            if run(lahar, self.files, arguments).status == 0:
                self.is_ready = True
                return
        sys.exit("%s: does not work unchanged" % self.name)


def find_cases():
    cases = []
    for path in sorted(ROOT.glob("prm/**/*.prm")):
        text = path.read_bytes()
        files = {name.decode(): (path.parent / name.decode()).read_bytes() for name in re.findall(rb"File *= *(\S+\.msh)", text)}
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


def run(lahar, files, arguments):
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if arguments.memory > 0:
            size = int(arguments.memory * 2**30)
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

    directory = tempfile.mkdtemp()
    try:
        names = set()
        for name, data in files.items():
            path = os.path.join(directory, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data)
            names.add(name.split("/")[0])
        # Open MPI without daemon and without drivers for networks, which take a minute now and then; with a directory
        # of its own, since another program's MPI may remove the common one at the wrong moment.
        environment = dict(os.environ, OMP_NUM_THREADS="1", DEAL_II_NUM_THREADS="1", OMPI_MCA_ess_singleton_isolated="1",
                           OMPI_MCA_pml="ob1", OMPI_MCA_btl="self", OMPI_MCA_orte_tmpdir_base=arguments.session)
        begin = time.monotonic()
        process = subprocess.Popen([lahar, "--check", "case.prm", *LIMITS], cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=limit_memory)
        try:
            out, err = process.communicate(timeout=arguments.seconds)
            status = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            status = None
        return Result(status, out.decode(errors="replace"), err.decode(errors="replace"),
                      sorted(set(os.listdir(directory)) - names), time.monotonic() - begin)
    finally:
        shutil.rmtree(directory)


def skeleton(message):
    """The message without what it quotes."""
    return re.sub(r"[-+]?\d[-+.e\d]*", "N", re.sub(r"'[^']*'", "''", message)).strip()[:160]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lahar", type=os.path.abspath)
    parser.add_argument("--number", type=int, default=70, help="of mutated inputs (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers (%(default)s)")
    parser.add_argument("--seconds", type=float, default=60., help="that one run may take (%(default)g)")
    parser.add_argument("--memory", type=float, default=4., help="address space of one run in GiB, 0: unlimited (%(default)g)")
    parser.add_argument("--keep", type=pathlib.Path, help="directory for the inputs that fail")
    parser.add_argument("--messages", action="store_true", help="print how often each kind of message appears")
    arguments = parser.parse_args()
    session_directory = tempfile.TemporaryDirectory()  # lasts until the end
    arguments.session = session_directory.name

    random.seed(arguments.seed)
    cases = find_cases()
    lines = sorted({line for case in cases for line in case.files["case.prm"].split(b"\n")})
    words = sorted({word.encode() for case in cases
                    for word in WORD.findall(case.files["case.prm"].decode(errors="replace"))})
    mutator = Mutator(words, lines)

    n_wrong, n_slow = 0, 0
    statuses, messages = collections.Counter(), collections.Counter()
    longest = (0., "")
    for number in range(arguments.number):
        case = random.choice(cases)
        if not case.is_ready:
            case.coarsen(arguments.lahar, arguments)
        files = dict(case.files)
        meshes = [name for name in files if name != "case.prm"]
        name = random.choice(meshes) if meshes and random.random() < 0.8 else "case.prm"
        files[name] = mutator.mutate(files[name])
        result = run(arguments.lahar, files, arguments)
        if result.status is None:  # the machine may have been busy
            n_slow += 1
            result = run(arguments.lahar, files, arguments)
        statuses[result.status] += 1
        if result.status != 0:
            messages["%s: %s" % (result.status, skeleton(result.err))] += 1
        longest = max(longest, (result.seconds, "number %d, %s" % (number, case.name)))
        wrong = result.wrong()
        if wrong:
            n_wrong += 1
            print("FAILED: seed %d, number %d, %s of %s: %s" % (arguments.seed, number, name, case.name, wrong))
            print("    " + result.err[:600].replace("\n", "\n    "), flush=True)
            if arguments.keep:
                for kept, data in files.items():
                    path = arguments.keep / ("%d-%d" % (arguments.seed, number)) / kept
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(data)

    if arguments.messages:
        for message, count in messages.most_common():
            print("%6d  %s" % (count, message))
    print("%d inputs, seed %d: %s; the longest run took %.1f s (%s)" % (
        arguments.number, arguments.seed,
        ", ".join("%d with status %s" % (statuses[status], status) for status in sorted(statuses, key=str)), *longest))
    if n_slow > 0:
        print("%d tried again after %g s" % (n_slow, arguments.seconds))
    print("%d failed" % n_wrong)
    sys.exit(n_wrong > 0)


if __name__ == "__main__":
    main()
