"""OBJ files: only points and faces are looked at, however they are counted."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.mesh_cache import read_set
from kagezou.io.sets.obj import bare_obj
from tests.io.sets.set_files import CUBE_OBJ, written


def test_all_but_points_and_faces_is_left_out() -> None:
    text = b"# a set\nmtllib ../x.mtl\no a\n v 0 0 0\nvt 0 0\nvn 0 0 1\nusemtl x\n  f 1/2/3 2//3 3/1\ns 1\ng b\nl 1 2\n"
    assert bare_obj(text) == b"v 0 0 0\nf 1 2 3\n"


def test_corners_may_be_counted_back_from_where_they_are_named() -> None:
    text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3/-1 -2/-1 -1\\\n/-1\n"
    assert bare_obj(text).splitlines()[-1] == b"f 4 5 6"


@pytest.mark.parametrize("face", ["1 2 3 4", "1/1 2/2 3/3 4/4", "-4 -3 -2 -1", "1//1 2//1 3//1 4//1"])
def test_a_face_of_four_corners_is_two_triangles(tmp_path: Path, face: str) -> None:
    mesh = read_set(written(tmp_path / "a.obj", f"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf {face}\n")).mesh
    assert (len(mesh.vertices), len(mesh.triangles), len(mesh.lines)) == (4, 2, 4)


def test_many_groups_and_materials_cost_nothing(tmp_path: Path) -> None:
    lines = CUBE_OBJ.splitlines()
    scattered = "\n".join(f"g g{number}\nusemtl m{number}\n{line}" for number, line in enumerate(lines * 3))
    plain = read_set(written(tmp_path / "plain.obj", CUBE_OBJ)).mesh
    assert np.array_equal(read_set(written(tmp_path / "a.obj", scattered)).mesh.vertices, plain.vertices)


def test_corners_that_are_no_numbers_are_damage(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match="cannot be read as a set"):
        read_set(written(tmp_path / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -x 2\n"))
