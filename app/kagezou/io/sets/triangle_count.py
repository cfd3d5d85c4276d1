"""How many triangles a set may have."""

from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.message import Message

MAX_TRIANGLES: Final = 5_000_000


def too_many(path: Path, count: int, most: int = MAX_TRIANGLES) -> InputProblem:
    """Return the problem of a set with more triangles than can be worked with."""
    return input_problem(
        path, Message("it has {count} triangles, more than the {most} that can be worked with", count=count, most=most)
    )
