"""Mattes of the ground and of set pieces: what of each is seen, adding up to the picture without a seam."""

from dataclasses import replace
from math import atan, degrees
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.export.frames import export_frames
from kagezou.export.receivers import receivers_of
from kagezou.export.request import RECEIVERS, ExportRequest
from kagezou.geometry.set_camera import SetCamera
from kagezou.importing.set_following import follow_camera
from kagezou.io.images.reading import read_cel
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import cut, with_key, with_values

SIZE = (320, 240)


@pytest.fixture
def room(tmp_path: Path) -> Document:
    """A wall and in front of it a box and a ball, seen in perspective from above."""
    document = cut(tmp_path, length=2)
    document = replace(document, canvas=replace(document.canvas, width_px=SIZE[0], height_px=SIZE[1]))
    document = with_values(
        document, ground__position=[160, 180], ground__declination=60, camera__fov=30, ground__roll=4
    )
    measures = {"width": 700.0, "height": 130.0, "position": (160.0, 150.0)}
    document = add_piece(document, "back wall", "wall", measures)
    document = add_piece(document, "crate", "box", {"width": 70.0, "height": 60.0, "depth": 50.0, "angle": 25.0,
                                                    "position": (110.0, 185.0)})  # fmt: skip
    return add_piece(document, "ground", "sphere", {"width": 60.0, "position": (215.0, 190.0)})


def alpha(path: Path) -> NDArray[np.float64]:
    return read_cel(path).rgba[..., 3] / 255.0


def exported(document: Document, folder: Path, **options: object) -> list[Path]:
    request = ExportRequest(folder, only=RECEIVERS, **options)  # type: ignore[arg-type]
    summary = export_frames(document, request, open_headless_context, lambda _done, _all: None, lambda: False)
    assert summary.is_whole
    return sorted(folder.glob("*/*.png"))


def test_each_receiver_has_a_name_of_its_own(room: Document) -> None:
    labels = [each.name for each in receivers_of(room)]
    assert labels == ["ground", "back wall", "crate", "ground_2"]


def test_what_is_seen_adds_up_without_a_seam(room: Document, tmp_path: Path) -> None:
    files = exported(room, tmp_path / "out")
    assert {path.parent.name for path in files} == {f"{each.name}_matte" for each in receivers_of(room)}
    first = {path.parent.name: alpha(path) for path in files if path.stem.endswith("0001")}
    total = sum(first.values(), np.zeros(SIZE[::-1]))
    assert total.max() <= 1 + 3 / 255, "nothing is seen twice"
    # The horizon is above the picture: everything below the wall's upper edge is one thing or another.
    assert total[150:].min() >= 1 - 3 / 255
    assert all(0.01 < each.mean() < 0.9 for each in first.values())
    # A little larger than a disc of its radius, as it is nearer than the place where it stands.
    ball = first["ground_2_matte"]
    assert ball.sum() == pytest.approx(np.pi * 30**2, rel=0.12)


def test_a_piece_hides_what_is_behind_it(room: Document, tmp_path: Path) -> None:
    with_crate = {path.parent.name: alpha(path) for path in exported(room, tmp_path / "with", frames=(1,))}
    without = replace(room, pieces=tuple(piece for piece in room.pieces if piece.name != "crate"))
    alone = {path.parent.name: alpha(path) for path in exported(without, tmp_path / "without", frames=(1,))}
    gone = sum(alone[name] - with_crate[name] for name in alone)
    assert np.abs(gone - with_crate["crate_matte"]).max() <= 4 / 255


def test_a_piece_that_is_away_is_not_seen(room: Document, tmp_path: Path) -> None:
    document = with_key(with_key(room, "set.crate.present", 1, value=True), "set.crate.present", 2, value=False)
    files = exported(document, tmp_path / "out")
    crate = [alpha(path) for path in files if path.parent.name == "crate_matte"]
    assert [bool(each.any()) for each in crate] == [True, False]


def test_without_flat_ground_its_matte_is_empty(room: Document, tmp_path: Path) -> None:
    document = with_values(room, ground__receives=False)
    files = exported(document, tmp_path / "out", frames=(1,))
    first = {path.parent.name: alpha(path) for path in files}
    assert not first["ground_matte"].any()
    assert first["crate_matte"].any()


def test_a_mesh_is_seen_as_the_box_it_was_made_of(room: Document, tmp_path: Path) -> None:
    corners = [(x, y, z) for x in (-1, 1) for y in (0, 1) for z in (-1, 1)]
    quads = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    text = "".join(f"v {x * 35} {y * 60} {z * 25}\n" for x, y, z in corners) + "".join(f"f {each}\n" for each in quads)
    (tmp_path / "crate.obj").write_text(text)
    others = replace(room, pieces=tuple(piece for piece in room.pieces if piece.name != "crate"))
    measures = {"scale": 1.0, "angle": 25.0, "position": (110.0, 185.0)}
    document = add_piece(others, "crate", "mesh", measures, tmp_path / "crate.obj")
    boxes = {path.parent.name: alpha(path) for path in exported(room, tmp_path / "a", frames=(1,))}
    meshes = {path.parent.name: alpha(path) for path in exported(document, tmp_path / "b", frames=(1,))}
    for name, matte in boxes.items():
        assert np.abs(meshes[name] - matte).mean() < 0.003, name


def test_they_come_beside_the_shadows_when_asked(room: Document, tmp_path: Path) -> None:
    request = ExportRequest(tmp_path / "out", frames=(1,), receivers=True)
    summary = export_frames(room, request, open_headless_context, lambda _done, _all: None, lambda: False)
    assert [folder.name for folder in summary.folders] == [
        "A_shadow", "ground_matte", "back wall_matte", "crate_matte", "ground_2_matte"
    ]  # fmt: skip
    again = replace(request, skip_existing=True)
    trusted = export_frames(room, again, open_headless_context, lambda _done, _all: None, lambda: False)
    assert (trusted.trusted, trusted.written) == (5, 0)


@pytest.mark.parametrize("is_perspective", [True, False])
@pytest.mark.parametrize("level", [0.5, 1.0, 1.5])
def test_level_cameras_of_a_set_see_it(tmp_path: Path, is_perspective: bool, level: float) -> None:  # noqa: FBT001
    wall = "v -1 0 -9\nv 1 0 -9\nv 1 2 -9\nv -1 2 -9\nf 1 2 3 4\n"
    (tmp_path / "wall.obj").write_text(wall)
    document = cut(tmp_path, length=1)
    document = replace(document, canvas=replace(document.canvas, width_px=SIZE[0], height_px=SIZE[1]))
    document = add_piece(document, "wall", "mesh", {"anchor": (0.0, 1.0, -9.0)}, tmp_path / "wall.obj")
    pose = np.eye(4)
    pose[1, 3] = level
    # As high as five units at the wall.
    height = 2 * degrees(atan(2.5 / 9)) if is_perspective else 5.0
    camera = SetCamera("c", is_perspective, height, 0.0, pose[np.newaxis])
    document = follow_camera(document, document.pieces[0].id, camera)
    document = set_constant(document, Address(GROUND_RECEIVES), raw=False)
    (matte,) = [alpha(path) for path in exported(document, tmp_path / "out") if path.parent.name == "wall_matte"]
    assert matte.sum() == pytest.approx((2 * SIZE[1] / 5) ** 2, rel=1e-3)
    rows = np.flatnonzero(matte[:, SIZE[0] // 2])
    assert rows[0] == pytest.approx(SIZE[1] / 2 - (2 - level) * SIZE[1] / 5, abs=1)
