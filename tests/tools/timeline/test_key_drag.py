"""Keys dragged along time, pointer by pointer."""

import pytest

from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_canvas, set_key
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import GROUND_DECLINATION, GROUND_ROLL
from kagezou.tools.timeline.key_drag import KeyDrag, KeyGrip, dragging_keys
from kagezou.tools.timeline.lane_pointer import LanePointer

ROLL, DECLINATION = Address(GROUND_ROLL), Address(GROUND_DECLINATION)
CELL_PX = 20.0
PRESSED = LanePointer(205.0, CELL_PX)


@pytest.fixture
def document() -> Document:
    """The roll keyed on 5, 10 and 20, the declination on 10, in a cut of 48 frames."""
    made = set_canvas(Document(Canvas(100, 100)), Canvas(100, 100, length_frames=48))
    for frame in (5, 10, 20):
        made = set_key(made, ROLL, frame, float(frame))
    return set_key(made, DECLINATION, 10, 30.0)


def refs(*frames: int) -> Refs:
    return frozenset(KeyRef(ROLL, frame) for frame in frames)


def begun(document: Document, grip: KeyGrip) -> KeyDrag:
    drag = dragging_keys(document, grip)
    assert drag.send(PRESSED).document is document
    return drag


def to(frames: float, *, catches: bool = True) -> LanePointer:
    return LanePointer(PRESSED.x_px + frames * CELL_PX, CELL_PX, catches=catches)


def frames_of(document: Document) -> list[int]:
    return [key.frame for key in track_of(document, ROLL).keys]


def test_keys_move_by_whole_frames_and_stay_chosen(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(10), 10, ()))
    shown = drag.send(to(2.4))
    assert (frames_of(shown.document), shown.refs, shown.frame) == ([5, 12, 20], refs(12), 12)
    assert shown.caught_by is None
    assert track_of(shown.document, DECLINATION) is track_of(document, DECLINATION)


def test_every_document_is_made_of_the_first(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(10), 10, ()))
    drag.send(to(10))
    # On its way it lay on the key of frame 20, which is there again.
    assert frames_of(drag.send(to(2)).document) == [5, 12, 20]


def test_what_catches_draws_the_key_unless_it_is_let_go_of(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(10), 10, (1, 14, 48)))
    assert drag.send(to(3.6)).caught_by == 14
    assert drag.send(to(3.6)).frame == 14
    free = drag.send(to(3.6, catches=False))
    assert (free.frame, free.caught_by) == (14, None)
    assert drag.send(to(6)).caught_by is None


def test_how_near_is_near_is_told_in_pixels(document: Document) -> None:
    drag = dragging_keys(document, KeyGrip(refs(10), 10, (20,)))
    drag.send(LanePointer(0.0, 1.0))
    assert drag.send(LanePointer(5.0, 1.0)).frame == 20, "5 frames are 5 px here"
    assert drag.send(LanePointer(2.0, 1.0)).frame == 12


def test_keys_are_stretched_about_the_one_that_stays(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(5, 10, 20), 20, (), stretches_about=5))
    shown = drag.send(to(15))
    assert frames_of(shown.document) == [5, 15, 35]
    assert shown.refs == refs(5, 15, 35)


def test_a_closed_drag_takes_no_more(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(10), 10, ()))
    drag.close()
    with pytest.raises(StopIteration):
        drag.send(to(1))


def test_a_key_stops_at_the_first_frame_and_says_so(document: Document) -> None:
    drag = begun(document, KeyGrip(refs(10, 20), 20, ()))
    shown = drag.send(to(-15))
    assert (frames_of(shown.document), shown.frame) == ([1, 5, 11], 11)
    assert str(shown.note) == "no key goes before the first frame"
    assert drag.send(to(-9)).note is None


@pytest.mark.parametrize(
    ("frame", "about", "way", "stopped_at", "said"),
    [
        (20, 5, -30, 6, "it cannot go past the key that stays"),
        (5, 20, 30, 19, "no key goes before the first frame, nor past the key that stays"),
        (5, 20, -30, 1, "no key goes before the first frame, nor past the key that stays"),
    ],
)
def test_stretched_keys_stop_at_the_key_that_stays(
    document: Document, frame: int, about: int, way: int, stopped_at: int, said: str
) -> None:
    drag = begun(document, KeyGrip(refs(5, 10, 20), frame, (), about))
    shown = drag.send(to(way))
    assert (shown.frame, str(shown.note)) == (stopped_at, said)
    assert stopped_at in frames_of(shown.document)


def test_keys_that_are_landed_on_are_counted(document: Document) -> None:
    shown = begun(document, KeyGrip(refs(10), 10, ())).send(to(10))
    assert (frames_of(shown.document), str(shown.note)) == ([5, 20], "replaced keys: 1")
