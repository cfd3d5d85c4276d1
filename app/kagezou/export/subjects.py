"""What a sequence of an export shows, from frame to frame."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.document.values import rgb_at, value_at
from kagezou.export.contents import (
    BlankContent,
    CompositeContent,
    Content,
    ReceiverContent,
    ReflectionContent,
    SetShadowContent,
    ShadowContent,
    UnitedContent,
)
from kagezou.scene.companions import contact_layer
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import LayerScene, Scene

if TYPE_CHECKING:  # what few exports show is loaded by those
    from kagezou.export.layered import LayeredContent
    from kagezou.export.layers_of_frame import LayerOfFrame

SET: Final = "set"
SET_UNDER: Final = "set_under"
GROUND: Final = "ground"
EVERYTHING: Final = "everything"
"""Stand where layers and set pieces have their ids, which are all of another form."""

_OVER: Final = ":over"

_BLACK: Final = (0, 0, 0)
_WHITE: Final = (255, 255, 255)


@dataclass(frozen=True, slots=True)
class _OfLayer:
    """Something of a layer, by its id."""

    layer_id: str

    @property
    def owner(self) -> str:
        """Whose it is: the layer's id."""
        return self.layer_id


@dataclass(frozen=True, slots=True)
class ShadowSubject(_OfLayer):
    """A character's shadow on the ground and the set."""

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the shadow; an empty cel and a hidden layer have an empty one."""
        seen = _seen(scene, self.layer_id)
        if seen is None or seen.cast is None:
            return _nothing(document, self.layer_id, scene, frame)
        return ShadowContent.of(scene, seen, seen.cast)


@dataclass(frozen=True, slots=True)
class UnitedSubject:
    """The shadows of layers, by their ids from the bottom, that unite over the whole cut."""

    layer_ids: tuple[str, ...]

    @property
    def owner(self) -> str:
        """Whose it is: the ids, behind a word that no id begins with."""
        return f"united:{','.join(self.layer_ids)}"

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the united shadow; one alone is the layer's own, and where there is none the picture is empty."""
        layers = tuple(layer for layer in scene.layers if layer.id in self.layer_ids and layer.cast is not None)
        if len(layers) > 1:
            return UnitedContent.of(scene, layers)
        return ShadowSubject(layers[0].id if layers else self.layer_ids[0]).content_at(document, scene, frame)


@dataclass(frozen=True, slots=True)
class TogetherSubject:
    """Shadows of several layers, by their ids from the bottom, that are handed over together.

    ``multiply`` and ``is_over`` are as of `ReceivedSubject`.
    """

    layer_ids: tuple[str, ...]
    multiply: bool = True
    is_over: bool = False

    @property
    def owner(self) -> str:
        """Whose it is: that of the lowest, behind a word that no id begins with."""
        return f"together:{self.layer_ids[0]}{_OVER if self.is_over else ''}"

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the shadows; an empty picture where none is."""
        layers = tuple(layer for layer in scene.layers if layer.id in self.layer_ids and layer.cast is not None)
        if not any(layer.look.multiply == self.multiply for layer in layers):
            return _nothing(document, self.layer_ids[0], scene, frame)
        from kagezou.export.mixed_contents import TogetherContent

        return TogetherContent.of(scene, layers, multiply=self.multiply)


@dataclass(frozen=True, slots=True)
class ReceivedSubject(_OfLayer):
    """What other characters cast on one.

    Parameters
    ----------
    multiply
        Whether it is of the shadows that multiply what is under them, or of the others.
    is_over
        Whether it lies over another of both.
    """

    multiply: bool = True
    is_over: bool = False

    @property
    def owner(self) -> str:
        """Whose it is: the layer's id, and a word behind it for what lies over another."""
        return self.layer_id + (_OVER if self.is_over else "")

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return what falls on the layer; an empty picture where nothing can."""
        seen = _seen(scene, self.layer_id)
        received = None if seen is None else seen.received
        ways = () if received is None else {shade.look.multiply for shade in received.shades}
        if seen is None or received is None or self.multiply not in ways:
            return _nothing(document, self.layer_id, scene, frame)
        from kagezou.export.mixed_contents import ReceivedContent

        return ReceivedContent(scene, seen, received, self.multiply)


@dataclass(frozen=True, slots=True)
class ContactSubject(_OfLayer):
    """The dark patches under a character's feet."""

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the patches; an empty picture where there are none."""
        seen = _seen(scene, self.layer_id)
        patches = None if seen is None else contact_layer(seen)
        if patches is None or patches.cast is None:
            return _nothing(document, self.layer_id, scene, frame)
        return ShadowContent.of(scene, patches, patches.cast)


@dataclass(frozen=True, slots=True)
class ReflectionSubject(_OfLayer):
    """A character mirrored in the ground."""

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the reflection; an empty picture where there is none."""
        seen = _seen(scene, self.layer_id)
        if seen is None or seen.reflection is None:
            return _nothing(document, self.layer_id, scene, frame)
        return ReflectionContent(scene, seen, seen.reflection)


