"""The words of a command line from a file, so that they depend on no console and no code page."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem, UsageProblem
from kagezou.message import Message

SIGN: Final = "@"
_LARGEST_BYTES: Final = 1 << 20


def given_words(words: Sequence[str]) -> list[str]:
    """Return the words of a command line; of ``@FILE`` alone those that the file has.

    It is UTF-8: a JSON list of texts, or one word a line, where empty lines are none. A file whose own name begins with
    the sign stays what it is.

    Raises
    ------
    InputProblem
        The file cannot be read, or is not UTF-8.
    UsageProblem
        It is no list of texts.
    """
    if len(words) != 1 or not words[0].startswith(SIGN) or len(words[0]) == 1 or _is_itself(words[0]):
        return list(words)
    path = Path(words[0][1:])
    text = _text_of(path)
    if not text.lstrip().startswith("["):
        return [line for line in text.splitlines() if line]
    try:
        found = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise _no_words(path, error) from error
    if not isinstance(found, list) or not all(isinstance(word, str) for word in found):
        raise _no_words(path, "not all of them are texts")
    # Two halves of a sign beyond 16 bit may come apart, and no name of a file has a zero.
    if any("\0" in word for word in found):
        raise _no_words(path, "a word has a zero in it")
    return found


def _is_itself(word: str) -> bool:
    try:
        return Path(word).is_file()
    except OSError:  # a name too long for the system
        return False


def _text_of(path: Path) -> str:
    from kagezou.io.files.faults import input_problem, shown

    try:
        with path.open("rb") as file:
            data = file.read(_LARGEST_BYTES + 1)
    except OSError as error:
        raise input_problem(path, error) from error
    if len(data) > _LARGEST_BYTES:
        raise InputProblem(Message("{path}: it is too large for the words of a command line", path=shown(path)))
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputProblem(Message("{path}: the words of a command line are UTF-8", path=shown(path))) from error


def _no_words(path: Path, cause: object) -> UsageProblem:
    from kagezou.io.files.faults import shown

    return UsageProblem(
        Message("{path}: it is no JSON list of the words of a command line: {cause}", path=shown(path), cause=cause)
    )
