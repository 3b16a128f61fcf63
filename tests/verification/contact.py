#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact with walls: pools on both sides of a wall without thickness, or a thin one, rest, with the force of the
difference of their levels; nothing passes it in a splash; nothing gets into pillars, and mirror images feel the same force."""

import numpy as np

from verification import Check, read_pvd, read_run, read_vtu, run_check, volume_changes

WEIGHT = 9810.
PILLAR = np.array([[0.15, 0.03, 0.], [0.19, 0.07, 0.12]])  # its mirror image has −y


def check_partition(check):
    force = WEIGHT * 0.5 * (0.4**2 - 0.1**2)
    thin = ("Boundaries/partition/polyline/Points=0.5, 0 : 0.5, 0.6 : 0.505, 0.6 : 0.505, 0",
            "Fluids/right/box/Corners=0.505, 0 : 1, 0.1")
    for law, name, entries in (("no slip", "no slip", ()), ("free slip", "free slip", ()),
                               ("no slip", "a wall of 0.2 mesh sizes", thin)):
        run = read_run(check.run("contact/partition.prm", f"Boundaries/tank/Law={law}", f"Boundaries/partition/Law={law}",
                                 *entries))
        check.below(f"pools, {name}: force on the partition over the exact one less 1",
                    np.abs(run["partition force x (N)"] / force - 1.).max(), 1e-7)
        check.below(f"pools, {name}: levels off (m)", max(np.abs(run["left level (m)"] - 0.4).max(),
                                                         np.abs(run["right level (m)"] - 0.1).max()), 1e-9)
        check.below(f"pools, {name}: kinetic energy (J)", run["Kinetic energy (J)"].max(), 1e-15)


def check_splash(check):
    for law in ("no slip", "free slip"):
        run = read_run(check.run("contact/splash.prm", f"Boundaries/partition/Law={law}"))
        check.below(f"splash, {law}: how far fluid comes through the wall (m)", run["front (m)"].max() - 0.5, 1e-9)
        check.below(f"splash, {law}: change of the level beyond (m)", np.abs(run["level (m)"] - 0.1).max(), 1e-8)
        for cause, change in zip(("solver", "remeshing"), volume_changes(run)):
            check.below(f"splash, {law}: volume change by {cause}", change, 1e-3)


def check_pillars(check):
    """Impulses of single runs differ by chance (doc/benchmarks/contact.md): sums over meshes that differ a little."""
    inside, weights = 0., np.random.default_rng(1).dirichlet(np.ones(4), 200)
    impulse = {"left": np.zeros(2), "right": np.zeros(2)}
    for mesh_size in (0.02, 0.0197, 0.0203, 0.0206):
        directory = check.run("contact/pillars.prm", f"Mesh size={mesh_size}")
        run = read_run(directory)
        for _, path in read_pvd(directory / "solution.pvd"):
            mesh = read_vtu(path, 3)
            places = np.einsum("kc,ncd->nkd", weights, mesh.points[mesh.cells])
            places[..., 1] = np.abs(places[..., 1])
            inside = max(inside, ((places > PILLAR[0] + 1e-6) & (places < PILLAR[1] - 1e-6)).all(axis=2).mean(axis=1).max())
        for name, of_pillar in impulse.items():
            of_pillar += [np.sum(run[f"{name} force {d} (N)"] * run["Time step size (s)"]) for d in "xy"]
    check.below("pillars: largest part of a cell inside", inside, 0.)
    mirror = impulse["right"] * [1., -1.]
    check.below("pillars: difference of the mirror images' impulses, four meshes",
                np.linalg.norm(impulse["left"] - mirror) / np.linalg.norm(impulse["left"]), 0.15)


def main():
    check = Check(__doc__)
    check_partition(check)
    check_splash(check)
    check_pillars(check)
    check.finish()


if __name__ == "__main__":
    run_check(main)
