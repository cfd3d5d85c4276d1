"""Finding a layer by the name that somebody typed."""

from collections.abc import Sequence

from kagezou.document.alike_names import folded
from kagezou.document.model import Document, Layer
from kagezou.errors import UsageProblem
from kagezou.message import Message, nearest


def layer_named(document: Document, name: str) -> Layer:
    """Return the layer of a name; in another case or Unicode form if there is none of just that name.

    Raises
    ------
    UsageProblem
        There is none, with the nearest name there is.
    """
    exact = (layer for layer in document.layers if layer.name == name)
    alike = (layer for layer in document.layers if folded(layer.name) == folded(name))
    found = next(exact, None) or next(alike, None)
    if found is None:
        raise UsageProblem(no_layer(name, [layer.name for layer in document.layers]))
    return found


def no_layer(name: str, known: Sequence[str]) -> Message:
    """Return what is said where no layer has a name, with what there is."""
    near = nearest(name, known)
    if near is not None:
        return Message("there is no layer {name!r} in this project; did you mean {near!r}?", name=name, near=near)
    if known:
        others = ", ".join(map(repr, known))
        return Message("there is no layer {name!r} in this project, only {others}", name=name, others=others)
    return Message("there is no layer {name!r} in this project, only none at all", name=name)
