"""What a script wishes to have exported, and the requests that are made of it."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.export import HandOffRequest
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.layered_frames import LAYERED_FRAMES
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS
from kagezou.export.exporters.table import SCENES, AnyExporter
from kagezou.export.exporters.video_file import VIDEO_FILE
from kagezou.export.file_names import USUAL, FileNames
from kagezou.export.request import DEPTHS, ExportRequest, Missing
from kagezou.export.video import VideoRequest
from kagezou.interface.values import AnyPath, FrameChoice, frames_of, path_of
from kagezou.io.files.processors import processors
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class Frames:
    """Numbered frames of shadows, each layer's in a folder of its own, or with ``layered`` of all layers in one file.

    Parameters
    ----------
    folder
        Where the folders are made.
    frames
        Which frames.
    layers
        Names of layers; None for all.
    format, depth
        ``png``, ``tga``, ``tiff``, ``exr``; layered ``psd`` or ``exr``; and bits a channel. None for the usual ones.
    composite, united, receivers, guides
        What is written besides, as ``kagezou render`` has it.
    names, start_frame, padding
        How files are called, such as ``"{layer}_{kind}.{frame}"``, the number of the first, and digits; None as usual.
    skip_existing
        Whether whole frames are left alone that would come out the same.
    keep_going
        Whether the other frames are made when a drawing cannot be read.
    missing
        Where a drawing is not there: ``fail`` makes nothing, ``empty`` the frame without it, ``hold`` the one with the
        drawing before it, else after it.
    """

    folder: AnyPath
    frames: FrameChoice = None
    layers: tuple[str, ...] | None = None
    format: str | None = None
    depth: int | None = None
    layered: bool = False
    composite: bool = False
    united: bool = False
    receivers: bool = False
    guides: bool = False
    names: str | None = None
    start_frame: int | None = None
    padding: int | None = None
    skip_existing: bool = False
    keep_going: bool = False
    missing: str = "fail"


@dataclass(frozen=True, slots=True)
class Video:
    """A video: the finished picture, or with ``layer`` that layer's shadow alone; ``.mp4``, or ``.mov`` with alpha.

    ``missing`` as of `Frames`.
    """

    path: AnyPath
    frames: FrameChoice = None
    layer: str | None = None
    missing: str = "fail"


@dataclass(frozen=True, slots=True)
class AfterEffects:
    """A folder of footage and a script that builds the composition, as ``kagezou export-ae`` writes it.

    ``name`` is that of composition and script; None for that of the project. ``missing`` as of `Frames`.
    """

    folder: AnyPath
    name: str | None = None
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    controls: bool = False
    format: str = "png"
    depth: int = 8
    skip_existing: bool = False
    missing: str = "fail"


@dataclass(frozen=True, slots=True)
class SceneFor:
    """All layers and a scene that lays them, for a program as ``kagezou export-scene --for`` names it.

    ``missing`` as of `Frames`.
    """

    folder: AnyPath
    program: str
    name: str | None = None
    depth: int = 8
    missing: str = "fail"


ExportWish: TypeAlias = Frames | Video | AfterEffects | SceneFor


def asked(wish: ExportWish, document: Document, project: Path | None) -> tuple[AnyExporter, Any, Place]:
    """Return the exporter of a wish, the request that is made of it, and the place it goes to.

    Raises
    ------
    UsageProblem
        There can be no such export.
    """
    stem = "cut" if project is None else project.stem
    match wish:
        case Frames():
            exporter = LAYERED_FRAMES if wish.layered else SHADOW_LAYERS
            return exporter, _frames(wish), Place(path_of(wish.folder), project, stem)
        case Video():
            path = path_of(wish.path)
            return VIDEO_FILE, _video(wish, path), Place(path.parent, project, stem)
        case AfterEffects():
            name = wish.name or stem
            return HAND_OFF, _hand_off(wish, name), Place(path_of(wish.folder), project, name)
        case SceneFor():
            return _scene(wish, document, Place(path_of(wish.folder), project, wish.name or stem))


def _frames(wish: Frames) -> ExportRequest:
    form = wish.format or ("psd" if wish.layered else "png")
    return ExportRequest(
        folder=path_of(wish.folder),
        frames=frames_of(wish.frames),
        layers=wish.layers,
        format=form,
        depth=wish.depth or DEPTHS.get(form, (8,))[0],
        composite=wish.composite,
        skip_existing=wish.skip_existing,
        workers=processors(),
        keep_going=wish.keep_going,
        missing=_missing(wish.missing),
        layered=wish.layered,
        receivers=wish.receivers,
        united=wish.united,
        guides=wish.guides,
        names=FileNames(wish.names or USUAL, wish.start_frame, wish.padding),
    )


def _missing(word: str) -> Missing:
    try:
        return Missing(word)
    except ValueError as error:
        words = ", ".join(Missing)
        raise UsageProblem(Message("missing is one of {words}, not {word!r}", words=words, word=word)) from error


def _video(wish: Video, path: Path) -> VideoRequest:
    return VideoRequest(path, frames_of(wish.frames), wish.layer, processors(), _missing(wish.missing))


def _hand_off(wish: AfterEffects, name: str) -> HandOffRequest:
    return HandOffRequest(
        folder=path_of(wish.folder),
        name=name,
        per_drawing=wish.per_drawing,
        copies=wish.copies,
        mattes=wish.mattes,
        controls=wish.controls,
        format=wish.format,
        depth=wish.depth,
        skip_existing=wish.skip_existing,
        workers=processors(),
        missing=_missing(wish.missing),
    )


def _scene(wish: SceneFor, document: Document, place: Place) -> tuple[AnyExporter, Any, Place]:
    exporter = next((each for each in SCENES if each.program == wish.program), None)
    if exporter is None:
        known = ", ".join(each.program for each in SCENES)
        raise UsageProblem(
            Message("there are no scenes for {program!r}, only for {known}", program=wish.program, known=known)
        )
    choices = ExportChoices(exporter.key, depth=wish.depth, missing=_missing(wish.missing).value)
    return exporter, exporter.request(document, choices, place), place
