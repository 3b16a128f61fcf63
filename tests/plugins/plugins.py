#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test plugins: install Lahar, build contrib/plugin-example against it outside the tree, run its case with the installed
program, and load what is no plugin for it. The code in doc/extending.md is the example's.

Usage: plugins.py BUILD_DIRECTORY
"""
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOT = os.path.dirname(TESTS)
sys.path.insert(0, TESTS)

from program_test import ENVIRONMENT, check, failed  # noqa: E402

BUILD = os.path.abspath(sys.argv[1])
EXAMPLE = os.path.join(ROOT, "contrib", "plugin-example")


def call(command, directory, **environment):
    return subprocess.run(command, cwd=directory, env=dict(ENVIRONMENT, **environment), stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=900)


def cached(name):
    """The value of an entry of the build's cache."""
    with open(os.path.join(BUILD, "CMakeCache.txt")) as file:
        found = re.search("^" + re.escape(name) + ":[A-Z]+=(.*)$", file.read(), re.M)
    return found[1] if found else ""


def fields_of(path):
    """The numbers of components of the fields in a .vtu file, by name."""
    with open(path, encoding="latin-1") as file:
        found = re.findall(r'<DataArray type="Float\d+" Name="(\w+)"(?: NumberOfComponents="(\d)")?', file.read())
    return {name: int(components or 1) for name, components in found if name != "Points"}


def test_page():
    text = open(os.path.join(ROOT, "doc", "extending.md")).read()
    blocks = re.findall("```cpp\n(.*?)```", text, re.S)
    for path in [*(os.path.join(EXAMPLE, name) for name in sorted(os.listdir(EXAMPLE)) if name.endswith(".cc")),
                 os.path.join(ROOT, "source", "boundary", "free_slip.cc")]:
        source = open(path).read().split("\n\n", 1)[1]
        check(f"doc/extending.md has {os.path.basename(path)} as it is", source in blocks)


def test_example(parent):
    """@return the installed program and the plugin."""
    prefix, source = os.path.join(parent, "lahar"), os.path.join(parent, "example")
    result = call(["cmake", "--install", BUILD, "--prefix", prefix], parent)
    check("Lahar is installed", result.returncode == 0, result.stderr)
    shutil.copytree(EXAMPLE, source, ignore=shutil.ignore_patterns("build", "output*"))
    build_type = cached("CMAKE_BUILD_TYPE")
    configure = ["cmake", "-S", ".", "-DCMAKE_PREFIX_PATH=" + prefix, "-Ddeal.II_DIR=" + cached("deal.II_DIR")]
    other = "Release" if build_type == "Debug" else "Debug"
    result = call([*configure, "-B", "other", "-DCMAKE_BUILD_TYPE=" + other], source)
    check(f"a plugin in {other} for a Lahar in {build_type} is refused by name",
          result.returncode != 0 and other in result.stderr and build_type in result.stderr, result.stderr)
    result = call([*configure, "-B", "build", "-DCMAKE_BUILD_TYPE=" + build_type,
                   "-DCMAKE_CXX_COMPILER_LAUNCHER=" + (shutil.which("ccache") or "")], source)
    check("the example is configured", result.returncode == 0, result.stdout, result.stderr)
    result = call(["cmake", "--build", "build"], source)
    check("... and built without warnings", result.returncode == 0 and "warning" not in result.stdout + result.stderr,
          result.stdout, result.stderr)

    lahar = os.path.join(prefix, "bin", "lahar")
    result = call([lahar, os.path.join(source, "case.prm")], parent)
    check("its case runs from another directory", result.returncode == 0, result.stderr)
    lines = open(os.path.join(parent, "output-plugin-example", "statistics")).read().splitlines()
    names = [line.split(": ", 1)[1] for line in lines if line.startswith("#")]
    check("... with the plugin's column", "fastest (m/s)" in names, names)
    column = names.index("fastest (m/s)")
    speeds = [float(line.split()[column]) for line in lines if not line.startswith("#")]
    # Ritter's front of a dam break without friction.
    check("... which is a speed of a column 0.2 m high", 0.1 < max(speeds) < 2. * (9.81 * 0.2)**0.5, max(speeds))
    fields = fields_of(os.path.join(parent, "output-plugin-example", "solution-00001.vtu"))
    check("... with the plugin's field behind Lahar's own", list(fields) == [
        "velocity", "pressure", "particle_kind", "strain_rate", "effective_viscosity", "yielded", "vorticity"], fields)
    check("... a number in the plane", fields.get("vorticity") == 1, fields)

    plugin = os.path.join(source, "build", "libexample.so")
    result = call([lahar, "--set", "Output directory=chosen", "--set", "End time=0.01", "--set", "Output interval=0.01",
                   "--set", "Postprocess/Fields=vorticity, velocity", "--set", "Stabilization/Form=pressure Laplacian",
                   os.path.join(source, "case.prm")], parent)
    check("its case runs with the plugin's stabilisation", result.returncode == 0, result.stderr)
    fields = fields_of(os.path.join(parent, "chosen", "solution-00001.vtu"))
    check("... and writes the fields that are chosen", list(fields) == ["velocity", "vorticity"], fields)
    result = call([lahar, "--set", "Plugins=" + plugin, "--set", "Output directory=space", "--set", "Time step=1e-3",
                   "--set", "End time=1e-3", os.path.join(ROOT, "prm/verification/three_dimensions/still_tank.prm")], parent)
    check("a case in space runs with the plugin", result.returncode == 0, result.stderr)
    fields = fields_of(os.path.join(parent, "space", "solution-00000.vtu"))
    check("... where the plugin's field is a vector", fields.get("vorticity") == 3, fields)
    ellipse = ["--set", "Fluids/fluid/Shape=ellipse", "--set", "Fluids/fluid/ellipse/Centre=0.3, 0.2", "--set",
               "Fluids/fluid/ellipse/Corners=40"]
    result = call([lahar, "--check", *ellipse, "--set", "Fluids/fluid/ellipse/Half axes=0.2, 0.1",
                   os.path.join(source, "case.prm")], parent)
    volume = re.search(r"Fluid volume +(\S+) m\^2", result.stdout)
    check("the plugin's shape has its volume", result.returncode == 0 and volume and
          abs(float(volume[1]) - math.pi * 0.2 * 0.1) < 1e-5, result.stdout, result.stderr)
    result = call([lahar, "--check", *ellipse, os.path.join(source, "case.prm")], parent)
    check("... and refuses one without extent", result.returncode == 2 and
          "'Fluids/fluid/ellipse/Half axes' is '0, 0'" in result.stderr, result.stderr)
    return lahar, plugin


