"""Files a user keeps: small texts that are read whole, and removed when they are not wanted any more."""

from pathlib import Path

from kagezou.errors import InputProblem, OutputProblem, ProjectProblem
from kagezou.io.files.faults import cause_of, shown
from kagezou.message import Message


def small_text(path: Path, most_bytes: int, too_large: Message) -> str:
    """Return the UTF-8 text of a file.

    Raises
    ------
    InputProblem
        The system refuses to read it; one sentence naming the file.
    ProjectProblem
        What is wrong with its contents, without the file's name: ``too_large`` for more than ``most_bytes``, or that
        it is not text.
    """
    try:
        with path.open("rb") as file:
            data = file.read(most_bytes + 1)
    except OSError as error:
        raise InputProblem(
            Message("{path} cannot be read: {cause}", path=shown(path), cause=cause_of(error))
        ) from error
    if len(data) > most_bytes:
        raise ProjectProblem(too_large)
    try:
        return data.decode()
    except UnicodeDecodeError as error:
        raise ProjectProblem(Message("it is not UTF-8 text")) from error


def folder_problems(folder: Path, variable: str) -> tuple[InputProblem, ...]:
    """Return what is wrong with a folder that a variable of the environment names; nothing where it can be read."""
    try:
        next(folder.iterdir(), None)
    except (OSError, ValueError) as error:  # a NUL in the name
        cause = cause_of(error) if isinstance(error, OSError) else str(error)
        words = Message("{variable}: {path}: {cause}", variable=variable, path=shown(folder), cause=cause)
        return (InputProblem(words),)
    return ()


def remove_file(path: Path) -> None:
    """Remove a file; one that is not there is removed already.

    Raises
    ------
    OutputProblem
        The system refuses; one sentence naming the file.
    """
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise OutputProblem(
            Message("{path}: cannot be removed: {cause}", path=shown(path), cause=cause_of(error))
        ) from error
