# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the names of the parts stand in the sketch of a case."""

import numpy as np

KINDS = {"Fluids": "fluid", "Boundaries": "boundary", "Solids": "solid"}


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
            lists = [line for line in walls.places_of_lines() if not any(is_on(line, points) for points in taken)]
        elif not others and len(walls.triangles):
            centres = walls.states[0][walls.triangles].mean(axis=1)
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
