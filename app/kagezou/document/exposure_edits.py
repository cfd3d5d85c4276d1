"""Edits of when drawings are exposed, as hands make them on a dope sheet: pure functions of ordered exposures.

What none of them touches: the drawings themselves, and the order of exposures, of which there is one a frame at most.
A place is given by the index of an exposure or by a frame; a layer's last exposure holds to the end of the cut.
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from kagezou.document.edits import set_canvas, set_exposures
from kagezou.document.model import Cels, Document, Exposure

Exposures = tuple[Exposure, ...]


@dataclass(frozen=True, slots=True)
class ExposureClip:
    """A copied stretch: names of drawings by frames behind its first one, None for an empty cel, and its length."""

    entries: tuple[tuple[int, str | None], ...]
    length: int


def index_at(exposures: Exposures, frame: int) -> int | None:
    """Return the index of what is exposed at a frame, None before the first exposure."""
    after = bisect_right(exposures, frame, key=lambda exposure: exposure.frame)
    return after - 1 if after else None


def with_exposures(document: Document, layer_id: str, exposures: Exposures, *, last_held: int = 1) -> Document:
    """Give a layer other exposures; where the last drawing moves out of the cut, the cut grows.

    Parameters
    ----------
    document, layer_id, exposures
        What gets what.
    last_held
        For how many frames the last drawing is seen then.
    """
    before = document.layer(layer_id).cels.exposures
    changed = set_exposures(document, layer_id, exposures)
    if not before or not exposures or exposures[-1].drawing is None or exposures[-1].frame <= before[-1].frame:
        return changed
    needed = max(exposures[-1].frame + last_held - 1, document.canvas.length_frames)
    return set_canvas(changed, replace(document.canvas, length_frames=needed))


def move_boundary(exposures: Exposures, index: int, frame: int) -> Exposures:
    """Let an exposure begin on another frame: the one before is held longer or shorter, all else stays in its place.

    What the boundary passes over is gone.
    """
    old, frame = exposures[index], max(frame, 1)
    if frame <= old.frame:
        before = tuple(each for each in exposures[:index] if each.frame < frame)
        return (*before, replace(old, frame=frame), *exposures[index + 1 :])
    return (*exposures[:index], *_from(exposures[index:], frame))


def room_of_boundary(exposures: Exposures, index: int, length_frames: int) -> tuple[int, int]:
    """Return the first and last frame on which an exposure may begin so that no drawing is passed over whole.

    Empty cels may be passed over; a drawing keeps a frame.
    """
    before = index - 1
    while before >= 0 and exposures[before].drawing is None:
        before -= 1
    least = 1 if before < 0 else max(exposures[before].frame, 1) + 1
    if 0 <= before < index - 1:
        least = exposures[before + 1].frame
    kept = index
    while kept < len(exposures) and exposures[kept].drawing is None:
        kept += 1
    starts = [each.frame for each in exposures] + [length_frames + 1]
    most = starts[index + 1] - 1 if kept == index else starts[kept]
    return (least, max(most, least))


def room_of_run(exposures: Exposures, first: int, last: int, length_frames: int) -> tuple[int, int | None]:
    """Return the first and last frame on which a run may begin so; None where nothing follows, and the cut grows."""
    least, _ = room_of_boundary(exposures, first, length_frames)
    if last + 1 == len(exposures):
        return (least, None)
    _, end = room_of_boundary(exposures, last + 1, length_frames)
    start = max(exposures[first].frame, 1)
    return (min(least, start), max(start + end - exposures[last + 1].frame, start))


def ripple(exposures: Exposures, index: int, frame: int) -> Exposures:
    """Let an exposure begin on another frame, and all that follow move along; the one before keeps a frame."""
    least = exposures[index - 1].frame + 1 if index else 1
    away = max(frame, least) - exposures[index].frame
    return exposures[:index] + tuple(replace(each, frame=each.frame + away) for each in exposures[index:])


def end_at(exposures: Exposures, index: int, frame: int, *, ripples: bool = False) -> Exposures:
    """Hold an exposure until before a frame, at least for one; behind a layer's last one comes an empty cel."""
    frame = max(frame, exposures[index].frame + 1)
    if index + 1 < len(exposures):
        return (ripple if ripples else move_boundary)(exposures, index + 1, frame)
    return (*exposures, Exposure(frame, None))


