"""The pictures of an export, each one once, with every file that holds it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.document import properties
from kagezou.document.model import Document, Drawing, Layer
from kagezou.document.set_properties import PIECE_CASTS
from kagezou.document.values import rgb_at
from kagezou.errors import UsageProblem
from kagezou.export.choice import chosen_frames, chosen_layers, is_ever
from kagezou.export.names import digits_for, safe_names
from kagezou.export.receivers import ReceiverContent, receiver_content, receivers_of
from kagezou.export.request import RECEIVED, RECEIVERS, SHADOWS, ExportRequest
from kagezou.geometry.camera import Camera
from kagezou.message import Message
from kagezou.picture_source import PictureSource, file_of
from kagezou.scene.evaluate import evaluate
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.scene import LayerScene, Received, Scene, SetShadow, ShadowCast, ShadowLook

COMPOSITE: Final = "composite"
"""The folder and the first part of the files of composites."""
LAYERED: Final = "layered"
"""The same of frames that hold all layers in one file."""


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
    """All that decides a composite but its size and format: the background and each layer, from the bottom.

    ``clay`` is what imported sets drawn as clay are seen with, and they themselves; None without any.
    """

    background: PictureSource | None
    layers: tuple[tuple[Drawing | None, ShadowCast | None, ShadowLook, Received | None], ...]
    set_shadow: SetShadow | None = None
    clay: tuple[Camera, tuple[PieceScene, ...]] | None = None


@dataclass(frozen=True, slots=True)
class LayeredContent:
    """All that decides a frame of layers but its size and format.

    Parameters
    ----------
    picture
        What its layers show.
    layers
        Ids and names of the characters, from the bottom, also of those that this frame does not show.
    has_set
        Whether the set casts a shadow at any time.
    receiving
        Ids of the characters that receive the shadows of others at any time.
    """

    picture: CompositeContent
    layers: tuple[tuple[str, str], ...]
    has_set: bool
    receiving: frozenset[str] = frozenset()


Content = ShadowContent | ReceivedContent | ReceiverContent | CompositeContent | LayeredContent

_Picture = tuple[str, Content, LayerScene | None]
"""Its folder's name, what it shows, and the layer it is drawn from."""


_UNSEEN = ShadowContent(None, ShadowLook((255, 255, 255), 0.0, multiply=True))
"""The matte of a receiver that is not there."""


@dataclass(frozen=True, slots=True)
class OutputFile:
    """One file of an export."""

    frame: int
    path: Path


@dataclass(frozen=True, slots=True)
class FrameJob:
    """One picture and the files it goes into.

    Parameters
    ----------
    content
        What it shows; equal contents have equal pixels.
    scene, layer
        What to draw it from: the first frame that shows it; the layer is None for a composite, a frame of layers, an
        empty shadow and the set's.
    targets
        In the order of their frames, never empty.
    """

    content: Content
    scene: Scene
    layer: LayerScene | None
    targets: tuple[OutputFile, ...]

    @property
    def mattes(self) -> tuple[PictureSource, ...]:
        """The drawings whose alpha it needs."""
        if isinstance(self.content, ReceivedContent):
            received = self.content.received
            casting = (cast.drawing.source for shade in received.shades for cast in shade.casts)
            return tuple(dict.fromkeys((received.drawing.source, *casting)))
        if not isinstance(self.content, ShadowContent):
            return ()
        return (self.content.cast.drawing.source,) if isinstance(self.content.cast, ShadowCast) else ()

    @property
    def cels(self) -> tuple[PictureSource, ...]:
        """The drawings it needs in colour."""
        if self._picture is None:
            return ()
        return tuple(drawing.source for drawing, *_ in self._picture.layers if drawing is not None)

    @property
    def pictures(self) -> tuple[PictureSource, ...]:
        """All that it is made of, but for sets."""
        background = None if self._picture is None else self._picture.background
        return (*self.mattes, *self.cels, *([background] if background is not None else []))

    @property
    def sources(self) -> tuple[Path, ...]:
        """Every file it is made of."""
        return (*map(file_of, self.pictures), *self.sets)

    @property
    def sets(self) -> tuple[Path, ...]:
        """The files of imported sets that it needs."""
        if isinstance(self.content, ReceivedContent):
            return ()
        if isinstance(self.content, ShadowContent) and self.content.cast is None:
            return ()
        return tuple(dict.fromkeys(piece.mesh.path for piece in self.scene.pieces if piece.mesh is not None))

    def only(self, targets: tuple[OutputFile, ...]) -> "FrameJob":
        """Return the job with some of its targets."""
        return replace(self, targets=targets)

    @property
    def _picture(self) -> CompositeContent | None:
        """The whole picture it shows, None for a shadow alone."""
        if isinstance(self.content, ShadowContent | ReceivedContent | ReceiverContent):
            return None
        return self.content.picture if isinstance(self.content, LayeredContent) else self.content


