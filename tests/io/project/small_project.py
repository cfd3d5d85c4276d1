"""A small project with one of everything, and a way to spoil it."""

import json
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

import pytest

from kagezou.animation.track import Track
from kagezou.document.edits import still
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer
from kagezou.errors import ProjectProblem
from kagezou.geometry.box import Box
from kagezou.io.project.file import dumps, loads
from tests.documents import FOLDER

Tree = dict[str, Any]


def small_document(folder: Path = FOLDER) -> Document:
    cels = Cels((Drawing("1", folder / "A/A_0001.png"),), (Exposure(1, 0), Exposure(3, None)))
    layer = Layer("layer-1", "A", cels, Box(1, 2, 30, 40), MappingProxyType({"tilt": Track(12.5)}))
    return Document(Canvas(64, 48, Fraction(24000, 1001), 24), still(folder / "bg.png"), (layer,))


def small_tree() -> Tree:
    tree = json.loads(dumps(small_document(), FOLDER))
    assert isinstance(tree, dict)
    return tree


def refusal(tree: object) -> str:
    with pytest.raises(ProjectProblem) as caught:
        loads(json.dumps(tree), FOLDER)
    return str(caught.value)
