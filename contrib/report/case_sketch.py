# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sketch of a case shows besides fluid and solids: walls, and where the names of the parts stand."""

import pathlib

import numpy as np

from lahar_output import Mesh, read_pvd, read_vtu, read_walls
from mesh_geometry import faces_with_cells

FEATURE_ANGLE = 20.  # degrees: between facets that meet flatter there is no edge
KINDS = {"Fluids": "fluid", "Boundaries": "boundary", "Solids": "solid"}


class Walls:
    """The rigid walls of a run: polylines in the plane, triangles and their edges in space."""

    def __init__(self, run, flow):
        self.lines, self.filled = [], []
        self.triangles, self.edges = np.zeros((0, 3, 3)), np.zeros((0, 2, 3))
        # Walls that move are drawn where they are at first.
        moving = [path for _, path in read_pvd(pathlib.Path(run.directory) / "solution.pvd", 2) if path.is_file()]
        path = moving[0] if moving else pathlib.Path(run.directory) / "walls.vtu"
        if run.dimension == 2:
            walls = read_walls(path)
            self.lines = [wall.corners for wall in walls]
            places = np.concatenate([surface.points for surface in flow.surfaces()[:1]])
            self.filled = [wall.is_closed and not contains(wall.corners, places).any() for wall in walls]
        elif path.is_file():
            mesh = read_vtu(path, 3)
            self.triangles = mesh.points[mesh.cells[:, :3]]
            self.edges = feature_edges(mesh)

    def corners(self):
        """All corners, (n, dimension)."""
        parts = [*self.lines, *([self.triangles.reshape(-1, 3)] if len(self.triangles) else [])]
        return np.concatenate(parts) if parts else np.zeros((0, 2))


def contains(polygon, points):
    """Which points lie inside a closed polygon."""
    inside = np.zeros(len(points), dtype=bool)
    for (x0, y0), (x1, y1) in zip(polygon[:-1], polygon[1:]):
        if y0 != y1:
            crosses = (points[:, 1] < y0) != (points[:, 1] < y1)
            inside ^= crosses & (points[:, 0] < x0 + (points[:, 1] - y0) / (y1 - y0) * (x1 - x0))
    return inside


def feature_edges(mesh):
    """The edges of triangles in space that are on the rim or where two of them meet at an angle."""
    corners = mesh.points[mesh.cells]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    edges, cells, others = faces_with_cells(Mesh(mesh.points, mesh.cells))
    is_flat = (others >= 0) & (np.abs((normals[cells]
                                       * normals[others]).sum(axis=1)) > np.cos(np.radians(FEATURE_ANGLE)))
    return mesh.points[edges[~is_flat]]


# --------------------------------------------------------------------------------------------------------- labels


def labels(run, flow, walls, box):
    """The names of the parts and of points, each with its kind, a text and the place that it belongs to."""
    found = []
    for kind, word in KINDS.items():
        for number, name in enumerate(run.case.names(kind), 1):
            place = place_of(run, flow, walls, box, kind, name, number)
            text = f"{name} ({run.case.law(kind, name)})" if run.case.law(kind, name) else name
            if place is not None:
                found.append({"kind": word, "text": text, "at": [float(x) for x in place]})
    for section, word in (("Point gauges", "gauge"), ("Solid points", "solid point")):
        for name, place in run.case.named_points(f"Postprocess/{section}/Points").items():
            found.append({"kind": "point", "text": f"{name} ({word})", "at": [float(x) for x in place]})
    return found


def place_of(run, flow, walls, box, kind, name, number):
    """A place in a part: the middle of a fluid or a solid, a point of a boundary; None if nothing tells."""
    if kind == "Boundaries":
        return place_of_boundary(run, walls, box, name)
    if kind == "Solids":
        solid = next((surface for surface in flow.solids if surface is not None and surface.body is not None), None)
        own = solid.triangles[solid.body == number] if solid is not None else []
        return middle(solid.points[own]) if len(own) else None
    bodies = run.case.point_lists(kind, name)
    if bodies:
        return bodies[0].mean(axis=0)
    if len(run.case.names("Fluids")) == 1 and flow.fluids[0] is not None:
        return middle(flow.fluids[0].points[flow.fluids[0].triangles])
    return None


def middle(corners):
    """The middle of a surface of triangles, (n, 3, dimension)."""
    return 0.5 * (corners.reshape(-1, corners.shape[-1]).min(axis=0) + corners.reshape(-1,
                                                                                       corners.shape[-1]).max(axis=0))


def place_of_boundary(run, walls, box, name):
    """The middle of the boundary's longest segment, in space of its first polygon, as far as it is in the box."""
    lists = run.case.point_lists("Boundaries", name)
    others = [other for other in run.case.names("Boundaries") if other != name]
    if lists and run.dimension == 3:
        # Beside the middle, where the fluid may stand, towards the viewer.
        corners = np.clip(lists[0], *box)
        return 0.4 * corners.mean(axis=0) + 0.6 * max(corners, key=lambda corner: corner[0] - corner[1])
    if not lists and all(run.case.point_lists("Boundaries", other) for other in others):
        # One boundary of another shape: the walls that are not the others'.
        taken = [points for other in others for points in run.case.point_lists("Boundaries", other)]
        if run.dimension == 2:
            lists = [line for line in walls.lines if not any(is_on(line, points) for points in taken)]
        elif not others and len(walls.triangles):
            centres = walls.triangles.mean(axis=1)
            return centres[np.linalg.norm(centres - centres.mean(axis=0), axis=1).argmin()]
    segments = [(a, b) for points in lists for a, b in zip(np.clip(points[:-1], *box), np.clip(points[1:], *box))]
    if not segments:
        return None
    a, b = max(segments, key=lambda segment: np.linalg.norm(segment[1] - segment[0]))
    return 0.5 * (a + b)


def is_on(line, points):
    """Whether all corners of a line are among the points."""
    scale = max(np.abs(points).max(), 1e-300)
    return all((np.abs(points - corner).max(axis=1) < 1e-6 * scale).any() for corner in line)
