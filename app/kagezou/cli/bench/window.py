"""What the window is measured with, and how its figures are told."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from kagezou.animation.track import Interpolation
from kagezou.cli.demo.stage import CHARACTER, make_drawings
from kagezou.cli.terminal import Json, ProgressLine
from kagezou.document.address import Address
from kagezou.document.edits import set_canvas, set_key
from kagezou.document.model import Document
from kagezou.document.properties import OF_LAYER
from kagezou.importing.staging import CharacterSource, new_document

FRAMES = 48
SIZE_PX = (1920, 1080)
LAYERS = 20
KEYS = 102


class Answered(Protocol):
    """How the window answered to one thing that was done."""

    @property
    def name(self) -> str:
        """What was done."""
        ...

    @property
    def paints_a_second(self) -> float:
        """How often something new was seen."""
        ...

    @property
    def latency_ms(self) -> float | None:
        """From input to paint, the median."""
        ...

    @property
    def late_ms(self) -> float | None:
        """What one in twenty exceeds."""
        ...


MeasureWindow = Callable[[Document, Document], tuple[str, Sequence[Answered]]]
"""Measures the window with the walk and the crowd of :func:`documents`; returns what draws, and the figures."""


def documents(folder: Path, workers: int) -> tuple[Document, Document]:
    """Return a walk of 48 frames, and a crowd of 20 layers with 102 keys each on one property."""
    with ProgressLine("drawing") as line:
        make_drawings(folder, workers, line.update, FRAMES)
    walk = new_document([CharacterSource(CHARACTER, folder)], size=SIZE_PX).document
    source = sorted(folder.glob("*.png"))[0]
    names = [f"{CHARACTER} {number}" for number in range(1, LAYERS + 1)]
    crowd = new_document([CharacterSource(name, source) for name in names], size=SIZE_PX).document
    crowd = set_canvas(crowd, replace(crowd.canvas, length_frames=KEYS))
    for number, layer in enumerate(crowd.layers):
        address = Address(OF_LAYER["shadow.opacity"], layer.id)
        for frame in range(1, KEYS + 1):
            value = 0.2 + 0.6 * ((7 * frame + 3 * number) % 19) / 19
            crowd = set_key(crowd, address, frame, value, Interpolation.BEZIER)
    return walk, crowd


def lines(answers: Sequence[Answered]) -> list[str]:
    """Return the figures as lines of a table."""
    rows = [f"  {'':<24} {'paints/s':>9} {'input to paint':>15} {'late (1 in 20)':>15}"]
    for each in answers:
        waits = ["-" if ms is None else f"{ms:.0f} ms" for ms in (each.latency_ms, each.late_ms)]
        rows.append(f"  {each.name:<24} {each.paints_a_second:>9.1f} {waits[0]:>15} {waits[1]:>15}")
    return rows


def report(answers: Sequence[Answered]) -> list[Json]:
    """Return the figures as values of JSON."""
    return [
        {
            "name": each.name,
            "paints_a_second": round(each.paints_a_second, 2),
            "latency_ms": None if each.latency_ms is None else round(each.latency_ms, 1),
            "late_ms": None if each.late_ms is None else round(each.late_ms, 1),
        }
        for each in answers
    ]
