"""The pictures of an export, each one once, with every file that holds it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Final

from kagezou.animation.track import Track
from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.model import Document, Drawing, Layer, PictureSource, file_of
from kagezou.document.property import Property
from kagezou.document.set_properties import PIECE_CASTS
from kagezou.errors import UsageProblem
from kagezou.export.names import digits_for, safe_names
from kagezou.export.request import RECEIVED, SHADOWS, SUFFIXES, ExportRequest
from kagezou.scene.evaluate import evaluate
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import LayerScene, Received, Scene, SetShadow, ShadowCast, ShadowLook

COMPOSITE: Final = "composite"
"""The folder and the first part of the files of composites."""


@dataclass(frozen=True, slots=True)
class ShadowContent:
    """All that decides a shadow picture but its size and format; without a cast it is empty."""

    cast: ShadowCast | SetCast | None
    look: ShadowLook


@dataclass(frozen=True, slots=True)
class ReceivedContent:
    """All that decides a picture of what others cast on a character, but its size and format."""

    received: Received


@dataclass(frozen=True, slots=True)
class CompositeContent:
    """All that decides a composite but its size and format: the background and each layer, from the bottom."""

    background: PictureSource | None
    layers: tuple[tuple[Drawing | None, ShadowCast | None, ShadowLook, Received | None], ...]
    set_shadow: SetShadow | None = None


Content = ShadowContent | ReceivedContent | CompositeContent


_Picture = tuple[str, Content, LayerScene | None]
"""Its folder's name, what it shows, and the layer it is drawn from."""


@dataclass(frozen=True, slots=True)
class Target:
    """One file of an export."""

    frame: int
    path: Path


@dataclass(frozen=True, slots=True)
class Job:
    """One picture and the files it goes into.

    Parameters
    ----------
    content
        What it shows; equal contents have equal pixels.
    scene, layer
        What to draw it from: the first frame that shows it; the layer is None for a composite, for an empty shadow
        and for the set's.
    targets
        In the order of their frames, never empty.
    """

    content: Content
    scene: Scene
    layer: LayerScene | None
    targets: tuple[Target, ...]

    @property
    def mattes(self) -> tuple[PictureSource, ...]:
        """The drawings whose alpha it needs."""
        if isinstance(self.content, CompositeContent):
            return ()
        if isinstance(self.content, ReceivedContent):
            received = self.content.received
            casting = (cast.drawing.source for shade in received.shades for cast in shade.casts)
            return tuple(dict.fromkeys((received.drawing.source, *casting)))
        return (self.content.cast.drawing.source,) if isinstance(self.content.cast, ShadowCast) else ()

    @property
    def cels(self) -> tuple[PictureSource, ...]:
        """The drawings it needs in colour."""
        if not isinstance(self.content, CompositeContent):
            return ()
        return tuple(drawing.source for drawing, *_ in self.content.layers if drawing is not None)

    @property
    def pictures(self) -> tuple[PictureSource, ...]:
        """All that it is made of."""
        background = self.content.background if isinstance(self.content, CompositeContent) else None
        return (*self.mattes, *self.cels, *([background] if background is not None else []))

    @property
    def sources(self) -> tuple[Path, ...]:
        """Every file it is made of."""
        return tuple(map(file_of, self.pictures))

    def only(self, targets: tuple[Target, ...]) -> "Job":
        """Return the job with some of its targets."""
        return replace(self, targets=targets)


@dataclass(frozen=True, slots=True)
class Plan:
    """Everything an export is to make: the pictures in the order of their first frames, folders and names."""

    jobs: tuple[Job, ...]
    folders: tuple[Path, ...]
    names: dict[str, str]

    @property
    def files(self) -> int:
        """How many files that are."""
        return sum(len(job.targets) for job in self.jobs)


def planned(document: Document, request: ExportRequest) -> Plan:
    """Return what an export is to make.

    Raises
    ------
    UsageProblem
        A layer or a frame is asked for that the document does not have, or there is nothing to make.
    """
    frames = _frames(document, request)
    layers = _layers(document, request)
    names = safe_names(layer.name for layer in document.layers)
    receiving = [layer for layer in layers if ever_receives(layer)] if request.only != SHADOWS else []
    layers = layers if request.only != RECEIVED else ()
    folders = [request.folder / f"{names[layer.name]}_shadow" for layer in layers]
    folders += [request.folder / f"{names[layer.name]}_received" for layer in receiving]
    has_set = request.layers is None and request.only != RECEIVED and _set_ever_casts(document)
    set_label = _set_label(document, names) if has_set else None
    if set_label is not None:
        folders.append(request.folder / set_label)
    if request.composite:
        folders.append(request.folder / COMPOSITE)
    if not folders:
        raise UsageProblem("there is nothing to render: the project has no visible character layer")
    digits = digits_for(document.canvas.length_frames)
    first: dict[Content, Job] = {}
    targets: dict[Content, list[Target]] = {}
    for frame in frames:
        scene = evaluate(document, frame)
        pictures: list[_Picture] = []
        pictures += [(f"{names[each.name]}_shadow", *_shadow(document, each, scene, frame)) for each in layers]
        pictures += [(f"{names[each.name]}_received", *_received(document, each, scene, frame)) for each in receiving]
        if set_label is not None:
            pictures.append((set_label, _set_shadow(scene), None))
        if request.composite:
            pictures.append((COMPOSITE, _composite(scene), None))
        for label, content, layer_scene in pictures:
            path = request.folder / label / f"{label}_{frame:0{digits}d}{SUFFIXES[request.format]}"
            first.setdefault(content, Job(content, scene, layer_scene, ()))
            targets.setdefault(content, []).append(Target(frame, path))
    jobs = tuple(job.only(tuple(targets[content])) for content, job in first.items())
    if request.once:
        jobs = tuple(_each_once(jobs, digits))
    return Plan(jobs, tuple(folders), {layer.name: names[layer.name] for layer in (*layers, *receiving)})


