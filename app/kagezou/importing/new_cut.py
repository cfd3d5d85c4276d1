"""A new cut of what was named: characters, a background, a timesheet, and perhaps another project as a template."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.document.set_pieces import stood_up, stood_up_notes
from kagezou.document.taking import Part, taken
from kagezou.importing.imported import Imported
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.oca_project import as_long_as, oca_among
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.sheet_project import check_seen, sources_beside, timed_from_beside
from kagezou.importing.staging import new_document, with_timesheet
from kagezou.io.files.spellings import on_disk
from kagezou.io.sheets.reading import read_timesheet
from kagezou.picture_source import PicturePart

_RATE: Final = Fraction(24)


@dataclass(frozen=True, slots=True)
class NewCut:
    """What a cut is to be like besides its drawings.

    Parameters
    ----------
    background
        A picture, or a folder or a pattern of pictures; None for none.
    timesheet, which
        A timesheet's file, and which of several sheets in it, as for `read_timesheet`.
    size_px, frame_rate
        Of the canvas; None for those of an OCA document, else of the template, else of the pictures and 24.
    template
        A cut whose light, looks, ground, set and first number are taken.
    """

    background: Path | PicturePart | None = None
    timesheet: Path | None = None
    which: str | None = None
    size_px: tuple[int, int] | None = None
    frame_rate: Fraction | None = None
    template: Document | None = None


def columns_of(timesheet: Path, which: str | None = None) -> tuple[CharacterSource, ...]:
    """Return the drawings of a timesheet's columns, which lie beside it.

    Raises
    ------
    InputProblem
        It cannot be read, or there are no drawings of any of its columns.
    """
    path = on_disk(timesheet.absolute())
    return tuple(sources_beside(path, read_timesheet(path, which)))


def new_cut(sources: Sequence[CharacterSource], wanted: NewCut, progress: Progress = no_progress) -> Imported:
    """Return a new document of characters, from bottom to top, timed by a sheet where there is one.

    Raises
    ------
    InputProblem, UsageProblem
        As for `new_document` and `read_timesheet`.
    """
    cut, like = oca_among(sources), wanted.template
    size = cut.size_px if cut else None if like is None else (like.canvas.width_px, like.canvas.height_px)
    rate = cut.frame_rate if cut else _RATE if like is None else like.canvas.frame_rate
    imported = new_document(
        sources,
        background=wanted.background,
        size=wanted.size_px or size,
        frame_rate=wanted.frame_rate or rate,
        progress=progress,
    )
    imported = imported if cut is None else as_long_as(imported, cut)
    if wanted.timesheet is None:
        return _like(timed_from_beside(imported, sources), like)
    timed = with_timesheet(imported.document, wanted.timesheet, wanted.which)
    check_seen(timed.document, wanted.timesheet)
    return _like(replace(timed, notes=(*imported.notes, *timed.notes)), like)


def _like(imported: Imported, template: Document | None) -> Imported:
    """Return a new cut with all that can be taken of a template: a frame's number and the production are part of it."""
    if template is None:
        return imported
    like = with_parts(imported, template, frozenset(Part))
    canvas = replace(like.document.canvas, first_frame=template.canvas.first_frame)
    slate = replace(like.document.slate, name=template.slate.name)
    return replace(like, document=replace(like.document, canvas=canvas, slate=slate))


def with_parts(imported: Imported, template: Document, parts: Collection[Part]) -> Imported:
    """Return a new cut with parts of a template; on its set the figures stand upright."""
    done = taken(imported.document, template, parts)
    stood = stood_up(done.document) if Part.SET in parts and done.document.pieces else done.document
    notes = (*imported.notes, *done.notes, *stood_up_notes(done.document, stood))
    return replace(imported, document=stood, notes=notes)
