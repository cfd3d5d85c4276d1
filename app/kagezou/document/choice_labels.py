"""What the choices of properties are called."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from kagezou.message import Message

CHOICE_LABELS: Final[Mapping[str, Message]] = MappingProxyType({
    "point": Message("Lamp"),
    "sun": Message("Sun"),
    "solid": Message("Solid"),
    "translucent": Message("Translucent"),
    "multiply": Message("Multiply"),
    "normal": Message("Normal"),
    "ones": Message("On ones"),
    "exposures": Message("With the drawings"),
    "wall": Message("Wall"),
    "box": Message("Box"),
    "steps": Message("Steps", "a set piece to walk up"),
    "ramp": Message("Ramp"),
    "cylinder": Message("Cylinder"),
    "sphere": Message("Sphere"),
    "mesh": Message("3-D set"),
    "none": Message("Not at all"),
    "wireframe": Message("Wireframe"),
    "clay": Message("Clay"),
    "y": Message("Y"),
    "z": Message("Z"),
})  # fmt: skip
"""By the words of files and command line; a test sees to it that every choice of the table is here."""
