# SPDX-License-Identifier: GPL-3.0-or-later
"""Snapshots as compact data for the page: what is drawn, rounded to 16 bits and compressed.

In the plane all triangles are kept with their outline, in space the triangles on the outside. A snapshot is one block
of bytes, whose arrays (little endian, component by component) stand one behind the other, each padded to four bytes:
for the fluid and then for the solids positions (uint16), corners of triangles (uint32), in the plane the outline
(uint32, lines separated by the largest number), and for the fluid the fields, by point uint16 or by triangle uint8;
last, where boundaries move, the places of the walls' points (float32).
"""

import functools
import gzip
from dataclasses import dataclass, field

import numpy as np

from lahar_output import OutputError, read_vtu
from mesh_geometry import faces_with_cells, joined_points, outside, usual_range

FIELDS = ("speed", "pressure", "yielded")
STEPS = 65535  # of a rounded number
SEPARATOR = 2**32 - 1
LARGEST_TOTAL = 24e6  # bytes of all blocks in base64


@dataclass
class Surface:
    """What is drawn of a mesh: triangles with points of their own."""

    points: np.ndarray
    triangles: np.ndarray
    fields: dict = field(default_factory=dict)
    outline: np.ndarray = None
    body: np.ndarray = None  # of solids, number by triangle


@dataclass
class Flow:
    """The snapshots of a run: times, and by time the surfaces of fluid and solids (None where there are none)."""

    times: list
    fluids: list
    solids: list

    def surfaces(self):
        return [surface for surface in (*self.fluids, *self.solids) if surface is not None]


def read_flow(run, n_snapshots):
    """At most @p n_snapshots snapshots, evenly in time, with the first and the last."""
    fluid, solid = dict(run.snapshots["fluid"]), dict(run.snapshots["solid"])
    all_times = sorted({*fluid, *solid})
    chosen = evenly(all_times, n_snapshots)
    read = lambda paths, time: read_once(paths[time], run.dimension) if time in paths else None  # noqa: E731
    return Flow(chosen, [read(fluid, time) for time in chosen], [read(solid, time) for time in chosen])


def evenly(times, n):
    """At most @p n of the times, those nearest to evenly spaced ones."""
    if len(times) <= n:
        return list(times)
    array = np.array(times)
    return sorted({times[np.abs(array - time).argmin()] for time in np.linspace(times[0], times[-1], n)})


def read_once(path, dimension):
    """The surface in a file, which is not read again where a report of the same files is made again and again."""
    return read_version(path, dimension, path.stat().st_mtime_ns if path.is_file() else None)


@functools.lru_cache(maxsize=400)
def read_version(path, dimension, _):
    return read_surface(path, dimension)


def read_surface(path, dimension):
    mesh = read_vtu(path, dimension)
    if len(mesh.cells) == 0:
        return None
    if not np.isfinite(mesh.points).all():
        raise OutputError(f"{path}: a point is not at a finite place")
    if dimension == 2:
        triangles, cells = mesh.cells, np.arange(len(mesh.cells))
    else:
        triangles, cells = outside(mesh) if mesh.cells.shape[1] == 4 else (mesh.cells, np.arange(len(mesh.cells)))
    # Neighbours share points, and points inside are left out.
    place, _ = joined_points(mesh.points)
    _, first, corners = np.unique(place[triangles].reshape(-1), return_index=True, return_inverse=True)
    kept = triangles.reshape(-1)[first]
    order = np.argsort(corners.reshape(-1, 3).min(axis=1), kind="stable")
    surface = Surface(mesh.points[kept], corners.reshape(-1, 3)[order])
    cells = cells[order]
    if "velocity" in mesh.point_data:
        surface.fields["speed"] = np.linalg.norm(mesh.point_data["velocity"].reshape(len(mesh.points), -1)[kept],
                                                 axis=1)
    if "pressure" in mesh.point_data:
        surface.fields["pressure"] = -mesh.point_data["pressure"][kept]
    if "yielded" in mesh.cell_data or "yielded" in mesh.point_data:
        surface.fields["yielded"] = mesh.at_cells("yielded")[cells] > 0.5
    if "body" in mesh.point_data or "body" in mesh.cell_data:
        surface.body = np.round(mesh.at_cells("body")[cells]).astype(int)
    if dimension == 2:
        edges, _, others = faces_with_cells(mesh)
        number_of = np.full(place.max() + 1, -1)
        number_of[place[kept]] = np.arange(len(kept))
        surface.outline = chained(number_of[place[edges[others < 0]]])
    return surface


def chained(edges):
    """Edges as lines of points, one behind the other and separated by SEPARATOR."""
    following = {}
    for a, b in edges.tolist():
        following.setdefault(a, []).append(b)
        following.setdefault(b, []).append(a)
    result = []
    for start in following:
        while following[start]:
            point = start
            result.append(point)
            while following[point]:
                neighbour = following[point].pop()
                following[neighbour].remove(point)
                result.append(neighbour)
                point = neighbour
            result.append(SEPARATOR)
    return np.array(result, dtype=np.uint32)


