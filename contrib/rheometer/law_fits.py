# SPDX-License-Identifier: GPL-3.0-or-later
"""Lahar's fluid laws without their regularisation, and their parameters from a flow curve by least squares."""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy.optimize import least_squares, nnls
from scipy.special import stdtrit

INFINITY = np.inf


@dataclass(frozen=True)
class Law:
    """A law by Lahar's name. Entries are (name in Lahar, unit, lowest, highest value), in the order of stress()."""

    name: str
    entries: tuple
    stress: Callable    # (strain rate in 1/s, parameters) → Pa
    bases: Callable     # strain rates → for values of the nonlinear parameters (columns, parameters of coefficients)


def positive(name, unit):
    return name, unit, 0., INFINITY


VISCOSITIES = positive("Viscosity at rest", "Pa s"), positive("Viscosity at high rates", "Pa s")
TIME, YIELD_STRESS = positive("Time constant", "s"), positive("Yield stress", "Pa")
CONSISTENCY = positive("Consistency", "Pa s^n")
INDEX = ("Flow index", "", 0.02, 3.)


def power_bases(with_yield_stress):
    def bases(rate):
        for n in np.linspace(0.1, 2., 39):
            columns = [rate**n] + ([np.ones_like(rate)] if with_yield_stress else [])
            yield columns, lambda c, n=n: [c[0], n, *c[1:]]
    return bases


def plateau_bases(fall, exponents):
    """The stress of a law with two viscosities is linear in them; fall(λ γ̇, exponent) is how much of the first is left."""
    def bases(rate):
        for time in np.logspace(-1.5, 1.5, 25) / np.sqrt(rate.min() * rate.max()):
            for exponent in exponents:
                left = fall(time * rate, exponent)
                yield [rate * left, rate * (1. - left)], lambda c, time=time, e=exponent: [c[0], c[1], time, e]
    return bases


def carreau(z, n):
    return (1. + z * z)**((n - 1.) / 2.)


def cross(z, q):
    return 1. / (1. + z**q)


def plateau_stress(fall):
    return lambda rate, p: rate * (p[1] + (p[0] - p[1]) * fall(p[2] * rate, p[3]))


def casson_stress(rate, p):
    return (np.sqrt(p[1]) + np.sqrt(p[0] * rate))**2


def casson_bases(rate):
    """Over the ratio of the two terms at the middle of the curve the stress is linear in one factor."""
    for ratio in np.logspace(-4., 4., 81):
        yield [casson_stress(rate, (1., ratio * np.sqrt(rate.min() * rate.max())))], \
            lambda c, r=ratio: [c[0], c[0] * r * np.sqrt(rate.min() * rate.max())]


LAWS = (
    Law("Newtonian", (positive("Viscosity", "Pa s"),), lambda rate, p: p[0] * rate,
        lambda rate: [([rate], list)]),
    Law("power law", (CONSISTENCY, INDEX), lambda rate, p: p[0] * rate**p[1], power_bases(False)),
    Law("Bingham", (positive("Plastic viscosity", "Pa s"), YIELD_STRESS), lambda rate, p: p[1] + p[0] * rate,
        lambda rate: [([rate, np.ones_like(rate)], list)]),
    Law("Casson", (positive("Casson viscosity", "Pa s"), YIELD_STRESS), casson_stress, casson_bases),
    Law("Herschel-Bulkley", (CONSISTENCY, INDEX, YIELD_STRESS), lambda rate, p: p[2] + p[0] * rate**p[1],
        power_bases(True)),
    Law("Carreau-Yasuda", (*VISCOSITIES, TIME, ("Flow index", "", 0.02, 1.)), plateau_stress(carreau),
        plateau_bases(carreau, np.linspace(0.1, 0.9, 9))),
    Law("Cross", (*VISCOSITIES, TIME, ("Exponent", "", 0.1, 1.)), plateau_stress(cross),
        plateau_bases(cross, np.linspace(0.2, 1., 9))),
)


