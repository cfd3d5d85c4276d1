"""What lies in a folder, or one sentence for why that is not told."""

from pathlib import Path

from kagezou.io.files.faults import input_problem, output_problem


def entries_to_read(folder: Path) -> list[Path]:
    """Return what lies in a folder that is read from.

    Raises
    ------
    InputProblem
        The system refuses.
    """
    try:
        return list(folder.iterdir())
    except OSError as error:
        raise input_problem(folder, error) from error


def entries_to_write(folder: Path) -> list[Path]:
    """Return what lies in a folder that is written into; nothing where there is none yet.

    Raises
    ------
    OutputProblem
        The system refuses.
    """
    try:
        return list(folder.iterdir()) if folder.is_dir() else []
    except OSError as error:
        raise output_problem(folder, error) from error
