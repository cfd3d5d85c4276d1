"""Figures that poke through set pieces, and grounding points whose shadow collapses, are found."""

import pytest

from kagezou.document import properties as p
from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.scene.misfits import Misfit, misfits_at, misfits_of, new_misfits
from tests.tools.tool_scenes import LAYER, document_with

LAMP = (p.LIGHT_POSITION, (200.0, -900.0, 1200.0))
WALL = {"width": 800.0, "height": 900.0}


def with_wall(y: float, upright: float = 0.0, **values: object) -> Document:
    """Return a figure whose feet are at row 900 and a wall at another row."""
    document = set_constant(document_with(LAMP), resolve(document_with(), "layers.A.upright"), upright)
    return add_piece(document, "Back", "wall", {**WALL, "position": (500.0, y), **values})


@pytest.mark.parametrize(
    ("document", "found"),
    [
        (with_wall(800), True),  # the head, 350 px back on the ground, lies behind a wall 200 px back
        (with_wall(800, 1.0), False),
        (with_wall(800, 0.8), False),
        (with_wall(720), False),
        (with_wall(895, 1.0), False),
        (with_wall(1000), False),
        (with_wall(800, 0.0, lean=30.0), False),
        (with_wall(800, 0.0, receives=False), False),
        (with_wall(800, 0.0, present=False), False),
        (with_wall(800, 0.0, position=(1100.0, 800.0)), False),
        (with_wall(800, 0.0, height=100.0), False),  # it leans over it
    ],
)
def test_a_figure_that_goes_through_a_wall_is_found(document: Document, found: bool) -> None:  # noqa: FBT001
    misfits = misfits_at(document, 1)
    assert [(misfit.figure_id, misfit.piece_id) for misfit in misfits] == [(LAYER, "piece-1")] * found
    assert all(str(misfit.message).startswith("A pokes through Back on frame 1") for misfit in misfits)


def test_a_figure_that_is_not_shown_pokes_through_nothing() -> None:
    document = with_wall(800)
    assert misfits_at(set_constant(document, resolve(document, "layers.A.visible"), raw=False), 1) == ()


def test_a_box_is_poked_through_and_a_round_piece_is_not_asked() -> None:
    figure = document_with(LAMP)
    box = add_piece(figure, "Box", "box", {"position": (500.0, 850.0), "width": 400.0, "height": 300.0, "depth": 80.0})
    assert len(misfits_at(box, 1)) == 1
    ball = add_piece(figure, "Ball", "sphere", {"position": (500.0, 850.0), "width": 400.0})
    assert misfits_at(ball, 1) == ()


def points(*pairs: tuple[float, float]) -> Document:
    return document_with((p.LIGHT_POSITION, (100.0, -900.0, 1200.0)), (p.GROUNDING, pairs))


def number(misfit: Misfit, name: str) -> float:
    found = misfit.message.values[name]
    assert isinstance(found, int | float)
    return found


def test_two_points_whose_shadow_is_a_sliver_are_found_with_what_is_left() -> None:
    # From the lamp this card is seen nearly edge-on: its slope over x is the lamp's own, -1200 for 400.
    sliver = points((470.0, 952.0), (530.0, 848.0))
    (misfit,) = misfits_at(sliver, 1)
    assert (misfit.figure_id, misfit.piece_id) == (LAYER, None)
    assert number(misfit, "percent") < 5
    assert misfits_at(points((420.0, 900.0), (580.0, 896.0)), 1) == ()
    assert misfits_at(points((420.0, 900.0)), 1) == ()
    assert misfits_at(points((500.0, 900.0), (501.0, 850.0)), 1) == ()  # one point, as they are taken


def test_what_comes_and_goes_over_the_cut_is_told_once_and_only_what_is_new() -> None:
    document = with_wall(1000)
    where = resolve(document, "set.Back.position")
    moving = set_key(set_key(document, where, 1, (500.0, 1000.0)), where, 24, (500.0, 800.0))
    (misfit,) = misfits_of(moving)
    assert 1 < number(misfit, "frame") <= 24
    assert misfits_of(document) == ()
    assert misfits_of(document_with()) == ()
    assert new_misfits((), (misfit,)) == (misfit,)
    assert new_misfits(misfits_of(moving), (misfit,)) == ()