@dataclass(frozen=True, slots=True)
class Plan:
    """Everything an export is to make: the pictures in the order of their first frames, folders and names."""

    jobs: tuple[FrameJob, ...]
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
    if request.layered:
        return _layered_plan(document, request)
    frames = chosen_frames(document, request)
    layers = chosen_layers(document, request)
    names = safe_names(layer.name for layer in document.layers)
    receiving = [layer for layer in layers if ever_receives(layer)] if request.only in (None, RECEIVED) else []
    layers = layers if request.only in (None, SHADOWS) else ()
    folders = [request.folder / f"{names[layer.name]}_shadow" for layer in layers]
    folders += [request.folder / f"{names[layer.name]}_received" for layer in receiving]
    has_set = request.layers is None and request.only in (None, SHADOWS) and _set_ever_casts(document)
    set_label = _set_label(document, names) if has_set else None
    if set_label is not None:
        folders.append(request.folder / set_label)
    receivers = receivers_of(document) if request.receivers or request.only == RECEIVERS else ()
    folders += [request.folder / each.label for each in receivers]
    if request.composite:
        folders.append(request.folder / COMPOSITE)
    if not folders:
        raise UsageProblem(Message("there is nothing to render: the project has no visible character layer"))
    digits = digits_for(document.canvas.length_frames)
    first: dict[Content, FrameJob] = {}
    targets: dict[Content, list[OutputFile]] = {}
    for frame in frames:
        scene = evaluate(document, frame)
        pictures: list[_Picture] = []
        pictures += [(f"{names[each.name]}_shadow", *_shadow(each, scene, frame)) for each in layers]
        pictures += [(f"{names[each.name]}_received", *_received(each, scene, frame)) for each in receiving]
        if set_label is not None:
            pictures.append((set_label, _set_shadow(scene), None))
        pictures += [
            (each.label, receiver_content(document, scene, frame, each) or _UNSEEN, None) for each in receivers
        ]
        if request.composite:
            pictures.append((COMPOSITE, _composite(scene), None))
        for label, content, layer_scene in pictures:
            path = request.folder / label / f"{label}_{frame:0{digits}d}{request.suffix}"
            first.setdefault(content, FrameJob(content, scene, layer_scene, ()))
            targets.setdefault(content, []).append(OutputFile(frame, path))
    jobs = tuple(job.only(tuple(targets[content])) for content, job in first.items())
    if request.once:
        jobs = tuple(_each_once(jobs, digits))
    return Plan(jobs, tuple(folders), {layer.name: names[layer.name] for layer in (*layers, *receiving)})


