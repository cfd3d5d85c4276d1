"""The sizes of drawings, from their headers alone, and what is odd about them."""

from collections import Counter
from dataclasses import dataclass, replace
from typing import Final

from kagezou.document.model import Drawing
from kagezou.errors import InputProblem
from kagezou.importing.file_notes import odd_size, said_once
from kagezou.importing.progress import LoadPhase, Progress
from kagezou.io.images.reading import ImageInfo, probe
from kagezou.message import Message

MAX_SIDE_PX: Final = 16384

_SHOWN: Final = 3
"""So many drawings that cannot be opened are named."""


@dataclass(frozen=True, slots=True)
class MeasuredCels:
    """Drawings whose headers have been read.

    Parameters
    ----------
    drawings
        With their sizes, where they can be opened.
    size_px
        The largest width and the largest height.
    notes
        About drawings that differ or cannot be opened, and what of their files is not used, one sentence each.
    """

    drawings: tuple[Drawing, ...]
    size_px: tuple[int, int]
    notes: tuple[Message, ...]


def canvas_size(size_px: tuple[int, int]) -> tuple[int, int]:
    """Return the size of pictures as that of a canvas, px; raises InputProblem where that is too large."""
    if max(size_px) > MAX_SIDE_PX:
        raise InputProblem(
            Message(
                "a canvas of {width} × {height} px, as the pictures have it, "
                "is larger than {most_side_px} px; please give a size",
                width=size_px[0],
                height=size_px[1],
                most_side_px=MAX_SIDE_PX,
            )
        )
    return size_px


def measured_cels(
    name: str, drawings: tuple[Drawing, ...], progress: Progress, *, are_placed: bool = False
) -> MeasuredCels:
    """Return the drawings of a layer called ``name`` with their sizes; of some that are placed these may differ.

    Raises
    ------
    InputProblem
        None of them can be opened.
    """
    infos: list[tuple[Drawing, ImageInfo]] = []
    problems: list[InputProblem] = []
    for index, drawing in enumerate(drawings):
        progress(LoadPhase.OPENING, index, len(drawings))
        try:
            infos.append((drawing, probe(drawing.source)))
        except InputProblem as problem:
            problems.append(problem)
    if not infos:
        raise problems[0]
    notes = [problem.message for problem in problems[:_SHOWN]]
    if len(problems) > _SHOWN:
        notes.append(Message("{name}: {count} drawings cannot be opened", name=name, count=len(problems)))
    sizes = Counter((info.width_px, info.height_px) for _, info in infos)
    if not are_placed:
        notes += odd_size(name, [(drawing.path, info.width_px, info.height_px) for drawing, info in infos])
    known = {id(drawing): (info.width_px, info.height_px) for drawing, info in infos}
    sized = tuple(replace(drawing, size_px=known.get(id(drawing))) for drawing in drawings)
    size = (max(width for width, _ in sizes), max(height for _, height in sizes))
    notes += said_once(name, ((drawing.path, info.notes) for drawing, info in infos))
    return MeasuredCels(sized, size, tuple(notes))
