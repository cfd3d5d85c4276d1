"""What is drawn of each curve: its lines, keys and handles in the coordinates of the graph."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Final

import numpy as np

from kagezou.animation.curve import Floats, Line, handles_of, speed_line, speeds_at, value_line
from kagezou.animation.track import Interpolation, Key, Track, components_of
from kagezou.document.address import Address, track_of
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Document
from kagezou.tools.curves.curve_list import Curve, same_in


class GraphKind(StrEnum):
    """What is drawn over time."""

    VALUE = "value"
    SPEED = "speed"


@dataclass(frozen=True, slots=True)
class ShownCurves:
    """What is to be drawn.

    Parameters
    ----------
    curves
        Which curves.
    kind
        What of them.
    normalises
        Whether each is stretched to the same height.
    ghost
        Another version of the document whose curves are drawn beside them.
    """

    curves: tuple[Curve, ...]
    kind: GraphKind = GraphKind.VALUE
    normalises: bool = False
    ghost: Document | None = None


@dataclass(frozen=True, slots=True)
class Fitting:
    """How a curve's own units lie in the graph: (value − middle) · factor."""

    middle: float = 0.0
    factor: float = 1.0

    def to_graph(self, values: Floats) -> Floats:
        """Return graph ordinates of values (N,)."""
        return np.asarray((values - self.middle) * self.factor, np.float64)

    def from_graph(self, ordinate: float) -> float:
        """Return the value at a graph ordinate."""
        return ordinate / self.factor + self.middle


@dataclass(frozen=True, slots=True)
class KeyMark:
    """A key as it is seen."""

    ref: KeyRef
    frame: float
    ordinate: float
    interpolation: Interpolation
    is_chosen: bool


@dataclass(frozen=True, slots=True)
class HandleMark:
    """The end of a handle as it is seen, and the key it belongs to."""

    key: KeyMark
    frame: float
    ordinate: float
    is_before: bool


@dataclass(frozen=True, slots=True)
class CurvePicture:
    """A curve as it is seen; the ghost is its other version, and ``chosen`` are the frames of its chosen keys."""

    curve: Curve
    track: Track
    fitting: Fitting
    line: Line
    keys: tuple[KeyMark, ...]
    handles: tuple[HandleMark, ...]
    ghost: Line | None
    chosen: frozenset[float] = frozenset()


Pictures = tuple[CurvePicture, ...]
Fittings = Mapping[tuple[Address, int], Fitting]
"""By address and component."""

NO_FITTINGS: Final[Fittings] = MappingProxyType({})


def pictures_of(
    document: Document, shown: ShownCurves, chosen: Refs, held: Fittings = NO_FITTINGS, before: Pictures = ()
) -> Pictures:
    """Return what is to be drawn now; a drag holds the fittings it began with, so that the curve follows the hand.

    Parameters
    ----------
    before
        What was drawn in the same way before: curves in which nothing changed are the very same again.
    """
    known = {(*_names(each.curve.address), each.curve.component): each for each in before}
    chosen_of: dict[_Names, set[float]] = {}
    for ref in chosen:
        chosen_of.setdefault(_names(ref.address), set()).add(ref.frame)
    made = []
    for curve in shown.curves:
        names = _names(curve.address)
        old = known.get((*names, curve.component))
        fitting = held.get((curve.address, curve.component)) if held else None
        is_same = old is not None and old.curve == curve
        if (
            old is None
            or not is_same
            or not _holds(old, track_of(document, curve.address), chosen_of.get(names), fitting)
        ):
            old = _picture(document, curve, shown, chosen, fitting)
        made.append(old)
    return tuple(made)


_Names = tuple[str, str | None, str | None]


def _names(address: Address) -> _Names:
    """Return what an address is known by: a property as a whole takes long to hash."""
    return address.property.name, address.layer_id, address.piece_id