def _layered_plan(document: Document, request: ExportRequest) -> Plan:
    """Return the frames of layers: with some layers chosen they hold those alone."""
    layers = chosen_layers(document, request)
    is_all = request.layers is None
    if not layers:
        raise UsageProblem(Message("there is nothing to render: the project has no visible character layer"))
    ids = {layer.id for layer in layers}
    names = tuple((layer.id, layer.name) for layer in layers)
    has_set = is_all and _set_ever_casts(document)
    receiving = frozenset(layer.id for layer in layers if ever_receives(layer))
    folder, digits = request.folder / LAYERED, digits_for(document.canvas.length_frames)
    first: dict[Content, FrameJob] = {}
    targets: dict[Content, list[OutputFile]] = {}
    for frame in chosen_frames(document, request):
        scene = evaluate(document, frame)
        if not is_all:
            chosen = tuple(layer for layer in scene.layers if layer.id in ids)
            scene = replace(scene, background=None, layers=chosen, set_shadow=None)
        content = LayeredContent(_composite(scene), names, has_set, receiving)
        path = folder / f"{LAYERED}_{frame:0{digits}d}{request.suffix}"
        first.setdefault(content, FrameJob(content, scene, None, ()))
        targets.setdefault(content, []).append(OutputFile(frame, path))
    jobs = tuple(job.only(tuple(targets[content])) for content, job in first.items())
    return Plan(jobs, (folder,), {})


def pictures_of(plan: Plan, folder: Path) -> tuple[int, ...]:
    """Return which picture, from 0 in the order in which they appear, a folder's layer shows on each of its frames."""
    shown: dict[int, int] = {}
    number = 0
    for job in plan.jobs:
        frames = [target.frame for target in job.targets if target.path.parent == folder]
        shown.update(dict.fromkeys(frames, number))
        number += bool(frames)
    return tuple(shown[frame] for frame in sorted(shown))


def _each_once(jobs: tuple[FrameJob, ...], digits: int) -> Iterator[FrameJob]:
    """Yield the jobs with one target in each folder they go to, numbered from 1."""
    numbers: dict[Path, int] = {}
    for job in jobs:
        targets = []
        for folder in dict.fromkeys(target.path.parent for target in job.targets):
            numbers[folder] = numbers.get(folder, 0) + 1
            first = next(target for target in job.targets if target.path.parent == folder)
            name = f"{folder.name}_{numbers[folder]:0{digits}d}{first.path.suffix}"
            targets.append(OutputFile(first.frame, folder / name))
        yield job.only(tuple(targets))


def _shadow(layer: Layer, scene: Scene, frame: int) -> tuple[ShadowContent, LayerScene | None]:
    """Return a layer's shadow on a frame; an empty cel and a hidden layer give an empty one."""
    seen = next((each for each in scene.layers if each.id == layer.id), None)
    if seen is None or seen.cast is None:
        return _nothing(layer, frame), None
    # How it is laid on what is under it does not change the layer itself.
    return ShadowContent(seen.cast, replace(seen.look, multiply=True)), seen


def _received(layer: Layer, scene: Scene, frame: int) -> tuple[ShadowContent | ReceivedContent, LayerScene | None]:
    """Return what falls on a layer on a frame; an empty picture where nothing can."""
    seen = next((each for each in scene.layers if each.id == layer.id), None)
    if seen is None or seen.received is None or not seen.received.shades:
        return _nothing(layer, frame), None
    return ReceivedContent(seen.received), seen


def _nothing(layer: Layer, frame: int) -> ShadowContent:
    return ShadowContent(None, ShadowLook(rgb_at(layer.tracks, properties.COLOR, frame), 0.0, multiply=True))


def _composite(scene: Scene) -> CompositeContent:
    layers = tuple((each.drawing, each.cast, each.look, each.received) for each in scene.layers)
    clay = tuple(piece for piece in scene.pieces if piece.mesh is not None and piece.display == "clay")
    return CompositeContent(scene.background, layers, scene.set_shadow, (scene.camera, clay) if clay else None)


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
    return any(is_ever(piece.tracks.get(PIECE_CASTS.name), PIECE_CASTS) for piece in document.pieces)


def ever_receives(layer: Layer) -> bool:
    """Return whether a layer receives the shadows of others at any time."""
    return is_ever(layer.tracks.get(properties.RECEIVES.name), properties.RECEIVES)
