"""What a person marks on a layer to work with it: locked, looked at alone, a colour; nothing that is rendered."""

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

LABELS: Final = MappingProxyType({
    "red": "#d9534f",
    "orange": "#e08e3c",
    "yellow": "#d9c34a",
    "green": "#6fae5a",
    "blue": "#5a93d1",
    "purple": "#9c78c9",
    "pink": "#d47fa6",
})  # fmt: skip
"""The colours a layer may be labelled with, by their words; none is the empty word."""


@dataclass(frozen=True, slots=True)
class LayerMarks:
    """The marks of one layer.

    Parameters
    ----------
    is_locked
        Whether it is not to be changed by hand.
    is_solo
        Whether it is looked at alone; exports show all layers as ever.
    label
        A colour of `LABELS`, or empty.
    """

    is_locked: bool = False
    is_solo: bool = False
    label: str = ""


NO_MARKS: Final = LayerMarks()
