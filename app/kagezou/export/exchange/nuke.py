"""Scenes for Nuke: a script of Read and Merge nodes.

Pictures are read as they are stored and laid on each other so; the sum is turned to linear light at the end, which is
what a viewer and writers of Nuke expect. Merge's multiply with alpha masking is A(1-b) + B(1-a) + AB.
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
    nodes = [_root(stack), *_reads(stack), _base(stack), *_merges(stack), *_to_linear(stack)]
    return SceneText("\n".join(nodes) + "\n")


def _root(stack: Stack) -> str:
    return _node(
        "Root",
        inputs=0,
        frame=stack.first_frame,
        first_frame=stack.first_frame,
        last_frame=stack.last_frame,
        lock_range="true",
        fps=_number(stack.frame_rate),
        format=_quoted(f"{_format(stack)} kagezou"),
        project_directory=r'"\[python \{nuke.script_directory()\}]"',
    )


def _reads(stack: Stack) -> Iterator[str]:
    """Yield what reads the layers, the uppermost first: merges take the last that was made first."""
    for place, layer in reversed(list(enumerate(stack.layers))):
        x = place * _COLUMN_PX
        yield _node(
            "Read",
            inputs=0,
            file_type="png",
            file=_quoted(stack.pattern(layer.label, "#" * stack.digits)),
            format=_quoted(f"{_format(stack)} kagezou"),
            first=stack.first_frame,
            last=stack.last_frame,
            origfirst=stack.first_frame,
            origlast=stack.last_frame,
            origset="true",
            raw="true",
            name=f"Read{place + 1}",
            label=_quoted(layer.name),
            xpos=x,
            ypos=0,
        )
        yield _node("Premult", name=f"Premult{place + 1}", xpos=x, ypos=_ROW_PX)


def _base(stack: Stack) -> str:
    return _node(
        "Constant",
        inputs=0,
        channels="rgba",
        format=_quoted(f"{_format(stack)} kagezou"),
        first=stack.first_frame,
        last=stack.last_frame,
        name="Canvas",
        xpos=-_COLUMN_PX,
        ypos=_ROW_PX,
    )


def _merges(stack: Stack) -> Iterator[str]:
    for place, layer in enumerate(stack.layers):
        way = {"operation": "multiply", "screen_alpha": "true"} if layer.multiply else {"operation": "over"}
        yield _node(
            "Merge2",
            inputs=2,
            **way,
            mix=_mix(stack, layer),
            name=f"Merge{place + 1}",
            label=_quoted(layer.name),
            xpos=-_COLUMN_PX,
            ypos=(place + 2) * _ROW_PX,
        )


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
    return f"{size} 0 0 {size} 1"


def _number(rate: Fraction) -> str:
    return f"{float(rate):.9g}"


def _quoted(words: str) -> str:
    """Return a text as one word of the script: what would be run or end it stands behind a backslash."""
    signs = {"\\": r"\\", '"': r"\"", "[": r"\[", "$": r"\$", "\n": r"\n"}
    return '"' + "".join(signs.get(sign, sign) for sign in words) + '"'


def _node(kind: str, **knobs: object) -> str:
    return "\n".join([f"{kind} {{", *(f" {knob} {value}" for knob, value in knobs.items()), "}"])


NUKE: Final = SceneTarget(".nk", nuke_scene, every_frame=True)
