"""OBJ files as programs write them: whatever their letters, line ends and countings; what is not used is said."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.set_files import CUBE_OBJ, written

QUAD = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"


def sizes(path: Path) -> tuple[int, int, int]:
    mesh = read_set(path).mesh
    return len(mesh.vertices), len(mesh.triangles), len(mesh.lines)


@pytest.mark.parametrize("face", ["1 2 3 4", "1/1 2/2 3/3 4/4", "-4 -3 -2 -1", "1//1 2//1 3//1 4//1", "-4 2 -2 4",
                                  "1/1/1 2/2/1 3/3/1 4/4/1", "1 2 3 4 # wall-a", "1\t2\t3\t4", "1 2 \\\n3 4",
                                  "1 2 \\  \r\n 3 4", "1 2 3 \\\n4\\\n/7"])  # fmt: skip
def test_a_face_of_four_corners_is_two_triangles(tmp_path: Path, face: str) -> None:
    assert sizes(written(tmp_path / "a.obj", QUAD.replace("1 2 3 4", face))) == (4, 2, 4)


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "ascii"]
)  # fmt: skip
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_letters_and_line_ends_of_any_system(tmp_path: Path, encoding: str, end: str) -> None:
    text = ("# a wall\n" + QUAD).replace("\n", end)
    assert sizes(written(tmp_path / "a.obj", text.encode(encoding))) == (4, 2, 4)


def test_big_endian_letters_with_their_mark(tmp_path: Path) -> None:
    assert sizes(written(tmp_path / "a.obj", b"\xfe\xff" + QUAD.encode("utf-16-be"))) == (4, 2, 4)


@pytest.mark.parametrize("point", ["1 0 0 1", "1 0 0 0.5 0.5 0.5", "1e0 0.0E+0 -0", "+1. .0 0 1 0 0 1", "  1   0\t0  "])
def test_points_may_have_weights_colours_and_exponents(tmp_path: Path, point: str) -> None:
    mesh = read_set(written(tmp_path / "a.obj", QUAD.replace("v 1 0 0", f"v {point}"))).mesh
    assert mesh.corners[1] == pytest.approx([1, 1, 0])
    assert len(mesh.vertices) == 4


def test_groups_materials_and_comments_cost_nothing(tmp_path: Path) -> None:
    lines = CUBE_OBJ.splitlines()
    scattered = "\n".join(f"g g{number}\nusemtl m#{number}\n{line}" for number, line in enumerate(lines * 3))
    head = "# C:\\sets\\\nmtllib ../x.mtl\no a\ns 1\n"
    plain = read_set(written(tmp_path / "plain.obj", CUBE_OBJ)).mesh
    found = read_set(written(tmp_path / "a.obj", head + scattered))
    assert np.array_equal(found.mesh.vertices, plain.vertices)
    assert not found.notes


def test_points_may_stand_behind_the_faces_that_name_them(tmp_path: Path) -> None:
    assert sizes(written(tmp_path / "a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")) == (3, 1, 3)


def test_corners_may_be_counted_back_from_where_they_are_named(tmp_path: Path) -> None:
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3/-1 -2/-1 -1/-1\n"
    mesh = read_set(written(tmp_path / "a.obj", text)).mesh
    assert len(mesh.triangles) == 2
    assert mesh.corners[1] == pytest.approx([6, 1, 0])


@pytest.mark.parametrize(
    ("line", "said"),
    [("l 1 2", "its lines are not used"), ("p 1", "its single points are not used"),
     ("curv 0 1 1 2", "its curves are not used"), ("surf 0 1 0 1 1 2 3 4", "its curved surfaces are not used"),
     ("call other.obj", "other files that it calls are not read"),
     ("f 1 2", "1 of its faces have fewer than three corners and are not used")],
)  # fmt: skip
def test_what_is_not_used_is_said_once(tmp_path: Path, line: str, said: str) -> None:
    found = read_set(written(tmp_path / "a.obj", f"{QUAD}{line}\n"))
    assert list(map(str, found.notes)) == [said]
    with pytest.raises(InputProblem, match="there are no triangles in it: "):
        read_set(written(tmp_path / "b.obj", QUAD.replace("f 1 2 3 4", line)))


@pytest.mark.parametrize(
    ("text", "said"),
    [("v 0,5 0 0\n", r"line 1 has a comma in a number: 'v 0,5 0 0'"),
     ("\n\nv 0 0 0\nv 1 0\n", r"line 4 cannot be understood: 'v 1 0'"),
     ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -x 2\n", r"line 4 cannot be understood: 'f -1 -x 2'"),
     ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", r"line 4 cannot be understood: 'f 0 1 2'"),
     ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", r"line 4 cannot"),
     ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", r"line 4 cannot")],
)  # fmt: skip
def test_a_line_that_makes_no_sense_is_named(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(InputProblem, match=said):
        read_set(written(tmp_path / "a.obj", text))
