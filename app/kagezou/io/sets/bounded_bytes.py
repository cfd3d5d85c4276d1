"""The bytes of sets from 3-D programs, as far as such files may go."""

from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.message import Message

MAX_BYTES: Final = 512 << 20


def state_of(path: Path) -> FileStamp:
    """Return size and times of change of a set's file.

    Raises
    ------
    InputProblem
        It is not there, no file or too large.
    """
    try:
        state = path.stat()
    except OSError as error:
        raise input_problem(path, error) from error
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, Message("it cannot be a file name")) from error
    if not path.is_file():
        raise input_problem(path, Message("it is not a file"))
    if state.st_size > MAX_BYTES:
        raise input_problem(
            path, Message("it is larger than {megabytes} MB, too large for a set", megabytes=MAX_BYTES >> 20)
        )
    return stamp_of(state)


def bytes_of(path: Path) -> bytes:
    """Return what is in a set's file.

    Raises
    ------
    InputProblem
        It cannot be read or is too large.
    """
    state_of(path)
    try:
        return path.read_bytes()
    except OSError as error:
        raise input_problem(path, error) from error


def check_inside(path: Path, name: str) -> None:
    """See that what a set's file refers to lies in its folder or below; nobody is asked for it else.

    Raises
    ------
    InputProblem
        It lies elsewhere, or on a network.
    """
    outside = ":" in name or "\\" in name or "\0" in name or name.startswith("/") or ".." in name.split("/")
    if outside or not (path.parent / name).resolve().is_relative_to(path.parent.resolve()):
        raise input_problem(
            path, Message("it refers to {name!r} outside its own folder, which is not followed", name=name[:80])
        )
