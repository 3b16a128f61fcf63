# SPDX-License-Identifier: GPL-3.0-or-later
"""The rigid walls of a run: points, and the lines or triangles that join them; where boundaries move, the places of the
points in each snapshot."""

import pathlib

import numpy as np

from lahar_output import Mesh, OutputError, read_pvd, read_wall_facets
from mesh_geometry import faces_with_cells, joined_points

FEATURE_ANGLE = 20.  # degrees: between facets that meet flatter there is no edge


class Walls:
    """Polylines in the plane, triangles and their edges in space, all as numbers of points.

    states: places of the points, (states, points, dimension), one state for every snapshot of the flow, or a single one
            where nothing moves
    filled: which of the lines are closed bodies without fluid inside
    """

    def __init__(self, run, flow):
        self.lines, self.filled = [], []
        self.triangles, self.edges = np.zeros((0, 3), dtype=int), np.zeros((0, 2), dtype=int)
        facets = facets_by_snapshot(pathlib.Path(run.directory), flow.times, run.dimension)
        if run.dimension == 2:
            self.states, self.lines = polylines(facets)
            surface = flow.surfaces()[0]
            centres = surface.points[surface.triangles].mean(axis=1)
            self.filled = [line[0] == line[-1] and not contains(self.states[0][line], centres).any()
                           for line in self.lines]
        else:
            self.states, self.triangles = shared_corners(facets)
            self.edges = feature_edges(self.states[0], self.triangles)

    @property
    def moves(self):
        return len(self.states) > 1

    def corners(self):
        """All places where a point is at some time, (n, dimension)."""
        return self.states.reshape(-1, self.states.shape[-1])

    def places_of_lines(self):
        """The lines as the places of their points in the first snapshot."""
        return [self.states[0][line] for line in self.lines]


def facets_by_snapshot(directory, times, dimension):
    """The corners of the facets in each snapshot, (states, facets, dimension, dimension); one state if all are alike."""
    files = [(time, path) for time, path in read_pvd(directory / "solution.pvd", 2) if path.is_file()]
    if len({path for _, path in files}) <= 1:
        return read_wall_facets(files[0][1] if files else directory / "walls.vtu", dimension)[None]
    paths = [min(files, key=lambda file: abs(file[0] - time))[1] for time in times]
    states = [read_wall_facets(path, dimension) for path in paths]
    for path, state in zip(paths, states):
        if len(state) != len(states[0]):
            raise OutputError(f"{path}: {len(state)} facets of walls; allowed: {len(states[0])}, as in {paths[0]}")
    return np.array(states)


def polylines(facets):
    """Segments as points and lines of their numbers: one goes on where the next segment begins at its end, always."""
    n = facets.shape[1]
    goes_on = (facets[:, :-1, 1] == facets[:, 1:, 0]).all(axis=(0, 2))
    lines = []
    for segment in range(n):
        if segment > 0 and goes_on[segment - 1]:
            lines[-1].append(segment)
        else:
            lines.append([segment])
    corners, result, first = [], [], 0
    for line in lines:
        # The ends of the line's segments, before them the start of the first one.
        points = np.concatenate([facets[:, line[:1], 0], facets[:, line, 1]], axis=1)
        numbers = first + np.arange(points.shape[1])
        if (points[:, 0] == points[:, -1]).all() and len(numbers) > 2:
            points, numbers = points[:, :-1], np.append(numbers[:-1], first)
        corners.append(points)
        result.append(numbers)
        first += points.shape[1]
    return np.concatenate(corners, axis=1) if corners else np.zeros((len(facets), 0, 2)), result


def shared_corners(facets):
    """Triangles as points and their numbers; neighbours share those that are at one place in all states."""
    n = 3 * facets.shape[1]
    if n == 0:
        return np.zeros((len(facets), 0, 3)), np.zeros((0, 3), dtype=int)
    numbers = np.zeros(n, dtype=np.int64)
    for state in facets.reshape(len(facets), n, 3):
        _, first, numbers = np.unique(numbers * n + joined_points(state)[0], return_index=True, return_inverse=True)
    return facets.reshape(len(facets), n, 3)[:, first], numbers.reshape(-1, 3)


def feature_edges(points, triangles):
    """The edges of triangles in space that are on the rim or where two of them meet at an angle."""
    if len(triangles) == 0:
        return np.zeros((0, 2), dtype=int)
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    edges, cells, others = faces_with_cells(Mesh(points, triangles), np.arange(len(points)))
    is_flat = (others >= 0) & (np.abs((normals[cells]
                                       * normals[others]).sum(axis=1)) > np.cos(np.radians(FEATURE_ANGLE)))
    return edges[~is_flat]


def contains(polygon, points):
    """Which points lie inside a closed polygon."""
    inside = np.zeros(len(points), dtype=bool)
    for (x0, y0), (x1, y1) in zip(polygon[:-1], polygon[1:]):
        if y0 != y1:
            crosses = (points[:, 1] < y0) != (points[:, 1] < y1)
            inside ^= crosses & (points[:, 0] < x0 + (points[:, 1] - y0) / (y1 - y0) * (x1 - x0))
    return inside
