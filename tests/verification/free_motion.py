#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""V9: free fall and rigid rotation keep momentum, angular momentum, energy and shape.

The statistics file has ten digits, hence 1e-9 for what is exact.
"""

import numpy as np

from verification import Check, integrate, last_mesh, read_pvd, read_run, read_vtu, run_check, volume_changes

GRAVITY, SIDE = 9.81, 0.2
DENSITY, RADIUS, OMEGA = 1000., 0.1, 10.


def check_free_fall(check):
    directory = check.run("free_motion/free_fall.prm")
    statistics = read_run(directory)
    time = statistics["Time (s)"]
    kinetic_energy = 0.5 * DENSITY * SIDE**2 * (GRAVITY * time)**2
    check.below("free fall, kinetic energy, relative error",
                np.abs(statistics["Kinetic energy (J)"] / kinetic_energy - 1.).max(), 1e-9)
    energy = statistics["Kinetic energy (J)"] + statistics["Potential energy (J)"]
    check.below("free fall, change of energy over the final kinetic energy", np.ptp(energy) / kinetic_energy[-1], 1e-9)
    fall = SIDE - statistics["height (m)"]
    first_step = 0.5 * GRAVITY * statistics["Time step size (s)"][0]**2
    check.below("free fall, error of the distance over g dt^2/2",
                np.abs(fall - 0.5 * GRAVITY * time**2).max() / first_step, 1e-6)
    velocity = last_mesh(directory).at_points("velocity")
    check.below("free fall, velocity by particle (single precision), relative error",
                np.abs(velocity[:, :2] - [0., -GRAVITY * time[-1]]).max() / (GRAVITY * time[-1]), 1e-6)
    check.below("free fall, volume change", max(volume_changes(statistics)), 1e-12)


def angular_momentum(mesh):
    velocity = mesh.at_points("velocity")
    return DENSITY * (integrate(mesh, (mesh.points[:, 0], velocity[:, 1]))
                      - integrate(mesh, (mesh.points[:, 1], velocity[:, 0])))


def check_spinning_drop(check):
    directory = check.run("free_motion/spinning_drop.prm")
    statistics = read_run(directory)
    meshes = [read_vtu(path) for _, path in read_pvd(directory / "solution.pvd")]
    moments = np.array([angular_momentum(mesh) for mesh in meshes])
    area = np.array([integrate(mesh, (np.ones(len(mesh.points)),) * 2) for mesh in meshes])
    spin = moments / (DENSITY * area**2 / (2. * np.pi))
    print("  angular velocity of a round drop with the moments of the snapshots: "
          + ", ".join(f"{value:.6f}" for value in spin) + " 1/s")
    momentum = np.array([[integrate(mesh, (np.ones(len(mesh.points)), mesh.at_points("velocity")[:, d]))
                          for d in range(2)] for mesh in meshes])
    check.below("spinning drop, momentum over mass times rim speed",
                np.abs(momentum).max() / (area[0] * OMEGA * RADIUS), 1e-6)
    check.below("spinning drop, change of angular momentum", np.abs(moments / moments[0] - 1.).max(), 1e-3)
    check.below("spinning drop, change of angular momentum after the first snapshot",
                np.abs(moments[1:] / moments[1] - 1.).max(), 1e-4)
    energy = statistics["Kinetic energy (J)"]
    check.below("spinning drop, change of energy", np.abs(energy / energy[0] - 1.).max(), 1e-3)
    radii = [statistics[name] for name in ("right (m)", "top (m)")] + [-statistics[name] for name in ("left (m)", "bottom (m)")]
    check.below("spinning drop, change of radius", max(np.abs(radius / RADIUS - 1.).max() for radius in radii), 0.005)
    check.below("spinning drop, volume change", max(volume_changes(statistics)), 1e-3)


def main():
    check = Check(__doc__)
    check_free_fall(check)
    check_spinning_drop(check)
    check.finish()


run_check(main)
