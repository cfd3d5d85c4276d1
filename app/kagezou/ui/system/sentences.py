"""The sentences of the rooms below in the language of the window.

Those rooms know no languages: they write English, which is what the command line prints. Here a sentence is known again
by its pattern, as ``sentences_ja.json`` lists them, with the Japanese beside it: ``{}`` stands for a value in both, and
``{1}`` for the second one where the order is another. A value may be a sentence itself, such as the cause behind a
file's name. Whatever no pattern knows, such as the words of a driver, is said as it is.
"""

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import islice

from kagezou.errors import Problem
from kagezou.locations import resource_folder
from kagezou.ui.system.words import is_japanese

_HOLE = re.compile(r"\{(\d*)\}")
_COLON = ": "
_DEEPEST, _MOST_COLONS, _LONGEST = 4, 6, 800
"""What is nested deeper or longer is no sentence of ours but the log of a driver."""


def sentence_of(problem: Problem) -> str:
    """Return what a problem says, in the language of the window."""
    return spoken(str(problem))


def spoken(text: str) -> str:
    """Return a sentence of the rooms below in the language of the window, beginning like one."""
    if is_japanese():
        return japanese(text)
    return text[:1].upper() + text[1:] if _read(text).begins else text


def japanese(text: str) -> str:
    """Return a sentence of the rooms below in Japanese; what is not known stays."""
    return _read(text).text


def patterns() -> Mapping[str, str]:
    """Return the Japanese of every English pattern."""
    text = (resource_folder() / "translations" / "sentences_ja.json").read_text(encoding="utf-8")
    return {str(english): str(other) for english, other in json.loads(text).items()}


@dataclass(frozen=True, slots=True)
class _Reading:
    """A way to understand a text.

    Parameters
    ----------
    text
        Its Japanese.
    known
        How many letters of it were known; more is better.
    begins
        Whether it begins with known words, not with a name.
    """

    text: str
    known: int
    begins: bool = False


@dataclass(frozen=True, slots=True)
class _Pattern:
    literals: tuple[str, ...]
    english: re.Pattern[str]
    known: int
    japanese: str
    begins: bool

    def read(self, text: str) -> re.Match[str] | None:
        # Most patterns are told by a word that is not there, which is quicker than matching.
        return self.english.fullmatch(text) if all(literal in text for literal in self.literals) else None

    def filled(self, values: Iterable[str]) -> str:
        given, order = list(values), iter(range(self.english.groups))
        return _HOLE.sub(lambda hole: given[int(hole[1]) if hole[1] else next(order)], self.japanese)


@cache
def _patterns() -> tuple[_Pattern, ...]:
    found = []
    for english, other in patterns().items():
        literals = _HOLE.split(english)[::2]
        whole = re.compile("(.*?)".join(map(re.escape, literals)), re.DOTALL)
        found.append(_Pattern(tuple(literals), whole, len("".join(literals)), other, begins=literals[0][:1].isalpha()))
    return tuple(found)


@lru_cache(maxsize=1024)
def _read(text: str, depth: int = _DEEPEST) -> _Reading:
    """Return the best reading: that which knows the most letters."""
    best = _Reading(text, 0)
    if len(text) > _LONGEST or not depth:
        return best
    for pattern in _patterns():
        match = pattern.read(text)
        if match is not None:
            values = [_read(value, depth - 1) for value in match.groups()]
            known = pattern.known + sum(value.known for value in values)
            if known > best.known:
                best = _Reading(pattern.filled(value.text for value in values), known, pattern.begins)
    # What stands before the first colon is most often the name of something; a name may hold a colon itself.
    for nth, colon in enumerate(islice(re.finditer(_COLON, text), _MOST_COLONS)):
        cause = _read(text[colon.end() :], depth - 1)
        if cause.known > best.known or (nth == 0 and cause.known == best.known > 0):
            best = _Reading(f"{text[: colon.start()]}：{cause.text}", cause.known)
    return best
