#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/rheometer/lahar-rheometer: parameters of known fluids come back, with noise within their intervals; units,
columns and dial readings; the printed lines and tables are ones that Lahar reads; wrong files are refused with their line.

Usage: rheometer.py LAHAR. Exit status 77 (skipped) without numpy, scipy or matplotlib.
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from program_test import ENVIRONMENT, check, failed, parts, shape, walls

if not all(importlib.util.find_spec(name) for name in ("numpy", "scipy", "matplotlib")):
    print("not tested: numpy, scipy or matplotlib is missing")
    sys.exit(77)

import matplotlib.image
import numpy as np

TOOL = os.path.abspath(os.path.join(HERE, "..", "..", "contrib", "rheometer", "lahar-rheometer"))
sys.path.insert(0, os.path.dirname(TOOL))
from flow_curve import FlowCurve
from law_fits import LAWS, fit_law

RATES = np.logspace(-1., 3., 25)
# By law: the stress for a strain rate, and the parameters by their entries.
FLUIDS = {
    "Newtonian": (lambda g: 0.3 * g, {"Viscosity": 0.3}),
    "power law": (lambda g: 2. * g**0.6, {"Consistency": 2., "Flow index": 0.6}),
    "Bingham": (lambda g: 15. + 0.05 * g, {"Plastic viscosity": 0.05, "Yield stress": 15.}),
    "Casson": (lambda g: (np.sqrt(15.) + np.sqrt(0.05 * g))**2, {"Casson viscosity": 0.05, "Yield stress": 15.}),
    "Herschel-Bulkley": (lambda g: 12. + 3. * g**0.45, {"Consistency": 3., "Flow index": 0.45, "Yield stress": 12.}),
    "Carreau-Yasuda": (lambda g: g * (0.02 + 4.98 * (1. + 4. * g * g)**-0.3),
                       {"Viscosity at rest": 5., "Viscosity at high rates": 0.02, "Time constant": 2., "Flow index": 0.4}),
    "Cross": (lambda g: g * (0.02 + 4.98 / (1. + (2. * g)**0.7)),
              {"Viscosity at rest": 5., "Viscosity at high rates": 0.02, "Time constant": 2., "Exponent": 0.7}),
}


