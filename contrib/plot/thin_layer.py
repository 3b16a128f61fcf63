# SPDX-License-Identifier: GPL-3.0-or-later
"""The slump of a cone of Bingham fluid by the theory of thin layers: an independent estimate of the spread in time.

Radial flow in a layer of the depth h(r, t), without inertia. The stress at the bed is

    tau_b = (rho g h − c tau0) |dh/dr|

c = 0 is lubrication theory (N. J. Balmforth et al., J. Non-Newtonian Fluid Mech. 142 (2007) 219-243 review it). The next
order counts the radial stress of the fluid above the bed, which is at yield too: spreading as u ~ r strains it equally in
both horizontal directions, so s_rr − s_zz = sqrt(3) (tau0² − s_rz²)^½, and with s_rz linear over the depth its mean is
sqrt(3) pi/4 tau0, hence c = sqrt(3) pi/4. This holds near rest; as long as only a part of the depth is at yield it is too
large. Below the depth Y = h (1 − tau0/tau_b) the fluid is sheared:

    2 pi r q = flux through the circle of radius r,   q = tau_b/h Y² (3 h − Y)/(6 mu),   dh/dt = −(1/r) d(r q)/dr
"""

import math
from dataclasses import dataclass

import numpy as np

GRAVITY = 9.81
NEXT_ORDER = math.sqrt(3.) * math.pi / 4.


@dataclass(frozen=True)
class Cone:
    """A truncated cone of fluid, SI units."""

    height: float
    base_radius: float
    top_radius: float
    density: float
    viscosity: float
    yield_stress: float

    @property
    def volume(self):
        a, b = self.base_radius, self.top_radius
        return math.pi * self.height * (a * a + a * b + b * b) / 3.


def spread(cone, times, order=NEXT_ORDER, n_rings=200, rings_until=None):
    """Diameters (m) at the ascending @p times (s), by explicit finite volumes on @p n_rings rings up to the radius
    @p rings_until (m; by default five times that of the base), which the layer must not reach.

    @p order is the factor c above: 0 or NEXT_ORDER. The time taken grows with the cube of the number of rings.
    """
    weight = cone.density * GRAVITY
    width = (rings_until or 5. * cone.base_radius) / n_rings
    edges = width * np.arange(n_rings + 1)
    middles, areas = 0.5 * (edges[1:] + edges[:-1]), math.pi * (edges[1:]**2 - edges[:-1]**2)
    slope = cone.height / (cone.base_radius - cone.top_radius)
    depth = np.clip(slope * (cone.base_radius - middles), 0., cone.height)
    depth *= cone.volume / (areas @ depth)
    flux, time, diameters = np.zeros(n_rings + 1), 0., []
    for target in times:
        while time < target * (1. - 1e-12):
            descent = (depth[:-1] - depth[1:]) / width
            upstream = np.where(descent > 0., depth[:-1], depth[1:])
            stress = np.maximum(weight * upstream - order * cone.yield_stress, 0.) * np.abs(descent)
            sheared = upstream * np.maximum(1. - cone.yield_stress / np.maximum(stress, 1e-300), 0.)
            flux[1:-1] = (2. * math.pi * edges[1:-1] * np.sign(descent) * stress / np.maximum(upstream, 1e-300)
                          * sheared**2 * (3. * upstream - sheared) / (6. * cone.viscosity))
            # Explicit: the limit of diffusion with the largest diffusivity.
            step = min(0.2 * width**2 * 3. * cone.viscosity / (weight * depth.max()**3), target - time)
            depth -= step * np.diff(flux) / areas
            time += step
        diameters.append(2. * front(depth, middles, width))
    return np.array(diameters)


def front(depth, middles, width):
    """Radius where the layer ends: the last wet ring is filled in proportion to its depth and the one's before."""
    last = np.flatnonzero(depth > 1e-3 * depth.max())[-1]
    return middles[last] - 0.5 * width + width * min(1., depth[last] / depth[last - 1])


def arrested_spread(cone, order=NEXT_ORDER):
    """Diameter (m) for infinite time: tau_b = tau0 everywhere, r = R + c h − h²/(2 l) with l = tau0/(rho g)."""
    length = cone.yield_stress / (cone.density * GRAVITY)

    def volume(summit):
        h = np.linspace(0., summit, 2001)
        radius = (summit**2 - h**2) / (2. * length) - order * (summit - h)
        return math.pi * np.sum(0.5 * (radius[1:]**2 + radius[:-1]**2) * np.diff(h))

    low, high = order * length, cone.height
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if volume(middle) > cone.volume else (middle, high)
    return 2. * (low**2 / (2. * length) - order * low)