# --------------------------------------------------------------------------------------------------------- scales


def field_ranges(flows):
    """For every field that all snapshots have: the range of its values and, without far ones, of its colours."""
    ranges = {}
    fluids = [surface for flow in flows for surface in flow.fluids if surface is not None]
    for name in FIELDS:
        if not fluids or any(name not in surface.fields for surface in fluids):
            continue
        if name == "yielded":
            ranges[name] = {"values": [0., 1.], "colours": [0., 1.]}
            continue
        values = np.concatenate([surface.fields[name] for surface in fluids])
        values = values[np.isfinite(values)]
        if len(values) == 0:
            continue
        lower, upper, step = even_range(*usual_range(values))
        ranges[name] = {"values": [float(values.min()), float(values.max())], "colours": [lower, upper], "step": step}
    return ranges


def even_range(lower, upper):
    """The range, zero with it, widened to multiples of a step 1, 2, 2.5 or 5 times a power of ten; and that step."""
    lower, upper = min(lower, 0.), max(upper, 0.)
    size = upper - lower if upper > lower else 1.
    power = 10.**np.floor(np.log10(size / 4.))
    step = next(float(power * factor) for factor in (1., 2., 2.5, 5., 10.) if power * factor >= size / 5.)
    first, last = np.floor(lower / step + 1e-9), np.ceil(upper / step - 1e-9)
    return float(first * step), float(max(last, first + 1.) * step), step


def view_box(flow, walls, reach=0.15):
    """The part of space that is shown: fluid but for a few far points, solids, and walls up to @p reach of the fluid's
    size beside them; @p walls are the corners of all of them, (n, dimension)."""
    points = np.concatenate([surface.points for surface in flow.surfaces()])
    lower, upper = np.array([usual_range(points[:, d]) for d in range(points.shape[1])]).T
    size = (upper - lower).max()
    for surface in flow.solids:
        if surface is not None:
            lower, upper = np.minimum(lower, surface.points.min(axis=0)), np.maximum(upper, surface.points.max(axis=0))
    if len(walls):
        lower = np.minimum(lower, np.maximum(walls.min(axis=0), lower - reach * size))
        upper = np.maximum(upper, np.minimum(walls.max(axis=0), upper + reach * size))
    margin = 0.03 * (upper - lower).max()
    return lower - margin, upper + margin


# ------------------------------------------------------------------------------------------------------- encoding


class Encoder:
    """Turns the snapshots of a run into blocks of bytes, and says how to read them."""

    def __init__(self, flow, walls, ranges):
        self.flow, self.walls, self.ranges = flow, walls, ranges
        points = [surface.points for surface in flow.surfaces()]
        self.lower = np.min([p.min(axis=0) for p in points], axis=0)
        self.size = np.maximum(np.max([p.max(axis=0) for p in points], axis=0) - self.lower, 1e-12)

    def blocks(self):
        """One block a snapshot, compressed, and what stands in it."""
        walls = self.walls.states if self.walls.moves else [None] * len(self.flow.times)
        return [self.encode(*snapshot) for snapshot in zip(self.flow.times, self.flow.fluids, self.flow.solids, walls)]

    def encode(self, time, fluid, solid, walls):
        arrays, head = [], {"time": time}
        for name, surface in (("fluid", fluid), ("solid", solid)):
            if surface is None:
                continue
            arrays.append(rounded(surface.points, self.lower, self.size).T.astype("<u2"))
            arrays.append(surface.triangles.T.astype("<u4"))
            head[name] = {"points": len(surface.points), "triangles": len(surface.triangles)}
            if surface.outline is not None:
                arrays.append(surface.outline.astype("<u4"))
                head[name]["outline"] = len(surface.outline)
            if name == "fluid":
                arrays += [self.field(surface, field_name) for field_name in self.ranges]
        if walls is not None:
            arrays.append(walls.T.astype("<f4"))
            head["walls"] = len(walls)
        data = b"".join(padded(np.ascontiguousarray(array).tobytes()) for array in arrays)
        return head, gzip.compress(data, 6, mtime=0)

    def field(self, surface, name):
        values = surface.fields[name]
        if name == "yielded":
            return values.astype("u1")
        lower, upper = self.ranges[name]["values"]
        return rounded(np.nan_to_num(values, nan=lower), lower, max(upper - lower, 1e-300)).astype("<u2")


def rounded(values, lower, size):
    return np.clip(np.round((values - lower) / size * STEPS), 0, STEPS)


def padded(data):
    return data + b"\0" * (-len(data) % 4)


def thinned(blocks_of_runs, largest=LARGEST_TOTAL):
    """The blocks of every run; every second one is left out, but for the first and the last, until all are below
    @p largest bytes in base64."""
    def total():
        return sum(4 * len(data) / 3 for blocks in blocks_of_runs for _, data in blocks)

    while total() > largest and any(len(blocks) > 2 for blocks in blocks_of_runs):
        blocks_of_runs = [blocks[::2] if len(blocks) % 2 == 1 else [blocks[0], *blocks[1::2]] for blocks
                          in blocks_of_runs]
    return blocks_of_runs