def move_run(exposures: Exposures, first: int, last: int, frame: int) -> Exposures:
    """Move exposures from index ``first`` to ``last`` together so that they begin on a frame.

    What they leave is held by their neighbour on that side, what they come to lie on is gone.
    """
    # What began before the cut did is seen from its first frame on.
    away = max(frame, 1) - max(exposures[first].frame, 1)
    moved = tuple(replace(each, frame=each.frame + away) for each in exposures[first : last + 1])
    before = tuple(each for each in exposures[:first] if each.frame < moved[0].frame)
    following = exposures[last + 1 :]
    if not following:
        return before + moved
    end = following[0].frame + away
    behind = _from(following, end) if away > 0 else (replace(following[0], frame=end), *following[1:])
    return before + moved + behind


def split(exposures: Exposures, frame: int) -> Exposures:
    """Begin what is exposed at a frame anew there, so that both parts can be changed alone."""
    index = index_at(exposures, frame)
    if index is None or exposures[index].frame == frame:
        return exposures
    return (*exposures[: index + 1], Exposure(frame, exposures[index].drawing), *exposures[index + 1 :])


def expose(exposures: Exposures, frame: int, drawing: int | None) -> Exposures:
    """Expose a drawing, or nothing, from a frame on until the next exposure."""
    others = [each for each in exposures if each.frame != frame]
    return tuple(sorted((*others, Exposure(frame, drawing)), key=lambda each: each.frame))


def replace_drawings(exposures: Exposures, first: int, last: int, drawing: int | None) -> Exposures:
    """Expose another drawing, or nothing, for the exposures from index ``first`` to ``last``."""
    return tuple(
        replace(each, drawing=drawing) if first <= index <= last else each for index, each in enumerate(exposures)
    )


def remove(exposures: Exposures, first: int, last: int) -> Exposures:
    """Take exposures away; what was before them is held on."""
    return exposures[:first] + exposures[last + 1 :]


def on_steps(exposures: Exposures, first: int, last: int, step: int) -> Exposures:
    """Hold each of the exposures from index ``first`` to ``last`` for ``step`` frames; what follows moves along.

    A drawing that is exposed several times in a row counts once.
    """
    run = exposures[first : last + 1]
    if not run:
        return exposures
    different = [run[0], *(after for before, after in pairwise(run) if after.drawing != before.drawing)]
    start = max(run[0].frame, 1)
    stepped = tuple(replace(each, frame=start + number * step) for number, each in enumerate(different))
    following = exposures[last + 1 :]
    away = start + len(stepped) * step - following[0].frame if following else 0
    return exposures[:first] + stepped + tuple(replace(each, frame=each.frame + away) for each in following)


def copy(cels: Cels, first: int, last: int, length: int) -> ExposureClip:
    """Return the exposures from index ``first`` to ``last`` of a layer in a cut of so many frames."""
    run = cels.exposures[first : last + 1]
    start = max(run[0].frame, 1)
    end = cels.exposures[last + 1].frame if last + 1 < len(cels.exposures) else max(length, run[-1].frame) + 1
    # Of what began before the cut did, the last is what is seen on its first frame.
    seen = {max(each.frame, 1): each.drawing for each in run}
    entries = ((frame - start, None if index is None else cels.drawings[index].name) for frame, index in seen.items())
    return ExposureClip(tuple(entries), max(end - start, 1))


def paste(cels: Cels, clip: ExposureClip, frame: int) -> Exposures:
    """Put a copied stretch down from a frame on, in the place of what is there; after it all is as before.

    A drawing that this layer has none of that name of stays empty.
    """
    numbers = {drawing.name: index for index, drawing in reversed(list(enumerate(cels.drawings)))}
    put = [Exposure(frame + away, None if name is None else numbers.get(name)) for away, name in clip.entries]
    end = frame + clip.length
    before = tuple(each for each in cels.exposures if each.frame < frame)
    return (*before, *put, *_from(cels.exposures, end, leading=True))


def _from(exposures: Sequence[Exposure], frame: int, *, leading: bool = False) -> Exposures:
    """Return what is exposed from a frame on; what is exposed at it begins there.

    Parameters
    ----------
    leading
        Whether nothing before the first exposure is an empty cel of its own.
    """
    behind = tuple(each for each in exposures if each.frame > frame)
    covered = [each for each in exposures if each.frame <= frame]
    if covered:
        return (replace(covered[-1], frame=frame), *behind)
    return (Exposure(frame, None), *behind) if leading else behind
