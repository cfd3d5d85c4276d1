"""Controls of all shadows at once: which layers of a hand-off are driven by them, and what of each."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from kagezou.document.figures import height_of
from kagezou.document.model import Document
from kagezou.export.after_effects.comp import Comp, CompLayer, Driven, HandOff, Rising
from kagezou.export.after_effects.heights import risings_of
from kagezou.message import Message
from kagezou.scene.contact_patches import GONE_OF_FIGURE

_SHADOWS: Final = "shadow"
_CONTACTS: Final = "contact"
_RECEIVED: Final = "received"


def controlled(document: Document, made: HandOff) -> HandOff:
    """Return a hand-off whose shadows are driven by controls.

    Opacity, colour and softness drive what lies in the main composition: shadows, patches under feet, and what
    characters receive. The height drives each figure's own shadow, wherever it lies, and what its feet touch.
    """
    risings = risings_of(document)
    gone = {layer.id: GONE_OF_FIGURE * max(height_of(layer, 1), 1.0) for layer in document.layers}
    return replace(made, controls=True, comps=tuple(_comp(each, risings, gone) for each in made.comps))


def notes_on_controls(made: HandOff) -> tuple[Message, ...]:
    """Return what the control of the height cannot move: shadows of several figures in one picture."""
    names = [
        layer.name
        for layer in made.comps[-1].layers
        if layer.driven is not None and _owner(layer).startswith("together:")
    ]
    if not made.controls or not names:
        return ()
    return (Message("the control Height does not move {names}", names=", ".join(repr(name) for name in names)),)


def _comp(comp: Comp, risings: Mapping[str, Rising], gone: Mapping[str, float]) -> Comp:
    is_main = comp.tag == "main"
    layers = (replace(each, driven=_driven(each, risings, gone, is_main=is_main)) for each in comp.layers)
    return comp if comp.tag == "lit" else replace(comp, layers=tuple(layers))


def _driven(
    layer: CompLayer, risings: Mapping[str, Rising], gone: Mapping[str, float], *, is_main: bool
) -> Driven | None:
    kind = layer.tag.split(":", 1)[0]
    if kind not in {_SHADOWS, _CONTACTS, _RECEIVED}:
        return None
    owner = _owner(layer)
    rising = risings.get(owner) if kind == _SHADOWS else None
    driven = Driven(has_look=is_main, rising=rising, gone_px=gone.get(owner, 0.0) if kind == _CONTACTS else 0.0)
    return driven if is_main or rising is not None else None


def _owner(layer: CompLayer) -> str:
    """Return the id of the layer whose footage it shows, or what else stands there."""
    return layer.footage.split(":", 1)[1]