def test_refused(parent, lahar, plugin):
    compiler = cached("CMAKE_CXX_COMPILER")

    def library(name, text):
        path = os.path.join(parent, name + ".so")
        source = os.path.join(parent, name + ".cc")
        with open(source, "w") as file:
            file.write(text)
        subprocess.run([compiler, "-shared", "-fPIC", source, "-o", path], check=True)
        return path

    text_file = os.path.join(parent, "text.so")
    with open(text_file, "w") as file:
        file.write("not a library\n" * 1000)
    other = library("other", 'extern "C" const char lahar_9_9_9_dealii_9_4_Release[];\n'
                             'extern "C" { extern const char *lahar_plugin; const char *lahar_plugin = lahar_9_9_9_dealii_9_4_Release; }\n')
    throws = library("throws", '#include <stdexcept>\nstatic const int value = [] { throw std::runtime_error("no such luck");'
                               ' return 1; }();\nint get() { return value; }\n')
    twice = os.path.join(parent, "twice.so")
    shutil.copy(plugin, twice)
    case = os.path.join(parent, "example", "case.prm")
    for what, plugins, words in (
            ("a plugin that is missing", "nowhere.so", ["nowhere.so", "exist"]),
            ("a file that is no library", text_file, ["text.so", "invalid ELF header"]),
            ("a library that is no plugin", library("plain", "int one() { return 1; }\n"), ["plain.so", "is no plugin"]),
            ("a plugin for another version", other, ["other.so", "lahar_9_9_9_dealii_9_4_Release", "built for this program"]),
            ("a plugin that throws while it is loaded", throws, ["throws.so", "no such luck"]),
            ("a second model of one name", f"{plugin} ; {twice}", ["twice.so", "'Bercovier-Engelman'"])):
        result = call([lahar, "--check", "--set", "Plugins=" + plugins, case], parent)
        lines = result.stderr.strip().splitlines()
        check(f"{what}: status 2 and one line that says so",
              result.returncode == 2 and len(lines) == 1 and all(word in lines[0] for word in ["'Plugins'", *words]),
              result.returncode, result.stderr)


def main():
    test_page()
    with tempfile.TemporaryDirectory() as parent:
        lahar, plugin = test_example(parent)
        test_refused(parent, lahar, plugin)
    return 1 if failed else 0


sys.exit(main())
