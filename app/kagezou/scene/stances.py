"""How figures stand, frame by frame: their feet on the canvas, the ground below them, and their height."""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import median
from typing import Final

from kagezou.document.figures import parts_of
from kagezou.document.model import Document, Drawing, Layer, drawing_size
from kagezou.document.properties import VISIBLE
from kagezou.document.remembered import Remembered
from kagezou.document.values import value_at
from kagezou.geometry.box import centred_offset
from kagezou.geometry.vectors import Point2
from kagezou.scene.placing import PLACING, placement_at
from kagezou.standing.foot import Foot, FootPin, Verdict
from kagezou.standing.seen import Seen, SeenFoot, Stance
from kagezou.standing.stances import stances

TRACKS_OF_A_PART: Final = 100_000
"""Tracks of a figure's parts are told apart by multiples of this."""

_TOUCHES_OF_FIGURE: Final = 0.03
"""A foot of a part comes this close to the figure's lowest one at least once; what never does is a hand or a waist."""


@dataclass(frozen=True, slots=True)
class FigureStances:
    """How a figure stands over the whole cut.

    Parameters
    ----------
    frames
        Where each run of frames begins, upward; the first is 1.
    stances
        One for each run.
    height_px
        The figure's height, canvas px: the middle one of all that are seen.
    """

    frames: tuple[int, ...]
    stances: tuple[Stance, ...]
    height_px: float

    def at(self, frame: int) -> Stance:
        """Return how it stands on a frame."""
        return self.stances[max(bisect_right(self.frames, frame) - 1, 0)]

    def around(self, frame: int, frames: float) -> tuple[Stance, ...]:
        """Return the stance of a frame in the middle of as many before as after it, with feet all.

        They begin at most so many frames before or after it; it stands alone beside one without feet.
        """
        index = max(bisect_right(self.frames, frame) - 1, 0)
        start, beside = self.frames[index], 0
        for steps in range(1, min(index, len(self.frames) - 1 - index) + 1):
            ends = (index - steps, index + steps)
            if not all(self.stances[end].feet and abs(self.frames[end] - start) <= frames for end in ends):
                break
            beside = steps
        return self.stances[index - beside : index + beside + 1]

    def around_jump(self, frame: int) -> tuple[int, int | None, int | None]:
        """Return where the run of a frame begins, and the last frame before it and the first after it on the ground.

        None where it is in the air, or unseen, from the first frame on or to the last.
        """
        index = max(bisect_right(self.frames, frame) - 1, 0)
        stands = [bool(stance.feet) and stance.lift_px <= 0 for stance in self.stances]
        before = next((self.frames[each + 1] - 1 for each in reversed(range(index)) if stands[each]), None)
        after = next((self.frames[each] for each in range(index + 1, len(stands)) if stands[each]), None)
        return self.frames[index], before, after

    @property
    def doubtful(self) -> tuple[int, ...]:
        """The frames on which drawings begin that a person should look at."""
        return tuple(frame for frame, stance in zip(self.frames, self.stances, strict=True) if stance.doubt)


_known: Remembered[FigureStances | None] = Remembered(64)

_of_layers: Remembered[FigureStances | None] = Remembered(256)
"""By the layers as they are: while one is edited most of them stay, and need not be asked what decides."""


def stances_of(document: Document, figure_id: str) -> FigureStances | None:
    """Return how a figure stands over the cut; None where no feet were found or put in any of its drawings."""
    parts = parts_of(document, figure_id)

    def asked() -> FigureStances | None:
        made_of = (document.canvas, *(part for layer in parts for part in (layer.cels, layer.figure, *_moving(layer))))
        return _known.of(made_of, lambda: _made(document, parts))

    return _of_layers.of((document.canvas, *parts), asked)


def forget_stances() -> None:
    """Keep nothing of documents that are gone: their drawings would stay in memory with how they stand."""
    _of_layers.forget()
    _known.forget()


def _moving(layer: Layer) -> Iterator[object]:
    """Yield what decides where a layer's feet are seen beside its cels."""
    return (layer.tracks.get(name) for name in (*sorted(PLACING), VISIBLE.name))


def _made(document: Document, parts: Sequence[Layer]) -> FigureStances | None:
    if not any(drawing.feet or drawing.pins for layer in parts for drawing in layer.cels.drawings):
        return None
    frames = _run_starts(document, parts)
    heights = [_height(document, parts, frame) for frame in frames]
    height = median([each for each in heights if each > 0] or [float(parts[0].figure.height)])
    feet = [tuple(_feet_on(document, parts, frame)) for frame in frames]
    if len(parts) > 1:
        feet = _near_the_ground(feet, height)
    runs = zip(frames, heights, feet, strict=True)
    numbers: dict[tuple[int | None, ...], int] = {}
    seen = [
        Seen(frame, height if shown > 0 else 0.0, found, numbers.setdefault(_exposed(parts, frame), len(numbers)))
        for frame, shown, found in runs
    ]
    return FigureStances(tuple(frames), stances(seen, float(document.canvas.frame_rate)), height)