def pictures_of(plan: Plan, folder: Path) -> tuple[int, ...]:
    """Return which picture, from 0 in the order in which they appear, a folder's layer shows on each of its frames."""
    shown: dict[int, int] = {}
    number = 0
    for job in plan.jobs:
        frames = [target.frame for target in job.targets if target.path.parent == folder]
        shown.update(dict.fromkeys(frames, number))
        number += bool(frames)
    return tuple(shown[frame] for frame in sorted(shown))


def _each_once(jobs: tuple[Job, ...], digits: int) -> Iterator[Job]:
    """Yield the jobs with one target in each folder they go to, numbered from 1."""
    numbers: dict[Path, int] = {}
    for job in jobs:
        targets = []
        for folder in dict.fromkeys(target.path.parent for target in job.targets):
            numbers[folder] = numbers.get(folder, 0) + 1
            first = next(target for target in job.targets if target.path.parent == folder)
            name = f"{folder.name}_{numbers[folder]:0{digits}d}{first.path.suffix}"
            targets.append(Target(first.frame, folder / name))
        yield job.only(tuple(targets))


def _shadow(document: Document, layer: Layer, scene: Scene, frame: int) -> tuple[ShadowContent, LayerScene | None]:
    """Return a layer's shadow on a frame; an empty cel and a hidden layer give an empty one."""
    seen = next((each for each in scene.layers if each.id == layer.id), None)
    if seen is None or seen.cast is None:
        return _nothing(document, layer, frame), None
    # How it is laid on what is under it does not change the layer itself.
    return ShadowContent(seen.cast, replace(seen.look, multiply=True)), seen


def _received(
    document: Document, layer: Layer, scene: Scene, frame: int
) -> tuple[ShadowContent | ReceivedContent, LayerScene | None]:
    """Return what falls on a layer on a frame; an empty picture where nothing can."""
    seen = next((each for each in scene.layers if each.id == layer.id), None)
    if seen is None or seen.received is None or not seen.received.shades:
        return _nothing(document, layer, frame), None
    return ReceivedContent(seen.received), seen


def _nothing(document: Document, layer: Layer, frame: int) -> ShadowContent:
    text = str(value_of(document, Address(properties.COLOR, layer.id), frame))
    red, green, blue = bytes.fromhex(text.removeprefix("#"))
    return ShadowContent(None, ShadowLook((red, green, blue), 0.0, multiply=True))


def _composite(scene: Scene) -> CompositeContent:
    layers = tuple((each.drawing, each.cast, each.look, each.received) for each in scene.layers)
    return CompositeContent(scene.background, layers, scene.set_shadow)


def _set_shadow(scene: Scene) -> ShadowContent:
    """Return the shadow of the set itself; an empty one while no piece casts."""
    if scene.set_shadow is None:
        return ShadowContent(None, ShadowLook((0, 0, 0), 0.0, multiply=True))
    return ShadowContent(scene.set_shadow.cast, replace(scene.set_shadow.look, multiply=True))


def _set_label(document: Document, names: dict[str, str]) -> str:
    """Return the name of the set's folder and files, which no layer's may be."""
    wanted = "set"
    while wanted in names:
        wanted += "_"
    return f"{safe_names((*(layer.name for layer in document.layers), wanted))[wanted]}_shadow"


def _set_ever_casts(document: Document) -> bool:
    return any(_is_ever(piece.tracks.get(PIECE_CASTS.name), PIECE_CASTS) for piece in document.pieces)


def _frames(document: Document, request: ExportRequest) -> tuple[int, ...]:
    length = document.canvas.length_frames
    if request.frames is None:
        return tuple(range(1, length + 1))
    beyond = [frame for frame in request.frames if not 1 <= frame <= length]
    if beyond or not request.frames:
        raise UsageProblem(f"frame {beyond[0] if beyond else 'none'} is not in the cut, which has frames 1-{length}")
    return tuple(sorted(set(request.frames)))


def _layers(document: Document, request: ExportRequest) -> tuple[Layer, ...]:
    if request.layers is None:
        return tuple(layer for layer in document.layers if _is_ever_visible(layer))
    by_name = {layer.name: layer for layer in document.layers}
    for name in request.layers:
        if name not in by_name:
            near = get_close_matches(name, by_name, n=1)
            hint = (
                f"; did you mean {near[0]!r}?" if near else f", only {', '.join(map(repr, by_name)) or 'none at all'}"
            )
            raise UsageProblem(f"there is no layer {name!r} in this project{hint}")
    return tuple(layer for layer in document.layers if layer.name in request.layers)


def _is_ever_visible(layer: Layer) -> bool:
    return _is_ever(layer.tracks.get(properties.VISIBLE.name), properties.VISIBLE)


def ever_receives(layer: Layer) -> bool:
    """Return whether a layer receives the shadows of others at any time."""
    return _is_ever(layer.tracks.get(properties.RECEIVES.name), properties.RECEIVES)


def _is_ever(track: Track | None, line: Property) -> bool:
    """Whether a switch is on at any time."""
    if track is None:
        return bool(line.default)
    return any(key.value for key in track.keys) if track.is_keyed else bool(track.constant)
