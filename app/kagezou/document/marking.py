"""Edits of what is marked on layers, and what the marks mean to whoever edits and looks."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from types import MappingProxyType

from kagezou.animation.track import Track
from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.document.model import Document, Layer
from kagezou.document.properties import VISIBLE
from kagezou.errors import UsageProblem
from kagezou.message import Message


def set_marks(document: Document, layer_ids: Iterable[str], change: Callable[[LayerMarks], LayerMarks]) -> Document:
    """Change the marks of layers.

    Raises
    ------
    UsageProblem
        There is no such colour.
    """
    ids = frozenset(layer_ids)
    changed = tuple(replace(each, marks=change(each.marks)) if each.id in ids else each for each in document.layers)
    for layer in changed:
        if layer.marks.label not in ("", *LABELS):
            raise UsageProblem(
                Message("{label!r} is no colour of a label: {known}", label=layer.marks.label, known=", ".join(LABELS))
            )
    return document if changed == document.layers else replace(document, layers=changed)


def locked_and_changed(before: Document, after: Document) -> tuple[str, ...]:
    """Return the names of the locked layers that an edit would change or take away.

    Their marks may change, or nobody could unlock them, and so may all that a canvas of another size takes along.
    """
    if before.layers is after.layers or (before.canvas.width_px, before.canvas.height_px) != (
        after.canvas.width_px,
        after.canvas.height_px,
    ):
        return ()
    now = {layer.id: layer for layer in after.layers}
    locked = (layer for layer in before.layers if layer.marks.is_locked)
    return tuple(layer.name for layer in locked if _is_changed(layer, now.get(layer.id)))


def soloed(document: Document) -> Document:
    """Return the document as it is looked at: where layers are looked at alone, with the others of their figures.

    The same document where there is none.
    """
    alone = {layer.joins or layer.id for layer in document.layers if layer.marks.is_solo}
    if not alone:
        return document
    hidden = Track(False)  # noqa: FBT003 - a value of a track

    def shown(layer: Layer) -> Layer:
        if (layer.joins or layer.id) in alone:
            return layer
        return replace(layer, tracks=MappingProxyType({**layer.tracks, VISIBLE.name: hidden}))

    return replace(document, layers=tuple(shown(layer) for layer in document.layers), linked=frozenset())


def _is_changed(before: Layer, after: Layer | None) -> bool:
    return after is None or (after is not before and replace(after, marks=before.marks) != before)