def _holds(picture: CurvePicture, track: Track, chosen: set[float] | None, fitting: Fitting | None) -> bool:
    """Whether a curve would be drawn the same again."""
    return picture.track is track and picture.chosen == (chosen or set()) and fitting in (None, picture.fitting)


def differing_frames(document: Document, other: Document, curve: Curve) -> tuple[int, ...]:
    """Return the frames on which a curve differs from its other version."""
    track = same_in(other, curve, document)
    if track is None:
        return ()
    own = track_of(document, curve.address)
    frames = range(1, document.canvas.length_frames + 1)
    return tuple(frame for frame in frames if _number(own, curve, frame) != _number(track, curve, frame))


def runs(frames: Sequence[int]) -> list[tuple[int, int]]:
    """Return runs of neighbouring frames as (first, last)."""
    runs: list[tuple[int, int]] = []
    for frame in frames:
        if runs and runs[-1][1] == frame - 1:
            runs[-1] = (runs[-1][0], frame)
        else:
            runs.append((frame, frame))
    return runs


def value_in(track: Track, component: int, frame: float) -> float | None:
    """Return a component's value, None where the property has no such one."""
    parts = components_of(track.value_at(frame)) or ()
    return parts[component] if component < len(parts) else None


def _number(track: Track, curve: Curve, frame: int) -> float | None:
    return value_in(track, curve.component, frame)


def _picture(document: Document, curve: Curve, shown: ShownCurves, chosen: Refs, held: Fitting | None) -> CurvePicture:
    track = track_of(document, curve.address)
    length = document.canvas.length_frames
    speeds = shown.kind is GraphKind.SPEED
    line = (speed_line if speeds else value_line)(track, curve.component, 1, length)
    fitting = held or (_fitted(line) if shown.normalises else Fitting())
    levels = _levels(curve, track, speeds=speeds)
    keys = tuple(
        _mark(curve, key, float(level), chosen) for key, level in zip(track.keys, fitting.to_graph(levels), strict=True)
    )
    ghost = None
    if shown.ghost is not None and (other := same_in(shown.ghost, curve, document)) is not None:
        drawn = (speed_line if speeds else value_line)(other, curve.component, 1, length)
        ghost = Line(drawn.frames, fitting.to_graph(drawn.values))
    handles = () if speeds else tuple(_handles(curve, track, keys, fitting))
    seen = Line(line.frames, fitting.to_graph(line.values))
    marked = frozenset(mark.frame for mark in keys if mark.is_chosen)
    return CurvePicture(curve, track, fitting, seen, keys, handles, ghost, marked)


def _fitted(line: Line) -> Fitting:
    low, high = float(np.min(line.values)), float(np.max(line.values))
    return Fitting((low + high) / 2, 2 / (high - low) if high > low else 1.0)


def _levels(curve: Curve, track: Track, *, speeds: bool) -> Floats:
    """Return where the keys lie: at their values, or at the speeds they are left with."""
    if speeds:
        found = [speeds_at(track, index, curve.component)[1] for index in range(len(track.keys))]
    else:
        found = [(components_of(key.value) or (0.0,))[curve.component] for key in track.keys]
    return np.array(found, np.float64)


def _mark(curve: Curve, key: Key, ordinate: float, chosen: Refs) -> KeyMark:
    ref = KeyRef(curve.address, key.frame)
    return KeyMark(ref, key.frame, ordinate, key.interpolation, ref in chosen)


def _handles(curve: Curve, track: Track, keys: tuple[KeyMark, ...], fitting: Fitting) -> list[HandleMark]:
    made = []
    for index, mark in enumerate(keys):
        if not mark.is_chosen:
            continue
        for handle, before in zip(handles_of(track, index, curve.component), (True, False), strict=True):
            if handle is not None:
                ordinate = float(fitting.to_graph(np.array([handle.value]))[0])
                made.append(HandleMark(mark, handle.frame, ordinate, before))
    return made
