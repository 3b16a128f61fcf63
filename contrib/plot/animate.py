#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a film of a Lahar run in the plane: one frame a snapshot, with one scale of colours and the same axes.

    animate.py output-quickstart -o flow.mp4 --field pressure
    animate.py output-quickstart -o flow.gif --fps 20 --limits 0 0.8 0 0.4

The ending of the file says which kind of film it is. Unyielded fluid is paler, walls are dark, also those that move,
and solids brown. Needs ffmpeg (Debian: apt install ffmpeg).
"""

import argparse
import math
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np
from matplotlib.cm import ScalarMappable

from figure_style import WIDTH, plt, use_style
from lahar_output import Mesh, OutputError, read_parameter, read_pvd, read_vtu, read_walls, run_script
from snapshots import (LABELS, add_legend, color_scale, draw_panel, extension, field_values, label_axes, make_axes,
                       view)

ENCODERS = {
    ".mp4": ("-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"),
    ".gif": ("-filter_complex", "split[all][copy];[all]palettegen[palette];[copy][palette]paletteuse=dither=none"),
}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path, metavar="OUTPUT", help="output directory of a run in the plane")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("film.mp4"),
                        help="the film, .mp4 or .gif (default: %(default)s)")
    parser.add_argument("--field", default="speed",
                        help="speed, yielded, or a field of the VTU files (default: %(default)s)")
    parser.add_argument("--log", action="store_true", help="logarithmic colours")
    parser.add_argument("--fps", type=float, default=10.,
                        help="frames, that is snapshots, a second (default: %(default)g)")
    parser.add_argument("--limits", type=float, nargs=4, metavar=("X0", "X1", "Y0", "Y1"),
                        help="the part drawn, in m (default: all that fluid and walls reach)")
    parser.add_argument("--width", type=int, default=1200, help="of the film in pixels (default: %(default)s)")
    return parser.parse_args()


class Series:
    """The snapshots of a run, read one by one: all of them may be too many to keep."""

    def __init__(self, directory):
        path = directory / "solution.pvd"
        self.snapshots = read_pvd(path)
        if not self.snapshots:
            raise OutputError(f"{path}: no snapshot")
        self.solids = dict(read_pvd(path, 1))
        self.moving_walls = dict(read_pvd(path, 2))
        self.directory = directory
        self.refuse_space()

    def refuse_space(self):
        parameters = self.directory / "parameters.prm"
        if parameters.is_file() and read_parameter(parameters, [], "Dimension") == "3" or \
                read_vtu(self.snapshots[0][1], 3).cells.shape[1] == 4:
            raise OutputError(f"{self.directory}: a run in space; contrib/plot/render.py draws those")

    @property
    def times(self):
        return [time for time, _ in self.snapshots]

    def read(self, i):
        """Fluid, solids (or None) and walls of snapshot @p i."""
        time, path = self.snapshots[i]
        solids = read_vtu(self.solids[time]) if time in self.solids else None
        return read_vtu(path), solids, read_walls(self.moving_walls.get(time, self.directory / "walls.vtu"))


class Film:
    """What all frames share: colours, axes, legend. Draws frame after frame into one figure."""

    def __init__(self, series, arguments):
        self.series, self.field = series, arguments.field
        self.first_mesh = series.read(0)[0]
        boxes, all_walls, all_values, has_unyielded = [], [], [], False
        for i in range(len(series.snapshots)):
            mesh, solids, walls = series.read(i)
            boxes += [box(part) for part in (mesh, solids) if part is not None and len(part.cells)]
            all_walls += walls
            if len(mesh.cells):
                all_values.append(field_values(mesh, self.field))
                has_unyielded |= mesh.has_field("yielded") and bool((mesh.at_cells("yielded") < 0.5).any())
        if not all_values:
            raise OutputError(f"{series.directory}: no fluid in any snapshot")
        self.limits = view(boxes, all_walls, arguments.limits)
        self.norm = None if self.field == "yielded" else color_scale(all_values, self.field, arguments.log)
        if self.norm is None:
            self.legend = (("black", "yielded"), ("0.8", "unyielded"))
        else:
            self.legend = (("0.85", "unyielded (paler)"),) if has_unyielded else ()
        self.n_decimals = decimals(series.times)
        self.make_figure(arguments.width, all_values)

    def make_figure(self, width, all_values):
        self.figure, self.grid = make_axes(1, self.limits, None)
        self.axes = self.grid[0, 0]
        # The encoder wants even numbers of pixels.
        dpi = width / WIDTH
        height = min(self.figure.get_figheight(), WIDTH) * dpi
        self.figure.set_dpi(dpi)
        self.figure.set_size_inches(*((2 * round(pixels / 2) + 0.01) / dpi for pixels in (width, height)))
        if self.norm is not None:
            self.figure.colorbar(ScalarMappable(self.norm, "viridis"), ax=self.grid,
                                 label=LABELS.get(self.field, self.field),
                                 extend=extension(self.norm, all_values), fraction=0.03, pad=0.015, aspect=25)
        self.draw(0)
        self.figure.canvas.draw()
        self.figure.set_layout_engine("none")  # so that nothing moves any more

    @property
    def size(self):
        return self.figure.canvas.get_width_height()

    def draw(self, i):
        mesh, solids, walls = self.series.read(i)
        self.axes.clear()
        if len(mesh.cells):
            draw_panel(self.axes, mesh, solids, walls, self.first_mesh, self.field, self.norm)
        self.axes.set(aspect="equal", xlim=self.limits[:2], ylim=self.limits[2:])
        label_axes(self.grid, 1)
        if self.legend:
            add_legend(self.axes, *self.legend)
        time = f"$t$ = {self.series.times[i]:.{self.n_decimals}f} s"
        self.axes.text(0.012, 0.975, time, transform=self.axes.transAxes, verticalalignment="top", zorder=5,
                       bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8})

    def frames(self):
        """The pixels of all frames, row by row in red, green and blue."""
        for i in range(len(self.series.snapshots)):
            self.draw(i)
            self.figure.canvas.draw()
            yield np.ascontiguousarray(np.asarray(self.figure.canvas.buffer_rgba())[..., :3]).tobytes()
        plt.close(self.figure)


def box(mesh):
    """Two points instead of all, which say how far the mesh reaches."""
    return Mesh(np.array([mesh.points.min(axis=0), mesh.points.max(axis=0)]), np.empty((0, 3), dtype=int))


def decimals(times):
    """How many decimals tell the times apart and give them in full, where that is not more than a few."""
    if len(times) < 2:
        return 3
    gap = max(np.median(np.diff(times)), 1e-12)
    most = max(0, math.ceil(-math.log10(gap)) + 1)
    for n in range(most):
        if all(abs(round(time, n) - time) < 1e-3 * gap for time in times):
            return n
    return most


def encode(frames, size, fps, path):
    """Write the film at @p path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    command = ["ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
               "-s", f"{size[0]}x{size[1]}", "-framerate", f"{fps:g}", "-i", "-",
               *ENCODERS[path.suffix.lower()], str(path.resolve())]
    with tempfile.TemporaryFile("w+", errors="replace") as messages:
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stderr=messages)
        n_frames = 0
        try:
            with process.stdin:
                for frame in frames:
                    process.stdin.write(frame)
                    n_frames += 1
        except BrokenPipeError:
            pass  # what ffmpeg complains of is said below
        except BaseException:
            process.kill()
            raise
        if process.wait() != 0:
            messages.seek(0)
            reason = messages.read().strip().splitlines() or [f"status {process.returncode}"]
            raise OutputError(f"{path}: ffmpeg fails: {reason[-1]}")
    return n_frames


def main():
    arguments = parse_arguments()
    if arguments.output.suffix.lower() not in ENCODERS:
        raise OutputError(f"{arguments.output}: a film ends with .mp4 or .gif")
    if not 0.1 <= arguments.fps <= 100.:
        raise OutputError(f"--fps must be 0.1 to 100, not {arguments.fps:g}")
    if not 100 <= arguments.width <= 4000:
        raise OutputError(f"--width must be 100 to 4000, not {arguments.width}")
    if shutil.which("ffmpeg") is None:
        raise OutputError("ffmpeg is missing (Debian: apt install ffmpeg)")
    use_style()
    film = Film(Series(arguments.directory), arguments)
    n_frames = encode(film.frames(), film.size, arguments.fps, arguments.output)
    print(f"Wrote {arguments.output}: {n_frames} frames, {n_frames / arguments.fps:.3g} s")


if __name__ == "__main__":
    run_script(main)
