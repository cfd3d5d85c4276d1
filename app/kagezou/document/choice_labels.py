"""What the choices of properties are called."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from kagezou.document.piece_kinds import TRAITS
from kagezou.message import Message

CHOICE_LABELS: Final[Mapping[str, Message]] = MappingProxyType({
    "point": Message("Lamp", "a kind of light"),
    "sun": Message("Sun"),
    "feet": Message("Feet"),
    "points": Message("Grounding points"),
    "line": Message("Ground line"),
    "cast": Message("Cast"),
    "disc": Message("Disc"),
    "solid": Message("Solid"),
    "translucent": Message("Translucent"),
    "smooth": Message("Smooth"),
    "hard": Message("Hard"),
    "casts": Message("Casts"),
    "left_out": Message("Left out"),
    "multiply": Message("Multiply"),
    "normal": Message("Normal"),
    "ones": Message("On ones"),
    "exposures": Message("With the drawings"),
    **{kind.value: traits.label for kind, traits in TRAITS.items()},
    "none": Message("Not at all"),
    "wireframe": Message("Wireframe"),
    "clay": Message("Clay"),
    "y": Message("Y"),
    "z": Message("Z"),
})  # fmt: skip
"""By the words of files and command line; a test sees to it that every choice of the table is here."""
