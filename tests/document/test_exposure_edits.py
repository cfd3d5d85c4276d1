"""Exposures under the hand: what moves, what stays, and that order and undo hold for any of them."""

from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document import edits, exposure_edits, invariants
from kagezou.document.exposure_edits import Exposures
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box

DRAWINGS = tuple(Drawing(name, Path(f"/c/{name}.png")) for name in "ABCD")
SHEET = "AAAAAABBBBBBCCCCCCDDDDDD"


def made(text: str) -> Exposures:
    """Return exposures from a sheet such as ``AAB.``, a letter a frame."""
    frames = [(1, text[0]), *((n, after) for n, (before, after) in enumerate(pairwise(text), 2) if after != before)]
    return tuple(Exposure(frame, None if letter == "." else "ABCD".index(letter)) for frame, letter in frames)


def seen(exposures: Exposures, length: int = 24) -> str:
    cels = Cels(DRAWINGS, exposures)
    found = (cels.drawing_at(frame) for frame in range(1, length + 1))
    return "".join("." if drawing is None else drawing.name for drawing in found)


def sound(exposures: Exposures) -> bool:
    return all(after.frame > before.frame for before, after in pairwise(exposures))


def test_a_boundary_lengthens_one_and_shortens_the_other() -> None:
    assert seen(exposure_edits.move_boundary(made(SHEET), 1, 9)) == "AAAAAAAABBBBCCCCCCDDDDDD"
    assert seen(exposure_edits.move_boundary(made(SHEET), 1, 4)) == "AAABBBBBBBBBCCCCCCDDDDDD"


def test_what_a_boundary_passes_over_is_gone() -> None:
    assert seen(exposure_edits.move_boundary(made(SHEET), 1, 15)) == "AAAAAAAAAAAAAACCCCDDDDDD"
    assert seen(exposure_edits.move_boundary(made(SHEET), 2, 3)) == "AACCCCCCCCCCCCCCCCDDDDDD"
    assert seen(exposure_edits.move_boundary(made(SHEET), 3, -5)) == "D" * 24


def test_the_first_exposure_leaves_nothing_before_it() -> None:
    assert seen(exposure_edits.move_boundary(made(SHEET), 0, 4)) == "...AAABBBBBBCCCCCCDDDDDD"


def test_a_ripple_moves_all_that_follows() -> None:
    assert seen(exposure_edits.ripple(made(SHEET), 1, 9)) == "AAAAAAAABBBBBBCCCCCCDDDD"
    assert seen(exposure_edits.ripple(made(SHEET), 1, -3)) == "ABBBBBBCCCCCCDDDDDDDDDDD"


def test_ends() -> None:
    assert seen(exposure_edits.end_at(made(SHEET), 0, 4)) == "AAABBBBBBBBBCCCCCCDDDDDD"
    assert seen(exposure_edits.end_at(made(SHEET), 0, 4, ripples=True)) == "AAABBBBBBCCCCCCDDDDDDDDD"
    assert seen(exposure_edits.end_at(made(SHEET), 3, 22)) == "AAAAAABBBBBBCCCCCCDDD..."
    assert seen(exposure_edits.end_at(made(SHEET), 3, 2)) == "AAAAAABBBBBBCCCCCCD....."


def test_moved_drawings_keep_their_length_and_their_neighbours_fill_in() -> None:
    assert seen(exposure_edits.move_run(made(SHEET), 1, 1, 10)) == "AAAAAAAAABBBBBBCCCDDDDDD"
    assert seen(exposure_edits.move_run(made(SHEET), 1, 1, 4)) == "AAABBBBBBCCCCCCCCCDDDDDD"
    assert seen(exposure_edits.move_run(made(SHEET), 1, 2, 10)) == "AAAAAAAAABBBBBBCCCCCCDDD"
    assert seen(exposure_edits.move_run(made(SHEET), 1, 1, 16)) == "AAAAAAAAAAAAAAABBBBBBDDD"
    assert seen(exposure_edits.move_run(made(SHEET), 3, 3, 22)) == "AAAAAABBBBBBCCCCCCCCCDDD"
    assert seen(exposure_edits.move_run(made(SHEET), 0, 0, 3)) == "..AAAAAABBBBCCCCCCDDDDDD"


def test_split_insert_replace_empty_and_remove() -> None:
    parts = exposure_edits.split(made(SHEET), 9)
    assert seen(parts) == SHEET
    assert [each.frame for each in parts] == [1, 7, 9, 13, 19]
    assert exposure_edits.split(parts, 9) is parts
    assert seen(exposure_edits.replace_drawings(parts, 2, 2, 3)) == "AAAAAABBDDDDCCCCCCDDDDDD"
    assert seen(exposure_edits.replace_drawings(parts, 1, 3, None)) == "AAAAAA............DDDDDD"
    assert seen(exposure_edits.expose(made(SHEET), 4, 2)) == "AAACCCBBBBBBCCCCCCDDDDDD"
    assert seen(exposure_edits.expose(made(SHEET), 7, 0)) == "AAAAAAAAAAAACCCCCCDDDDDD"
    assert seen(exposure_edits.remove(made(SHEET), 1, 2)) == "AAAAAAAAAAAAAAAAAADDDDDD"
    assert seen(exposure_edits.remove(made(SHEET), 0, 0)) == "......BBBBBBCCCCCCDDDDDD"


