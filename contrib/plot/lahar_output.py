# SPDX-License-Identifier: GPL-3.0-or-later
"""Read what Lahar writes: the statistics file, the list of snapshots, the snapshots and the walls of a run.

Needs numpy only. Wrong input raises OutputError with a message of one line.
"""

import base64
import bisect
import pathlib
import sys
import xml.etree.ElementTree
import zlib
from dataclasses import dataclass, field

import numpy as np

VTK_TRIANGLE, VTK_TETRAHEDRON = 5, 10

NUMPY_TYPES = {
    "Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4",
    "Int64": "i8", "UInt64": "u8", "Float32": "f4", "Float64": "f8",
}


class OutputError(Exception):
    """An output file is missing or does not say what is asked for."""


@dataclass
class Mesh:
    """A snapshot of triangles, in space of tetrahedra. Neighbouring cells do not share points: deal.II writes every cell's
    own corners."""

    points: np.ndarray  # (n points, 2 or 3), in m
    cells: np.ndarray   # (n cells, 3 or 4), indices of points
    point_data: dict = field(default_factory=dict)
    cell_data: dict = field(default_factory=dict)

    @property
    def triangles(self):
        return self.cells

    def at_points(self, name):
        """The field @p name by point."""
        if name not in self.point_data:
            raise OutputError(f"no point field '{name}'; there are: {self.field_names()}")
        return self.point_data[name]

    def at_cells(self, name):
        """The field @p name by cell; the mean of a cell's corners where it is stored by point."""
        if name in self.cell_data:
            return self.cell_data[name]
        return self.at_points(name)[self.cells].mean(axis=1)

    def has_field(self, name):
        return name in self.point_data or name in self.cell_data

    def field_names(self):
        return ", ".join(sorted({*self.point_data, *self.cell_data})) or "none"


@dataclass
class Wall:
    """A rigid wall: a polyline whose last point is its first one if it is a closed body."""

    corners: np.ndarray

    @property
    def is_closed(self):
        return len(self.corners) > 2 and np.array_equal(self.corners[0], self.corners[-1])


