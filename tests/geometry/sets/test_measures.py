"""Tables of kinds are whole, and measures are scaled in every size."""

import pytest

from kagezou.geometry.ground import ground_plane
from kagezou.geometry.sets.bodies import Ball, Body, Drum, Solid
from kagezou.geometry.sets.measures import Measures, PieceKind, by_kind
from kagezou.geometry.sets.shapes import SHAPES, bodies_of


def test_a_table_that_lacks_a_kind_is_refused() -> None:
    whole = {kind: kind.name for kind in reversed(PieceKind)}
    assert list(by_kind(whole).items()) == [(kind, kind.name) for kind in PieceKind]
    del whole[PieceKind.RAMP], whole[PieceKind.WALL]
    with pytest.raises(LookupError, match="WALL, RAMP"):
        by_kind(whole)


def test_sizes_are_scaled_and_angles_and_counts_are_not() -> None:
    measures = Measures(PieceKind.STEPS, 2.0, 3.0, 4.0, lean_deg=5.0, count=6)
    assert measures.scaled(2.0) == Measures(PieceKind.STEPS, 4.0, 6.0, 8.0, lean_deg=5.0, count=6)


def test_all_kinds_but_those_of_files_have_a_shape() -> None:
    assert [kind for kind in PieceKind if SHAPES[kind] is None] == [PieceKind.MESH]


@pytest.mark.parametrize(
    ("kind", "bodies"),
    [
        (PieceKind.WALL, (Solid,)),
        (PieceKind.BOX, (Solid,)),
        (PieceKind.STEPS, (Solid,) * 3),
        (PieceKind.RAMP, (Solid,)),
        (PieceKind.CYLINDER, (Drum,)),
        (PieceKind.SPHERE, (Ball,)),
        (PieceKind.MESH, ()),
    ],
)
def test_what_each_kind_is_made_of(kind: PieceKind, bodies: tuple[type[Body], ...]) -> None:
    stand = ground_plane((500, 800), 0.0, 60.0)
    made = bodies_of(stand, Measures(kind, 200.0, 100.0, 50.0, count=3))
    assert tuple(type(body) for body in made) == bodies
