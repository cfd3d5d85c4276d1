"""What stands out in curves: one line for each thing, of every property, and not what is meant."""

from pathlib import Path

import pytest

from kagezou.animation.track import Interpolation
from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.model import Document, Exposure
from kagezou.document.properties import COLOR, LIGHT_POSITION, OPACITY, SOFTNESS
from kagezou.document.property import AnyProperty
from kagezou.ui.curves.flags import FlagKind, flags_of, keyed_addresses
from tests.export.small_cuts import cut

LIMIT = 60.0
LIGHT = Address(LIGHT_POSITION)


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """A figure on ones, so that no key lies between two drawings."""
    return cut(tmp_path, count=24, length=24)


def keyed(document: Document, prop: AnyProperty, *keys: tuple[int, object]) -> Document:
    address = Address(prop, None if prop is LIGHT_POSITION else document.layers[0].id)
    for frame, value in keys:
        document = edits.set_key(document, address, frame, value)
    return document


def found(document: Document, limit_px: float = LIMIT) -> list[tuple[FlagKind, int, int]]:
    return [(flag.kind, flag.frame, flag.last) for flag in flags_of(document, keyed_addresses(document), limit_px)]


def test_a_fast_move_is_one_line_with_its_frames(document: Document) -> None:
    moved = keyed(document, LIGHT_POSITION, (5, (0.0, 0.0, 0.0)), (12, (700.0, 0.0, 0.0)))
    (flag,) = flags_of(moved, keyed_addresses(moved), LIMIT)
    assert (flag.kind, flag.frame, flag.last) == (FlagKind.FAST, 6, 12)
    assert flag.amount == pytest.approx(100.0)
    assert found(moved, 101.0) == []


@pytest.mark.parametrize(
    ("prop", "before", "after"),
    [
        (OPACITY, 0.8, 0.3),
        (SOFTNESS, 2.0, 9.0),
        (COLOR, "#202020", "#C02020"),
        (LIGHT_POSITION, (0.0, 0.0, 0.0), (70.0, 0.0, 0.0)),
    ],
    ids=str,
)
def test_a_leap_of_any_property_is_found(document: Document, prop: AnyProperty, before: object, after: object) -> None:
    assert found(keyed(document, prop, (8, before), (9, after))) == [(FlagKind.JUMP, 9, 0)]


@pytest.mark.parametrize(
    ("prop", "usual", "out"),
    [(OPACITY, 0.8, 0.2), (SOFTNESS, 2.0, 9.0), (LIGHT_POSITION, (0.0, 0.0, 0.0), (400.0, 0.0, 0.0))],
    ids=str,
)
def test_one_frame_that_is_out_is_one_line(document: Document, prop: AnyProperty, usual: object, out: object) -> None:
    assert found(keyed(document, prop, (8, usual), (9, out), (10, usual))) == [(FlagKind.JUMP, 9, 0)]


def test_a_leap_within_a_slow_drift_is_found(document: Document) -> None:
    drift = keyed(document, OPACITY, (1, 0.1), (11, 0.2), (12, 0.5), (22, 0.6))
    assert found(drift) == [(FlagKind.JUMP, 12, 0)]


def test_fades_eases_and_still_values_are_none(document: Document) -> None:
    assert found(keyed(document, OPACITY, (4, 0.0), (12, 1.0))) == []
    assert found(keyed(document, OPACITY, (4, 0.0), (6, 1.0))) == []
    assert found(keyed(document, OPACITY, (4, 0.5), (20, 0.5))) == []
    assert found(keyed(document, OPACITY, (4, 0.5), (5, 0.505))) == [], "nobody sees that"


def test_a_held_key_is_meant_to(document: Document) -> None:
    stepped = edits.set_key(document, LIGHT, 3, (0.0, 0.0, 0.0), Interpolation.HOLD)
    stepped = edits.set_key(stepped, LIGHT, 9, (500.0, 0.0, 0.0), Interpolation.HOLD)
    assert found(stepped) == []


def test_properties_keyed_between_two_drawings_are_one_line_a_layer(document: Document) -> None:
    layer = document.layers[0]
    twos = edits.set_exposures(document, layer.id, tuple(Exposure(frame, frame // 2) for frame in range(1, 24, 2)))
    for prop, value in ((OPACITY, 0.5), (SOFTNESS, 2.0), (COLOR, "#202020")):
        twos = keyed(twos, prop, (8, value))
    (flag,) = flags_of(twos, keyed_addresses(twos), LIMIT)
    assert (flag.kind, flag.frame, flag.others) == (FlagKind.OFF_EXPOSURES, 8, 2)


def test_flags_are_of_the_whole_cut_in_the_order_of_frames(document: Document) -> None:
    both = keyed(document, OPACITY, (15, 0.8), (16, 0.3))
    both = keyed(both, LIGHT_POSITION, (4, (0.0, 0.0, 0.0)), (5, (300.0, 0.0, 0.0)))
    flags = flags_of(both, keyed_addresses(both), LIMIT)
    assert [flag.frame for flag in flags] == [5, 16]
    assert flags[1].address == Address(OPACITY, both.layers[0].id)
    assert flags[1].amount == pytest.approx(0.5)
