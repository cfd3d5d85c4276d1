"""The commands that a page of the manual names, in their order: what can be typed, and what only shows a form."""

import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
PROGRAM: Final = "kagezou"
_PLACES: Final = re.compile(
    r"(?P<fence>^```(?P<kind>\w*)\n(?P<block>.*?)^```)"
    r"|(?P<indented>^(?: {4,}\S[^\n]*\n)+)"
    r"|!\[[^\]]*\]\((?P<picture>[^)]+)\)"
    r"|`(?P<inline>[^`]+)`",
    re.MULTILINE | re.DOTALL,
)
_COMMAND: Final = re.compile(r"(kagezou|python3?|pip|openjd|deadline|blender|rattler-build|export|\.venv\S+)(?=\s)")
_FORM: Final = re.compile(r"\b[A-Z][A-Z_]+\b|\bP\.kage|\bS\.xdts|\.\.\.|#FRAMESPEC#|\{chunk\}|[][|]")


@dataclass(frozen=True, slots=True)
class PageCommand:
    """One command line of a page.

    Parameters
    ----------
    text
        The line as it would be typed.
    pictures
        The pictures below it, before the next command, as the page links them.
    """

    text: str
    pictures: tuple[str, ...] = ()

    @property
    def words(self) -> list[str]:
        """Its words, as a shell parts them, without a comment at its end."""
        return shlex.split(self.text, comments=True)

    @property
    def is_form(self) -> bool:
        """Whether it only shows how a command is written: words in capitals, dots or brackets stand for others."""
        bare = re.sub(r"'[^']*'|\"[^\"]*\"", "", self.text)
        words = self.words
        return bool(_FORM.search(bare)) or (words[0] == PROGRAM and len(words) > 1 and _lacks_object(words))


def _lacks_object(words: list[str]) -> bool:
    """Tell whether a command is only named: a verb alone, or with options that have nothing to work on."""
    complete = {"doctor", "demo", "bench", "integrate", "style"}
    return words[1] not in complete and all(word.startswith("-") for word in words[2:]) and "--panel" not in words


def commands(text: str) -> Iterator[PageCommand]:
    """Yield the commands of a page's Markdown."""
    last: PageCommand | None = None
    for found in _PLACES.finditer(text):
        if found["picture"]:
            if last is not None:
                last = PageCommand(last.text, (*last.pictures, found["picture"]))
            continue
        for line in _lines(found):
            if last is not None:
                yield last
            last = PageCommand(line)
    if last is not None:
        yield last


def _lines(found: re.Match[str]) -> Iterator[str]:
    if found["fence"]:
        lines = found["block"].splitlines() if found["kind"] == "sh" else []
    elif found["indented"]:
        lines = found["indented"].splitlines()
    else:
        lines = [" ".join(found["inline"].split())]
    for line in lines:
        typed = re.split(r"\s{4,}", line.strip())[0]
        if _COMMAND.match(typed):
            yield typed


def pages() -> list[Path]:
    """Return every file in which people look for commands."""
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*/*.md"))]
