"""Scenes for Fusion: a composition of Loaders and Merges, as Fusion itself writes them, a table of Lua.

Everything lies on white. A layer that multiplies is laid on white of its own first, and what is under it multiplied
with that: both are opaque, so that no setting of alpha matters.
"""

from collections.abc import Iterator
from typing import Final

from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held
from kagezou.message import Message

_COLUMN: Final = 110.0
_ROW: Final = 66.0
_FLOAT: Final = 4
"""How pictures are calculated with: 32 bit floats, which round nothing on the way."""


def fusion_scene(stack: Stack) -> SceneText:
    """Return the composition of a cut; it finds the pictures beside itself."""
    tools, last = [_background(stack)], "Canvas"
    for place, layer in enumerate(stack.layers, start=1):
        tools.append(_loader(stack, layer, place))
        tools += (_multiplied if layer.multiply else _laid)(stack, layer, place, last)
        last = f"Merge{place}"
    body = "\n".join(tools)
    text = f"Composition {{\n{_head(stack)}\n\tTools = ordered() {{\n{body}\n\t}},\n\tActiveTool = {_text(last)},\n}}\n"
    notes = () if stack.is_filled else (Message("nothing fills the canvas; Fusion has white there"),)
    return SceneText(text, notes)


def _head(stack: Stack) -> str:
    span = f"{{ {stack.first_frame}, {stack.last_frame} }}"
    form = f"Width = {stack.width_px}, Height = {stack.height_px}, AspectX = 1, AspectY = 1"
    return (
        f"\tCurrentTime = {stack.first_frame},\n\tRenderRange = {span},\n\tGlobalRange = {span},\n\tHiQ = true,\n"
        f"\tPrefs = {{ Comp = {{ FrameFormat = {{ {form}, Rate = {float(stack.frame_rate):.9g}, "
        f"DepthFull = {_FLOAT}, DepthInteractive = {_FLOAT}, DepthPreview = {_FLOAT}, DepthLock = true }} }} }},"
    )


def _background(stack: Stack) -> str:
    inputs = {
        "GlobalOut": _number(stack.last_frame),
        "GlobalIn": _number(stack.first_frame),
        "Width": _number(stack.width_px),
        "Height": _number(stack.height_px),
        "UseFrameFormatSettings": _number(0),
        "TopLeftRed": _number(1),
        "TopLeftGreen": _number(1),
        "TopLeftBlue": _number(1),
        "TopLeftAlpha": _number(1),
    }
    return _tool("Canvas", "Background", inputs, (0, 0))


def _loader(stack: Stack, layer: StackLayer, place: int) -> str:
    """Return what reads a layer, its colour multiplied by its alpha."""
    first, last = stack.first_frame, stack.last_frame
    clip = {
        "ID": _text("Clip1"),
        "Filename": _text(f"Comp:/{stack.file(layer.label, first)}"),
        "FormatID": _text("PNGFormat"),
        "StartFrame": first,
        "Length": stack.length_frames,
        "LengthSetManually": "true",
        "TrimIn": 0,
        "TrimOut": stack.length_frames - 1,
        "ExtendFirst": 0,
        "ExtendLast": 0,
        "Loop": 0,
        "AspectMode": 0,
        "Depth": 0,
        "TimeCode": 0,
        "GlobalStart": first,
        "GlobalEnd": last,
    }
    lines = "".join(f"\t\t\t\t\t{name} = {value},\n" for name, value in clip.items())
    clips = f"\t\t\tClips = {{\n\t\t\t\tClip {{\n{lines}\t\t\t\t}}\n\t\t\t}},\n"
    inputs = {"PostMultiplyByAlpha": _number(1), "Comments": f"Input {{ Value = {_text(layer.name)}, }}"}
    return _tool(f"Loader{place}", "Loader", inputs, (place * 2, place - 1), clips)


def _laid(stack: Stack, layer: StackLayer, place: int, last: str) -> Iterator[str]:
    yield from _merge(stack, layer, place, last, f"Loader{place}")


def _multiplied(stack: Stack, layer: StackLayer, place: int, last: str) -> Iterator[str]:
    on_white = {"Background": _from("Canvas"), "Foreground": _from(f"Loader{place}")}
    yield _tool(f"OnWhite{place}", "Merge", on_white, (place * 2 - 1, place))
    yield from _merge(stack, layer, place, last, f"OnWhite{place}", ApplyMode='Input { Value = FuID { "Multiply" }, }')


def _merge(stack: Stack, layer: StackLayer, place: int, last: str, upper: str, **way: str) -> Iterator[str]:
    """Yield what lays a layer on the sum, and the curve of its opacity where that changes."""
    keys = list(held(layer.opacities, stack.first_frame))
    blend = _number(keys[0][1]) if len(keys) == 1 else f'Input {{ SourceOp = "Opacity{place}", Source = "Value", }}'
    inputs = {"Background": _from(last), "Foreground": _from(upper), **way, "Blend": blend}
    yield _tool(f"Merge{place}", "Merge", inputs, (0, place))
    if len(keys) > 1:
        yield _spline(f"Opacity{place}", keys)


def _spline(name: str, keys: list[tuple[int, float]]) -> str:
    """Return a curve that keeps each value up to the frame before the next: straight lines between keys."""
    points = []
    for place, (frame, value) in enumerate(keys):
        if place and keys[place - 1][0] < frame - 1:
            points.append((frame - 1, keys[place - 1][1]))
        points.append((frame, value))
    lines = "".join(f"\t\t\t\t[{frame}] = {{ {value:.9g}, Flags = {{ Linear = true }} }},\n" for frame, value in points)
    return f"\t\t{name} = BezierSpline {{\n\t\t\tKeyFrames = {{\n{lines}\t\t\t}},\n\t\t}},"


def _tool(name: str, kind: str, inputs: dict[str, str], place: tuple[int, int], more: str = "") -> str:
    lines = "".join(f"\t\t\t\t{key} = {value},\n" for key, value in inputs.items())
    where = f"{{ {place[0] * _COLUMN:g}, {place[1] * _ROW:g} }}"
    view = f"\t\t\tViewInfo = OperatorInfo {{ Pos = {where} }},\n"
    return f"\t\t{name} = {kind} {{\n{more}\t\t\tInputs = {{\n{lines}\t\t\t}},\n{view}\t\t}},"


def _from(tool: str) -> str:
    return f'Input {{ SourceOp = "{tool}", Source = "Output", }}'


def _number(value: float) -> str:
    return f"Input {{ Value = {value:.9g}, }}"


def _text(words: str) -> str:
    """Return a string of Lua; only what would end it stands behind a backslash."""
    signs = {"\\": r"\\", '"': r"\"", "\n": r"\n", "\r": r"\r"}
    return '"' + "".join(signs.get(sign, sign) for sign in words) + '"'


FUSION: Final = SceneTarget(".comp", "fusion_layers", fusion_scene, every_frame=True)
