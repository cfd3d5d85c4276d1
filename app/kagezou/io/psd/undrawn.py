"""What psd-tools cannot draw with what is installed here, and how it is left out so that the rest is drawn."""

# ruff: noqa: SLF001 - an effects block has no public switch

import functools
import platform
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from typing import Any, Final

_DRAWN_EFFECTS: Final = frozenset({"coloroverlay", "gradientoverlay", "patternoverlay", "stroke"})
_BY_SCIPY: Final = frozenset({"gradientoverlay", "stroke"})
_ADJUSTED: Final = frozenset({"exposure", "invert", "levels", "posterize", "threshold"})
_ADJUSTED_BY_SCIPY: Final = frozenset({"brightnesscontrast", "curves", "huesaturation"})
_SWITCH: Final = b"masterFXSwitch"

_GRADIENT_FILL: Final = "GradientFill"
_VECTOR_STROKE: Final = "VectorStroke"
_BY_EXTRA: Final = _DRAWN_EFFECTS | _ADJUSTED_BY_SCIPY | {_GRADIENT_FILL.lower()}
"""What is left out only where scipy is: an effect that needs none is left out beside one that does."""


def undrawn_in(layer: Any) -> tuple[str, ...]:
    """Return the names of what a layer has itself and that will not be seen."""
    names = _effects(layer)
    if not _loses_effects(layer):
        names = [name for name in names if name.lower() not in _DRAWN_EFFECTS]
    return tuple(dict.fromkeys([*names, *([_unfilled(layer)] if _unfilled(layer) else [])]))


def drawn_by_extra(names: Iterable[str]) -> tuple[str, ...]:
    """Return those of the ``names`` of what is left out that the packages of the extra ``psd`` would draw."""
    return tuple(
        name for name in names if name.lower() in _BY_EXTRA or (name == _VECTOR_STROKE and _has_aggdraw_in_extra())
    )


@contextmanager
def without_undrawn(layers: Iterable[Any]) -> Iterator[None]:
    """Hide fills that cannot be drawn, and switch off the effects of layers that have such ones, for the block."""
    hidden = [layer for layer in layers if layer.visible and _unfilled(layer)]
    switches = [layer.effects._data[_SWITCH] for layer in layers if _loses_effects(layer)]
    try:
        for layer in hidden:
            layer.visible = False
        for switch in switches:
            switch.value = False
        yield
    finally:
        for switch in switches:
            switch.value = True
        for layer in hidden:
            layer.visible = True


def _effects(layer: Any) -> list[str]:
    return [type(effect).__name__ for effect in layer.effects if effect.enabled] if layer.has_effects() else []


def _loses_effects(layer: Any) -> bool:
    return not _is_there("scipy") and any(name.lower() in _BY_SCIPY for name in _effects(layer))


def _unfilled(layer: Any) -> str:
    """Return the name of the kind of a layer that cannot be drawn at all, or an empty text."""
    from psd_tools.api.layers import AdjustmentLayer

    has_scipy = _is_there("scipy")
    if layer.kind == "gradientfill" and not has_scipy:
        return _GRADIENT_FILL
    known = _ADJUSTED | _ADJUSTED_BY_SCIPY if has_scipy else _ADJUSTED
    if isinstance(layer, AdjustmentLayer) and layer.kind not in known:
        return type(layer).__name__
    if layer.kind == "shape" and layer.has_stroke() and layer.stroke.enabled and not _is_there("aggdraw"):
        return _VECTOR_STROKE
    return ""


def _has_aggdraw_in_extra() -> bool:
    """Whether there is a built package of aggdraw for this machine; there is none for Intel Macs."""
    return platform.system() != "Darwin" or platform.machine() == "arm64"


@functools.cache
def _is_there(package: str) -> bool:
    return find_spec(package) is not None
