"""The document and its parts: frozen values, nothing else."""

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType

from kagezou.animation.track import Track
from kagezou.document.layer_marks import NO_MARKS, LayerMarks
from kagezou.document.note import Note
from kagezou.document.slate import NO_SLATE, Slate
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.vanishing import VanishingLines
from kagezou.picture_source import OutlinedPicture, Paper, PicturePart, PictureSource
from kagezou.standing.foot import Foot, FootPin

Tracks = Mapping[str, Track]
"""Property name → track; a property that is missing has its default as its constant."""

NO_TRACKS: Tracks = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Canvas:
    """The picture and its time: size in px, frames a second, the cut's length, and the number its first frame bears."""

    width_px: int
    height_px: int
    frame_rate: Fraction = Fraction(24)
    length_frames: int = 1
    first_frame: int = 1

    @property
    def box(self) -> Box:
        """The whole picture."""
        return Box(0, 0, self.width_px, self.height_px)


@dataclass(frozen=True, slots=True)
class Drawing:
    """One cel: its name on the sheet, its picture file, and perhaps the part of that file which it is.

    It lies centred on the canvas, pixel for pixel, unless its layer moves it.

    Parameters
    ----------
    name, path, part
        As above; ``part`` is None for a whole file.
    size_px
        Width and height of the picture; None where that is not known, which counts as the canvas's.
    figure
        The opaque part of the picture, px of the picture; None where it is not known.
    feet
        What was found in the picture, by track; None where nothing was looked for.
    pins
        What a person said about them, by track.
    paper
        Which white is clear where the file has no alpha; the same in all drawings of a layer.
    """

    name: str
    path: Path
    part: str | None = None
    size_px: tuple[int, int] | None = None
    figure: Box | None = None
    feet: tuple[Foot, ...] | None = None
    pins: tuple[FootPin, ...] = ()
    paper: Paper = Paper.WHITE

    @property
    def source(self) -> PictureSource:
        """What its pixels come from."""
        if self.part is not None:
            return PicturePart(self.path, self.part, self.paper)
        return OutlinedPicture(self.path) if self.paper is Paper.BORDER else self.path


def drawing_size(canvas: Canvas, drawing: Drawing | None) -> tuple[int, int]:
    """Return width and height of a drawing, px; the canvas's where they are not known."""
    known = None if drawing is None else drawing.size_px
    return known or (canvas.width_px, canvas.height_px)


@dataclass(frozen=True, slots=True)
class Exposure:
    """From ``frame`` on this drawing (an index) is seen, or none, until the next exposure."""

    frame: int
    drawing: int | None


@dataclass(frozen=True, slots=True)
class Cels:
    """The drawings of a layer and when each is exposed; exposures are ordered, one a frame.

    Before the first exposure nothing is seen; the last one holds to the end of the cut.
    """

    drawings: tuple[Drawing, ...] = ()
    exposures: tuple[Exposure, ...] = ()

    def drawing_at(self, frame: int) -> Drawing | None:
        """Return what is exposed at a frame, None for an empty cel."""
        index = self.index_at(frame)
        return None if index is None else self.drawings[index]

    def index_at(self, frame: int) -> int | None:
        """Return which drawing is exposed at a frame, None for an empty cel."""
        after = bisect_right(self.exposures, frame, key=lambda exposure: exposure.frame)
        return self.exposures[after - 1].drawing if after else None

    def exposed_since(self, frame: int) -> int:
        """Return the frame on which what is seen at ``frame`` came to be seen."""
        after = bisect_right(self.exposures, frame, key=lambda exposure: exposure.frame)
        return max(self.exposures[after - 1].frame, 1) if after else 1


