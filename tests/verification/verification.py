# SPDX-License-Identifier: GPL-3.0-or-later
"""What the verification checks share: run lahar, read its statistics, compare with a reference, report.

Needs numpy and contrib/plot/lahar_output.py. A check exits with 0 if every quantity holds its tolerance, 1 with one line
on stderr if one does not or the run fails.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "prm" / "verification"
sys.path.insert(0, str(ROOT / "contrib" / "plot"))
sys.path.insert(0, str(ROOT / "tests"))

from lahar_output import OutputError, read_pvd, read_statistics, read_vtu  # noqa: E402
from program_test import on_ranks  # noqa: E402


class CheckError(Exception):
    """A run failed or a quantity misses its tolerance."""


def parse_arguments(description):
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--lahar", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="directory for the runs")
    parser.add_argument("--set", action="append", default=[], metavar="ENTRY=VALUE",
                        help="passed on to lahar: other meshes and time steps than the case's")
    parser.add_argument("--ranks", type=int, default=1, help="number of ranks")
    parser.add_argument("--mpiexec", default="mpiexec", help="starts several ranks")
    return parser.parse_args()


class Check:
    """The runs of one case and the quantities compared."""

    def __init__(self, description):
        arguments = parse_arguments(description)
        self.lahar = arguments.lahar.resolve()
        self.output = arguments.output
        self.overrides = arguments.set
        self.n_ranks, self.mpiexec = arguments.ranks, arguments.mpiexec
        self.misses = []

    def run(self, prm, *settings, resume=False):
        """Run prm/verification/@p prm with further settings "entry=value", or @p resume the last such run. Return its
        output directory."""
        directory = (self.output / pathlib.Path(prm).stem).resolve()
        if not resume:
            shutil.rmtree(directory, ignore_errors=True)
            directory.mkdir(parents=True)
        command = [str(self.lahar), *(["--resume"] if resume else []), "--set", f"Output directory={directory}"]
        for override in [*settings, *self.overrides]:
            command += ["--set", override]
        command, environment = on_ranks([*command, str(CASES / prm)], self.mpiexec, self.n_ranks)
        start = time.monotonic()
        with open(directory / "screen.txt", "w") as screen:
            status = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=screen,
                                    stderr=subprocess.STDOUT).returncode
        print(f"{prm}: {time.monotonic() - start:.1f} s")
        if status != 0:
            lines = (directory / "screen.txt").read_text().strip().splitlines()
            raise CheckError(f"{prm}: lahar exits with {status}: {lines[-1] if lines else ''}")
        return directory

    def near(self, name, value, reference, tolerance):
        """Compare with a reference, relative @p tolerance."""
        self.below(name, abs(value / reference - 1.), tolerance, f"{value:.6g}, reference {reference:.6g}, error ")

    def below(self, name, error, tolerance, text=""):
        """Compare an error with its tolerance."""
        is_met = bool(error <= tolerance)
        print(f"  {'ok  ' if is_met else 'FAIL'} {name}: {text}{error:.3g} (tolerance {tolerance:g})")
        if not is_met:
            self.misses.append(f"{name}: {text}{error:.3g} exceeds {tolerance:g}")

    def finish(self):
        if self.misses:
            raise CheckError("; ".join(self.misses))


def run_check(main):
    """Call main(); turn a miss into one line on stderr and exit status 1."""
    try:
        main()
    except (CheckError, OutputError, OSError) as error:
        sys.stdout.flush()
        print(f"{pathlib.Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(1)


def read_run(directory):
    """The columns of a run's statistics, by name."""
    return read_statistics(directory / "statistics")


def read_reference(path):
    """The columns of a reference file under prm/verification, by name."""
    lines = [line for line in (CASES / path).read_text().splitlines() if line.strip() and not line.startswith("#")]
    values = np.array([[float(word) for word in line.split(",")] for line in lines[1:]])
    return dict(zip(lines[0].split(","), values.T))


def at_time(statistics, name, time):
    """A column interpolated between steps."""
    return float(np.interp(time, statistics["Time (s)"], statistics[name]))


def volume_changes(statistics):
    """The largest change of volume in the run, by the solver and by remeshing, in shares of the initial volume."""
    return [float(np.abs(statistics[f"Volume change by {cause}"]).max()) for cause in ("solver", "remeshing")]


def check_balance_of_momentum(check, name, run, densities, boundaries, tolerance, gravity=9.81):
    """In each step the momentum of all fluid is what weight and boundaries have given to it, what remeshing and the solver
    have given by changing its mass, and what lies between the times for which momentum and mean forces stand. @p densities by
    fluid."""
    step = run["Time step size (s)"]
    mass = sum(density * run[f"{fluid} volume (m^dim)"] for fluid, density in densities.items())
    for d, weight in (("x", 0.), ("y", -gravity)):
        force = sum(run[f"{boundary} force {d} (N)"] for boundary in boundaries)
        changes = sum(run[f"Momentum change by {cause} {d} (N s)"] for cause in ("solver", "remeshing", "lag"))
        error = run[f"Momentum {d} (N s)"] - np.cumsum((mass * weight - force) * step) - changes
        check.below(f"{name}: largest error of the momentum {d} over the impulse of the boundaries",
                    np.abs(error).max() / np.sum(np.abs(force) * step), tolerance)


def deposit(directory, width, fluid=None):
    """By snapshot of a column of grains @p width wide at the start, from x = 0: the time; the run-out over the width of what is
    deeper than 0.1 widths from the column on, in strips of 0.1 widths; the same of what is deeper than 0.2 widths; the part of
    the grains beyond 1.3 widths; the depth of the middle over the width. Where there are several fluids the grains are the one
    of the number @p fluid."""
    rows = []
    for time, path in read_pvd(directory / "solution.pvd"):
        mesh = read_vtu(path)
        a, b, c = (mesh.points[mesh.triangles[:, k]] / width for k in range(3))
        areas = 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
        if fluid is not None:
            areas = areas * (mesh.at_cells("fluid") == fluid)
        x = (a + b + c)[:, 0] / 3.
        edges = np.arange(0., x.max() + 0.3, 0.1)
        depth = np.histogram(x, edges, weights=areas)[0] / 0.1
        ends = [edges[int(np.argmax(depth < least))] - 1. for least in (0.1, 0.2)]
        rows.append((time, *ends, areas[x > 2.3].sum() / areas.sum(), depth[:5].mean()))
    return np.array(rows).T


def last_mesh(directory):
    return read_vtu(read_pvd(directory / "solution.pvd")[-1][1])


def fluid_fronts(directory):
    """Times of the snapshots, and by snapshot and fluid of two the least and the largest x of its cells."""
    times, fronts = [], []
    for time, path in read_pvd(directory / "solution.pvd"):
        mesh = read_vtu(path)
        x, fluid = mesh.points[mesh.triangles][:, :, 0], mesh.at_cells("fluid")
        times.append(time)
        fronts.append([(x[fluid == f].min(), x[fluid == f].max()) for f in (0., 1.)])
    return np.array(times), np.array(fronts)


def integrate(mesh, values):
    """Integral over the fluid of a product of fields that are linear by triangle, given at the points."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    areas = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    first, second = (value[mesh.triangles] for value in values)
    return float(np.sum(areas * (np.sum(first * second, axis=1) + first.sum(axis=1) * second.sum(axis=1)) / 12.))