@dataclass(frozen=True, slots=True)
class SetShadowSubject:
    """The shadow of the set itself."""

    @property
    def owner(self) -> str:
        """Whose it is: `SET`."""
        return SET

    def content_at(self, _document: Document, scene: Scene, _frame: int) -> Content:
        """Return the shadow; an empty one while no piece casts."""
        if scene.set_shadow is None:
            return BlankContent(scene, _BLACK)
        return SetShadowContent.of(scene, scene.set_shadow)


@dataclass(frozen=True, slots=True)
class ClaySubject:
    """Imported sets drawn as clay, over the background picture or under it."""

    is_under: bool = False

    @property
    def owner(self) -> str:
        """Whose it is: `SET` or `SET_UNDER`."""
        return SET_UNDER if self.is_under else SET

    def content_at(self, _document: Document, scene: Scene, _frame: int) -> Content:
        """Return the sets; an empty picture while none is drawn there."""
        from kagezou.export.clay import ClayContent

        return ClayContent.of(scene, is_under=self.is_under) or BlankContent(scene, _BLACK)


@dataclass(frozen=True, slots=True)
class ReceiverSubject:
    """Where the ground, or a set piece by its id, is seen."""

    piece_id: str | None

    @property
    def owner(self) -> str:
        """Whose it is: the piece's id, or `GROUND`."""
        return self.piece_id or GROUND

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the matte; an empty one where the receiver is not there."""
        has_ground = value_at(document.tracks, GROUND_RECEIVES, frame)
        pieces = tuple(
            replace(piece, casts=piece.id == self.piece_id, blocks=False, receives=False) for piece in scene.pieces
        )
        if not (has_ground if self.piece_id is None else any(piece.casts for piece in pieces)):
            return BlankContent(scene, _WHITE)
        return ReceiverContent(scene, SetCast(scene.camera, scene.ground, pieces, (), has_ground))


@dataclass(frozen=True, slots=True)
class CompositeSubject:
    """Background, shadows and characters in one picture, perhaps with ground, set and feet as lines over them."""

    with_guides: bool = False

    @property
    def owner(self) -> str:
        """Whose it is: `EVERYTHING`."""
        return EVERYTHING

    def content_at(self, document: Document, scene: Scene, frame: int) -> Content:
        """Return the finished picture."""
        if not self.with_guides:
            return CompositeContent.of(scene)
        from kagezou.scene.guide_lines import guide_lines

        return CompositeContent.of(scene, guide_lines(document, frame))


@dataclass(frozen=True, slots=True)
class LayeredSubject:
    """Frames that hold all layers in one file.

    Parameters
    ----------
    layers
        The characters, from the bottom.
    has_set
        Whether the set casts a shadow at any time.
    is_whole
        Whether background and set are in it; else the characters alone are.
    clay
        As of `LayeredContent`.
    """

    layers: "tuple[LayerOfFrame, ...]"
    has_set: bool
    is_whole: bool
    clay: tuple[bool, ...] = ()

    @property
    def owner(self) -> str:
        """Whose it is: `EVERYTHING`."""
        return EVERYTHING

    def content_at(self, _document: Document, scene: Scene, _frame: int) -> "LayeredContent":
        """Return the frame; every one has the same list of layers."""
        from kagezou.export.layered import LayeredContent

        if not self.is_whole:
            ids = {layer.id for layer in self.layers}
            chosen = tuple(layer for layer in scene.layers if layer.id in ids)
            pieces = tuple(replace(piece, display="none") for piece in scene.pieces)
            scene = replace(scene, background=None, layers=chosen, pieces=pieces, set_shadow=None)
        return LayeredContent(scene, CompositeContent.of(scene), self.layers, self.has_set, self.clay)


Subject = (
    ShadowSubject
    | UnitedSubject
    | TogetherSubject
    | ReceivedSubject
    | ContactSubject
    | ReflectionSubject
    | SetShadowSubject
    | ClaySubject
    | ReceiverSubject
    | CompositeSubject
    | LayeredSubject
)


def _seen(scene: Scene, layer_id: str) -> LayerScene | None:
    return next((each for each in scene.layers if each.id == layer_id), None)


def _nothing(document: Document, layer_id: str, scene: Scene, frame: int) -> Content:
    return BlankContent(scene, rgb_at(document.layer(layer_id).tracks, properties.COLOR, frame))