@dataclass(frozen=True, slots=True)
class Layer:
    """A character layer and the properties of its shadow.

    Parameters
    ----------
    id
        Stable for the life of the document; never shown.
    name
        Unique in the document; part of property paths and of the names of rendered files.
    cels
        The drawings over time.
    figure
        The opaque part of the first drawing, canvas px: the measure of the character's height.
    tracks
        By layer property name.
    joins
        The id of the layer of whose figure it is a part; None for a figure of its own.
    marks
        What is marked on it to work with it; nothing that is rendered.
    """

    id: str
    name: str
    cels: Cels
    figure: Box
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)
    joins: str | None = None
    marks: LayerMarks = NO_MARKS


def drawing_offset(canvas: Canvas, layer: Layer) -> tuple[int, int]:
    """Return where the top left pixel of a layer's first drawing lies on the canvas before the layer moves it, px."""
    drawings = layer.cels.drawings
    return centred_offset(canvas.box, *drawing_size(canvas, drawings[0] if drawings else None))


@dataclass(frozen=True, slots=True)
class Marker:
    """A named place in time: from ``frame`` on, for ``duration_frames`` frames (0 for a place alone)."""

    frame: int
    comment: str = ""
    duration_frames: int = 0


@dataclass(frozen=True, slots=True)
class Piece:
    """A set piece on the ground: a wall, a box and the like, by its properties.

    Parameters
    ----------
    id
        Stable for the life of the document; never shown.
    name
        Unique in the set; part of property paths.
    tracks
        By set piece property name; its shape is one of them.
    source
        The file of an imported set, for a piece of that shape.
    """

    id: str
    name: str
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)
    source: Path | None = None


@dataclass(frozen=True, slots=True)
class BroughtLight:
    """The light that a style brought along, by which it can be taken back.

    Parameters
    ----------
    tracks
        What the style set, by names of the scene's properties.
    before
        What was there; a property that is missing had never been set.
    """

    tracks: Tracks
    before: Tracks


@dataclass(frozen=True, slots=True)
class Document:
    """A cut: canvas, background, character layers from bottom to top, the scene's properties and its set.

    Parameters
    ----------
    behind
        The background's pictures and when each is seen; without any there is none.
    work_area
        First and last frame that are played and worked on; None for the whole cut.
    markers
        In order, one a frame.
    notes
        In the order in which they were made.
    vanishing
        The edges of the floor in the background picture by which the camera was matched; None before that.
    linked
        Names of layer properties that are the same for all layers, values and keys alike.
    brought_light
        The light of the style that was put on last, if it was asked for; None otherwise.
    timesheet
        The text of the sheet that timed the cut, kept for what of it is not used here; empty where there was none.
    slate
        What the cut is called.
    """

    canvas: Canvas
    behind: Cels = field(default_factory=Cels)
    layers: tuple[Layer, ...] = ()
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)
    work_area: tuple[int, int] | None = None
    markers: tuple[Marker, ...] = ()
    notes: tuple[Note, ...] = ()
    pieces: tuple[Piece, ...] = ()
    vanishing: VanishingLines | None = None
    linked: frozenset[str] = frozenset()
    brought_light: BroughtLight | None = None
    timesheet: str = ""
    slate: Slate = NO_SLATE

    @property
    def background(self) -> PictureSource | None:
        """The first picture of the background; None where there is none."""
        return self.behind.drawings[0].source if self.behind.drawings else None

    @property
    def is_blank(self) -> bool:
        """Whether there is nothing to see."""
        return not self.layers and not self.pieces and self.background is None

    @property
    def played(self) -> tuple[int, int]:
        """First and last frame that are played: the work area as far as it lies within the cut, else the whole cut."""
        length = self.canvas.length_frames
        first, last = self.work_area or (1, length)
        return (first, min(last, length)) if first <= length else (1, length)

    def layer(self, layer_id: str) -> Layer:
        """Return the layer with this id; KeyError if there is none."""
        for layer in self.layers:
            if layer.id == layer_id:
                return layer
        raise KeyError(layer_id)

    def piece(self, piece_id: str) -> Piece:
        """Return the set piece with this id; KeyError if there is none."""
        for piece in self.pieces:
            if piece.id == piece_id:
                return piece
        raise KeyError(piece_id)
