"""Files of text as programs of many systems write them: with marks of their encoding, wide letters, any line ends."""

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.message import Message

_MARKS: Final = (
    (b"\xff\xfe\0\0", "utf-32-le"),
    (b"\0\0\xfe\xff", "utf-32-be"),
    (b"\xef\xbb\xbf", "utf-8"),
    (b"\xff\xfe", "utf-16-le"),
    (b"\xfe\xff", "utf-16-be"),
)
"""Byte order marks, the longer ones first."""

_SOME: Final = 200
_CHUNK: Final = 1 << 20


def utf8_of(data: bytes) -> bytes:
    """Return a text as UTF-8 without a byte order mark; what cannot be told is left as it is."""
    for mark, encoding in _MARKS:
        if data.startswith(mark):
            return data[len(mark) :] if encoding == "utf-8" else _encoded(data[len(mark) :], encoding)
    start = data[: 2 * _SOME]
    # Every other byte of Latin text in wide letters is 0.
    if len(start) >= 8 and start[1::2].count(0) > 0.8 * len(start) / 2 and not start[::2].count(0):
        return _encoded(data, "utf-16-le")
    if len(start) >= 8 and start[::2].count(0) > 0.8 * len(start) / 2 and not start[1::2].count(0):
        return _encoded(data, "utf-16-be")
    return data


def lines_of(text: bytes) -> Iterator[bytes]:
    """Yield the lines of a text, whose ends are those of Unix, Windows or old Macs; few of them are held at once."""
    if b"\r" in text:
        text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    start = 0
    while start < len(text):
        end = text.find(b"\n", start + _CHUNK)
        end = len(text) if end < 0 else end
        yield from text[start:end].split(b"\n")
        start = end + 1


def bad_line(path: Path, number: int, words: bytes) -> InputProblem:
    """Return the problem of a line, counted from 1, in which these words make no sense."""
    text = b" ".join(words.split()).decode("utf-8", "replace")[:60]
    if b"," in words:
        return input_problem(
            path,
            Message(
                "line {number} has a comma in a number: {text!r}; please export it with decimal points",
                number=number,
                text=text,
            ),
        )
    return input_problem(path, Message("line {number} cannot be understood: {text!r}", number=number, text=text))


def _encoded(data: bytes, encoding: str) -> bytes:
    return data.decode(encoding, "replace").encode("utf-8", "replace")
