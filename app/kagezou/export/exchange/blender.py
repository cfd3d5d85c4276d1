"""Scenes for Blender: a Python script that builds cards before an orthographic camera."""

from fractions import Fraction
from typing import Any, Final

from kagezou.export.exchange.scripts import filled_in
from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held
from kagezou.message import Message

_MOST_FPS: Final = 32767


def blender_scene(stack: Stack) -> SceneText:
    """Return the script of a cut, ASCII only: what comes from people is JSON within a string, and never run."""
    fps, base = rate_of(stack.frame_rate)
    cut = {
        "name": stack.name,
        "folder": stack.folder,
        "width": stack.width_px,
        "height": stack.height_px,
        "fps": fps,
        "fps_base": base,
        "first": stack.first_frame,
        "last": stack.last_frame,
        "depth": stack.depth,
        "layers": [_layer(stack, each) for each in stack.layers],
    }
    notes = () if stack.is_filled else (Message("nothing fills the canvas; Blender has white there"),)
    return SceneText(filled_in("build_blender.py.in", cut), notes)


def rate_of(rate: Fraction) -> tuple[int, float]:
    """Return frames a second as Blender has them: a whole number, and what it is divided by; 24 and 1.001."""
    if rate.denominator == 1001:
        return round(rate), 1.001
    whole = rate.limit_denominator(1000)
    if whole.numerator <= _MOST_FPS:
        return whole.numerator, float(whole.denominator)
    return round(rate), float(round(rate) / rate)


def _layer(stack: Stack, layer: StackLayer) -> dict[str, Any]:
    return {
        "name": layer.name,
        "first": stack.file(layer.label, 1),
        "multiply": layer.multiply,
        "pictures": _pictures(stack, layer),
        "opacities": [list(key) for key in held(layer.seen_opacities, stack.first_frame)],
    }


def _pictures(stack: Stack, layer: StackLayer) -> list[list[int]]:
    """Return when which picture begins; while nothing is seen the one before stays, with no opacity."""
    shown, last = [], 1
    for number in layer.pictures:
        last = number or last
        shown.append(last)
    return [list(key) for key in held(shown, stack.first_frame)]


BLENDER: Final = SceneTarget(".py", "blender_layers", blender_scene)
