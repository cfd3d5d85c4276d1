"""A cut of a batch."""

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Cut:
    """A cut: the name of its folder in the output, and where its files lie."""

    name: str
    path: Path