@dataclass
class Fit:
    """A law with its parameters from n points."""

    law: Law
    parameters: np.ndarray
    half_widths: np.ndarray  # of the 95 % intervals; nan where the data do not tell
    rms: float               # Pa
    relative_rms: float      # of the stress
    information: float       # Schwarz's criterion (Ann. Statist. 6 (1978) 461): the lower, the better

    @property
    def is_at_limit(self):
        """Which parameters are at an end of their range."""
        _, _, lowest, highest = (np.array(column) for column in zip(*self.law.entries))
        return (self.parameters <= lowest) | (self.parameters >= highest)

    @property
    def is_told(self):
        """Whether the data tell all parameters."""
        return bool(np.all(np.isfinite(self.half_widths) | self.is_at_limit))

    def stress(self, rate):
        return self.law.stress(np.asarray(rate), self.parameters)

    def lines(self, density=None):
        """Lines of a .prm file."""
        entries = [(name, f"{value:.5g}") for (name, *_), value in zip(self.law.entries, self.parameters)]
        if density is not None:
            entries.insert(0, ("Density", f"{density:g}"))
        width = max(len(name) for name, _ in entries)
        return [f"set Law = {self.law.name}", f"subsection {self.law.name}",
                *(f"  set {name:{width}} = {value}" for name, value in entries), "end"]

    def text(self):
        """The parameters with their intervals."""
        words = []
        for (name, unit, *_), value, half_width, is_at_limit in zip(self.law.entries, self.parameters, self.half_widths,
                                                                    self.is_at_limit):
            interval = "(at its limit)" if is_at_limit else \
                f"± {half_width:.2g}" if np.isfinite(half_width) else "(not told by the data)"
            words.append(f"{name} {value:.4g} {interval} {unit}".rstrip())
        return ", ".join(words)


def n_points_for(law):
    """Least number of points: with fewer than three more than parameters their errors would be guesses."""
    return len(law.entries) + 3


def fit_law(law, curve, relative):
    """The parameters for which the sum of the squared differences of the stress, or of them over the stress, is least."""
    weight = 1. / curve.stress if relative else np.ones_like(curve.stress)
    lower, upper = (np.array([entry[i] for entry in law.entries]) for i in (2, 3))

    best, start = INFINITY, None
    for columns, parameters in law.bases(curve.rate):
        coefficients, norm = nnls(np.column_stack(columns) * weight[:, None], curve.stress * weight)
        if norm < best:
            best, start = norm, np.array(parameters(list(coefficients)))
    size = np.where(start > 0., start, 1e-3 * np.maximum(start.max(), 1e-12))
    solution = least_squares(lambda x: (law.stress(curve.rate, x * size) - curve.stress) * weight,
                             np.clip(start, lower, upper) / size, bounds=(lower / size, upper / size), x_scale="jac",
                             xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=2000)
    values = np.where(solution.x * size < lower + 1e-7 * size, lower, solution.x * size)

    n, n_parameters = len(curve.rate), len(values)
    differences = law.stress(curve.rate, values) - curve.stress
    squares = np.sum((differences * weight)**2)
    floor = n * (1e-9 * np.max(curve.stress * weight))**2
    information = n * np.log(max(squares, floor) / n) + n_parameters * np.log(n)
    is_free = solution.active_mask == 0
    is_free &= (values > lower) & (values < upper)
    half_widths = np.full(n_parameters, np.nan)
    _, singular, directions = np.linalg.svd(solution.jac[:, is_free], full_matrices=False)
    if singular.size and singular[-1] > 1e-8 * singular[0]:
        variances = squares / (n - n_parameters) * np.sum((directions / singular[:, None])**2, axis=0)
        half_widths[is_free] = stdtrit(n - n_parameters, 0.975) * np.sqrt(variances) * size[is_free]
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = differences / curve.stress
    return Fit(law, values, half_widths, float(np.sqrt(np.mean(differences**2))), float(np.sqrt(np.mean(shares**2))),
               float(information))
