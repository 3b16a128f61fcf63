#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with triangulated surfaces in a flow in space: a wedge of 30 degrees, a sphere of which a part is below the
floor, a horseshoe with its hollow towards the flow. Nothing gets into them, and mirror images feel the same impulse."""

import numpy as np

from verification import Check, read_pvd, read_run, read_vtu, run_check, volume_changes

TOP, BOTTOM = 0.12, -0.02


def prism(corners, top):
    """Vertices and triangles of an upright prism; @p corners go round its base, @p top has the triangles of that."""
    n = len(corners)
    vertices = [(*corner, z) for z in (BOTTOM, TOP) for corner in corners]
    sides = [face for a in range(n) for b in [(a + 1) % n] for face in ((a, b, n + b), (a, n + b, n + a))]
    lids = [tuple(n + i for i in face) for face in top] + [face[::-1] for face in top]
    return np.array(vertices), np.array(sides + lids)


def wedge():
    half = 0.1 * np.tan(np.radians(15.))
    return prism([(0.14, 0.05), (0.24, 0.05 - half), (0.24, 0.05 + half)], [(0, 1, 2)])


def horseshoe():
    corners = [(0., 0.), (0.1, 0.), (0.1, 0.1), (0., 0.1), (0., 0.07), (0.06, 0.07), (0.06, 0.03), (0., 0.03)]
    return prism([(0.14 + x, 0.02 + y) for x, y in corners],
                 [(0, 1, 6), (0, 6, 7), (1, 2, 5), (1, 5, 6), (2, 3, 4), (2, 4, 5)])


def sphere():
    """An octahedron, each of its edges divided in eight, on a sphere of radius 0.04 m around (0.17, 0.06, 0.02)."""
    n, places, faces = 8, {}, []
    for octant in np.ndindex(2, 2, 2):
        sign = 1 - 2 * np.array(octant)

        def number(i, j):
            key = tuple(sign * (i, j, n - i - j))
            return places.setdefault(key, len(places))

        for i in range(n):
            for j in range(n - i):
                triangles = [((i, j), (i + 1, j), (i, j + 1))]
                if i + j < n - 1:
                    triangles.append(((i + 1, j), (i + 1, j + 1), (i, j + 1)))
                faces += [tuple(number(*c) for c in triangle)[::sign.prod()] for triangle in triangles]
    directions = np.array(list(places), float)
    return [0.17, 0.06, 0.02] + 0.04 * directions / np.linalg.norm(directions, axis=1)[:, None], np.array(faces)


def write_off(path, vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0", *("{:.12g} {:.12g} {:.12g}".format(*v) for v in vertices),
             *("3 {} {} {}".format(*f) for f in faces)]
    path.write_text("\n".join(lines) + "\n")


def turns(points, vertices, faces):
    """How often the closed surface winds round each point: 1 inside, 0 outside."""
    a, b, c = (vertices[faces[:, k]][None] - points[:, None] for k in range(3))
    lengths = [np.linalg.norm(x, axis=2) for x in (a, b, c)]
    dots = [np.einsum("pfd,pfd->pf", x, y) for x, y in ((a, b), (b, c), (c, a))]
    volume = np.einsum("pfd,pfd->pf", a, np.cross(b, c))
    rest = lengths[0] * lengths[1] * lengths[2] + dots[0] * lengths[2] + dots[1] * lengths[0] + dots[2] * lengths[1]
    return np.arctan2(volume, rest).sum(axis=1) / (2. * np.pi)


def largest_part_inside(directory, body):
    """The largest part of a cell's sampled points that lies in the body or its mirror image, over all snapshots."""
    vertices, faces = body
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    margin = 1e-6 * np.vstack([np.zeros(3), np.eye(3), -np.eye(3)])  # what is on the surface is not inside
    weights, worst = np.random.default_rng(1).dirichlet(np.ones(4), 100), 0.
    for _, path in read_pvd(directory / "solution.pvd"):
        mesh = read_vtu(path, 3)
        places = np.einsum("kc,ncd->nkd", weights, mesh.points[mesh.cells])
        places[..., 1] = np.abs(places[..., 1])
        cells, samples = np.nonzero(((places > low) & (places < high)).all(axis=2))
        inside = np.zeros(places.shape[:2])
        for part in np.array_split(np.arange(len(cells)), 1 + len(cells) // 2000):
            chosen = places[cells[part], samples[part]]
            deep = turns(chosen, vertices, faces) > 0.5
            deep[deep] = [(turns(place + margin, vertices, faces) > 0.5).all() for place in chosen[deep]]
            inside[cells[part], samples[part]] = deep
        worst = max(worst, inside.mean(axis=1).max())
    return worst


def check_body(check, name, body, is_flat):
    """On faces that are not flat cells may lie below chords, but none as a whole."""
    vertices, faces = body
    check.output.mkdir(parents=True, exist_ok=True)
    entries = []
    for side, mirror in (("left", 1.), ("right", -1.)):
        path = (check.output / f"{name}_{side}.off").resolve()
        write_off(path, vertices * [1., mirror, 1.], faces if mirror > 0. else faces[:, ::-1])
        entries.append(f"Boundaries/{side}/surface/File={path}")
    directory = check.run("contact/bodies.prm", *entries)
    run = read_run(directory)
    part = largest_part_inside(directory, body)
    if is_flat:
        check.below(f"{name}: largest part of a cell inside", part, 0.)
    else:
        check.below(f"{name}: a cell inside as a whole", float(part >= 1.), 0.)
    impulse = {side: np.array([np.sum(run[f"{side} force {d} (N)"] * run["Time step size (s)"]) for d in "xy"])
               for side in ("left", "right")}
    mirror = impulse["right"] * [1., -1.]
    check.below(f"{name}: difference of the mirror images' impulses",
                np.linalg.norm(impulse["left"] - mirror) / np.linalg.norm(impulse["left"]), 0.15)
    check.below(f"{name}: no impulse (N s)", 0.01 - impulse["left"][0], 0.)
    for cause, change in zip(("solver", "remeshing"), volume_changes(run)):
        check.below(f"{name}: volume change by {cause}", change, 1e-4)


def main():
    check = Check(__doc__)
    check_body(check, "sphere", sphere(), False)
    check_body(check, "wedge", wedge(), True)
    check_body(check, "horseshoe", horseshoe(), True)
    check.finish()


if __name__ == "__main__":
    run_check(main)
