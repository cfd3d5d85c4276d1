"""How scripts come to a cut: opened, made of drawings, or changed in its place while nobody else can change it."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.new_cut import NewCut, columns_of, new_cut
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.importing.understood import understood
from kagezou.interface.cut import Cut, document_of, kept_cut
from kagezou.interface.keeping import held, opened
from kagezou.interface.values import AnyPath, path_of, rate_of
from kagezou.io.project.file import load
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

DrawingChoice: TypeAlias = AnyPath | Mapping[str, AnyPath]
"""Drawings: names of characters with a folder, a pattern such as ``walk_#.png``, a picture or a PSD file each, from
the lowest to the topmost, ``"Hero=arm"`` for one more cel of Hero; or one file that holds a cut, such as a PSD."""


@dataclass(frozen=True, slots=True)
class NewWish:
    """What a new cut is to be like, as `kagezou.new` takes it."""

    background: AnyPath | None = None
    timesheet: AnyPath | None = None
    size: tuple[int, int] | None = None
    fps: str | float | Fraction | None = None
    template: AnyPath | Cut | None = None


def open_cut(path: AnyPath, open_context: OpenContext) -> Cut:
    """Return the cut of a project file.

    Raises
    ------
    ProjectProblem
        The file is missing, damaged or from a newer version.
    """
    where = path_of(path)
    document, seen = opened(where)
    return Cut(where, (), document, open_context, seen)


def make_cut(drawings: DrawingChoice, wish: NewWish, open_context: OpenContext) -> Cut:
    """Return a cut of drawings that was never saved.

    Raises
    ------
    UsageProblem, InputProblem, ProjectProblem
        A file cannot be found or read, or a name is none.
    """
    sheet = None if wish.timesheet is None else path_of(wish.timesheet)
    if not isinstance(drawings, Mapping) and path_of(drawings).suffix.lower() in TIMESHEET_SUFFIXES:
        sheet = path_of(drawings)
        sources: Sequence[CharacterSource] = columns_of(sheet)
    else:
        sources = _sources(drawings, is_timed=sheet is not None)
    wanted = NewCut(
        background=None if wish.background is None else path_of(wish.background),
        timesheet=sheet,
        size_px=wish.size,
        frame_rate=rate_of(wish.fps),
        template=_template(wish.template),
    )
    made = new_cut(sources, wanted)
    if not made.document.layers and made.document.background is None:
        raise UsageProblem(Message("there is no character and no background in it"))
    said = (*understood(made.document), *made.notes)
    return Cut(None, tuple(dict.fromkeys(map(str, said))), made.document, open_context)


def edit_cut(path: AnyPath, change: Callable[[Cut], Cut], open_context: OpenContext) -> Cut:
    """Open a project, change it and save it, while no other writer that asks can change it.

    Raises
    ------
    ProjectProblem, OutputProblem, DiskFullProblem
        It cannot be read or written, or somebody else holds it for half a minute.
    """
    where = path_of(path)
    open_cut(where, open_context)  # Before a lock is made beside a project that is not there.
    with held(where) as said:
        before = open_cut(where, open_context)
        after = change(before)
        notes = tuple(dict.fromkeys((*after.notes, *map(str, said))))
        if after == before:
            return replace(after, notes=notes)
        return kept_cut(after, where, None, said, force=True)


def _sources(drawings: DrawingChoice, *, is_timed: bool) -> list[CharacterSource]:
    if not isinstance(drawings, Mapping):
        return [CharacterSource(None, path_of(drawings))]
    sources = []
    for name, path in drawings.items():
        figure, _, cel = name.partition("=")
        sources.append(CharacterSource(cel or figure, path_of(path), is_timed, figure if cel else None))
    return sources


def _template(given: AnyPath | Cut | None) -> Document | None:
    match given:
        case None:
            return None
        case Cut():
            return document_of(given)
    return load(Path(path_of(given)))
