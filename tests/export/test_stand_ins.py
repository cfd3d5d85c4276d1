"""Missing drawings in a sequence: nothing, an empty frame, or a neighbour, and what is said of it."""

from pathlib import Path

import pytest

from kagezou.document.edits import add_layer, set_background_cels, set_exposures
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import InputProblem
from kagezou.export.request import Missing, Summary
from kagezou.export.stand_ins import Filled, filled_throughout
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from tests.export.small_cuts import bytes_below, cut, drawings, export, with_values


def lost(folder: Path, *numbers: int) -> Document:
    """Return a cut of six drawings of which some are not there."""
    document = cut(folder)
    export(document, folder / "whole")
    for number in numbers:
        (folder / "drawings" / f"a_{number:04d}.png").unlink()
    return document


def frame(folder: Path, number: int) -> bytes:
    return bytes_below(folder)[f"A_shadow/A_shadow_{number:04d}.png"]


def said(summary: Summary) -> list[str]:
    return [str(each) for each in summary.notes]


def test_gaps_are_all_named_before_the_first_frame(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match=r"3 drawings are missing: .*a_0001.*a_0003.*a_0004"):
        export(lost(tmp_path, 1, 3, 4), tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_empty_frames_stand_in_and_are_told_once(tmp_path: Path) -> None:
    summary = export(lost(tmp_path, 2, 4, 5), tmp_path / "out", missing=Missing.EMPTY)
    assert said(summary) == ["A: missing, so left empty on frames 2,4-5: a_0002.png, a_0004.png, a_0005.png"]
    assert summary.is_whole
    for number in range(1, 7):
        alpha = read_cel(tmp_path / "out" / "A_shadow" / f"A_shadow_{number:04d}.png").rgba[..., 3]
        assert alpha.any() == (number in (1, 3, 6))


def test_the_nearest_drawing_is_held_before_else_after(tmp_path: Path) -> None:
    summary = export(lost(tmp_path, 1, 4, 5), tmp_path / "out", missing=Missing.HOLD)
    assert said(summary) == [
        "A: missing, so the nearest drawing is held on frames 1,4-5: a_0001.png, a_0004.png, a_0005.png"
    ]
    shows = {1: 2, 2: 2, 3: 3, 4: 3, 5: 3, 6: 6}
    assert all(frame(tmp_path / "out", at) == frame(tmp_path / "whole", of) for at, of in shows.items())


def test_what_is_held_is_there_itself_though_other_frames_were_asked_for(tmp_path: Path) -> None:
    summary = export(lost(tmp_path, 3, 4), tmp_path / "out", missing=Missing.HOLD, frames=(4, 5))
    assert said(summary) == ["A: missing, so the nearest drawing is held on frames 4: a_0004.png"]
    assert frame(tmp_path / "out", 4) == frame(tmp_path / "whole", 2)


def test_an_empty_cel_is_no_gap_and_stays(tmp_path: Path) -> None:
    document = lost(tmp_path, 3)
    document = set_exposures(document, document.layers[0].id, (Exposure(1, 0), Exposure(2, None), Exposure(3, 2)))
    export(document, tmp_path / "out", missing=Missing.HOLD)
    assert not read_cel(tmp_path / "out" / "A_shadow" / "A_shadow_0002.png").rgba[..., 3].any()
    assert frame(tmp_path / "out", 3) == frame(tmp_path / "whole", 1)


@pytest.mark.parametrize("way", [Missing.EMPTY, Missing.HOLD])
def test_a_whole_layer_that_is_gone_is_refused_whatever_stands_in(tmp_path: Path, way: Missing) -> None:
    document = add_layer(
        lost(tmp_path, 2), "B", Cels(drawings(tmp_path / "b", 1, "b"), (Exposure(1, 0),)), Box(1, 1, 2, 2)
    )
    (tmp_path / "b" / "b_0001.png").unlink()
    with pytest.raises(InputProblem, match=r"b_0001.png: the drawing is missing"):
        export(document, tmp_path / "out", missing=way)


def test_what_nobody_needs_is_not_told(tmp_path: Path) -> None:
    summary = export(lost(tmp_path, 6), tmp_path / "out", missing=Missing.HOLD, frames=(1, 2))
    assert (said(summary), summary.written) == ([], 2)


def test_a_background_that_moves_is_held_as_well(tmp_path: Path) -> None:
    behind = Cels(drawings(tmp_path / "behind", 3, "bg"), (Exposure(1, 0), Exposure(3, 1), Exposure(5, 2)))
    document = set_background_cels(cut(tmp_path), behind)
    (tmp_path / "behind" / "bg_0002.png").unlink()
    summary = export(document, tmp_path / "out", missing=Missing.HOLD, composite=True)
    assert said(summary) == ["background: missing, so the nearest drawing is held on frames 3-4: bg_0002.png"]


def test_a_drawing_that_came_back_is_made_anew(tmp_path: Path) -> None:
    document = lost(tmp_path)
    third = tmp_path / "drawings" / "a_0003.png"
    data = third.read_bytes()
    third.unlink()
    export(document, tmp_path / "out", missing=Missing.HOLD)
    third.write_bytes(data)
    summary = export(document, tmp_path / "out", missing=Missing.HOLD, skip_existing=True)
    assert (summary.written, said(summary)) == (1, [])
    assert bytes_below(tmp_path / "out") == bytes_below(tmp_path / "whole")


def test_a_matter_of_course_says_nothing(tmp_path: Path) -> None:
    """Nothing is missing, so nothing stands in, however it is asked for."""
    document = cut(tmp_path)
    for way in Missing:
        assert filled_throughout(document, way) == Filled(document)


def test_what_hands_on_the_drawings_fills_those_that_cast_nothing_as_well(tmp_path: Path) -> None:
    document = with_values(lost(tmp_path, 3), layers__A__visible=False)
    filled = filled_throughout(document, Missing.HOLD)
    assert [str(each) for each in filled.notes] == [
        "A: missing, so the nearest drawing is held on frames 3: a_0003.png"
    ]
    assert [each.drawing for each in filled.document.layers[0].cels.exposures] == [0, 1, 1, 3, 4, 5]
