"""Open Cel Animation: the pictures of every layer and one JSON file, as OCA 1.1 has it (oca.rxlab.guide).

The programs that read it count frames from 0, whatever ``startTime`` says; and the opacity of a frame is that of its
layer there, not a part of it, as Krita writes it.
"""

import json
from collections.abc import Iterator
from typing import Any, Final

from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held
from kagezou.message import Message
from kagezou.version import __version__

_SPEC: Final = "1.1.0"


def oca_scene(stack: Stack) -> SceneText:
    """Return the JSON of a cut."""
    document = {
        "ocaVersion": _SPEC,
        "originApp": "Kagezou",
        "originAppVersion": __version__,
        "name": stack.name,
        "frameRate": _plain(float(stack.frame_rate)),
        "width": stack.width_px,
        "height": stack.height_px,
        "startTime": 0,
        "endTime": stack.length_frames,
        "colorDepth": f"U{stack.depth}",
        "backgroundColor": [0.0, 0.0, 0.0, 0.0],
        "layers": [_layer(stack, each) for each in stack.layers],
    }
    text = json.dumps(document, ensure_ascii=False, allow_nan=False, indent=4) + "\n"
    return SceneText(text, tuple(_notes(stack)))


def _layer(stack: Stack, layer: StackLayer) -> dict[str, Any]:
    frames = [*_frames(stack, layer)]
    return {
        "name": layer.name,
        "frames": frames,
        "childLayers": [],
        "type": "paintlayer",
        "fileType": "png",
        "blendingMode": "multiply" if layer.multiply else "normal",
        "inheritAlpha": False,
        "animated": len(frames) > 1,
        **_place(stack),
        "label": -1,
        "opacity": _plain(layer.opacities[0]),
        "visible": True,
        "passThrough": False,
        "reference": False,
    }


def _frames(stack: Stack, layer: StackLayer) -> Iterator[dict[str, Any]]:
    """Yield the frames of a layer: each lasts until its picture or its opacity changes."""
    shown = list(held(zip(layer.pictures, layer.opacities, strict=True), 0))
    ends = [*(at for at, _ in shown[1:]), stack.length_frames]
    for (start, (picture, opacity)), end in zip(shown, ends, strict=True):
        file = stack.file(layer.label, picture) if picture else ""
        yield {
            "name": file.rpartition("/")[2].removesuffix(".png") or "_blank",
            "fileName": file,
            "frameNumber": start,
            "opacity": _plain(opacity),
            **(_place(stack) if picture else {"position": [0, 0], "width": 0, "height": 0}),
            "duration": end - start,
        }


def _place(stack: Stack) -> dict[str, Any]:
    return {
        "position": [stack.width_px // 2, stack.height_px // 2],
        "width": stack.width_px,
        "height": stack.height_px,
    }


def _notes(stack: Stack) -> Iterator[Message]:
    if stack.first_frame != 1:
        yield Message("frames are counted from 0 in OCA: its frame 0 is frame {first} here", first=stack.first_frame)


def _plain(number: float) -> float:
    """Return a number with as many digits as tell it apart."""
    return float(f"{number:.9g}")


OCA: Final = SceneTarget(".oca", "oca_layers", oca_scene)
