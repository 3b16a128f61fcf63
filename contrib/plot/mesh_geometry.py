# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry of snapshots: which corners are the same point, what lies on the outside, the usual range of values."""

import numpy as np

# The edges of a triangle; the faces of a tetrahedron, each turned outwards where the tetrahedron is right-handed.
FACES = {3: ((0, 1), (1, 2), (2, 0)), 4: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))}
BITS = 21  # of a coordinate, so that three of them are one whole number of 63 bits


def usual_range(values):
    """The range of the values without a few far ones, such as those of single drops."""
    lower, upper = np.percentile(values, [0.2, 99.8])
    tolerance = 0.25 * (upper - lower)
    return (lower if values.min() < lower - tolerance else values.min(),
            upper if values.max() > upper + tolerance else values.max())


def joined_points(points):
    """For every point the number of its place, equal for points at one place; and the first point at every place."""
    lower = points.min(axis=0)
    size = max((points.max(axis=0) - lower).max(), 1e-300)
    steps = np.round((points - lower) / size * (2**BITS - 1)).astype(np.int64)
    keys = np.zeros(len(points), dtype=np.int64)
    for d in range(points.shape[1]):
        keys = (keys << BITS) | steps[:, d]
    _, first, place = np.unique(keys, return_index=True, return_inverse=True)
    return place.reshape(-1), first


def faces_with_cells(mesh, place=None):
    """Every edge of triangles, in space every face of tetrahedra, as its points and the one or two cells beside it (the
    second is -1 on the boundary). Points are one where @p place has the same number for them; without it where they
    are at one place."""
    if place is None:
        place, _ = joined_points(mesh.points)
    faces = np.concatenate([mesh.cells[:, face] for face in FACES[mesh.cells.shape[1]]])
    cells = np.tile(np.arange(len(mesh.cells)), len(FACES[mesh.cells.shape[1]]))
    corners = np.sort(place[faces], axis=1).astype(np.int64)
    # Sorted corners as one number: the places of the first two, then of the pair and the third.
    keys = corners[:, 0]
    for d in range(1, corners.shape[1]):
        if d > 1:
            keys = np.unique(keys, return_inverse=True)[1].reshape(-1)
        keys = keys * (place.max(initial=0) + 1) + corners[:, d]
    _, first, number = np.unique(keys, return_index=True, return_inverse=True)
    number = number.reshape(-1)
    others = np.full(len(first), -1)
    is_second = np.ones(len(number), dtype=bool)
    is_second[first] = False
    others[number[is_second]] = cells[is_second]
    return faces[first], cells[first], others


def outside(mesh):
    """The edges of triangles, in space the faces of tetrahedra on the outside, turned outwards: points and cells."""
    faces, cells, others = faces_with_cells(mesh)
    is_outer = others < 0
    faces, cells = faces[is_outer], cells[is_outer]
    if mesh.cells.shape[1] == 4:
        corners = mesh.points[mesh.cells[cells]]
        is_left_handed = np.linalg.det(corners[:, 1:] - corners[:, :1]) < 0.
        faces[is_left_handed] = faces[is_left_handed][:, ::-1]
    return faces, cells


def rim_radius(points, size):
    """The rim of a flow about the axis z: the largest distance of @p points from it in sectors 1.5 times @p size wide there,
    by the angle from −180 degrees on."""
    radius, angle = np.hypot(*points.T[:2]), np.arctan2(points[:, 1], points[:, 0])
    n_sectors = max(1, int(2. * np.pi * radius.max(initial=0.) / (1.5 * size)))
    rim = np.zeros(n_sectors)
    np.maximum.at(rim, ((angle / (2. * np.pi) + 0.5) * n_sectors).astype(int) % n_sectors, radius)
    return rim
