"""The project file: one UTF-8 JSON text with relative paths, safe to read from a stranger and easy to compare.

Loading opens nothing but the file itself: the pictures it names are not touched, nothing runs, nothing is written. Only
names that Unicode can write in two ways are looked for, as the project may come from a system that keeps the other one.
`FORMAT.md` beside this module describes every key.
"""

import hashlib
import os
import re
import time
from pathlib import Path
from typing import Final

from kagezou.document import invariants
from kagezou.document.model import Document
from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import sweep_stale, write_bytes
from kagezou.io.files.faults import cause_of, shown
from kagezou.io.files.json_text import Reader, formatted, parse
from kagezou.io.files.spellings import on_disk
from kagezou.io.project.file_state import FileState
from kagezou.io.project.path_changes import as_on_disk
from kagezou.io.project.paths import absolute
from kagezou.io.project.reading import document_of
from kagezou.io.project.versions import upgraded
from kagezou.io.project.writing import tree_of
from kagezou.message import Message

_VERSION: Final = re.compile(r"(.+)_(\d{2,5})")

MAX_BYTES: Final = 32 << 20
"""A project larger than this is refused before it is read."""


def load(path: Path) -> Document:
    """Return the document of the project at ``path``; its pictures have absolute paths and are not opened.

    Raises
    ------
    ProjectProblem
        The file is missing, unreadable, damaged or from a newer program: one sentence with the file's name and the
        JSON path of what is wrong.
    """
    try:
        path = on_disk(path)
        return as_on_disk(loads(_text_at(path), absolute(path).parent))
    except OSError as error:
        raise ProjectProblem(Message("{path}: {cause}", path=shown(path), cause=cause_of(error))) from error
    except ProjectProblem as problem:
        raise ProjectProblem(Message("{path}: {cause}", path=shown(path), cause=problem)) from problem


def next_version(path: Path) -> Path:
    """Return the path of the next version of a project that is not there yet: ``walk`` → ``walk_002``, and so on."""
    found = _VERSION.fullmatch(path.stem)
    name, number, digits = (found[1], int(found[2]), len(found[2])) if found else (path.stem, 1, 3)
    while True:
        number += 1
        wanted = path.with_name(f"{name}_{number:0{digits}d}{path.suffix}")
        if not wanted.exists():
            return wanted


def save(document: Document, path: Path) -> FileState:
    """Write the project as a whole or not at all, and return what its file is like; the old one stays as ``NAME~``.

    Raises
    ------
    ProjectProblem
        The document cannot be kept in a project that loads again.
    DiskFullProblem, OutputProblem
        The file cannot be written; the old one is still there.
    """
    folder = absolute(path).parent
    try:
        text = dumps(document, folder)
        loads(text, folder)
    except ProjectProblem as problem:
        raise ProjectProblem(Message("{path}: cannot be saved: {cause}", path=shown(path), cause=problem)) from problem
    data = text.encode("utf-8")
    write_bytes(path, data, keep_previous=True)
    sweep_stale(folder)
    # Of what was written, not of what lies there by now.
    return FileState(len(data), hashlib.sha256(data).hexdigest(), int(time.time()))


def dumps(document: Document, folder: Path) -> str:
    """Return the text of a project file that lies in ``folder``.

    Raises
    ------
    ProjectProblem
        A picture lies where a project cannot name it, or the text is larger than a project may be.
    """
    text = formatted(tree_of(document, absolute(folder)))
    # Bytes are counted only where they could be too many: a character has at most four.
    if len(text) > MAX_BYTES // 4 and len(text.encode("utf-8")) > MAX_BYTES:
        raise ProjectProblem(_too_large())
    return text


def loads(text: str, folder: Path) -> Document:
    """Return the document of a project's text; relative paths start at ``folder``.

    Raises
    ------
    ProjectProblem
        With the JSON path of what is wrong.
    """
    document = document_of(Reader(upgraded(parse(text))), absolute(folder))
    invariants.check(document)
    return document


def _text_at(path: Path) -> str:
    try:
        if path.exists() and not path.is_file():
            raise ProjectProblem(Message("it is not a file"))
        with path.open("rb") as stream:
            if os.fstat(stream.fileno()).st_size > MAX_BYTES:
                raise ProjectProblem(_too_large())
            return stream.read(MAX_BYTES + 1).decode("utf-8")
    except UnicodeDecodeError as error:
        raise ProjectProblem(Message("it is not UTF-8 text (byte {start})", start=error.start + 1)) from error
    except ValueError as error:  # a NUL in the name
        raise ProjectProblem(Message("it cannot be the name of a file")) from error


def _too_large() -> Message:
    return Message("it is larger than {megabytes} MB, too large for a project", megabytes=MAX_BYTES >> 20)
