"""PLY files as text and as bytes of both orders, with lists of any numbers and elements between."""

import struct
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.set_files import CUBE, CUBE_FACES, written

FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
CODES = {"uchar": "B", "char": "b", "ushort": "H", "int": "i", "uint32": "I", "float": "f", "double": "d", "int8": "b"}
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]

Row = list[tuple[str, object]]
Part = tuple[str, list[str], list[Row]]
"""Numbers with their kinds; a list is told by the kinds of its length and its numbers."""


def ply(order: str, elements: list[Part], end: str = "\n") -> bytes:
    """Return a file of elements: name, properties as they stand in a head, rows."""
    head = ["ply", f"format {order} 1.0", "comment made by hand"]
    for name, properties, rows in elements:
        head += [f"element {name} {len(rows)}", *(f"property {each}" for each in properties)]
    made = end.join([*head, "end_header", ""]).encode()
    for row in (row for _, _, rows in elements for row in rows):
        flat: list[tuple[str, object]] = []
        for kind, value in row:
            if isinstance(value, list):
                of_length, of_number = kind.split()
                flat += [(of_length, len(value)), *((of_number, each) for each in value)]
            else:
                flat.append((kind, value))
        if FORMATS[order]:
            made += b"".join(struct.pack(FORMATS[order] + CODES[kind], value) for kind, value in flat)
        else:
            made += (" ".join(str(value) for _, value in flat) + end).encode()
    return made


def cube(kind: str = "float", lists: str = "uchar int", faces: list[list[int]] = QUADS) -> list[Part]:
    points: list[Row] = [[(kind, float(x)), (kind, float(y)), (kind, float(z))] for x, y, z in CUBE]
    rows: list[Row] = [[(lists, face)] for face in faces]
    return [("vertex", [f"{kind} {axis}" for axis in "xyz"], points), ("face", [f"list {lists} vertex_indices"], rows)]


@pytest.mark.parametrize("order", FORMATS)
@pytest.mark.parametrize("kind", ["float", "double", "int"])
@pytest.mark.parametrize("lists", ["uchar int", "uint32 ushort", "int8 uint32", "ushort uchar"])
def test_any_order_and_any_numbers(tmp_path: Path, order: str, kind: str, lists: str) -> None:
    parts = cube(kind, lists)
    if kind == "int":
        parts[0] = (
            *parts[0][:2],
            [[(each, int(str(value).partition(".")[0])) for each, value in row] for row in parts[0][2]],
        )
    mesh = read_set(written(tmp_path / "a.ply", ply(order, parts))).mesh
    assert (len(mesh.vertices), len(mesh.triangles), len(mesh.lines)) == (8, 12, 12)


@pytest.mark.parametrize("order", FORMATS)
def test_faces_of_many_lengths_beside_other_properties_and_elements(tmp_path: Path, order: str) -> None:
    points: list[Row] = [[("uchar", 7), *row, ("float", 0.5)] for row in cube()[0][2]]
    faces: list[list[int]] = [*QUADS[:3], *CUBE_FACES[6:8].tolist(), *QUADS[4:]]
    rows: list[Row] = [[("float", 1.0), ("uchar float", [0.5] * len(face) * 2), ("uchar int", face)] for face in faces]
    elements: list[Part] = [
        ("material", ["uchar red", "list uchar int names"], [[("uchar", 1), ("uchar int", [1, 2])]] * 2),
        ("vertex", ["uchar red", *(f"float {axis}" for axis in "xyz"), "float quality"], points),
        ("face", ["float quality", "list uchar float texcoord", "list uchar int vertex_index"], rows),
        ("edge", ["int vertex1", "int vertex2"], [[("int", 0), ("int", 1)]]),
    ]
    found = read_set(written(tmp_path / "a.ply", ply(order, elements)))
    assert len(found.mesh.triangles) == 12
    assert [str(note) for note in found.notes] == ["its elements material, edge are not used"]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("order", ["ascii", "binary_little_endian"])
def test_line_ends_of_any_system(tmp_path: Path, end: str, order: str) -> None:
    assert len(read_set(written(tmp_path / "a.ply", ply(order, cube(), end))).mesh.triangles) == 12


def test_text_with_a_mark_of_its_letters(tmp_path: Path) -> None:
    for encoding in ("utf-8-sig", "utf-16"):
        text = ply("ascii", cube()).decode()
        assert len(read_set(written(tmp_path / "a.ply", text.encode(encoding))).mesh.triangles) == 12


@pytest.mark.parametrize("order", FORMATS)
def test_strips_of_triangles_end_at_minus_one(tmp_path: Path, order: str) -> None:
    strips: list[Row] = [[("int int", [0, 1, 2, 3, -1, 4, 6, 5])], [("int int", [-1, 5, 6, 7, -1])]]
    elements: list[Part] = [cube()[0], ("tristrips", ["list int int vertex_indices"], strips)]
    mesh = read_set(written(tmp_path / "a.ply", ply(order, elements))).mesh
    assert len(mesh.triangles) == 4
    normals = [np.cross(b - a, c - a) for a, b, c in mesh.vertices[mesh.triangles]]
    assert sorted(round(float(normal[0])) for normal in normals) == [-1, -1, 1, 1]


def test_a_concave_face_leaves_its_doorway_open(tmp_path: Path) -> None:
    flat = [(-3, 0), (-1, 0), (-1, 3), (1, 3), (1, 0), (3, 0), (3, 4), (-3, 4)]
    points: list[Row] = [[("float", float(x)), ("float", float(y)), ("float", 0.0)] for x, y in flat]
    elements: list[Part] = [
        ("vertex", ["float x", "float y", "float z"], points),
        ("face", ["list uchar int vertex_indices"], [[("uchar int", list(range(8)))]]),
    ]
    mesh = read_set(written(tmp_path / "a.ply", ply("ascii", elements))).mesh
    sides = mesh.vertices[mesh.triangles]
    area = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1).sum() / 2
    assert area == pytest.approx(18)


@pytest.mark.parametrize(
    ("data", "said"),
    [(ply("ascii", cube()).replace(b"\n0.0 0.0 1.0", b"\n0,0 0.0 1.0"), "line 12 has a comma in a number"),
     (ply("ascii", cube()).replace(b"\n0.0 0.0 1.0", b"\n0.0 x 1.0"), "line 12 cannot be understood"),
     (ply("ascii", cube())[:-5], "damaged"),
     (ply("binary_big_endian", cube())[:-1], "damaged"),
     (ply("binary_little_endian", cube(faces=[[0, 1, 8]])), "a triangle names a missing corner"),
     (ply("binary_little_endian", cube(faces=[[0, 1, -1]])), "a triangle names a missing corner"),
     (ply("ascii", cube(faces=[])), "there are no triangles in it"),
     (ply("ascii", cube())[3:], "damaged"),
     (ply("ascii", [("face", ["list uchar int vertex_indices"], [])]).replace(b"face 0", b"face -1"), "damaged"),
     (ply("ascii", [("empty", [], [])]).replace(b"empty 0", b"empty 99999999999"), "there are no triangles"),
     (ply("ascii", cube()).replace(b"float x", b"float16 x"), "damaged")],
)  # fmt: skip
def test_what_is_broken_is_one_sentence(tmp_path: Path, data: bytes, said: str) -> None:
    with pytest.raises(InputProblem, match=said):
        read_set(written(tmp_path / "a.ply", data))
