"""Every length and place of a cut mapped alike: larger or smaller, and moved on the canvas."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import atan, degrees, radians, tan
from types import MappingProxyType
from typing import Final, cast

from kagezou.animation.ease import Ease
from kagezou.animation.track import Key, Track, Value
from kagezou.document.figure_properties import BACKGROUND_POSITION, POSITION
from kagezou.document.model import Canvas, Cels, Tracks
from kagezou.document.properties import GROUND_POSITION, GROUNDING, LIGHT_POSITION
from kagezou.document.property import AnyProperty, Usual
from kagezou.document.set_properties import PIECE_POSITION
from kagezou.geometry.vectors import Point2

PLACES: Final = frozenset((GROUND_POSITION, LIGHT_POSITION, BACKGROUND_POSITION, POSITION, GROUNDING, PIECE_POSITION))
"""The properties whose values are places on the canvas; an anchor is one in its drawing."""

_POWERS: Final = MappingProxyType({"px": 1, "px²": 2})
"""Units of lengths and areas: how often a size multiplies them."""


@dataclass(frozen=True, slots=True)
class LengthMap:
    """Where lengths and places go.

    Parameters
    ----------
    factor
        By how much every length is multiplied, over 0; an area by its square.
    shift
        By how much a place of the canvas is moved after that, px; the depth of a place is not moved.
    """

    factor: float = 1.0
    shift: Point2 = (0.0, 0.0)

    def tracks(self, tracks: Tracks, table: Mapping[str, AnyProperty]) -> Tracks:
        """Return the tracks of an owner whose properties are those of a table."""
        # What has no track has its default, which is a length as well; what is usual for the cut follows its canvas.
        measured = {
            name: (prop, tracks.get(name, Track(prop.default)))
            for name, prop in table.items()
            if prop.unit in _POWERS and (name in tracks or prop.usual is Usual.DEFAULT)
        }
        mapped = {name: (track, self.track(prop, track)) for name, (prop, track) in measured.items()}
        changed = {name: after for name, (before, after) in mapped.items() if after != before}
        return MappingProxyType({**tracks, **changed})

    def track(self, prop: AnyProperty, track: Track) -> Track:
        """Return the track of a property; one that is neither length nor place stays."""
        return multiplied(track, self.factor ** _POWERS.get(prop.unit, 0), self.shift if prop in PLACES else (0.0, 0.0))

    def point(self, point: Point2) -> Point2:
        """Return where a point of the canvas goes."""
        return (point[0] * self.factor + self.shift[0], point[1] * self.factor + self.shift[1])


def multiplied(track: Track, times: float, shift: Point2 = (0.0, 0.0)) -> Track:
    """Return a track with all its numbers multiplied, then the first two of each value moved."""

    def key(each: Key) -> Key:
        return replace(
            each,
            value=_mapped(each.value, times, shift),
            ease_in=_quicker(each.ease_in, times),
            ease_out=_quicker(each.ease_out, times),
        )

    return Track(_mapped(track.constant, times, shift), tuple(key(each) for each in track.keys))


def widened(track: Track, times: float) -> Track:
    """Return the vertical field of view that sees so many times the height from the same eye."""

    def wider(value: Value) -> float:
        return 2 * degrees(atan(times * tan(radians(cast("float", value)) / 2)))

    return Track(wider(track.constant), tuple(replace(key, value=wider(key.value)) for key in track.keys))


def sized(cels: Cels, canvas: Canvas) -> Cels:
    """Return cels whose drawings of unknown size are as large as a canvas, for which they count."""
    size = (canvas.width_px, canvas.height_px)
    return replace(cels, drawings=tuple(replace(each, size_px=each.size_px or size) for each in cels.drawings))


def _quicker(eases: Iterable[Ease], times: float) -> tuple[Ease, ...]:
    return tuple(replace(ease, speed=ease.speed * times) for ease in eases)


def _mapped(value: Value, times: float, shift: Point2) -> Value:
    """Return a number, a point, a place, of which the depth is not moved, or points."""
    if isinstance(value, float):
        return value * times
    if not isinstance(value, tuple):
        return value
    if value and isinstance(value[0], tuple):
        return cast("Value", tuple(_mapped(cast("Value", point), times, shift) for point in value))
    numbers = cast("tuple[float, ...]", value)
    return tuple(number * times + way for number, way in zip(numbers, (*shift, 0.0), strict=False))
