"""The description of the project file in Japanese: the same tables, with words from a list and the window's own."""

import json
import re
from functools import cache
from pathlib import Path
from typing import Final

from kagezou.document.properties import TABLE
from kagezou.document.property import Scope
from kagezou.ui.system.words import translated

WORDS: Final = Path(__file__).resolve().parent / "site" / "project_file_ja.json"
_MISSING: Final = "May be missing."
_SCOPES: Final = {
    "## Properties of the scene": Scope.DOCUMENT,
    "## Properties of a layer": Scope.LAYER,
    "## Properties of a set piece": Scope.PIECE,
}
_KINDS: Final = (
    (re.compile(r"whole number, (\S+) to (\S+)"), r"整数、\1～\2"),
    (re.compile(r"number, (\S+) to (\S+)( \S+)?"), r"数、\1～\2\3"),
    (re.compile(r"list of at most (\d+) objects"), r"オブジェクトの配列（\1 個まで）"),
    (re.compile(r"text of at most (\d+) characters"), r"テキスト（\1 文字まで）"),
    (re.compile(r"(\[.*\]) in (\S+)"), r"\1（\2）"),
    (re.compile(r'("[\w#-]+"(?: or "[\w#-]+")*)'), r"\1"),
)
"""Values whose description is made of a word and numbers."""


def in_japanese(description: str) -> str:
    """Return the description with every word translated; KeyError names one that the list lacks."""
    text, example = description.split("## Example")
    scope, blocks = Scope.DOCUMENT, []
    for block in re.split(r"\n{2,}", text.strip()):
        scope = _SCOPES.get(block, scope)
        blocks.append(_block(block, scope))
    return "\n\n".join([*blocks, _word("## Example")]) + example


@cache
def _words() -> dict[str, str]:
    words: dict[str, str] = json.loads(WORDS.read_text(encoding="utf-8"))
    return words


def _word(text: str) -> str:
    return _words()[text]


def _block(block: str, scope: Scope) -> str:
    if not block.startswith("|"):
        return _word(" ".join(block.split()))
    return "\n".join(_row(line, scope) for line in block.splitlines())


def _row(line: str, scope: Scope) -> str:
    if line.startswith(("|---", "| ---")):
        return line
    cells = [cell.strip() for cell in line.strip("|").split(" | ")]
    if not cells[0].startswith("`"):
        cells = [_word(cell) for cell in cells]
    elif len(cells) == 4:  # a property: the window has words for it
        (prop,) = (each for each in TABLE if each.scope is scope and f"`{each.name}`" == cells[0])
        cells[1:] = [_kind(cells[1]), _words().get(cells[2], cells[2]), translated(prop.help)]
    else:
        meaning, missing, _ = cells[2].partition(_MISSING)
        cells[1:] = [_kind(cells[1]), _word(meaning.strip()) + (_word(_MISSING) if missing else "")]
    return f"| {' | '.join(cells)} |"


def _kind(value: str) -> str:
    if value in _words():
        return _word(value)
    for pattern, japanese in _KINDS:
        found = pattern.fullmatch(value)
        if found:
            return found.expand(japanese).replace('" or "', '" か "')
    return _word(value)
