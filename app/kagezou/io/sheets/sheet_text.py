"""The text of a timesheet file, however it is encoded, and the JSON in it, whatever stands around that."""

import codecs
import json
import re
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.json_text import parse
from kagezou.message import Message

_MARKS: Final = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
_ZEROS: Final = ((0, "utf-16-be"), (1, "utf-16-le"))
_NO_LETTERS: Final = re.compile("[\x80\xa0\uf8f0-\uf8f3]")
"""What bytes become that Shift-JIS has no letters for."""

_EMPTY: Final = " \t\r\n\0\x1a\ufeff"


def text_of(data: bytes) -> tuple[str, tuple[Message, ...]]:
    """Return the text that ``data`` holds: UTF-8, UTF-16 or Shift-JIS; and what is to be said of that.

    Raises
    ------
    ProjectProblem
        It is none of these.
    """
    encoding = next((name for mark, name in _MARKS if data.startswith(mark)), "")
    if not encoding and data[:2] != b"\0\0":
        encoding = next((name for at, name in _ZEROS if data[at : at + 1] == b"\0"), "")
    try:
        if encoding:
            return data.decode(encoding), _encoding_notes(encoding)
        return data.decode("utf-8"), ()
    except UnicodeDecodeError as error:
        text = "" if encoding else data.decode("cp932", "replace")
        if not text or "\ufffd" in text or _NO_LETTERS.search(text):
            raise ProjectProblem(Message("it is not UTF-8 text")) from error
        return text, _encoding_notes("Shift-JIS")


def _encoding_notes(encoding: str) -> tuple[Message, ...]:
    if encoding.startswith("utf-8"):
        return ()
    name = "UTF-16" if encoding.startswith("utf-16") else encoding
    return (Message("its text is {encoding}, where UTF-8 is usual", encoding=name),)


def json_in(text: str) -> tuple[object, tuple[Message, ...]]:
    """Return the JSON value that a text begins with, and whether something stands behind it.

    Raises
    ------
    ProjectProblem
        As for `parse`.
    """
    whole = text.strip(_EMPTY)
    try:
        return parse(whole), ()
    except ProjectProblem:
        try:
            _, end = json.JSONDecoder().raw_decode(whole)
        except (ValueError, RecursionError):
            end = len(whole)
        if end == len(whole):
            raise
    return parse(whole[:end]), (Message("what stands behind its end is not used"),)
