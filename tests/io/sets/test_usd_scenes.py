"""What a USD stage shows: purposes, holes, solids, instances, skins, variants; what of it is not used is said."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets import usd_child
from kagezou.io.sets.mesh_cache import read_set
from kagezou.io.sets.triangles import Triangles
from tests.io.sets.usd_files import SKIN, instancer, lefts, mesh, read, said, stage

pytest.importorskip("pxr", reason="the package usd-core is not installed")


def volume(found: object) -> float:
    mesh = found.mesh  # type: ignore[attr-defined]
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]] for corner in range(3))
    return abs(float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6)


@pytest.mark.parametrize(
    ("purpose", "places", "notes"),
    [("render", [0, 9], []), ("default", [0, 9], []), ("guide", [0], ["1 of its shapes are guides and are not used"]),
     ("proxy", [0], ["1 of its shapes are proxies for others and are not used"])],
)  # fmt: skip
def test_what_is_for_a_finished_picture_is_drawn(
    tmp_path: Path, purpose: str, places: list[float], notes: list[str]
) -> None:
    token = f'uniform token purpose = "{purpose}"'
    found = read(tmp_path, mesh("a") + mesh("b", token, (9, 0, 0)))
    assert (lefts(found), said(found)) == (places, notes)
    inherited = f'def Xform "x" {{\n{token}\n{mesh("b", "", (9, 0, 0))}}}'
    assert lefts(read(tmp_path, mesh("a") + inherited)) == places
    cube = f'def Cube "c" {{\n{token}\ndouble size = 18\n\n}}'
    assert lefts(read(tmp_path, mesh("a") + cube)) == ([-9, 0, 9] if len(places) == 2 else [0])
    if len(places) == 1:
        with pytest.raises(InputProblem, match="there are no triangles in it: 1 of its shapes are"):
            read(tmp_path, mesh("b", token))


@pytest.mark.parametrize("holes", ["[1]", "[1, 1]", "[1, 7, -2]"])
def test_holes_stay_open(tmp_path: Path, holes: str) -> None:
    two = """def Mesh "m" {
        point3f[] points = [(0,0,0), (1,0,0), (1,1,0), (0,1,0), (2,0,0), (2,1,0)]
        int[] faceVertexCounts = [4, 4]
        int[] faceVertexIndices = [0, 1, 2, 3, 1, 4, 5, 2]
        int[] holeIndices = %s
    }"""
    assert lefts(read(tmp_path, two % holes)) == [0]
    assert lefts(read(tmp_path, two % "[]")) == [0, 1]


def test_a_concave_face_leaves_its_doorway_open(tmp_path: Path) -> None:
    found = read(tmp_path, """def Mesh "m" {
        point3f[] points = [(-3,0,0), (-1,0,0), (-1,3,0), (1,3,0), (1,0,0), (3,0,0), (3,4,0), (-3,4,0)]
        int[] faceVertexCounts = [8]
        int[] faceVertexIndices = [0, 1, 2, 3, 4, 5, 6, 7]
    }""")  # fmt: skip
    sides = found.mesh.vertices[found.mesh.triangles]
    areas = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1) / 2
    assert areas.sum() == pytest.approx(18)


@pytest.mark.parametrize(
    "token", ['token visibility = "invisible"', 'token visibility.timeSamples = {1: "invisible", 9: "inherited"}']
)
def test_what_is_invisible_takes_along_what_hangs_on_it(tmp_path: Path, token: str) -> None:
    body = mesh("a") + f'def Xform "x" {{\n{token}\n{mesh("b", "", (9, 0, 0))}}}'
    assert lefts(read(tmp_path, body, "startTimeCode = 1\nendTimeCode = 9")) == [0]
    assert lefts(read(tmp_path, body.replace('"invisible"', '"inherited"', 1))) == [0, 9]


SOLIDS = {
    "Cube": ("double size = 3", (3, 3, 3), 27.0),
    "Sphere": ("double radius = 2", (4, 4, 4), 4 / 3 * pi * 8),
    "Cylinder": ("double radius = 2\ndouble height = 3", (4, 4, 3), pi * 12),
    "Cone": ("double radius = 2\ndouble height = 3", (4, 4, 3), pi * 4),
    "Capsule": ("double radius = 2\ndouble height = 3", (4, 4, 7), pi * 12 + 4 / 3 * pi * 8),
    "Plane": ("double width = 3\ndouble length = 5", (3, 5, 0), 0.0),
    "Cylinder_1": ("double radiusTop = 2\ndouble radiusBottom = 2\ndouble height = 3", (4, 4, 3), pi * 12),
    "Capsule_1": ("double radiusTop = 2\ndouble radiusBottom = 2\ndouble height = 3", (4, 4, 7),
                  pi * 12 + 4 / 3 * pi * 8),
}  # fmt: skip


@pytest.mark.parametrize("kind", SOLIDS)
@pytest.mark.parametrize("axis", [None, "X", "Y", "Z"])
def test_solids_along_any_axis(tmp_path: Path, kind: str, axis: str | None) -> None:
    values, sizes, held = SOLIDS[kind]
    token = "" if axis is None or kind in ("Cube", "Sphere") else f'uniform token axis = "{axis}"'
    found = read(tmp_path, f'def {kind} "s" {{\n{values}\n{token}\n}}')
    low, high = found.mesh.corners
    along = {"X": (sizes[2], sizes[0], sizes[1]), "Y": (sizes[1], sizes[2], sizes[0])}.get(axis or "Z", sizes)
    if kind == "Plane":
        along = {"X": (0, 5, 3), "Y": (3, 0, 5)}.get(axis or "Z", (3, 5, 0))
    assert high - low == pytest.approx(along if token or not axis else sizes, abs=0.02)
    assert low + high == pytest.approx([0, 0, 0], abs=1e-6)
    assert volume(found) == pytest.approx(held, rel=0.02)
    assert not found.notes


def test_solids_without_values_have_those_of_the_format(tmp_path: Path) -> None:
    low, high = read(tmp_path, 'def Cube "s" {}').mesh.corners
    assert (high - low).tolist() == [2, 2, 2]
    assert len(read(tmp_path, 'def Sphere "s" {}').mesh.triangles) == 48 * 2 * 23


def test_instances_of_points_with_turns_sizes_and_ids(tmp_path: Path) -> None:
    more = """point3f[] positions = [(0,0,0), (10,0,0), (20,0,0), (30,0,0)]
        int[] protoIndices = [0, 1, 0, 0]
        float3[] scales = [(1,1,1), (1,1,1), (2,1,1), (1,1,1)]
        quath[] orientations = [(1,0,0,0), (1,0,0,0), (1,0,0,0), (0,0,0,1)]
        int64[] ids = [5, 6, 7, 8]
        int64[] invisibleIds = [6]"""
    protos = mesh("a") + mesh("b", "", (100, 0, 0))
    found = read(tmp_path, instancer(more, protos, "</i/p/a>, </i/p/b>"))
    # The one that is turned half round begins on the other side; what is invisible and the prototypes are not there.
    assert lefts(found) == [0, 20, 29]
    assert found.mesh.corners[1][0] == pytest.approx(30, abs=1e-3)
    shown = read(tmp_path, instancer(more.replace("[6]", "[]"), protos, "</i/p/a>, </i/p/b>"))
    assert lefts(shown) == [0, 20, 29, 110]
    assert not shown.notes


def test_instances_of_instances_are_placed_and_counted(tmp_path: Path) -> None:
    row = "point3f[] positions = [%s]\nint[] protoIndices = [%s]"
    inner = instancer(row % ("(0,0,0), (2,0,0)", "0, 0"), "", "</i/p/i/p/a>")
    found = read(tmp_path, instancer(row % ("(0,0,0), (100,0,0)", "0, 0"), inner, "</i/p/i>"))
    assert lefts(found) == [0, 2, 100, 102]
    many = row % (", ".join(["(0,0,0)"] * 1000), ", ".join(["0"] * 1000))
    deep = instancer(many, instancer(many, instancer(many, "", "</i/p/i/p/i/p/a>"), "</i/p/i/p/i>"), "</i/p/i>")
    with pytest.raises(InputProblem, match="triangles, more than the 5000000"):
        read(tmp_path, deep)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [(("</i/p/a>", "</i>"), "made of themselves"), (("[0, 0]", "[0, 3]"), "an instancer names"),
     (("(2,0,0)]", "(2,0,0), (3,0,0)]"), "an instancer names|triangles")],
)  # fmt: skip
def test_instances_that_cannot_be(tmp_path: Path, change: tuple[str, str], sentence: str) -> None:
    body = instancer("point3f[] positions = [(0,0,0), (2,0,0)]\nint[] protoIndices = [0, 0]")
    with pytest.raises(InputProblem, match=sentence):
        read(tmp_path, body.replace(*change))


def test_instances_of_prims_are_drawn(tmp_path: Path) -> None:
    body = f'class "proto" {{\n{mesh("m")}}}\n'
    body += "".join(
        f'def Xform "x{at}" (\n instanceable = true\n references = </proto>\n) {{\n'
        f"double3 xformOp:translate = ({at}, 0, 0)\n"
        'uniform token[] xformOpOrder = ["xformOp:translate"]\n}\n'
        for at in (3, 6)
    )
    assert lefts(read(tmp_path, body)) == [3, 6]


def test_what_is_no_surface_is_said_by_its_kind(tmp_path: Path) -> None:
    body = (
        'def BasisCurves "a" {}\ndef BasisCurves "b" {}\ndef Points "p" {}\ndef NurbsPatch "n" {}\ndef Volume "v" {}\n'
    )
    found = read(tmp_path, mesh("m") + body)
    assert said(found) == ["its BasisCurves (×2), NurbsPatch, Points, Volume are not used"] or (
        len(said(found)) == 1 and all(kind in said(found)[0] for kind in ("BasisCurves (×2)", "Points", "Volume"))
    )


def test_variants_are_used_as_they_are_chosen_and_said(tmp_path: Path) -> None:
    body = """def Xform "x" (
        variants = { string door = "open" }
        prepend variantSets = "door"
    ) {
        variantSet "door" = {
            "open" { %s }
            "shut" { %s }
        }
    }"""
    found = read(tmp_path, body % (mesh("a", "", (4, 0, 0)), mesh("b", "", (8, 0, 0))))
    assert lefts(found) == [4]
    assert said(found) == ["of its variants these are used: door=open"]


def test_layers_and_payloads_beside_it_are_read_and_missing_ones_said(tmp_path: Path) -> None:
    stage(tmp_path / "part.usda", f'def Xform "x" {{\n{mesh("m")}}}', 'defaultPrim = "x"')
    body = 'def "a" (\n payload = @./part.usda@\n) {}\ndef "b" (\n references = @./gone/away.usda@\n) {}\n'
    found = read(tmp_path, body)
    assert len(found.mesh.triangles) == 2
    assert said(found) == ["it refers to ./gone/away.usda, which cannot be read"]


def test_animated_shapes_stand_as_on_the_first_frame(tmp_path: Path) -> None:
    way = "double3 xformOp:translate.timeSamples = {1: (1,0,0), 5: (5,0,0), 9: (9,0,0)}\n"
    body = f'def Xform "x" {{\n{way}uniform token[] xformOpOrder = ["xformOp:translate"]\n{mesh("m")}}}'
    found = read(tmp_path, body, "startTimeCode = 5\nendTimeCode = 9")
    assert lefts(found) == [5]
    assert said(found) == ["its shapes are animated: they are used as on its first frame"]
    assert lefts(read(tmp_path, body)) == [1]
    points = "point3f[] points.timeSamples = {1: [(0,0,0), (1,0,0), (1,1,0)], 2: [(5,0,0), (6,0,0), (6,1,0)]}"
    bent = f'def Mesh "m" {{\n{points}\nint[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0,1,2]\n}}'
    assert lefts(read(tmp_path, bent, "startTimeCode = 2\nendTimeCode = 2")) == [5]


def test_units_and_cages_are_said(tmp_path: Path) -> None:
    found = read(tmp_path, mesh("m", 'uniform token subdivisionScheme = "loop"'), "metersPerUnit = 0.01")
    assert said(found) == ["its subdivision surfaces are used as their cages",
                           "its unit is 0.01 m; its size on the canvas does not follow from that"]  # fmt: skip
    assert not read(tmp_path, mesh("m", 'uniform token subdivisionScheme = "none"'), "metersPerUnit = 1").notes


def test_skins_are_posed_as_on_the_first_frame(tmp_path: Path) -> None:
    inner = mesh("m").partition("{")[2].rpartition("}")[0]
    found = read(tmp_path, SKIN % inner, "startTimeCode = 2\nendTimeCode = 3")
    assert lefts(found) == [8]
    assert "its skins are posed as on its first frame" in said(found)
    before = (tmp_path / "a.usda").read_text()
    read_set(tmp_path / "a.usda")
    assert (tmp_path / "a.usda").read_text() == before, "only in memory"


def test_a_mirrored_camera_is_said(tmp_path: Path) -> None:
    body = 'def Camera "c" {\nfloat3 xformOp:scale = (-1, 1, 1)\nuniform token[] xformOpOrder = ["xformOp:scale"]\n}\n'
    assert said(read(tmp_path, mesh("m") + body)) == ["its cameras c are mirrored, which is not done"]


@pytest.mark.parametrize(
    "body",
    [
        'def Mesh "m" {\nfloat points = 3\nint[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\n}\n',
        'def Mesh "m" {\npoint3f[] points = [(0,0,0)]\nstring faceVertexCounts = "3"\n}\n',
        'def Sphere "s" {\nstring radius = "wide"\n}\n',
        'def Cylinder "c" {\ntoken axis = "W"\n}\n',
    ],
)
def test_attributes_of_any_type_are_one_sentence(tmp_path: Path, body: str) -> None:
    with pytest.raises(InputProblem, match="the file is damaged"):
        read(tmp_path, body)


@pytest.mark.parametrize(
    "error", [UnicodeDecodeError("utf-8", b"\xff", 0, 1, "invalid start byte"), RuntimeError("vector::reserve")]
)
def test_what_openusd_makes_of_damage_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    """What a damaged file gives for names and lengths may change from reading to reading."""

    def failing(_opened: object, _most: int) -> Triangles:
        raise error

    monkeypatch.setattr(usd_child, "triangles_in", failing)
    with pytest.raises(InputProblem, match="the file is damaged"):
        read(tmp_path, mesh("m"))