def _exposed(parts: Sequence[Layer], frame: int) -> tuple[int | None, ...]:
    """Return which drawing of each part is exposed on a frame."""
    return tuple(part.cels.index_at(frame) for part in parts)


def _run_starts(document: Document, parts: Sequence[Layer]) -> list[int]:
    """Return the frames on which what is seen of a figure may change, from 1."""
    length = document.canvas.length_frames
    if any(layer.tracks[name].is_keyed for layer in parts for name in PLACING if name in layer.tracks):
        return list(range(1, length + 1))
    starts = {1}
    for layer in parts:
        starts |= {exposure.frame for exposure in layer.cels.exposures if 1 <= exposure.frame <= length}
        visible = layer.tracks.get(VISIBLE.name)
        if visible is not None:
            starts |= {key.frame for key in visible.keys if 1 <= key.frame <= length}
    return sorted(starts)


def _height(document: Document, parts: Sequence[Layer], frame: int) -> float:
    """Return how high a figure is seen, canvas px; 0 where nothing of it is."""
    tops: list[float] = []
    bottoms: list[float] = []
    for _, layer, drawing in _shown(parts, frame):
        box = drawing.figure or layer.figure
        offset = _offset(document, drawing) if drawing.figure is not None else (0, 0)
        corners = [(x + offset[0], y + offset[1]) for x in (box.left, box.right) for y in (box.top, box.bottom)]
        placement = placement_at(document, layer, frame)
        rows = [corner[1] if placement is None else placement.placed(corner)[1] for corner in corners]
        tops.append(min(rows))
        bottoms.append(max(rows))
    return max(bottoms) - min(tops) if tops else 0.0


def _shown(parts: Sequence[Layer], frame: int) -> Iterator[tuple[int, Layer, Drawing]]:
    """Yield the place among the parts, the layer and the drawing of what is seen on a frame."""
    for index, layer in enumerate(parts):
        drawing = layer.cels.drawing_at(frame)
        if drawing is not None and (index == 0 or value_at(layer.tracks, VISIBLE, frame)):
            yield index, layer, drawing


def _feet_on(document: Document, parts: Sequence[Layer], frame: int) -> Iterator[SeenFoot]:
    for index, layer, drawing in _shown(parts, frame):
        first = index * TRACKS_OF_A_PART
        placement = placement_at(document, layer, frame)
        left, top = _offset(document, drawing)
        for foot, pin in feet_of(drawing):
            x, y = (foot.place[0] + left, foot.place[1] + top)
            place = (x, y) if placement is None else placement.placed((x, y))
            row = None
            if pin is not None and pin.ground_row is not None:
                below = (x, pin.ground_row + top)
                row = below[1] if placement is None else placement.placed(below)[1]
            yield SeenFoot(first + foot.track, place, None if pin is None else pin.verdict, row)


def feet_of(drawing: Drawing) -> Iterator[tuple[Foot, FootPin | None]]:
    """Yield the feet of a drawing, drawing px, with what a person said about them; what was said to be none is not."""
    places: dict[int, Point2] = {foot.track: foot.place for foot in drawing.feet or ()}
    pins = {pin.track: pin for pin in drawing.pins}
    places |= {track: pin.place for track, pin in pins.items() if pin.place is not None}
    for track in sorted(places):
        pin = pins.get(track)
        if pin is None or pin.verdict is not Verdict.NONE:
            yield Foot(track, places[track]), pin


def _near_the_ground(feet: Sequence[tuple[SeenFoot, ...]], height: float) -> list[tuple[SeenFoot, ...]]:
    """Return the feet without those that never come near the figure's lowest one, unless a person said so."""
    kept: set[int] = set()
    for found in feet:
        lowest = max((foot.place[1] for foot in found), default=0.0)
        kept |= {
            foot.track
            for foot in found
            if foot.verdict is not None or lowest - foot.place[1] <= _TOUCHES_OF_FIGURE * height
        }
    return [tuple(foot for foot in found if foot.track in kept) for found in feet]


def _offset(document: Document, drawing: Drawing) -> tuple[int, int]:
    return centred_offset(document.canvas.box, *drawing_size(document.canvas, drawing))
