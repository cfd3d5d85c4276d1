"""Tables of kinds are whole, and measures are scaled in every size."""

import pytest

from kagezou.geometry.sets.measures import Measures, PieceKind, by_kind
from kagezou.geometry.sets.shapes import SHAPES


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
