"""Timesheet files of any kind: all the sheets in one, and the one that is meant."""

import unicodedata
from dataclasses import replace
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.sheets.sheet_text import text_of
from kagezou.io.sheets.sts import is_sts, sts_sheet
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.io.sheets.xdts import sheets_of
from kagezou.message import Message

MAX_BYTES: Final = 32 << 20


def read_timesheet(path: Path, which: str | None = None) -> Timesheet:
    """Return the timesheet at ``path``: XDTS, TDTS or STS, told apart by what is in it.

    Parameters
    ----------
    path
        The file.
    which
        The name of one of several sheets in it, or its number from 1 up, which may have a ``#`` before it; None for the
        first.

    Raises
    ------
    InputProblem
        It cannot be read, is no timesheet or has no such sheet: one sentence with the place of what is wrong.
    """
    sheets = read_sheets(path)
    names = sheet_names(sheets)
    index = 0 if which is None else _index_of(which, names)
    if index is None:
        raise InputProblem(
            Message(
                "{path}: there is no sheet {which!r} in it, but {names}",
                path=shown(path),
                which=which,
                names=", ".join(f"{number} ({name})" for number, name in enumerate(names, start=1)),
            )
        )
    sheet = sheets[index]
    if len(sheets) == 1:
        return sheet
    others = ", ".join(name for at, name in enumerate(names) if at != index)
    note = Message(
        "of its {count} sheets {name} is used, not {others}", count=len(sheets), name=names[index], others=others
    )
    return replace(sheet, notes=(note, *sheet.notes))


def read_sheets(path: Path) -> tuple[Timesheet, ...]:
    """Return all sheets in the timesheet file at ``path``, at least one.

    Raises
    ------
    InputProblem
        It cannot be read or is no timesheet: one sentence with the place of what is wrong.
    """
    try:
        path = on_disk(path)
        if path.exists() and not path.is_file():
            raise input_problem(path, Message("it is not a file"))
        with path.open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            raise input_problem(
                path, Message("it is larger than {megabytes} MB, too large for a timesheet", megabytes=MAX_BYTES >> 20)
            )
        if is_sts(data):
            return (sts_sheet(data),)
        text, notes = text_of(data)
        return tuple(replace(sheet, notes=(*notes, *sheet.notes)) for sheet in sheets_of(text))
    except OSError as error:
        raise input_problem(path, error) from error
    except ProjectProblem as problem:
        raise input_problem(path, problem.message) from problem
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, Message("it cannot be a file name")) from error


def sheet_names(sheets: tuple[Timesheet, ...]) -> list[str]:
    """Return what the sheets of a file are called: by their names, else by their numbers."""
    return [sheet.name or str(number) for number, sheet in enumerate(sheets, start=1)]


def _index_of(which: str, names: list[str]) -> int | None:
    """Return which sheet is meant, by name before number."""
    wanted = _plain(which)
    plain = [_plain(name) for name in names]
    if wanted in plain:
        return plain.index(wanted)
    figures = wanted.removeprefix("#")
    number = int(figures) if figures.isdecimal() and len(figures) < 6 else 0
    return number - 1 if 1 <= number <= len(names) else None


def _plain(name: str) -> str:
    return unicodedata.normalize("NFKC", name).strip().casefold()
