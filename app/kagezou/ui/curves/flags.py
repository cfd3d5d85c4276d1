"""What a lead looks for in curves: jumps from frame to frame, moves too fast, and keys between two drawings."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from itertools import pairwise
from typing import Final

import numpy as np

from kagezou.animation.curve import largest_steps
from kagezou.animation.track import Interpolation, Track, components_of
from kagezou.document.address import Address, addresses, track_of, tracks_of
from kagezou.document.linking import is_linked
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty, Kind

_MEASURED: Final = (Kind.POINT, Kind.PLACE, Kind.POINTS)
_STANDS_OUT: Final = 4.0
"""A step so many times as large as those around it is a jump."""
_COMES_BACK: Final = 0.5
"""A value that is out for one frame comes back to within this part of its step."""
_LEAST_OF_COLOUR: Final = 12.0
_LEAST_OF_RANGE: Final = 0.02
_LEAST_NUMBER: Final = 1.0
"""Jumps that nobody sees are smaller: of colours in steps of 255, of numbers a part of what their slider or their range
offers, where that is no more than `_WIDE`."""
_WIDE: Final = 1000.0
_KEPT: Final = 4096


class FlagKind(StrEnum):
    """What is noticed."""

    JUMP = "jump"
    FAST = "fast"
    OFF_EXPOSURES = "off exposures"


@dataclass(frozen=True, slots=True)
class Flag:
    """Something to look at.

    Parameters
    ----------
    amount
        How far a value jumps, or moves at most from one frame to the next, in its own unit; 0 for the others.
    last
        The last frame of a move that is too fast; 0 for the others.
    others
        How many more properties of the same layer have a key between the same two drawings.
    """

    kind: FlagKind
    frame: int
    address: Address
    amount: float = 0.0
    last: int = 0
    others: int = 0


def flags_of(document: Document, looked_at: Sequence[Address], limit_px: float) -> tuple[Flag, ...]:
    """Return what stands out in some properties, in the order of frames.

    A value that stands out from the frames around it jumps; a held key is meant to.

    Parameters
    ----------
    limit_px
        Places that move farther than this from one frame to the next are too fast: for one frame that is a jump, for
        several it is one move.
    """
    found: list[Flag] = []
    for address in looked_at:
        moves = _moves(track_of(document, address), address.property, document.canvas.length_frames, limit_px)
        found += [Flag(kind, frame, address, amount, last) for frame, kind, amount, last in moves]
    found += _off_exposures(document, looked_at)
    return tuple(sorted(found, key=lambda flag: (flag.frame, flag.kind, flag.address.property.name)))


def keyed_addresses(document: Document) -> tuple[Address, ...]:
    """Return every property of the document that has keys; one that is the same for all layers once."""
    linked: set[str] = set()
    found = []
    for address in addresses(document):
        name = address.property.name
        track = tracks_of(document, address).get(name)
        if track is None or not track.is_keyed or address.property.holds_only:
            continue
        if address.layer_id is not None and is_linked(document, address):
            if name in linked:
                continue
            linked.add(name)
        found.append(address)
    return tuple(found)


_Move = tuple[int, FlagKind, float, int]
"""Frame, kind, amount and last frame of a flag."""


@lru_cache(_KEPT)
def _moves(track: Track, prop: AnyProperty, length: int, limit_px: float) -> tuple[_Move, ...]:
    """Return jumps and fast moves; they are kept, for most curves are the same from one edit to the next."""
    steps = dict(largest_steps(track, 1, length))
    for key, follower in pairwise(track.keys):
        if key.interpolation is Interpolation.HOLD and follower.frame in steps:
            steps[follower.frame] = 0.0
    if prop.kind in _MEASURED:
        fast = _runs([frame for frame, step in steps.items() if step > limit_px])
        return tuple(_move_of(track, steps, first, last) for first, last in fast)
    least = _least(prop)
    return tuple(
        (frame, FlagKind.JUMP, step, 0)
        for frame, step in steps.items()
        if step > least and _stands_out(track, steps, frame)
    )


def _move_of(track: Track, steps: dict[int, float], first: int, last: int) -> _Move:
    """Return the flag of a run of steps that are too far: one frame, there and back, or a move."""
    most = max(steps[frame] for frame in range(first, last + 1))
    is_jump = first == last or (last == first + 1 and _comes_back(track, steps, first))
    return (first, FlagKind.JUMP, most, 0) if is_jump else (first, FlagKind.FAST, most, last)


def _stands_out(track: Track, steps: dict[int, float], frame: int) -> bool:
    """Return whether a value leaps to a frame, alone or to come back after it."""
    step, before = steps[frame], steps.get(frame - 1, 0.0)
    after, later = steps.get(frame + 1, 0.0), steps.get(frame + 2, 0.0)
    if step > _STANDS_OUT * max(before, after):
        return True
    return min(step, after) > _STANDS_OUT * max(before, later) and _comes_back(track, steps, frame)


def _comes_back(track: Track, steps: dict[int, float], frame: int) -> bool:
    """Return whether a value that leaps to a frame is after it about where it was before."""
    before, after = (components_of(track.value_at(each)) or () for each in (frame - 1, frame + 1))
    if frame + 1 not in steps or len(before) != len(after):
        return False
    return float(np.hypot.reduce(np.subtract(after, before))) < _COMES_BACK * min(steps[frame], steps[frame + 1])


def _least(prop: AnyProperty) -> float:
    """Return the smallest jump of a property that is seen."""
    if prop.kind is Kind.COLOR:
        return _LEAST_OF_COLOUR
    low, high = prop.slides or (prop.low, prop.high)
    return _LEAST_OF_RANGE * (high - low) if high - low <= _WIDE else _LEAST_NUMBER


def _runs(frames: list[int]) -> Iterator[tuple[int, int]]:
    """Yield the first and last of frames that follow on each other."""
    there = set(frames)
    starts = [frame for frame in frames if frame - 1 not in there]
    ends = [frame for frame in frames if frame + 1 not in there]
    yield from zip(starts, ends, strict=True)


def _off_exposures(document: Document, looked_at: Iterable[Address]) -> Iterator[Flag]:
    """Yield the frames with keys on which a layer that is not on ones shows the same drawing as before."""
    found: dict[tuple[int, str], list[Address]] = {}
    for address in looked_at:
        if address.layer_id is not None:
            for frame in _frames_off_exposures(document, address):
                found.setdefault((frame, address.layer_id), []).append(address)
    for (frame, _), those in found.items():
        yield Flag(FlagKind.OFF_EXPOSURES, frame, those[0], others=len(those) - 1)


def _frames_off_exposures(document: Document, address: Address) -> list[int]:
    cels = document.layer(address.layer_id or "").cels
    changes = {max(exposure.frame, 1) for exposure in cels.exposures}
    if not changes or len(changes) >= document.canvas.length_frames:
        return []
    return [key.frame for key in track_of(document, address).keys if key.frame not in changes]
