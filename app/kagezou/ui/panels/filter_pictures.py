"""Pictures that show what a filter does: the same shadow with three values of one property, from left to right.

``packaging/dev_filter_pictures.py`` draws them with the demo's character; the manual shows them, too.
"""

from collections.abc import Mapping
from html import escape
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Value
from kagezou.document.property import AnyProperty
from kagezou.locations import manual_folder
from kagezou.ui.system.shown_units import shown_unit
from kagezou.ui.system.words import translated

_WIDTH_PX: Final = 420

EXAMPLES: Final[Mapping[str, tuple[float, ...]]] = MappingProxyType(
    {
        "shadow.simplify": (0.0, 25.0, 80.0),
        "shadow.distance": (0.0, 400.0, 1200.0),
        "shadow.elongation": (0.0, 0.5, 1.0),
        "shadow.hold": (0.0, 0.5, 1.0),
        "shadow.grow": (-8.0, 0.0, 10.0),
        "shadow.softness": (0.0, 12.0, 40.0),
        "shadow.penumbra": (0.0, 0.04, 0.12),
        "shadow.fade": (0.0, 1400.0, 700.0),
        "shadow.wave1.amplitude": (0.0, 10.0, 26.0),
        "shadow.wave1.wavelength": (24.0, 60.0, 140.0),
        "shadow.wave_anchor": (0.0, 400.0, 1200.0),
        "shadow.slits": (0.0, 0.3, 0.7),
        "contact.strength": (0.0, 0.4, 0.9),
        "reflection.opacity": (0.0, 0.3, 0.7),
    }
)
"""The values that are shown of a property of a layer, by its name."""

_WAVES: Final[Mapping[str, Value]] = MappingProxyType(
    {"shadow.wave1.amplitude": 16.0, "shadow.wave1.wavelength": 60.0, "shadow.wave1.direction": 80.0}
)

COMPANIONS: Final[Mapping[str, Mapping[str, Value]]] = MappingProxyType(
    {
        "shadow.distance": {"shadow.simplify": 80.0},
        "shadow.elongation": {"shadow.simplify": 60.0},
        "shadow.hold": {"shadow.simplify": 130.0, "shadow.elongation": 0.0},
        "shadow.wave1.amplitude": {key: _WAVES[key] for key in _WAVES if not key.endswith("amplitude")},
        "shadow.wave1.wavelength": {key: _WAVES[key] for key in _WAVES if not key.endswith("wavelength")},
        "shadow.wave_anchor": _WAVES,
        "shadow.slits": {**_WAVES, "shadow.wave_anchor": 60.0},
    }
)
"""What else is set in the pictures of a property, as it does nothing by itself."""


def picture_of(name: str) -> Path:
    """Return where the picture of a property lies."""
    return manual_folder() / "pictures" / f"{name}.png"


def tip_of(prop: AnyProperty, *more: str) -> str:
    """Return the tool tip of a property: what it does, further lines, and a picture where there is one."""
    lines = [translated(prop.help), *(line for line in more if line)]
    if prop.name not in EXAMPLES:
        return "\n".join(lines)
    # Tool tips are measured only as rich text when they hold a picture.
    words = "<br>".join(escape(line) for line in lines)
    picture = f'<img src="{escape(str(picture_of(prop.name)))}" width="{_WIDTH_PX}">'
    return f"<p>{words}</p><p>{picture}<br>{escape(_values(prop))}</p>"


def _values(prop: AnyProperty) -> str:
    """Return the values in the picture, from left to right, as the inspector shows them."""
    shown = shown_unit(prop)
    return " · ".join(
        f"{value * shown.factor:g}{f' {shown.unit}' if shown.unit else ''}" for value in EXAMPLES[prop.name]
    )
