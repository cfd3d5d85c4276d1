"""The document and its parts: frozen values, nothing else."""

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType

from kagezou.animation.track import Track
from kagezou.geometry.box import Box

Tracks = Mapping[str, Track]
"""Property name → track; a property that is missing has its default as its constant."""

NO_TRACKS: Tracks = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Canvas:
    """The picture and its time: size in px, frames a second, and the cut's length (its last frame)."""

    width_px: int
    height_px: int
    frame_rate: Fraction = Fraction(24)
    length_frames: int = 1

    @property
    def box(self) -> Box:
        """The whole picture."""
        return Box(0, 0, self.width_px, self.height_px)


@dataclass(frozen=True, slots=True)
class Drawing:
    """One cel: its name on the sheet and its picture file. It lies centred on the canvas, pixel for pixel."""

    name: str
    path: Path


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
        after = bisect_right(self.exposures, frame, key=lambda exposure: exposure.frame)
        index = self.exposures[after - 1].drawing if after else None
        return None if index is None else self.drawings[index]

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
    """

    id: str
    name: str
    cels: Cels
    figure: Box
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)


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
    """

    id: str
    name: str
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)


@dataclass(frozen=True, slots=True)
class Document:
    """A cut: canvas, background picture, character layers from bottom to top, the scene's properties and its set."""

    canvas: Canvas
    background: Path | None = None
    layers: tuple[Layer, ...] = ()
    tracks: Tracks = field(default_factory=lambda: NO_TRACKS)
    pieces: tuple[Piece, ...] = ()

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
