"""The camera matched to a picture by floor edges and the horizon."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.invariants import check
from kagezou.document.model import Canvas, Document
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.vanishing import VanishingLines, first_lines, horizon_of, laid
from kagezou.geometry.vectors import Point2
from kagezou.io.project.file import dumps, loads
from kagezou.tools.handles import drag_of, matching_handles_of, nudge
from kagezou.tools.pointer import Modifiers, Pointer
from tests.tools.tool_scenes import FREE, UNZOOMED, document_with, number

SIZE = (1000.0, 1000.0)
PAINTED = (Camera(1000, 1000, 50.0), 4.0, 72.0)
"""The camera a background was painted for, its roll and its declination."""


def painted_lines(azimuth_deg: float = 40.0) -> VanishingLines:
    camera, roll, declination = PAINTED
    return laid(first_lines(SIZE), camera, ground_plane((500.0, 900.0), roll, declination), azimuth_deg)


def dragged(document: Document, handle_id: str, end: Point2, modifiers: Modifiers = FREE) -> Document:
    handle = matching_handles_of(document, 1, UNZOOMED).find(handle_id)
    assert handle is not None
    drag = drag_of(handle, document, 1, UNZOOMED)
    for place in (handle.canvas_px, end):
        document = drag.send(Pointer.seen_at(UNZOOMED, place, modifiers))
    drag.close()
    check(document)
    return document


def numbers(document: Document) -> tuple[float, float, float]:
    lines = (properties.FOV, properties.GROUND_ROLL, properties.GROUND_DECLINATION)
    fov, roll, declination = (number(document, line) for line in lines)
    return (fov, roll, declination)


def test_lines_laid_onto_the_painted_floor_find_its_camera() -> None:
    document = document_with()
    ends = [end for line in painted_lines().all for end in line]
    for index, end in enumerate(ends):
        document = dragged(document, f"match.end.{index}", end)
    assert numbers(document) == pytest.approx((50.0, 4.0, 72.0), abs=1e-6)
    assert document.vanishing is not None
    assert number(document, properties.GROUND_DECLINATION) != properties.GROUND_DECLINATION.default
    handles = matching_handles_of(document, 1, UNZOOMED)
    assert handles.note is None
    for index, end in enumerate(ends):
        found = handles.find(f"match.end.{index}")
        assert found is not None
        assert found.canvas_px == pytest.approx(end)


def test_what_cannot_be_a_floor_keeps_the_camera_and_says_why() -> None:
    document = replace(document_with((properties.FOV, 50.0)), vanishing=painted_lines())
    before = numbers(document)
    start = document.vanishing.first[0][0]  # type: ignore[union-attr]
    document = dragged(document, "match.end.1", start)
    assert numbers(document) == before
    assert matching_handles_of(document, 1, UNZOOMED).note is not None


def test_lines_that_do_not_tell_the_field_of_view_keep_the_one_before_and_say_so() -> None:
    document = document_with((properties.FOV, 35.0), (properties.GROUND_DECLINATION, 70.0))
    # The first line of a hand makes the lines tell something that was never meant.
    document = dragged(document, "match.end.0", (180.0, 700.0))
    assert number(document, properties.FOV) != pytest.approx(35.0, abs=0.5)
    for index, end in ((4, (600.0, 700.0)), (5, (900.0, 700.0)), (6, (600.0, 850.0)), (7, (900.0, 850.0))):
        document = dragged(document, f"match.end.{index}", end)
    for index, end in ((0, (300.0, 900.0)), (1, (400.0, 700.0)), (2, (700.0, 900.0)), (3, (600.0, 700.0))):
        document = dragged(document, f"match.end.{index}", end)
    assert number(document, properties.FOV) == pytest.approx(35.0)
    note = matching_handles_of(document, 1, UNZOOMED).note
    assert str(note).endswith("it stays at 35.0°")
    # Lines that tell one again are believed, and then a field of view that was typed is kept from there on.
    told = dragged(document, "match.end.7", (900.0, 800.0))
    for index, end in ((0, (200.0, 900.0)), (1, (250.0, 700.0)), (2, (900.0, 900.0))):
        told = dragged(told, f"match.end.{index}", end)
    assert number(told, properties.FOV) != pytest.approx(35.0, abs=0.5)
    typed = set_constant(told, Address(properties.FOV), 28.0)
    untold = dragged(typed, "match.end.7", (900.0, 850.0))
    assert number(untold, properties.FOV) == pytest.approx(28.0)
    read = loads(dumps(untold, Path("/p")), Path("/p"))
    assert read.vanishing == untold.vanishing


def test_the_horizon_sets_the_declination_and_takes_the_lines_along() -> None:
    camera, roll, declination = PAINTED
    document = replace(
        document_with(
            (properties.FOV, 50.0), (properties.GROUND_ROLL, roll), (properties.GROUND_DECLINATION, declination)
        ),
        vanishing=painted_lines(),
    )
    handle = matching_handles_of(document, 1, UNZOOMED).find("match.horizon")
    assert handle is not None
    lower = nudge(handle, document, 1, 0.0, 40.0, UNZOOMED)
    assert number(lower, properties.GROUND_DECLINATION) > declination
    assert number(lower, properties.GROUND_ROLL) == roll
    horizon = horizon_of(camera, roll, number(lower, properties.GROUND_DECLINATION))
    before = horizon_of(camera, roll, declination)
    assert horizon is not None
    assert before is not None
    assert horizon.height_px == pytest.approx(before.height_px - 40.0, abs=0.2)
    # The lines now tell this very camera: touching one changes nothing.
    end = matching_handles_of(lower, 1, UNZOOMED).find("match.end.0")
    assert end is not None
    aside = dragged(lower, "match.end.0", (end.canvas_px[0] + 30.0, end.canvas_px[1] + 8.0))
    again = dragged(aside, "match.end.0", end.canvas_px)
    assert numbers(again) == pytest.approx(numbers(lower), abs=1e-6)


def test_the_end_of_the_horizon_rolls_the_ground_and_snaps_level() -> None:
    document = document_with((properties.FOV, 40.0), (properties.GROUND_DECLINATION, 80.0))
    end = matching_handles_of(document, 1, UNZOOMED).find("match.horizon_end")
    assert end is not None
    rolled = dragged(document, "match.horizon_end", (end.canvas_px[0], end.canvas_px[1] + 60.0))
    assert number(rolled, properties.GROUND_ROLL) == pytest.approx(11.31, abs=0.01)
    level = dragged(rolled, "match.horizon_end", (end.canvas_px[0], end.canvas_px[1] + 3.0), Modifiers(snap=True))
    assert number(level, properties.GROUND_ROLL) == 0.0
    middle = matching_handles_of(document, 1, UNZOOMED).find("match.horizon")
    assert middle is not None
    assert dragged(document, "match.horizon_end", middle.canvas_px) == document


def test_a_picture_without_perspective_begins_with_a_usual_lens() -> None:
    document = document_with()
    lower = dragged(document, "match.horizon", (500.0, 200.0))
    assert number(lower, properties.FOV) == 40.0
    assert number(lower, properties.GROUND_DECLINATION) == pytest.approx(77.7, abs=0.1)


def test_an_empty_scene_can_be_matched_too() -> None:
    document = Document(Canvas(1600, 900))
    handles = matching_handles_of(document, 1, UNZOOMED)
    assert {handle.id for handle in handles.handles} == {
        "match.horizon", "match.horizon_end", *(f"match.end.{index}" for index in range(8))
    }  # fmt: skip
    assert handles.guides