def run_script(main):
    """Call main(); turn wrong input into one line on stderr and exit status 2."""
    try:
        main()
    except (OutputError, OSError) as error:
        print(f"{pathlib.Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(2)


# ---------------------------------------------------------------------------------------------------- statistics


def read_statistics(path):
    """The columns of a statistics file (deal.II's TableHandler with separate column description), by name.

    A column of numbers is an array of floats, any other one an array of strings.
    """
    names, rows = [], []
    for line in read_text(path).splitlines(keepends=True):
        if not line.endswith("\n"):
            break  # a running program is writing it
        if line.startswith("#"):
            names.append(line.split(":", 1)[-1].strip())
        elif line.strip():
            rows.append(line.split())
    if not names or any(len(row) != len(names) for row in rows):
        raise OutputError(f"{path}: not a statistics file: rows and column names differ in number")
    return {name: to_array(row[i] for row in rows) for i, name in enumerate(names)}


def column(statistics, name, path):
    """The column @p name of the statistics read from @p path, which must hold numbers."""
    if name not in statistics:
        raise OutputError(f"{path}: no column '{name}'; there are: {', '.join(statistics)}")
    if statistics[name].dtype.kind != "f":
        raise OutputError(f"{path}: column '{name}' does not hold numbers")
    return statistics[name]


def to_array(words):
    words = list(words)
    try:
        return np.array(words, dtype=float)
    except ValueError:
        return np.array(words)


# ----------------------------------------------------------------------------------------------------- snapshots


def read_pvd(path, part=0):
    """The snapshots of a .pvd file, a list of (time in s, path) in the order of time: part 0 is the fluid, 1 the
    solids, 2 the walls."""
    entries = parse_xml(path).iter("DataSet")
    folder = pathlib.Path(path).parent
    try:
        return sorted((float(entry.get("timestep")), folder / entry.get("file")) for entry in entries
                      if int(entry.get("part", 0)) == part)
    except (TypeError, ValueError):
        raise OutputError(f"{path}: a DataSet without time or file name") from None


def nearest_snapshots(snapshots, times):
    """Of the snapshots (time, path) those nearest to @p times, each once, in the order of time."""
    all_times = [time for time, _ in snapshots]
    chosen = set()
    for time in times:
        right = bisect.bisect_left(all_times, time)
        candidates = [i for i in (right - 1, right) if 0 <= i < len(all_times)]
        chosen.add(min(candidates, key=lambda i: abs(all_times[i] - time)))
    return [snapshots[i] for i in sorted(chosen)]


def read_vtu(path, dimension=2):
    """The mesh in a .vtu file, or in the pieces of a .pvtu file: triangles in the plane; in space tetrahedra or triangles."""
    root = parse_xml(path)
    try:
        if root.get("type") == "PUnstructuredGrid":
            folder = pathlib.Path(path).parent
            return join([read_vtu(folder / piece.get("Source"), dimension) for piece in root.iter("Piece")])
        return join([read_piece(piece, DataReader(root), dimension) for piece in root.iter("Piece")])
    except (ValueError, KeyError, AttributeError, TypeError, zlib.error) as error:
        raise OutputError(f"{path}: cannot read this VTU file ({error})") from None


def read_piece(piece, reader, dimension):
    """The mesh in one <Piece> of a VTU file."""
    n_points = int(piece.get("NumberOfPoints"))
    n_cells = int(piece.get("NumberOfCells"))
    entries = {entry.get("Name"): entry for entry in piece.find("Cells")}
    types = np.unique(reader.read(entries["types"]))
    if np.any(types != VTK_TRIANGLE) and (dimension == 2 or np.any(types != VTK_TETRAHEDRON)):
        raise ValueError("only triangles can be drawn" if dimension == 2 else "only tetrahedra or triangles can be drawn")
    cells = reader.read(entries["connectivity"]).reshape(n_cells, 4 if VTK_TETRAHEDRON in types else 3)
    if n_cells > 0 and not 0 <= cells.min() <= cells.max() < n_points:
        raise ValueError("a cell has a point that is not there")
    return Mesh(
        points=reader.read(piece.find("Points/DataArray")).reshape(n_points, 3)[:, :dimension].astype(float),
        cells=cells,
        point_data=read_fields(piece.find("PointData"), n_points, reader),
        cell_data=read_fields(piece.find("CellData"), n_cells, reader),
    )


def read_fields(section, n_values, reader):
    """The data arrays of a section by name, of shape (n_values,) or (n_values, components)."""
    fields = {}
    for entry in section if section is not None else ():
        n_components = int(entry.get("NumberOfComponents", 1))
        shape = (n_values,) if n_components == 1 else (n_values, n_components)
        fields[entry.get("Name")] = reader.read(entry).reshape(shape).astype(float)
    return fields


def join(meshes):
    """One mesh from the pieces of several ranks."""
    if not meshes:
        raise ValueError("no piece")
    first_points = np.cumsum([0] + [len(mesh.points) for mesh in meshes])
    return Mesh(
        points=np.concatenate([mesh.points for mesh in meshes]),
        cells=np.concatenate([mesh.cells + first for mesh, first in zip(meshes, first_points)]),
        point_data=join_fields([mesh.point_data for mesh in meshes]),
        cell_data=join_fields([mesh.cell_data for mesh in meshes]),
    )


def join_fields(pieces):
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


class DataReader:
    """Decodes the data arrays of one VTK XML file.

    Binary data are base64. Without a compressor they are [number of bytes] and the bytes; with zlib they are a header
    [number of blocks, size of a block, size of the last one, compressed sizes ...] and, encoded apart, the blocks.
    """

    def __init__(self, root):
        self.byte_order = ">" if root.get("byte_order") == "BigEndian" else "<"
        self.header_type = np.dtype(self.byte_order + NUMPY_TYPES[root.get("header_type", "UInt32")])
        self.compressor = root.get("compressor")
        if self.compressor not in (None, "vtkZLibDataCompressor"):
            raise ValueError(f"compressor {self.compressor} is not supported")

    def read(self, entry):
        """The flat array in the XML element @p entry."""
        data_type = np.dtype(self.byte_order + NUMPY_TYPES[entry.get("type")])
        text = "".join((entry.text or "").split()) if entry.get("format") == "binary" else (entry.text or "")
        if entry.get("format") == "ascii":
            return np.array(text.split(), dtype=data_type)
        if entry.get("format") != "binary":
            raise ValueError(f"data format {entry.get('format')} is not supported")
        return np.frombuffer(self.decompress(text) if self.compressor else self.decode_plain(text), dtype=data_type)

    def decode_plain(self, text):
        data = base64.b64decode(text)
        n_bytes = int(np.frombuffer(data, self.header_type, 1)[0])
        return data[self.header_type.itemsize:self.header_type.itemsize + n_bytes]

    def decompress(self, text):
        n_blocks = int(self.decode_header(text, 1)[0])
        sizes = self.decode_header(text, 3 + n_blocks)[3:]
        data = base64.b64decode(text[self.n_characters(3 + n_blocks):])
        ends = np.cumsum(sizes, dtype=int)
        return b"".join(zlib.decompress(data[end - int(size):end]) for end, size in zip(ends, sizes))

    def decode_header(self, text, n_entries):
        return np.frombuffer(base64.b64decode(text[:self.n_characters(n_entries)]), self.header_type, n_entries)

    def n_characters(self, n_entries):
        """Base64 turns every three bytes begun into four characters."""
        return 4 * -(-n_entries * self.header_type.itemsize // 3)


# --------------------------------------------------------------------------------------------------------- walls


def read_walls(path):
    """The walls in the plane as polylines, from a file walls.vtu or walls-NNNNN.vtu; none if there is no such file."""
    lines = []
    for start, end in read_wall_facets(path, 2):
        if lines and np.array_equal(lines[-1][-1], start):
            lines[-1].append(end)
        else:
            lines.append([start, end])
    return [Wall(np.array(line)) for line in lines]


def read_wall_facets(path, dimension):
    """The corners of the walls' facets, (n, dimension, dimension): segments in the plane, triangles in space; none if
    there is no such file."""
    if not pathlib.Path(path).is_file():
        return np.zeros((0, dimension, dimension))
    root = parse_xml(path)
    try:
        piece, reader = next(root.iter("Piece")), DataReader(root)
        points = reader.read(piece.find("Points/DataArray")).reshape(-1, 3)[:, :dimension].astype(float)
        cells = {entry.get("Name"): entry for entry in piece.find("Cells")}
        return points[reader.read(cells["connectivity"])].reshape(-1, dimension, dimension)
    except (StopIteration, ValueError, KeyError, AttributeError, TypeError, IndexError, zlib.error) as error:
        raise OutputError(f"{path}: cannot read these walls ({error})") from None


def parse_walls(text):
    """The walls in a text 'x, y : x, y ... ; x, y : ...'."""
    try:
        lines = [[[float(number) for number in point.split(",")] for point in line.split(":")]
                 for line in text.split(";") if line.strip()]
        walls = [Wall(np.array(line).reshape(len(line), 2)) for line in lines]
    except ValueError:
        raise OutputError(f"walls must read 'x, y : x, y ... ; x, y : ...', not '{text}'") from None
    return walls


def read_parameter(path, section, name):
    """The value of an entry of a .prm file as deal.II's ParameterHandler prints it; empty where it is not set."""
    value, current = "", []
    for line in read_text(path).splitlines():
        words = line.split("#", 1)[0].strip()
        if words.startswith("subsection "):
            current.append(words.split(None, 1)[1])
        elif words == "end":
            del current[-1:]
        elif words.startswith("set ") and "=" in words and current == section:
            key, text = words[4:].split("=", 1)
            value = text.strip() if key.strip() == name else value
    return value


# --------------------------------------------------------------------------------------------------------- files


def read_text(path):
    try:
        return pathlib.Path(path).read_text()
    except UnicodeDecodeError:
        raise OutputError(f"{path}: not a text file") from None
    except OSError as error:
        raise OutputError(f"{path}: {error.strerror}") from None


def parse_xml(path):
    try:
        return xml.etree.ElementTree.fromstring(read_text(path))
    except xml.etree.ElementTree.ParseError as error:
        raise OutputError(f"{path}: not a complete XML file ({error})") from None
