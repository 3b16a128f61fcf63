# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured flow curves: strain rates in 1/s and stresses in Pa from a text file."""

import math
from dataclasses import dataclass

import numpy as np

# Fann's model 35 with rotor R1, bob B1 and spring F1. Radii 1.8415 and 1.7245 cm: the strain rate at the bob is
# 2 ω R1²/(R1² − B1²), 1.7023 1/s a turn a minute, for a Newtonian fluid; the stress is 5.11 dyn/cm² a degree (Fann,
# Model 35 Viscometer, Instruction Manual 208878).
FANN_RATE, FANN_STRESS = 1.7023, 0.511

RATE_UNITS = {"1/s": 1., "1/min": 1. / 60.}
STRESS_UNITS = {"Pa": 1., "mPa": 1e-3, "kPa": 1e3, "dyn/cm2": 0.1, "lbf/100ft2": 0.478803}


class DataError(Exception):
    """The data are not what the tool can use: a text for the user."""


@dataclass
class FlowCurve:
    """Points of a flow curve by growing strain rate."""

    rate: np.ndarray    # 1/s
    stress: np.ndarray  # Pa

    def rows_of_table(self):
        """Strain rates and stresses that both grow: neighbours of which the stress does not are one point, their mean."""
        groups = []  # [number, mean rate, mean stress]
        for rate, stress in zip(self.rate, self.stress):
            groups.append([1, rate, stress])
            while len(groups) > 1 and not (groups[-1][1] > groups[-2][1] and groups[-1][2] > groups[-2][2]):
                n, *last = groups.pop()
                m, *before = groups.pop()
                groups.append([n + m, *((m * a + n * b) / (m + n) for a, b in zip(before, last))])
        return [(rate, stress) for _, rate, stress in groups]


def split_line(line):
    """The cells of a line: between ';' or tabs, where a number may have a decimal comma, else ',', else blanks."""
    for separator in ";\t":
        if separator in line:
            return [cell.strip().replace(",", ".") for cell in line.split(separator)]
    return [cell.strip() for cell in line.split(",")] if "," in line else line.split()


def to_number(cell):
    """The cell as a finite number, None if it is none."""
    try:
        number = float(cell)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def read_flow_curve(path, columns, rate_factor, stress_factor, limits):
    """The points of a file. @param columns numbers of the two columns, from 1. @param limits of the strain rates in 1/s
    that count. @throws DataError with file and line."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            lines = file.read().splitlines()
    except UnicodeDecodeError:
        raise DataError(f"{path}: no text in UTF-8. Allowed: a text file with numbers (.csv)") from None
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}. Allowed: a text file with numbers (.csv)") from None
    points, may_be_head = [], True
    for number, line in enumerate(lines, start=1):
        text = line.split("#", 1)[0].strip()
        if not text:
            continue
        cells = split_line(text)
        found = [to_number(cells[column - 1]) if column <= len(cells) else None for column in columns]
        is_head = may_be_head and all(to_number(cell) is None for cell in cells)
        may_be_head = False
        if is_head:
            continue
        if None in found:
            raise DataError(f"{path}:{number}: found '{text[:60]}'. Allowed: numbers in the columns {columns[0]} and "
                            f"{columns[1]}, separated by ',', ';', tabs or blanks; '#' begins a comment")
        if found[0] <= 0. or found[1] < 0.:
            raise DataError(f"{path}:{number}: found '{text[:60]}'. Allowed: a strain rate above zero and a stress that "
                            "is not negative")
        points.append((found[0] * rate_factor, found[1] * stress_factor))
    points = sorted(point for point in points if limits[0] <= point[0] <= limits[1])
    if len({rate for rate, _ in points}) < 4:
        raise DataError(f"{path}: {len(points)} points that count. Allowed: at least four strain rates")
    return FlowCurve(*(np.array(values) for values in zip(*points)))