def write(directory, name, text):
    path = os.path.join(directory, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def rows(rates, stresses, separator=", "):
    return "".join(f"{rate:.9g}{separator}{stress:.9g}\n" for rate, stress in zip(rates, stresses))


def run(directory, *arguments):
    return subprocess.run([sys.executable, "-B", TOOL, *arguments], cwd=directory, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True)


def lines_of(process):
    """The printed lines of a .prm file: the law, its entries by name, the text."""
    text = re.search(r"^set Law = .*?^end$", process.stdout, re.M | re.S)
    if not text:
        return "", {}, ""
    entries = {name.strip(): float(value) for name, value in re.findall(r"^  set (.*?) *= (\S+)$", text[0], re.M)}
    return text[0].splitlines()[0][len("set Law = "):], entries, text[0]


def is_accepted(lahar, directory, text):
    """Whether lahar --check takes a case whose fluid has these lines."""
    case = ("set Dimension = 2\nset Output directory = out\nset End time = 1\nset Time step = 1e-3\nset Mesh size = 0.02\n" +
            parts("Fluids", {"fluid": shape("box", "Corners = 0, 0 : 0.1, 0.1") + text}) + walls("-1, 0 : 1, 0"))
    path = write(directory, "case.prm", case)
    process = subprocess.run([lahar, "--check", path], cwd=directory, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True)
    return process.returncode == 0, process.stderr


def test_fits(lahar, directory):
    random = np.random.default_rng(7)
    for law, (stress_of, parameters) in FLUIDS.items():
        path = write(directory, "exact.csv", rows(RATES, stress_of(RATES)))
        process = run(directory, path)
        found, entries, text = lines_of(process)
        check(f"{law}: exact data are recognised", process.returncode == 0 and found == law, process.stdout, process.stderr)
        check("... and their parameters", entries.keys() == parameters.keys() and all(
            abs(entries[name] / value - 1.) < 1e-3 for name, value in parameters.items()), entries)
        check("... in lines that Lahar takes", *is_accepted(lahar, directory, text))

        # One run of noise may leave an interval of 95 %; in the mean of twenty they hold nearly always.
        n_inside = n_all = 0
        for _ in range(20):
            noisy = stress_of(RATES) * (1. + 0.02 * random.standard_normal(len(RATES)))
            fit = fit_law(next(one for one in LAWS if one.name == law), FlowCurve(RATES, noisy), True)
            for (name, *_), value, width in zip(fit.law.entries, fit.parameters, fit.half_widths):
                n_all += 1
                n_inside += abs(value - parameters[name]) <= width
        check(f"{law}: the intervals hold the parameters of noisy data", 0.85 * n_all <= n_inside, f"{n_inside} of {n_all}")


def test_reading(lahar, directory):
    stress_of, parameters = FLUIDS["Herschel-Bulkley"]
    exact = stress_of(RATES)
    for what, text, arguments in (
            ("other columns and units, with a head", "no; stress/mPa; t; rate/min\n" + "".join(
                f"{i}; {1e3 * s:.9g}; x; {60. * g:.9g}\n" for i, (g, s) in enumerate(zip(RATES, exact))),
             ["--columns", "4", "2", "--stress-unit", "mPa", "--rate-unit", "1/min"]),
            ("decimal commas", rows(RATES, exact, "; ").replace(".", ","), []),
            ("blanks, comments and a byte order mark", "\ufeff# a mud\n" + rows(RATES, exact, "  "), []),
            ("dial readings", "rpm,degrees\n" + rows(RATES / 1.7023, exact / 0.511), ["--fann"]),
            ("dial readings with a spring of twice the stiffness", rows(RATES / 1.7023, exact / 1.022), ["--fann", "--spring", "2"]),
            ("a range of strain rates", rows(RATES, exact) + "5000, 1\n0.001, 400\n", ["--rates", "0.01", "2000"])):
        process = run(directory, write(directory, "data.csv", text), *arguments)
        law, entries, _ = lines_of(process)
        check(f"{what}", law == "Herschel-Bulkley" and all(abs(entries[name] / value - 1.) < 1e-3 for name, value in
                                                            parameters.items()), process.stdout, process.stderr)

    # Readings of a thin film of noise: neighbours whose stress falls become one row.
    wavy = np.where(np.arange(len(RATES)) % 5 == 2, 0.9, 1.) * exact
    process = run(directory, write(directory, "data.csv", rows(RATES, wavy)), "--table", "table.csv", "-o", "flow.png",
                  "--density", "1100", "--law", "Bingham")
    law, entries, text = lines_of(process)
    check("the law and the density that are asked for", law == "Bingham" and entries["Density"] == 1100., process.stdout)
    picture = os.path.join(directory, "flow.png")
    check("the picture shows something", os.path.exists(picture) and matplotlib.image.imread(picture)[..., :3].std() > 0.01)
    table = np.loadtxt(os.path.join(directory, "table.csv"), delimiter=",")
    check("the table grows, from the yield stress", np.all(np.diff(table, axis=0) > 0.) and table[0][0] == 0. and
          5. < table[0][1] < 15. and 10 < len(table) < len(RATES) + 1, table)
    check("... and Lahar takes it", *is_accepted(lahar, directory, "set Law = table\nsubsection table\n  set File = table.csv\nend"))
    process = run(directory, write(directory, "six.csv", "600, 53\n300, 38\n200, 32\n100, 24.5\n6, 11\n3, 10\n"), "--fann")
    check("six readings tell three parameters, not four", lines_of(process)[0] == "Herschel-Bulkley" and
          "Cross is left out" in process.stdout, process.stdout)


def test_refused(directory):
    good = rows(RATES, 3. * RATES)
    for what, text, arguments, words in (
            ("text in a row", "1, 2\n2, three\n" + good, [], ["data.csv:2:", "'2, three'", "columns 1 and 2"]),
            ("a second head", "rate, stress\n1/s, Pa\n" + good, [], ["data.csv:2:", "'1/s, Pa'"]),
            ("too few columns", "# one\n1\n", [], ["data.csv:2:", "'1'"]),
            ("a column that is not there", good, ["--columns", "1", "3"], ["data.csv:1:", "columns 1 and 3"]),
            ("an infinite number", "1, inf\n", [], ["data.csv:1:", "'1, inf'"]),
            ("no strain rate", "0, 1\n" + good, [], ["data.csv:1:", "above zero"]),
            ("a negative stress", "1, -1\n" + good, [], ["data.csv:1:", "not negative"]),
            ("three points", "1, 2\n2, 3\n3, 4\n", [], ["data.csv", "at least four"]),
            ("a stress of zero in relative fits", "0.01, 0\n" + good, ["--relative"], ["data.csv", "above zero"]),
            ("no stress at all", rows(RATES, 0. * RATES), [], ["data.csv", "no stress"]),
            ("too few points for a law", rows(RATES[:5], RATES[:5]), ["--law", "Cross"], ["5 points", "Cross"]),
            ("an unknown law", good, ["--law", "honey"], ["honey", "Casson"]),
            ("an unknown unit", good, ["--stress-unit", "bar"], ["bar", "kPa"]),
            ("a picture of no kind", good, ["-o", "picture.xyz"], ["picture.xyz"])):
        process = run(directory, write(directory, "data.csv", text), *arguments)
        lines = process.stderr.strip().splitlines()
        check(f"{what}: status 2 and a message", process.returncode == 2 and lines and "Traceback" not in process.stderr and
              all(word in lines[-1] for word in words), process.returncode, process.stderr)
    with open(os.path.join(directory, "binary.csv"), "wb") as file:
        file.write(b"\xff\xfe\x00\x01" * 10)
    for name, word in (("nowhere.csv", "No such file"), ("binary.csv", "UTF-8"), (".", "directory")):
        process = run(directory, name)
        check(f"'{name}' is refused", process.returncode == 2 and word in process.stderr and
              len(process.stderr.splitlines()) == 1, process.stderr)


def main():
    lahar = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as directory:
        test_fits(lahar, directory)
        test_reading(lahar, directory)
        test_refused(directory)
    sys.exit(1 if failed else 0)


main()