def test_on_twos_and_threes() -> None:
    ones = made("ABCD")
    assert seen(exposure_edits.on_steps(ones, 0, 3, 2), 8) == "AABBCCDD"
    assert seen(exposure_edits.on_steps(ones, 0, 3, 3), 12) == "AAABBBCCCDDD"
    assert seen(exposure_edits.on_steps(made(SHEET), 1, 2, 2)) == "AAAAAABBCCDDDDDDDDDDDDDD"
    again = exposure_edits.split(exposure_edits.on_steps(ones, 0, 3, 2), 2)
    assert seen(exposure_edits.on_steps(again, 0, 4, 1), 4) == "ABCD", "a drawing twice in a row counts once"
    assert exposure_edits.on_steps((), 0, 0, 2) == ()


def test_a_copied_stretch_goes_to_another_layer_by_the_names_of_drawings() -> None:
    clip = exposure_edits.copy(Cels(DRAWINGS, made(SHEET)), 1, 2, 24)
    assert clip.length == 12
    assert seen(exposure_edits.paste(Cels(DRAWINGS, made(SHEET)), clip, 3)) == "AABBBBBBCCCCCCCCCCDDDDDD"
    other = Cels((Drawing("X", Path("/x")), DRAWINGS[2]), (Exposure(20, 0),))
    pasted = exposure_edits.paste(other, clip, 2)
    assert [(each.frame, each.drawing) for each in pasted] == [(2, None), (8, 1), (14, None), (20, 0)]
    last = exposure_edits.copy(Cels(DRAWINGS, made(SHEET)), 3, 3, 24)
    assert last.length == 6


def test_the_cut_grows_with_what_is_moved_out_of_it() -> None:
    document = edits.add_layer(Document(Canvas(9, 9)), "A", Cels(DRAWINGS, made("ABCD")), Box(0, 0, 1, 1))
    assert document.canvas.length_frames == 4
    twos = exposure_edits.on_steps(made("ABCD"), 0, 3, 2)
    assert exposure_edits.with_exposures(document, "layer-1", twos).canvas.length_frames == 7
    assert exposure_edits.with_exposures(document, "layer-1", twos, last_held=2).canvas.length_frames == 8
    shorter = exposure_edits.remove(made("ABCD"), 2, 3)
    assert exposure_edits.with_exposures(document, "layer-1", shorter).canvas.length_frames == 4


def test_what_began_before_the_cut_counts_from_its_first_frame() -> None:
    early = (Exposure(-4, 0), Exposure(-1, 1), Exposure(4, 2))
    clip = exposure_edits.copy(Cels(DRAWINGS, early), 0, 2, 6)
    assert (clip.entries, clip.length) == (((0, "B"), (3, "C")), 6)
    assert seen(exposure_edits.on_steps(early, 1, 2, 2), 6) == "BBCCCC"
    assert seen(exposure_edits.move_run(early, 1, 1, 3), 8) == "BBBBBCCC"


sheets = st.text("ABCD.", min_size=1, max_size=24).map(made)


@given(sheets, st.data())
def test_order_holds_under_any_edit(exposures: Exposures, data: st.DataObject) -> None:
    count = len(exposures)
    first = data.draw(st.integers(0, count - 1))
    last = data.draw(st.integers(first, count - 1))
    frame = data.draw(st.integers(-3, 30))
    cels = Cels(DRAWINGS, exposures)
    for changed in (
        exposure_edits.move_boundary(exposures, first, frame),
        exposure_edits.ripple(exposures, first, frame),
        exposure_edits.end_at(exposures, first, frame),
        exposure_edits.end_at(exposures, first, frame, ripples=True),
        exposure_edits.move_run(exposures, first, last, frame),
        exposure_edits.split(exposures, frame),
        exposure_edits.expose(exposures, frame, 2),
        exposure_edits.replace_drawings(exposures, first, last, None),
        exposure_edits.remove(exposures, first, last),
        exposure_edits.on_steps(exposures, first, last, data.draw(st.integers(1, 4))),
        exposure_edits.paste(cels, exposure_edits.copy(cels, first, last, 24), frame),
    ):
        assert sound(changed)
        document = Document(Canvas(9, 9, length_frames=24))
        document = edits.add_layer(document, "A", cels, Box(0, 0, 1, 1))
        invariants.check(exposure_edits.with_exposures(document, "layer-1", changed))


@given(sheets, st.data())
def test_putting_things_where_they_are_changes_nothing(exposures: Exposures, data: st.DataObject) -> None:
    index = data.draw(st.integers(0, len(exposures) - 1))
    place = exposures[index].frame
    assert exposure_edits.move_boundary(exposures, index, place) == exposures
    assert exposure_edits.ripple(exposures, index, place) == exposures
    assert exposure_edits.move_run(exposures, index, index, place) == exposures
    cels = Cels(DRAWINGS, exposures)
    clip = exposure_edits.copy(cels, index, index, 24)
    assert seen(exposure_edits.paste(cels, clip, place)) == seen(exposures)
    frame = data.draw(st.integers(1, 24))
    assert seen(exposure_edits.split(exposures, frame)) == seen(exposures)


@pytest.mark.parametrize(("frame", "index"), [(0, None), (1, 0), (6, 0), (7, 1), (99, 3)])
def test_what_is_exposed_at_a_frame(frame: int, index: int | None) -> None:
    assert exposure_edits.index_at(made(SHEET), frame) == index
