"""Scenes for Nuke: a script of Read and Merge nodes.

Pictures are read as they are stored and laid on each other so; the sum is turned to linear light at the end, which is
what a viewer and writers of Nuke expect. A layer that multiplies is laid on white first, and what is under it is
multiplied with that, so that no setting of alpha matters; where nothing may be under it, it is laid under the product.
"""

from collections.abc import Iterator
from fractions import Fraction
from typing import Final

from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held

_COLUMN_PX: Final = 120
_ROW_PX: Final = 120
_FULL: Final = 1.0


def nuke_scene(stack: Stack) -> SceneText:
    """Return the script of a cut; it finds the pictures beside itself."""
    nodes = [_root(stack), *_canvases(stack)]
    for place, layer in enumerate(stack.layers, start=1):
        nodes += [*_picture(stack, layer, place), *(_multiplied if layer.multiply else _over)(stack, layer, place)]
    return SceneText("\n".join((*nodes, *_to_linear(stack))) + "\n")


def _root(stack: Stack) -> str:
    return _node(
        "Root",
        inputs=0,
        frame=stack.first_frame,
        first_frame=stack.first_frame,
        last_frame=stack.last_frame,
        lock_range="true",
        fps=_number(stack.frame_rate),
        format=_quoted(_format(stack)),
        project_directory=r'"\[python \{nuke.script_directory()\}]"',
    )


def _canvases(stack: Stack) -> Iterator[str]:
    """Yield a clear canvas, the sum so far, and a white one."""
    for name, color in (("Clear", "{0 0 0 0}"), ("White", "{1 1 1 1}")):
        yield _node(
            "Constant",
            inputs=0,
            channels="rgba",
            color=color,
            format=_quoted(_format(stack)),
            first=stack.first_frame,
            last=stack.last_frame,
            name=name,
            xpos=-_COLUMN_PX * (1 if name == "Clear" else 2),
            ypos=0,
        )
        yield f"set {name} [stack 0]"
    yield "push $Clear"
    yield "set Sum [stack 0]"


def _picture(stack: Stack, layer: StackLayer, place: int) -> Iterator[str]:
    """Yield what reads a layer, its colour multiplied by its alpha."""
    x, y = place * _COLUMN_PX, (place - 1) * _ROW_PX
    yield _node(
        "Read",
        inputs=0,
        file_type="png",
        file=_quoted(stack.pattern(layer.label, "#" * stack.digits)),
        format=_quoted(_format(stack)),
        first=stack.first_frame,
        last=stack.last_frame,
        origfirst=stack.first_frame,
        origlast=stack.last_frame,
        origset="true",
        raw="true",
        name=f"Read{place}",
        label=_quoted(layer.name),
        xpos=x,
        ypos=y,
    )
    yield _node("Premult", name=f"Premult{place}", xpos=x, ypos=y + _ROW_PX)
    yield "set Picture [stack 0]"


def _over(stack: Stack, layer: StackLayer, place: int) -> Iterator[str]:
    yield "push $Sum"
    yield _merge(layer, f"Merge{place}", place, operation="over", mix=_mix(stack, layer))
    yield "set Sum [stack 0]"


def _multiplied(stack: Stack, layer: StackLayer, place: int) -> Iterator[str]:
    """Yield what multiplies the sum; of two inputs the upper one of the stack is B."""
    rgb = "{rgba.red rgba.green rgba.blue -rgba.alpha}"
    yield "push $White"
    yield "push $Picture"
    yield _merge(layer, f"OnWhite{place}", place, operation="under")
    yield "push $Sum"
    yield _merge(layer, f"Merge{place}", place, operation="multiply", output=rgb, mix=_mix(stack, layer))
    yield "set Sum [stack 0]"
    if not stack.is_filled:
        yield "push $Picture"
        yield "push $Sum"
        yield _merge(layer, f"Under{place}", place, operation="under", mix=_mix(stack, layer))
        yield "set Sum [stack 0]"


def _merge(layer: StackLayer, name: str, place: int, **knobs: str) -> str:
    """Return a merge of two inputs."""
    down = {"OnWhite": 1, "Merge": 2, "Under": 3}[name.rstrip("0123456789")]
    y = (place - 1) * _ROW_PX + down * _ROW_PX // 3
    return _node("Merge2", inputs=2, **knobs, name=name, label=_quoted(layer.name), xpos=-_COLUMN_PX, ypos=y)


def _to_linear(stack: Stack) -> Iterator[str]:
    """Yield what turns the sum to linear light, which is of colours without their alpha."""
    y = (len(stack.layers) + 2) * _ROW_PX
    yield _node("Unpremult", name="Unpremult1", xpos=-_COLUMN_PX, ypos=y)
    yield _node("Colorspace", colorspace_in="sRGB", name="ToLinear", xpos=-_COLUMN_PX, ypos=y + _ROW_PX // 2)
    yield _node("Premult", name="Cut", xpos=-_COLUMN_PX, ypos=y + _ROW_PX)


def _mix(stack: Stack, layer: StackLayer) -> str:
    """Return the opacity: one number, or a curve that is held from key to key."""
    keys = list(held(layer.opacities, stack.first_frame))
    if len(keys) == 1:
        return f"{keys[0][1]:.9g}"
    curve = " ".join(f"x{frame} {opacity:.9g}" for frame, opacity in keys)
    return f"{{{{curve K {curve}}}}}"


def _format(stack: Stack) -> str:
    size = f"{stack.width_px} {stack.height_px}"
    return f"{size} 0 0 {size} 1 kagezou_{stack.width_px}x{stack.height_px}"


def _number(rate: Fraction) -> str:
    return f"{float(rate):.9g}"


def _quoted(words: str) -> str:
    """Return a text as one word of the script: what would be run or end it stands behind a backslash."""
    signs = {"\\": r"\\", '"': r"\"", "[": r"\[", "$": r"\$", "\n": r"\n"}
    return '"' + "".join(signs.get(sign, sign) for sign in words) + '"'


def _node(kind: str, **knobs: object) -> str:
    return "\n".join([f"{kind} {{", *(f" {knob} {value}" for knob, value in knobs.items()), "}"])


NUKE: Final = SceneTarget(".nk", "nuke_layers", nuke_scene, every_frame=True)
