"""Projects and the command line, for its tests."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.__main__ import main
from kagezou.io.images.writing import write_rgba

_FOUND = re.compile(r": (one drawing|[0-9]+ drawings), ")


def make_drawings(folder: Path, count: int = 3, size: tuple[int, int] = (64, 48)) -> Path:
    """Draw a block that stands on the lower third and walks to the right."""
    folder.mkdir(parents=True, exist_ok=True)
    width, height = size
    for number in range(1, count + 1):
        pixels = np.zeros((height, width, 4), np.uint8)
        left = width // 3 + 2 * number
        pixels[height // 3 : height * 5 // 6, left : left + width // 6] = (200, 120, 40, 255)
        write_rgba(folder / f"walk_{number:04d}.png", pixels)
    return folder


class Shell:
    """The command line within this process: what it returned and said."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self._capsys = capsys
        self.out = ""
        self.said = ""

    def __call__(self, *words: object) -> int:
        code = main([str(word) for word in words])
        self.out, self.said = self._capsys.readouterr()
        return code

    def ok(self, *words: object) -> str:
        """Run what must succeed without a word on stderr but what drawings were found, and return its output."""
        assert self(*words) == 0, self.said
        assert [line for line in self.said.splitlines() if not _FOUND.search(line)] == []
        return self.out

    def missing(self, *words: object) -> str:
        """Run what tells of a missing file, and return its output."""
        assert self(*words) == 3, self.said
        return self.out

    def json(self, *words: object) -> Any:
        return json.loads(self.ok(*words))

    def fails(self, code: int, *words: object) -> str:
        """Run what must fail with a code and one line on stderr; return the line without its head."""
        assert self(*words) == code, self.said
        assert self.said.startswith("kagezou: ")
        assert self.said.count("\n") == 1
        assert self.out == ""
        return self.said.removeprefix("kagezou: ").rstrip("\n")
