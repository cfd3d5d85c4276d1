"""What handles are placed by and drags start from: one frame of a document, worked out once."""

from dataclasses import dataclass
from math import cos, radians, sin

from kagezou.document import properties
from kagezou.document.address import Address, tracks_of
from kagezou.document.edits import set_value
from kagezou.document.model import Document, Layer
from kagezou.document.property import AnyProperty, Property, Scope
from kagezou.document.values import T, value_at
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Point2, Vector3, Vector4
from kagezou.scene.evaluate import camera_at, contact_of, ground_at, light_at
from kagezou.scene.figure_card import card_at
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.scene.placing import drawing_of, figure_box, shown_parts
from kagezou.tools.view import CanvasView


@dataclass(frozen=True, slots=True)
class FrameGeometry:
    """One frame seen by one person: the document, the layer worked on, the view, and the geometry that follows.

    ``layer`` and ``card`` are both None where no layer is worked on, ``piece_id`` where no set piece is; ``piece`` is
    None also where that piece is not seen. The view gives handles on arms their constant length on screen.
    """

    document: Document
    frame: int
    view: CanvasView
    layer: Layer | None
    camera: Camera
    ground: Plane
    light: Vector4
    card: Card | None
    piece_id: str | None = None
    piece: PieceFrame | None = None

    @classmethod
    def of(
        cls, document: Document, frame: int, layer_id: str | None, view: CanvasView, piece_id: str | None = None
    ) -> "FrameGeometry":
        """Work a frame out; KeyError where the document has no such layer or set piece."""
        camera, ground = camera_at(document, frame), ground_at(document, frame)
        layer = None if layer_id is None else document.layer(layer_id)
        card = None if layer is None else card_at(document, layer, frame, camera, ground)
        piece = None if piece_id is None else piece_frame(document.piece(piece_id), frame, camera, ground)
        light = light_at(document, frame, ground)
        return cls(document, frame, view, layer, camera, ground, light, card, piece_id, piece)

    @property
    def is_sun(self) -> bool:
        """Whether the light is the sun rather than a lamp."""
        return self.light[3] == 0

    @property
    def contact(self) -> Vector3:
        """Where the character stands on the ground, world px; without a layer the ground's position."""
        return self.ground.origin if self.card is None else contact_of(self.card, self.ground)

    @property
    def figure_box(self) -> Box:
        """The figure of the layer worked on as it is seen, moved cels and parts included; empty without a layer."""
        return Box(0, 0, 0, 0) if self.figure is None else figure_box(self.document, self.figure.id, self.frame)

    @property
    def figure(self) -> Layer | None:
        """The layer of the figure that the layer worked on belongs to."""
        if self.layer is None or self.layer.joins is None:
            return self.layer
        return self.document.layer(self.layer.joins)

    @property
    def is_figure_shown(self) -> bool:
        """Whether anything of that figure casts a shadow."""
        if self.figure is None or not value_at(self.figure.tracks, properties.VISIBLE, self.frame):
            return False
        parts = shown_parts(self.document, self.figure.id, self.frame)
        return any(drawing_of(self.document, part, self.frame) is not None for part in parts)

    @property
    def along(self) -> Point2:
        """The ground line's direction on the canvas, unit length, to the right."""
        roll = radians(self.value(properties.GROUND_ROLL))
        return (cos(roll), sin(roll))

    @property
    def across(self) -> Point2:
        """The direction on the canvas square to the ground line, unit length, downward."""
        x, y = self.along
        return (-y, x)

    def address(self, prop: AnyProperty) -> Address:
        """Return where a property of the document, or of the layer or set piece worked on, lives."""
        if prop.scope is Scope.PIECE:
            return Address(prop, piece_id=self.piece_id)
        return Address(prop, self.layer.id if self.layer is not None and prop.scope is Scope.LAYER else None)

    def value(self, prop: Property[T], document: Document | None = None) -> T:
        """Return the value at the frame, here or in another version of the document."""
        return value_at(tracks_of(document or self.document, self.address(prop)), prop, self.frame)

    def edited(self, prop: AnyProperty, raw: object, document: Document | None = None) -> Document:
        """Return the document with a property set at the frame; numbers are kept to the property's range."""
        if isinstance(raw, float):
            raw = min(max(raw, prop.low), prop.high)
        return set_value(document or self.document, self.address(prop), raw, self.frame)
