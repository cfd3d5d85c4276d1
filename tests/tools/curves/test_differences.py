"""Between which frames a curve looks another than before."""

import pytest

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Interpolation
from kagezou.document.address import Address
from kagezou.document.ease_edits import set_ease
from kagezou.document.edits import remove_key, set_canvas, set_key
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import GROUND_ROLL
from kagezou.tools.curves.curve_list import curves_of
from kagezou.tools.curves.differences import EVERYWHERE, NOWHERE, differing_span, joined
from kagezou.tools.curves.picture import CurvePicture, GraphKind, ShownCurves, pictures_of

ROLL = Address(GROUND_ROLL)
NONE: Refs = frozenset()


@pytest.fixture
def document() -> Document:
    """A cut of 48 frames with keys of the roll on 10, 20, 30 and 40."""
    made = set_canvas(Document(Canvas(100, 100)), Canvas(100, 100, length_frames=48))
    for frame, value in ((10, 0.0), (20, 20.0), (30, 10.0), (40, 15.0)):
        made = set_key(made, ROLL, frame, value, Interpolation.LINEAR)
    return made


def chosen(*frames: int) -> Refs:
    return frozenset(KeyRef(ROLL, frame) for frame in frames)


def seen(
    document: Document, refs: Refs = NONE, kind: GraphKind = GraphKind.VALUE, ghost: Document | None = None
) -> CurvePicture:
    return pictures_of(document, ShownCurves(curves_of(document, None), kind, ghost=ghost), refs)[0]


def test_what_stayed_differs_nowhere(document: Document) -> None:
    assert differing_span(seen(document), seen(document)) == NOWHERE
    assert differing_span(seen(document, chosen(20)), seen(document, chosen(20))) == NOWHERE


def test_a_key_that_moved_changes_the_curve_between_its_neighbours(document: Document) -> None:
    higher = set_key(document, ROLL, 20, 25.0)
    assert differing_span(seen(document), seen(higher)) == (10.0, 30.0)
    later = set_key(remove_key(document, ROLL, 20), ROLL, 24, 20.0, Interpolation.LINEAR)
    assert differing_span(seen(document), seen(later)) == (10.0, 30.0)


def test_at_an_end_it_changes_to_the_end_of_the_cut(document: Document) -> None:
    assert differing_span(seen(document), seen(set_key(document, ROLL, 10, 5.0))) == (1.0, 20.0)
    assert differing_span(seen(document), seen(set_key(document, ROLL, 40, 5.0))) == (30.0, 48.0)


def test_an_ease_changes_the_curve_and_its_handles(document: Document) -> None:
    eased = set_ease(document, chosen(10, 20, 30, 40), (EASY,), (EASY,))
    other = set_ease(eased, chosen(20), (EASY,), (Ease(1.0, 0.9),))
    assert differing_span(seen(eased), seen(other)) == (20.0, 30.0)
    assert differing_span(seen(eased, chosen(20)), seen(other, chosen(20))) == (20 - 10 / 3, 30.0), (
        "its handles as well"
    )


def test_another_choice_changes_keys_or_all_of_a_curve(document: Document) -> None:
    assert differing_span(seen(document, chosen(10)), seen(document, chosen(10, 30))) == (30.0, 30.0)
    assert differing_span(seen(document), seen(document, chosen(10))) == EVERYWHERE, "its line is wider"


def test_another_number_of_keys_or_another_ghost_changes_everything(document: Document) -> None:
    assert differing_span(seen(document), seen(remove_key(document, ROLL, 20))) == EVERYWHERE
    assert differing_span(seen(document), seen(document, ghost=document)) == EVERYWHERE
    assert differing_span(seen(document, ghost=document), seen(document, ghost=document)) == NOWHERE
    other = set_key(document, ROLL, 20, 25.0)
    assert differing_span(seen(document, ghost=document), seen(document, ghost=other)) == EVERYWHERE
    fewer = remove_key(document, ROLL, 20)
    assert differing_span(seen(document, ghost=document), seen(document, ghost=fewer)) == EVERYWHERE


def test_speeds_differ_where_the_curve_does(document: Document) -> None:
    higher = set_key(document, ROLL, 20, 25.0)
    before, after = (seen(each, kind=GraphKind.SPEED) for each in (document, higher))
    first, last = differing_span(before, after)
    assert (first, last) == (10.0, 30.0)


def test_spans_are_joined_to_the_least_that_holds_both() -> None:
    assert joined((1.0, 4.0), (6.0, 9.0)) == (1.0, 9.0)
    assert joined(NOWHERE, (6.0, 9.0)) == (6.0, 9.0)
    assert joined(EVERYWHERE, (6.0, 9.0)) == EVERYWHERE
