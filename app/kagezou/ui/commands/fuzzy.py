"""How well some typed letters fit a text, in English or Japanese."""

import unicodedata

_WHOLE, _WORD_START, _INSIDE, _SCATTERED = 4000, 3000, 2000, 1000
"""The four ways a word can be met, from the best on; within each, shorter texts and earlier places are better."""

_NEAR_START = 40
_GAP_COST = 8


def folded(text: str) -> str:
    """Return a text without what people type differently: case, width, and katakana for hiragana."""
    plain = unicodedata.normalize("NFKC", text).casefold()
    return "".join(chr(ord(letter) - 0x60) if "ァ" <= letter <= "ヶ" else letter for letter in plain)


def score(typed: str, text: str) -> int | None:
    """Return how well typed words fit a text, higher is better; None if one of them does not fit at all.

    Words may come in any order and each may leave letters out: "sv as" and "as save" both find "Save As". Nothing typed
    fits everything equally.
    """
    within = folded(text)
    found = [_word_score(word, within) for word in folded(typed).split()]
    if not all(found):
        return None
    return sum(each or 0 for each in found) - len(within)


def _word_score(word: str, text: str) -> int | None:
    at = text.find(word)
    if at < 0:
        return _scattered_score(word, text)
    if word == text:
        return _WHOLE
    starts = [place for place in _word_starts(text) if text.startswith(word, place)]
    return _WORD_START - min(starts[0], _NEAR_START) if starts else _INSIDE - min(at, _NEAR_START)


def _scattered_score(word: str, text: str) -> int | None:
    """Return the score of letters met in order with others between; the first must begin a word."""
    best = None
    for start in _word_starts(text):
        place, gaps = start - 1, 0
        for letter in word:
            next_place = text.find(letter, place + 1)
            if next_place < 0:
                break
            gaps += next_place > place + 1 and place >= start
            place = next_place
        else:
            if text[start] == word[0]:
                found = max(_SCATTERED - _GAP_COST * gaps - min(start, _NEAR_START), 1)
                best = found if best is None else max(best, found)
    return best


def _word_starts(text: str) -> list[int]:
    return [
        place for place, letter in enumerate(text) if letter.isalnum() and (place == 0 or text[place - 1] in " /-(")
    ]
