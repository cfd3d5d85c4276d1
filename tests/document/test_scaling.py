"""A smaller cut is the same cut: every length divided, everything else as it was, at every frame."""

from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.animation.track import Value, components_of
from kagezou.document.model import Canvas, Document, Tracks
from kagezou.document.properties import TABLE
from kagezou.document.property import AnyProperty, Scope
from kagezou.document.scaling import scaled, usable_divisor
from tests.documents import documents


def value(tracks: Tracks, prop: AnyProperty, frame: float) -> Value:
    track = tracks.get(prop.name)
    return prop.default if track is None else track.value_at(frame)


def holders(document: Document, scope: Scope) -> list[Tracks]:
    match scope:
        case Scope.DOCUMENT:
            return [document.tracks]
        case Scope.LAYER:
            return [layer.tracks for layer in document.layers]
        case Scope.PIECE:
            return [piece.tracks for piece in document.pieces]


@settings(max_examples=25)
@given(documents(), st.sampled_from([2, 4]), st.floats(1, 1000))
def test_lengths_are_divided_at_every_frame_and_nothing_else_is(document: Document, divisor: int, frame: float) -> None:
    small = scaled(document, divisor)
    for prop in TABLE:
        for before, after in zip(holders(document, prop.scope), holders(small, prop.scope), strict=True):
            full, part = value(before, prop, frame), value(after, prop, frame)
            power = {"px": 1, "px²": 2}.get(prop.unit, 0)
            for whole, piece in zip(components_of(full) or (), components_of(part) or (), strict=True):
                assert abs(piece * divisor**power - whole) <= 1e-9 * max(1e7, abs(whole))


def test_only_a_divisor_of_both_sides_is_usable() -> None:
    assert usable_divisor(Canvas(1920, 1080), 4) == 4
    assert usable_divisor(Canvas(1000, 750), 4) == 2
    assert usable_divisor(Canvas(1001, 750), 4) == 1
