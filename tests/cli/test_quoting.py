"""Every example can be typed as it stands into zsh, too, which takes brackets, braces and the like for itself."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PLACES = (
    ROOT / "README.md",
    *sorted((ROOT / "docs").rglob("*.md")),
    *sorted((ROOT / "app" / "kagezou" / "cli").rglob("*.py")),
)
TAKEN = re.compile(r"[][{}#^!()~]|(?<!\S)=")
"""What zsh reads itself where nothing quotes it; a ``*`` that is to name files is meant so."""
PLACEHOLDERS = re.compile(r"#FRAMESPEC#|\{chunk\}|(?<=\s)\[[^]']*\]")
"""What another program fills in, and the brackets of what may be left out."""


def examples(text: str) -> Iterator[str]:
    for line in text.splitlines():
        if re.match(r"\s*kagezou [a-z]", line):
            yield re.split(r"\s{4,}", line.strip())[0]
        yield from re.findall(r"`(kagezou [a-z][^`]*)`", line)


def bare(words: str) -> str:
    """Return what stands outside quotes."""
    return re.sub(r"'[^']*'|\"[^\"]*\"", "", PLACEHOLDERS.sub("", words))


def test_unquoted_signs_are_seen() -> None:
    assert TAKEN.search(bare("kagezou set a.kage position=[1,2]"))
    assert TAKEN.search(bare("kagezou render a.kage --names {layer}.{frame}"))
    assert TAKEN.search(bare("kagezou set a.kage color=#123"))
    assert not TAKEN.search(bare("kagezou set a.kage 'color=#123' light.position=1,2,3"))
    assert list(examples("    kagezou demo    makes one\nsay `kagezou doctor` first")) == [
        "kagezou demo",
        "kagezou doctor",
    ]


@pytest.mark.parametrize("path", PLACES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_examples_quote_what_a_shell_takes(path: Path) -> None:
    found = [each for each in examples(path.read_text(encoding="utf-8")) if TAKEN.search(bare(each))]
    assert found == []
