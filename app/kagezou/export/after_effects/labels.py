"""Labels of layers in After Effects: the colour that a layer has in the list of Kagezou."""

from dataclasses import replace
from types import MappingProxyType
from typing import Final

from kagezou.document.model import Document
from kagezou.export.after_effects.comp import Comp, CompLayer, Footage, HandOff

NUMBERS: Final = MappingProxyType({
    "red": 1,
    "orange": 11,
    "yellow": 2,
    "green": 9,
    "blue": 8,
    "purple": 10,
    "pink": 4,
})  # fmt: skip
"""Of the label colours as After Effects has them at first; a person may have given the numbers other colours."""


def labelled(document: Document, made: HandOff) -> HandOff:
    """Return a hand-off whose footage and layers of labelled characters have the labels' numbers, others none."""
    numbers = {layer.id: NUMBERS.get(layer.marks.label, 0) for layer in document.layers}
    return replace(
        made,
        footage=tuple(_item(each, numbers) for each in made.footage),
        comps=tuple(_comp(each, numbers) for each in made.comps),
    )


def _comp(comp: Comp, numbers: dict[str, int]) -> Comp:
    return replace(comp, layers=tuple(_layer(each, numbers) for each in comp.layers))


def _item(footage: Footage, numbers: dict[str, int]) -> Footage:
    return replace(footage, label=_number(footage.tag, numbers))


def _layer(layer: CompLayer, numbers: dict[str, int]) -> CompLayer:
    return replace(layer, label=_number(layer.tag, numbers))


def _number(tag: str, numbers: dict[str, int]) -> int:
    """Return the label of the first layer whose id is a part of a tag."""
    return next((numbers[part] for part in tag.split(":") if part in numbers), 0)
