"""As much of Natron as its scenes use: the object model that its manual documents, and what its nodes do to pixels."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.export.exchange.cuts import pixels_of

Pixels = NDArray[np.float64]
_PARAMS: dict[str, dict[str, Any]] = {
    "net.sf.openfx.MergePlugin": {"operation": "over", "mix": 1.0, "OutputChannelsA": True, "screenAlpha": False},
    "net.sf.openfx.ConstantPlugin": {"extent": "default", "color": (0.0, 0.0, 0.0, 0.0)},
    "fr.inria.openfx.OCIOColorSpace": {"ocioInputSpace": "", "ocioOutputSpace": "", "premult": False},
    "fr.inria.built-in.Output": {},
    "read": {
        "ocioInputSpace": "sRGB",
        "ocioOutputSpace": "Linear",
        "ocioInputSpaceIndex": 1,
        "ocioOutputSpaceIndex": 0,
        "firstFrame": 0,
        "lastFrame": 0,
        "startingTime": 0,
    },
}
_INPUTS = {"net.sf.openfx.MergePlugin": ("B", "A", "Mask", "A2"), "fr.inria.openfx.OCIOColorSpace": ("Source", "Mask")}


class Param:
    """A parameter; numbers may have keys, between which they go straight."""

    def __init__(self, value: Any) -> None:
        self.value = value
        self.keys: dict[int, float] = {}

    def get(self) -> Any:
        return self.value

    def set(self, *values: Any) -> None:
        if isinstance(self.value, float) and len(values) == 2:
            self.keys[values[1]] = values[0]
            return
        self.value = values[0] if len(values) == 1 else values

    def at(self, frame: int) -> float:
        """Return a number on a frame."""
        if not self.keys:
            return float(self.value)
        frames = sorted(self.keys)
        return float(np.interp(frame, frames, [self.keys[each] for each in frames]))


class Effect:
    """A node."""

    def __init__(self, plugin: str, file: str = "") -> None:
        self.plugin, self.file = plugin, file
        self.label = self.script_name = ""
        self.params = {name: Param(value) for name, value in _PARAMS[plugin].items()}
        self.labels = _INPUTS.get(plugin, ("Source",))
        self.inputs: dict[str, Effect] = {}

    # The names are Natron's.
    def getParam(self, name: str) -> Param | None:  # noqa: N802
        return self.params.get(name)

    def getMaxInputCount(self) -> int:  # noqa: N802
        return len(self.labels)

    def getInputLabel(self, number: int) -> str:  # noqa: N802
        return self.labels[number]

    def getPluginID(self) -> str:  # noqa: N802
        return self.plugin

    def connectInput(self, number: int, source: "Effect") -> None:  # noqa: N802
        self.inputs[self.labels[number]] = source

    def setLabel(self, label: str) -> None:  # noqa: N802
        self.label = label

    def setScriptName(self, name: str) -> None:  # noqa: N802
        assert name.isidentifier()
        self.script_name = name

    def setPosition(self, _x: float, _y: float) -> None:  # noqa: N802
        return

    def shown(self, frame: int, size: tuple[int, int]) -> Pixels:
        """Return what it makes on a frame, (H, W, 4)."""
        match self.plugin:
            case "read":
                return self._read(frame)
            case "net.sf.openfx.ConstantPlugin":
                assert self.params["extent"].value == "project"
                return np.full((size[1], size[0], 4), self.params["color"].value)
            case "net.sf.openfx.MergePlugin":
                return self._merged(frame, size)
        return self.inputs["Source"].shown(frame, size)

    def _read(self, frame: int) -> Pixels:
        space = self.params["ocioInputSpace"].value
        assert space == self.params["ocioOutputSpace"].value, "the picture would be turned to linear light"
        first, last, start = (self.params[name].value for name in ("firstFrame", "lastFrame", "startingTime"))
        assert first == start <= frame <= last
        stored = pixels_of(Path(self.file.replace("####", f"{frame:04d}")))
        return np.concatenate([stored[..., :3] * stored[..., 3:], stored[..., 3:]], -1)

    def _merged(self, frame: int, size: tuple[int, int]) -> Pixels:
        under, over = (self.inputs[label].shown(frame, size) for label in ("B", "A"))
        b, a = under[..., 3:], over[..., 3:]
        laid = {"over": over + under * (1 - a), "under": over * (1 - b) + under, "multiply": over * under}
        made = under + (laid[self.params["operation"].value] - under) * self.params["mix"].at(frame)
        if not self.params["OutputChannelsA"].value:
            made[..., 3:] = b
        return np.asarray(made)


class App:
    """A project."""

    def __init__(self) -> None:
        self.nodes: list[Effect] = []
        self.formats: list[str] = []
        names = ("outputFormat", "frameRate", "frameRange", "lockRange")
        self.params = {name: Param("") for name in names}

    def createNode(self, plugin: str) -> Effect:  # noqa: N802
        self.nodes.append(Effect(plugin))
        return self.nodes[-1]

    def createReader(self, file: str) -> Effect:  # noqa: N802
        self.nodes.append(Effect("read", file))
        return self.nodes[-1]

    def addFormat(self, form: str) -> None:  # noqa: N802
        name, size, aspect = form.split(" ")
        assert name.isidentifier()
        assert (len(size.split("x")), float(aspect)) == (2, 1.0)
        self.formats.append(form)

    def getProjectParam(self, name: str) -> Param:  # noqa: N802
        return self.params[name]
