"""Which properties the letter keys reveal."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.ui.timeline.rows import Reveal

_NAMES: Final = (*OF_DOCUMENT, *OF_LAYER)


def _beginning(*starts: str) -> frozenset[str]:
    return frozenset(name for name in _NAMES if name.startswith(starts))


REVEALED: Final[Mapping[str, frozenset[str]]] = MappingProxyType({
    "reveal_light": _beginning("light."),
    "reveal_ground": _beginning("ground.", "camera."),
    "reveal_contacts": frozenset({"grounding"}),
    "reveal_shape": _beginning("shadow.simplify", "shadow.distance", "shadow.elongation", "shadow.grow"),
    "reveal_tilt": frozenset({"tilt"}),
    "reveal_opacity": _beginning("shadow.opacity", "shadow.fade", "shadow.color", "shadow.tip"),
    "reveal_waves": _beginning("shadow.wave"),
    "reveal_softness": _beginning("shadow.softness", "shadow.penumbra"),
})  # fmt: skip
"""Command → names of properties."""

ANIMATED: Final = Reveal()
CHANGED: Final = Reveal(changed=True)


def toggled(now: Reveal, command: str) -> Reveal:
    """Return what a command reveals; a second time it goes back to what is keyed."""
    wanted = Reveal(REVEALED[command])
    return ANIMATED if now == wanted else wanted


def added(now: Reveal, command: str) -> Reveal:
    """Return what a command reveals beside what is revealed already."""
    return Reveal(REVEALED[command] | (now.names or frozenset()))


def animated_or_changed(now: Reveal) -> Reveal:
    """Return what is keyed; a second time, all that is not at its default."""
    return CHANGED if now == ANIMATED else ANIMATED
