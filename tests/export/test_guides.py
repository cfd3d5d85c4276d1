"""The set's outlines over a composite: drawn where they lie, light in dark, and part of what decides a picture."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.export.guides import coverage, with_guides
from kagezou.export.request import ExportRequest
from kagezou.io.images.reading import read_cel
from kagezou.scene.guide_lines import GuideLines
from tests.export.small_cuts import bytes_below, cut, export


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """A block before a wall whose foot is seen at row 30, from column 12 to 52."""
    values = {"position": [32, 30], "width": 40.0, "height": 20.0}
    return add_piece(cut(tmp_path, count=2), "wall", "wall", values)


def test_a_level_line_covers_its_width_and_no_more() -> None:
    covered = coverage([((2.0, 5.0), (8.0, 5.0))], 10, 10, 1.5)
    assert np.allclose(covered[:, 4], [0, 0, 0, 0, 0.75, 0.75, 0, 0, 0, 0])
    assert not covered[:, 9].any()
    assert np.allclose(coverage([((5.0, 2.0), (5.0, 8.0))], 10, 10, 1.5), covered.T)


@pytest.mark.parametrize("slope", [0.3, 1.0, -1.7])
def test_a_slanting_line_covers_as_much_as_it_is_long_and_wide(slope: float) -> None:
    end = (150.0, 100.0 + 50.0 * slope)
    covered = coverage([((100.0, 100.0), end)], 300, 300, 1.5)
    length = float(np.hypot(50.0, 50.0 * slope))
    assert covered.sum() == pytest.approx(1.5 * length, rel=0.05)


def test_what_lies_far_outside_costs_and_covers_nothing() -> None:
    assert not coverage([((-1e7, -5.0), (1e7, -5.0)), ((20.0, 0.0), (30.0, 9.0))], 10, 10, 1.5).any()
    crossing = coverage([((-1e7, 5.0), (1e7, 5.0))], 10, 10, 1.5)
    assert np.allclose(crossing[5], 0.75)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("tone", [0.0, 1.0])
def test_lines_are_seen_on_black_and_on_white(kind: type[np.uint8], tone: float) -> None:
    top = np.iinfo(kind).max
    picture = np.full((40, 40, 4), round(tone * top), kind)
    picture[..., 3] = top
    made = with_guides(picture, GuideLines((((0.0, 10.5), (40.0, 10.5)),), (((0.0, 30.5), (40.0, 30.5)),)))
    assert made.dtype == kind
    column = made[:, 20, 0] / top
    assert (made[..., 3] == top).all()
    edge, floor = (float(np.ptp(column[row - 4 : row + 5])) for row in (10, 30))
    assert floor >= edge > 0.2
    assert column[20] == tone


def test_on_a_clear_picture_they_have_their_own_opacity() -> None:
    made = with_guides(np.zeros((20, 20, 4), np.uint8), GuideLines((((0.0, 10.5), (20.0, 10.5)),), ()))
    assert 0 < made[10, 10, 3] < 255
    assert made[10, 10, 0] > made[12, 10, 0]
    assert not made[0].any()


def test_guides_are_drawn_into_composites_alone(document: Document, tmp_path: Path) -> None:
    plain, guided = tmp_path / "plain", tmp_path / "guided"
    export(document, plain, composite=True)
    export(document, guided, composite=True, guides=True)
    before, after = bytes_below(plain), bytes_below(guided)
    assert {name for name in before if before[name] != after[name]} == {
        "composite/composite_0001.png",
        "composite/composite_0002.png",
    }
    alpha = read_cel(guided / "composite" / "composite_0001.png", white_is_clear=False).rgba[:, 45, 3]
    assert alpha[29] > 128
    assert alpha[5] == 0


def test_guides_are_part_of_what_is_left_alone_when_it_is_there(document: Document, tmp_path: Path) -> None:
    out = tmp_path / "out"
    written = [
        export(document, out, composite=True, skip_existing=True, guides=guides).written
        for guides in (False, False, True, True)
    ]
    assert written == [4, 0, 2, 0]


def test_guides_without_composites_are_refused() -> None:
    with pytest.raises(UsageProblem, match="composites"):
        ExportRequest(Path("out"), guides=True)
    assert replace(ExportRequest(Path("out"), composite=True), guides=True).guides
