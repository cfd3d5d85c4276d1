"""Finding feet: reading the drawings of layers, and putting what was found into a document."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from threading import Lock
from typing import Final

from kagezou.animation.frames import format_frames
from kagezou.document.edits import set_drawings
from kagezou.document.model import Document, Drawing, Layer
from kagezou.errors import InputProblem
from kagezou.importing.imported import Imported
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.images.reading import Matte, read_matte
from kagezou.message import Message
from kagezou.picture_source import PictureSource
from kagezou.scene.stances import stances_of
from kagezou.standing.finding import Footless, FoundFeet, found_feet
from kagezou.standing.outline import Outline, outline_of

_READERS: Final = 2
"""Decoding runs on so many threads; more would leave nothing for the window."""

_MOST_NAMED: Final = 12
"""So many doubtful frames are named."""


@dataclass(frozen=True, slots=True)
class Look:
    """What was seen of one drawing: its size, px, and its outline; None where nothing of it is solid."""

    size_px: tuple[int, int]
    outline: Outline | None


@dataclass(frozen=True, slots=True)
class FeetOfLayer:
    """What was found in the drawings of a layer.

    Parameters
    ----------
    looks, feet
        By the source of the drawing; one that cannot be read is in neither.
    """

    looks: Mapping[PictureSource, Look]
    feet: Mapping[PictureSource, FoundFeet]

    @property
    def footless(self) -> Footless | None:
        """Why no drawing at all has feet; None where one has."""
        if any(found.feet for found in self.feet.values()):
            return None
        reasons = [found.footless for found in self.feet.values() if found.footless not in (None, Footless.EMPTY)]
        return max(reasons, key=reasons.count) if reasons else Footless.EMPTY


def document_with_feet(document: Document, layer_ids: Iterable[str], progress: Progress = no_progress) -> Imported:
    """Return the document with the feet of layers, and what the user should know of them."""
    found = {layer_id: feet_in(document.layer(layer_id), progress) for layer_id in layer_ids}
    for layer_id, feet in found.items():
        document = with_feet(document, layer_id, feet)
    notes = tuple(note for layer_id, feet in found.items() for note in feet_notes(document, layer_id, feet))
    return Imported(document, notes, tuple(found))


def feet_in(layer: Layer, progress: Progress = no_progress, stopped: Callable[[], bool] = lambda: False) -> FeetOfLayer:
    """Return the feet in the drawings of a layer, which are read once each.

    Parameters
    ----------
    layer
        What is looked at; its exposures say which drawing comes when.
    progress
        Told how many drawings have been looked at, from several threads, one at a time.
    stopped
        Asked before each drawing; once it is true the rest is left out.
    """
    sources = list(dict.fromkeys(drawing.source for drawing in _in_order(layer)))
    done, lock = 0, Lock()

    def look(source: PictureSource) -> Look | None:
        nonlocal done
        if stopped():
            return None
        try:
            found = look_of(read_matte(source))
        except InputProblem:
            return None  # Who brought it in has said so.
        with lock:
            done += 1
            progress(LoadPhase.FEET, done, len(sources))
        return found

    with ThreadPoolExecutor(_READERS) as pool:
        found = dict(zip(sources, pool.map(look, sources), strict=True))
    looks = {source: each for source, each in found.items() if each is not None}
    feet = found_feet([each.outline for each in looks.values()])
    return FeetOfLayer(looks, dict(zip(looks, feet, strict=True)))


def look_of(matte: Matte) -> Look:
    """Return what feet are found by in a drawing."""
    box = matte.box
    outline = None if box is None else outline_of(matte.alpha, box.left, box.top, matte.height_px)
    return Look((matte.width_px, matte.height_px), outline)


def with_feet(document: Document, layer_id: str, found: FeetOfLayer) -> Document:
    """Return the document with what was found in the drawings of a layer; what a person said stays."""
    layer = document.layer(layer_id)
    drawings = tuple(_with(drawing, found) for drawing in layer.cels.drawings)
    return set_drawings(document, layer_id, drawings)


def feet_notes(document: Document, layer_id: str, found: FeetOfLayer) -> tuple[Message, ...]:
    """Return what the user should know of the feet of a layer of ``document``, which has them."""
    layer = document.layer(layer_id)
    reason = found.footless
    if reason is not None and layer.joins is None:
        words = Message(
            "{name}: no feet were found ({reason}), so it stands on the ground line",
            name=layer.name,
            reason=reason.value,
        )
        return (words,)
    return doubt_notes(document, layer_id)


def doubt_notes(document: Document, layer_id: str) -> tuple[Message, ...]:
    """Return what is said of the drawings of a layer on which it is doubtful which foot carries."""
    layer = document.layer(layer_id)
    stances = stances_of(document, layer.joins or layer_id)
    doubtful = stances.doubtful if stances is not None and layer.joins is None else ()
    if not doubtful:
        return ()
    named = format_frames(doubtful[:_MOST_NAMED]) + (", …" if len(doubtful) > _MOST_NAMED else "")
    return (
        Message(
            "{name}: which foot carries is doubtful on {count} drawings (frames {frames}); please look at them",
            name=layer.name,
            count=len(doubtful),
            frames=named,
        ),
    )


def _in_order(layer: Layer) -> Sequence[Drawing]:
    """Return the drawings in the order in which they are first shown, then those that never are."""
    drawings = layer.cels.drawings
    shown = [drawings[each.drawing] for each in layer.cels.exposures if each.drawing is not None]
    return (*shown, *drawings)


def _with(drawing: Drawing, found: FeetOfLayer) -> Drawing:
    look = found.looks.get(drawing.source)
    if look is None:
        return drawing
    box = None if look.outline is None else look.outline.box
    return replace(drawing, size_px=look.size_px, figure=box, feet=found.feet[drawing.source].feet)
