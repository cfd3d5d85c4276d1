"""STL files as text and as bytes."""

import struct
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.set_files import CUBE, CUBE_FACES, CUBE_STL, written


def facet(corners: object, end: str = "\n") -> str:
    inner = end.join(f"   vertex {x:e} {y:e} {z:e}" for x, y, z in np.asarray(corners, float))
    return end.join([" facet normal 0 0 0", "  outer loop", inner, "  endloop", " endfacet", ""])


def solid(name: str, faces: object = CUBE_FACES, end: str = "\n") -> str:
    return (
        f"solid {name}{end}" + "".join(facet(CUBE[face], end) for face in np.asarray(faces)) + f"endsolid {name}{end}"
    )


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r", " "])
def test_text_with_any_line_ends(tmp_path: Path, end: str) -> None:
    assert len(read_set(written(tmp_path / "a.stl", solid("cube", end=end))).mesh.triangles) == 12


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_text_with_a_mark_of_its_letters(tmp_path: Path, encoding: str) -> None:
    assert len(read_set(written(tmp_path / "a.stl", solid("cube").encode(encoding))).mesh.triangles) == 12


def test_several_solids_in_capitals_without_names(tmp_path: Path) -> None:
    text = solid("", CUBE_FACES[:5]) + solid("b c", CUBE_FACES[5:])
    assert len(read_set(written(tmp_path / "a.stl", "\n " + text.upper())).mesh.triangles) == 12


@pytest.mark.parametrize("head", [b"solid cube", b"solid facet normal", b"COLOR=", b""])
def test_bytes_whatever_their_head_begins_with(tmp_path: Path, head: bytes) -> None:
    assert len(read_set(written(tmp_path / "a.stl", head.ljust(80) + CUBE_STL[80:])).mesh.triangles) == 12
    longer = read_set(written(tmp_path / "b.stl", head.ljust(80, b"\0") + CUBE_STL[80:] + b"tail"))
    assert [str(note) for note in longer.notes] == ["4 bytes behind its last triangle are not used"]


def test_triangles_that_are_no_numbers_are_left_out_and_said(tmp_path: Path) -> None:
    bad = struct.pack("<12fH", 0, 0, 0, np.nan, 0, 0, 1, 0, 0, 0, np.inf, 0, 0)
    data = CUBE_STL[:80] + struct.pack("<I", 14) + bad + CUBE_STL[84:] + bad
    found = read_set(written(tmp_path / "a.stl", data))
    assert len(found.mesh.triangles) == 12
    assert [str(note) for note in found.notes] == ["2 of its triangles have a corner that is not a number"]
    text = solid("a").replace("endsolid a", facet([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]]) + "endsolid a")
    assert read_set(written(tmp_path / "b.stl", text)).notes


def test_facets_that_are_no_triangles_are_said(tmp_path: Path) -> None:
    found = read_set(written(tmp_path / "a.stl", solid("a") + facet([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])))
    assert len(found.mesh.triangles) == 12
    assert [str(note) for note in found.notes] == ["1 of its facets are no triangles and are not used"]


def test_text_that_ends_between_two_triangles_is_said(tmp_path: Path) -> None:
    found = read_set(written(tmp_path / "a.stl", solid("a").partition("endsolid")[0]))
    assert [str(note) for note in found.notes] == ["it ends within a solid: something may be missing"]


@pytest.mark.parametrize(
    ("data", "said"),
    [(solid("a").replace("vertex 0.0", "vertex 0,0", 1).encode(), "line 4 has a comma in a number"),
     (solid("a").replace("vertex 0.0", "vertex x0.0", 1).encode(), "line 4 cannot be understood"),
     (solid("a").encode()[:160], "cut off"),
     (CUBE_STL[:-1], "cut off"),
     (b"solid nothing\nendsolid nothing\n", "there are no triangles in it"),
     (b"no set", "damaged")],
)  # fmt: skip
def test_what_is_broken_is_one_sentence(tmp_path: Path, data: bytes, said: str) -> None:
    with pytest.raises(InputProblem, match=said):
        read_set(written(tmp_path / "a.stl", data))
