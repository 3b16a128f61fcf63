# SPDX-License-Identifier: GPL-3.0-or-later
"""What the parameters of a run say: entries, what differs from the defaults, the parts of the case and their places."""

import re
from dataclasses import dataclass

import numpy as np

from lahar_output import OutputError, read_text

# Shapes whose places are lists of points in the entry of this name.
POINTS_OF_SHAPE = {"box": "Corners", "polygon": "Corners", "convex": "Corners", "polyline": "Points"}
PLACES = ("Output directory",)  # where a run is kept is no property of it


@dataclass
class Entry:
    section: tuple  # names of the subsections around it
    name: str
    value: str
    default: str
    documentation: str

    @property
    def path(self):
        return "/".join((*self.section, self.name))

    @property
    def is_default(self):
        return self.value == self.default


class CaseParameters:
    """All entries of a run, in the order of its parameters.prm."""

    def __init__(self, path):
        self.path = path
        self.entries = {entry.path: entry for entry in read_entries(path)}
        if "Dimension" not in self.entries:
            raise OutputError(f"{path}: no entry 'Dimension'; allowed: the parameters.prm that a run has written")
        self.dimension = 3 if self.get("Dimension") == "3" else 2
        # What two dimensions stand for: of a plane all is per metre of depth.
        self.geometry = ("in space" if self.dimension == 3 else "rotational symmetry"
                         if self.get("Geometry") == "rotational symmetry" else "plane strain")

    def get(self, path, otherwise=""):
        return self.entries[path].value if path in self.entries else otherwise

    def number(self, path, otherwise=float("nan")):
        try:
            return float(self.get(path))
        except ValueError:
            return otherwise

    def changed(self):
        """The entries that differ from the defaults."""
        return [entry for entry in self.entries.values() if not entry.is_default and entry.name not in PLACES]

    def names(self, kind):
        """The names of the parts of a kind: Fluids, Boundaries, Solids."""
        return [name.strip() for name in self.get(kind).split(",") if name.strip()]

    def gravity(self):
        return parse_point(self.get("Gravity"), self.dimension)

    def point_lists(self, kind, name):
        """The bodies or walls of a part as arrays of points; none where the shape is a mesh file or a plugin's."""
        shape = self.get(f"{kind}/{name}/Shape")
        if shape in POINTS_OF_SHAPE:
            return parse_point_lists(self.get(f"{kind}/{name}/{shape}/{POINTS_OF_SHAPE[shape]}"), self.dimension)
        if shape == "cylinder":
            return parse_point_lists(self.get(f"{kind}/{name}/cylinder/Ends"), self.dimension)
        base = parse_point(self.get(f"{kind}/{name}/{shape}/Base"), self.dimension)
        height = self.number(f"{kind}/{name}/{shape}/Height")
        if base is not None and self.dimension == 3 and np.isfinite(height):
            return [np.array([base, base + [0., 0., height]])]
        return []

    def law(self, kind, name):
        return self.get(f"{kind}/{name}/Law")

    def law_entries(self, kind, name):
        """The entries of a part's law: name, value and unit, as far as its explanation says it."""
        section = (kind, name, self.law(kind, name))
        return [(entry.name, entry.value, unit_in(entry.documentation)) for entry in self.entries.values()
                if entry.section == section]

    def named_points(self, path):
        """Points such as those of gauges, 'foot: 0.286, 0.01 ; ...', by name."""
        parts = [text.partition(":") for text in self.get(path).split(";")]
        points = {name.strip(): parse_point(numbers, self.dimension) for name, _, numbers in parts}
        return {name: point for name, point in points.items() if point is not None}


def unit_in(documentation):
    """The unit that an explanation such as 'Density ρ in kg/m³, above zero.' names; empty without one."""
    found = re.search(r" in ((?:kg|m|s|N|Pa|J|W|K|1/s)(?:[ /·](?:kg|m|s|N|Pa|J|K))*[²³]?)[,.:;]", documentation)
    return found[1] if found else ""


def read_entries(path):
    """The entries of a .prm file as deal.II's ParameterHandler prints it, with '# default: ...' behind what differs."""
    entries, section, documentation = [], [], []
    for line in read_text(path).splitlines():
        words = line.strip()
        if words.startswith("#"):
            documentation.append(words.lstrip("# "))
        elif words.startswith("subsection "):
            section.append(words.split(None, 1)[1])
            documentation = []
        elif words == "end":
            del section[-1:]
        elif words.startswith("set ") and "=" in words:
            name, text = words[4:].split("=", 1)
            value, mark, default = re.match(r"(.*?)\s*(?:#\s*(default:)?(.*))?$", text.strip()).groups()
            entries.append(Entry(tuple(section), name.strip(), value, default.strip() if mark else value,
                                 " ".join(documentation)))
            documentation = []
        elif not words:
            documentation = []
    return entries


def parse_point(text, dimension):
    """The point 'x, y' or 'x, y, z'; None if it is none."""
    try:
        point = np.array([float(word) for word in text.split(",")])
    except ValueError:
        return None
    return point if len(point) == dimension and np.isfinite(point).all() else None


def parse_point_lists(text, dimension):
    """The lists of points in 'x, y : x, y ... ; x, y : ...'; none if it does not read so."""
    lists = [[parse_point(point, dimension) for point in part.split(":")] for part in text.split(";") if part.strip()]
    if any(point is None for points in lists for point in points):
        return []
    return [np.array(points) for points in lists]


def differing(cases):
    """The paths of entries that all cases have and whose values differ between them."""
    paths = {path: None for case in cases for path in case.entries}
    return [path for path in paths
            if path.rsplit("/", 1)[-1] not in PLACES and all(path in case.entries for case in cases)
            and len({case.get(path) for case in cases}) > 1]
