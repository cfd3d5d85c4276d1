"""Files of values: properties by the paths people write, each with its value or its keys as a project file has them."""

from pathlib import Path
from typing import Final

from kagezou.animation.track import Track
from kagezou.document.address import Address, resolve
from kagezou.document.model import Document
from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.files.faults import shown
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.files.small_files import small_text
from kagezou.io.project.reading import read_track
from kagezou.message import Message

_MAX_BYTES: Final = 1 << 26


def load_tracks(path: Path, document: Document) -> tuple[tuple[Address, Track], ...]:
    """Return the tracks of a file, ``{"layers.A.scale": [50, 50], "layers.A.position": {"keys": [...]}}``.

    Raises
    ------
    InputProblem
        It cannot be read or holds something else; one sentence with the place of the first thing that is wrong.
    UsageProblem
        The document has no such property.
    """
    try:
        text = small_text(path, _MAX_BYTES, Message("it is too large for values"))
        rows = Reader(parse(text)).members()
        addresses = {name: resolve(document, name) for name in rows}
        return tuple((addresses[name], read_track(row, addresses[name].property)) for name, row in rows.items())
    except ProjectProblem as problem:
        raise InputProblem(
            Message("{path} does not hold values: {cause}", path=shown(path), cause=problem)
        ) from problem
