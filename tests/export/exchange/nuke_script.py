"""As much of Nuke as its scenes use: the script's stack of nodes, and what these do to pixels, as its manual says."""

import re
import shlex
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.export.exchange.cuts import pixels_of

Pixels = NDArray[np.float64]
_STATEMENT = re.compile(r"^(\w+) \{\n(.*?)^\}$|^(set|push) (\S+)(?: \[stack 0\])?$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Node:
    """A node, its knobs as they are written, and what it is connected to, input 0 first."""

    kind: str
    knobs: dict[str, str]
    inputs: tuple["Node", ...] = field(default=(), repr=False)

    def knob(self, name: str) -> str:
        """Return the word that a knob is set to."""
        return next(iter(shlex.split(self.knobs[name].replace("\\[", "["))))


def nodes_of(script: str) -> list[Node]:
    """Return the nodes of a script, in their order: each takes its inputs from the top of the stack."""
    stack: list[Node] = []
    named: dict[str, Node] = {}
    found = []
    for kind, body, command, name in _STATEMENT.findall(script):
        if command == "set":
            named[name] = stack[-1]
        elif command == "push":
            stack.append(named[name.removeprefix("$")])
        else:
            knobs = dict(line.strip().split(" ", 1) for line in body.splitlines())
            inputs = tuple(stack.pop() for _ in range(int(knobs.get("inputs", "1"))))
            found.append(Node(kind, knobs, inputs))
            if kind != "Root":
                stack.append(found[-1])
    return found


def shown(node: Node, folder: Path, frame: int) -> Pixels:
    """Return what a node makes on a frame: (H, W, 4), as Nuke has it in its buffers."""
    return _KINDS[node.kind](node, folder, frame)


def _read(node: Node, folder: Path, frame: int) -> Pixels:
    assert node.knob("raw") == "true", "without it Nuke would turn the picture to linear light"
    assert int(node.knob("first")) <= frame <= int(node.knob("last"))
    file = node.knob("file")
    return pixels_of(folder / re.sub("#+", lambda found: f"{frame:0{len(found[0])}d}", file))


def _constant(node: Node, _folder: Path, _frame: int) -> Pixels:
    width, height = map(int, node.knob("format").split()[:2])
    return np.full((height, width, 4), np.array(node.knobs["color"].strip("{}").split(), float))


def _premult(node: Node, folder: Path, frame: int) -> Pixels:
    below = shown(node.inputs[0], folder, frame)
    return np.concatenate([below[..., :3] * below[..., 3:], below[..., 3:]], -1)


def _unpremult(node: Node, folder: Path, frame: int) -> Pixels:
    below = shown(node.inputs[0], folder, frame)
    alpha = below[..., 3:]
    return np.concatenate([below[..., :3] / np.where(alpha > 0, alpha, 1), alpha], -1)


def _colorspace(node: Node, folder: Path, frame: int) -> Pixels:
    assert node.knobs["colorspace_in"] == "sRGB"
    below = shown(node.inputs[0], folder, frame)
    color = below[..., :3]
    linear = np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
    return np.concatenate([linear, below[..., 3:]], -1)


def _merge(node: Node, folder: Path, frame: int) -> Pixels:
    under, over = (shown(each, folder, frame) for each in node.inputs)
    b, a = under[..., 3:], over[..., 3:]
    laid = {"over": over + under * (1 - a), "under": over * (1 - b) + under, "multiply": over * under}
    made: Pixels = under + (laid[node.knobs["operation"]] - under) * _at(node.knobs.get("mix", "1"), frame)
    if node.knobs.get("output", "").endswith("-rgba.alpha}"):
        made[..., 3:] = b
    return made


def _at(value: str, frame: int) -> float:
    """Return a knob's number on a frame; a curve of constant keys holds each until the next."""
    if not value.startswith("{{curve K "):
        return float(value)
    keys = [(int(at[1:]), float(number)) for at, number in re.findall(r"(x-?\d+) ([\d.e-]+)", value)]
    return next(number for at, number in reversed(keys) if at <= frame)


_KINDS: dict[str, Callable[[Node, Path, int], Pixels]] = {
    "Read": _read,
    "Constant": _constant,
    "Premult": _premult,
    "Unpremult": _unpremult,
    "Colorspace": _colorspace,
    "Merge2": _merge,
}
