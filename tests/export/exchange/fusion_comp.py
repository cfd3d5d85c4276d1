"""As much of Fusion as its scenes use: the table of a composition, and what its tools do to pixels."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.export.exchange.cuts import pixels_of

Pixels = NDArray[np.float64]
_TOKEN = re.compile(r'\s*("(?:\\.|[^"\\])*"|[{}\[\]=,()]|-?\d[\w.+-]*|\w+)')


def table_in(text: str) -> dict[str, Any]:
    """Return a table of Lua as a dictionary; what stands before a brace is its ``kind``."""
    tokens = _TOKEN.findall(text)
    assert not _TOKEN.sub("", text).strip(), "every sign is understood"
    value, rest = _value(tokens)
    assert not rest
    assert isinstance(value, dict)
    return value


def _value(tokens: list[str]) -> tuple[Any, list[str]]:
    head, rest = tokens[0], tokens[1:]
    if head == "{":
        return _table("", rest)
    if rest[:1] == ["{"]:
        return _table(head, rest[1:])
    if rest[:3] == ["(", ")", "{"]:
        return _table(head, rest[3:])
    if head.startswith('"'):
        return re.sub(r"\\(.)", r"\1", head[1:-1]), rest
    return {"true": True, "false": False}.get(head, head) if head[0].isalpha() else float(head), rest


def _table(kind: str, tokens: list[str]) -> tuple[dict[Any, Any], list[str]]:
    made: dict[Any, Any] = {"kind": kind}
    place = 1
    while tokens[0] != "}":
        key: Any = place
        if tokens[0] == "[":
            key, tokens = float(tokens[1]), tokens[4:]
        elif tokens[1] == "=":
            key, tokens = tokens[0], tokens[2:]
        else:
            place += 1
        made[key], tokens = _value(tokens)
        tokens = tokens[1:] if tokens[0] == "," else tokens
    return made, tokens[1:]


@dataclass(frozen=True)
class Composition:
    """A composition and the folder that it was opened from."""

    table: dict[str, Any]
    folder: Path

    @property
    def tools(self) -> dict[str, Any]:
        return {name: tool for name, tool in self.table["Tools"].items() if name != "kind"}

    def shown(self, name: str, frame: int) -> Pixels:
        """Return what a tool makes on a frame, (H, W, 4) multiplied by alpha."""
        tool = self.tools[name]
        inputs = tool.get("Inputs", {})
        if tool["kind"] == "Background":
            assert inputs["UseFrameFormatSettings"]["Value"] == 0
            color = [inputs[f"TopLeft{each}"]["Value"] for each in ("Red", "Green", "Blue", "Alpha")]
            return np.full((int(inputs["Height"]["Value"]), int(inputs["Width"]["Value"]), 4), color)
        if tool["kind"] == "Loader":
            return self._loaded(tool, frame)
        assert tool["kind"] == "Merge"
        under = self.shown(inputs["Background"]["SourceOp"], frame)
        over = self.shown(inputs["Foreground"]["SourceOp"], frame) * self._number(inputs.get("Blend"), frame)
        if inputs.get("ApplyMode", {}).get("Value", {}).get(1, "Normal") == "Normal":
            return np.asarray(over + under * (1 - over[..., 3:]))
        amount = over[..., 3:]
        assert inputs["ApplyMode"]["Value"][1] == "Multiply"
        assert np.allclose(amount, amount.flat[0]), "what multiplies is as opaque everywhere"
        assert (under[..., 3] == 1).all(), "and so is what it multiplies"
        return np.asarray(under * (1 - amount) + under * over)

    def _loaded(self, tool: dict[str, Any], frame: int) -> Pixels:
        clip = tool["Clips"][1]
        assert tool["Inputs"]["PostMultiplyByAlpha"]["Value"] == 1
        assert clip["Length"] == clip["TrimOut"] - clip["TrimIn"] + 1 == clip["GlobalEnd"] - clip["GlobalStart"] + 1
        assert clip["GlobalStart"] <= frame <= clip["GlobalEnd"]
        first = self.folder / clip["Filename"].removeprefix("Comp:/")
        digits = re.search(r"(\d+)\.png$", first.name)
        assert digits is not None
        number = int(digits[1]) + frame - int(clip["GlobalStart"])
        stored = pixels_of(first.with_name(f"{first.name[: digits.start()]}{number:0{len(digits[1])}d}.png"))
        return np.concatenate([stored[..., :3] * stored[..., 3:], stored[..., 3:]], -1)

    def _number(self, given: dict[str, Any] | None, frame: int) -> float:
        if given is None:
            return 1.0
        if "Value" in given:
            return float(given["Value"])
        keys = {at: key for at, key in self.tools[given["SourceOp"]]["KeyFrames"].items() if at != "kind"}
        assert all(key["Flags"]["Linear"] for key in keys.values())
        frames = sorted(keys)
        return float(np.interp(frame, frames, [keys[each][1] for each in frames]))
