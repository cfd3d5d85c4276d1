"""Scenes for Natron: a Python script that it runs, with readers and merges.

Its Merge multiplies colours as they are, whatever "alpha masking" is said to do (`ofxsMerging.h`, `mergePixel`), so a
layer that multiplies is laid on white first.
"""

from typing import Any, Final

from kagezou.export.exchange.scripts import filled_in
from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held


def natron_scene(stack: Stack) -> SceneText:
    """Return the script of a cut, ASCII only."""
    cut = {
        "width": stack.width_px,
        "height": stack.height_px,
        "rate": float(stack.frame_rate),
        "first": stack.first_frame,
        "last": stack.last_frame,
        "filled": stack.is_filled,
        "layers": [_layer(stack, each) for each in stack.layers],
    }
    return SceneText(filled_in("build_natron.py.in", cut))


def _layer(stack: Stack, layer: StackLayer) -> dict[str, Any]:
    return {
        "name": layer.name,
        "files": stack.pattern(layer.label, "#" * stack.digits),
        "multiply": layer.multiply,
        "opacities": [list(key) for key in held(layer.opacities, stack.first_frame)],
    }


NATRON: Final = SceneTarget(".py", "natron_layers", natron_scene, every_frame=True, is_module=True)
