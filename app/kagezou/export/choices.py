"""What a person chooses for an export: how, whatever it is for, and where to."""

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.export.file_names import USUAL
from kagezou.export.request import Missing

AS_CUT: Final = -1
"""Files bear the numbers that the frames of the cut bear."""


@dataclass(frozen=True, slots=True)
class ExportChoices:
    """One way to export; what an exporter does not know is left alone.

    Parameters
    ----------
    kind
        The key of an exporter.
    only_work_area
        Whether frames outside the work area are left out; a hand-off to After Effects always has them all.
    format
        One of those of its exporter.
    depth, composite, receivers, united, skip_existing
        As of `ExportRequest`.
    missing
        A word of `Missing`.
    in_one
        Whether a farm makes frames of layers instead of shadow layers.
    per_drawing, copies, mattes, controls
        As of `HandOffRequest`.
    chunk
        Frames a task of a farm.
    names
        The pattern of `FileNames`.
    start
        The number of the file of the first frame, or `AS_CUT`.
    video_layer
        The name of the layer whose shadow a video shows; empty for the finished picture.
    """

    kind: str = "layers"
    only_work_area: bool = False
    format: str = "png"
    depth: int = 8
    composite: bool = False
    receivers: bool = False
    united: bool = False
    in_one: bool = False
    skip_existing: bool = True
    missing: str = Missing.FAIL.value
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    controls: bool = False
    chunk: int = 10
    names: str = USUAL
    start: int = AS_CUT
    video_layer: str = ""


@dataclass(frozen=True, slots=True)
class Place:
    """Where an export goes, and what it is of: the project's file, if there is one, and its name."""

    folder: Path
    project: Path | None
    name: str
