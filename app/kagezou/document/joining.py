"""Which figure a layer is a part of, by the names and paths that people write (``layers.NAME.joins``)."""

from dataclasses import dataclass

from kagezou.document.edits import join_layer
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class JoinPath:
    """What a layer joins, as something that can be set: it is one for the whole cut and has no keys."""

    layer_id: str


def join_path(document: Document, path: str) -> JoinPath | None:
    """Return what ``layers.NAME.joins`` names; None for any other path."""
    named = [layer.id for layer in document.layers if path == f"layers.{layer.name}.joins"]
    return JoinPath(named[0]) if named else None


def joins(document: Document, path: JoinPath) -> str:
    """Return the name of the layer whose figure a layer is a part of; empty for a figure of its own."""
    figure_id = document.layer(path.layer_id).joins
    return "" if figure_id is None else document.layer(figure_id).name


def joined(document: Document, path: JoinPath, raw: object, frame: int | None = None) -> Document:
    """Make a layer a part of the figure with a name, or with "" a figure of its own.

    Raises
    ------
    UsageProblem
        There is no such layer, it would join itself, or a key is asked for.
    """
    if frame is not None:
        raise UsageProblem(Message("what a layer joins holds for the whole cut and has no keys"))
    if raw == "":
        return join_layer(document, path.layer_id, None)
    found = [layer.id for layer in document.layers if layer.name == raw]
    if not found:
        raise UsageProblem(Message("there is no layer {name!r} to be joined", name=raw))
    return join_layer(document, path.layer_id, found[0])
