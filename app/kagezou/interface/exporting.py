"""Exports that scripts ask for, carried out, and what came of them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeAlias

from kagezou.document.model import Document
from kagezou.errors import AfterExportFailed
from kagezou.export.after.hooks import check_command, hand_on, hooks_of
from kagezou.export.after.manifest import Handover, manifest_of
from kagezou.export.made_files import MadeFile
from kagezou.export.request import Failure
from kagezou.interface.values import ProgressCallback, StopCallback
from kagezou.interface.wishes import ExportWish, asked
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

AfterExport: TypeAlias = str | Callable[[Mapping[str, Any]], object] | None
"""What comes after an export: a command, empty for nothing; a function that takes the manifest, on the same thread; or
None for what ``KAGEZOU_AFTER_EXPORT`` and installed packages say."""


@dataclass(frozen=True, slots=True)
class ExportedFile:
    """A file that an export left: what it is, of which layer, on which frame; the hash of its bytes where it is known.

    ``kind`` is a word such as ``"shadow"``, ``"composite"``, ``"script"`` or ``"video"``; ``is_new`` whether this
    export wrote it.
    """

    path: Path
    kind: str
    layer: str | None
    frame: int | None
    sha256: str | None
    is_new: bool


@dataclass(frozen=True, slots=True)
class Exported:
    """What came of an export.

    Parameters
    ----------
    files
        All that are there, whole.
    is_whole
        Whether they are all that was asked for.
    is_stopped
        Whether it was stopped.
    failures
        Frames that could not be made, each with why; only with ``keep_going``.
    where
        The folder, or the one file to look for.
    notes
        What is to be said, one sentence each.
    """

    files: tuple[ExportedFile, ...]
    is_whole: bool
    is_stopped: bool
    failures: tuple[tuple[tuple[int, ...], str], ...]
    where: Path
    notes: tuple[str, ...]
    _over: Handover = field(repr=False, compare=False)

    def manifest(self) -> dict[str, Any]:
        """Return what is handed to whatever comes after an export: what was made, from what, versions and hashes.

        Raises
        ------
        OutputProblem
            A file that was made cannot be read any more.
        """
        return dict(manifest_of(self._over))


@dataclass(frozen=True, slots=True)
class ExportJob:
    """An export to be carried out: of what, where it is kept, and with what it is drawn and watched."""

    document: Document
    project: Path | None
    open_context: OpenContext
    progress: ProgressCallback
    stop: StopCallback


def exported(job: ExportJob, wish: ExportWish, after: AfterExport) -> Exported:
    """Carry an export out, and what comes after it.

    Raises
    ------
    UsageProblem, InputProblem, OutputProblem, DiskFullProblem, GraphicsProblem
        As for the command line.
    HandingOnFailed
        The export is whole, and is its ``exported``, but what comes after it failed.
    """
    if after is None or isinstance(after, str):
        check_command(after)
    exporter, request, place = asked(wish, job.document, job.project)
    made = exporter.export(job.document, request, job.open_context, job.progress, job.stop)
    outcome, files = exporter.outcome(made, place), exporter.made_files(made)
    over = Handover(exporter.key, job.document, job.project, files, is_whole=outcome.is_whole, notes=outcome.notes)
    failures: tuple[Failure, ...] = getattr(made, "failures", ())
    came = Exported(
        files=_files(files, job.document),
        is_whole=outcome.is_whole,
        is_stopped=outcome.cancelled and not failures,
        failures=tuple((each.frames, str(each.message)) for each in failures),
        where=outcome.where,
        notes=tuple(str(each) for each in outcome.notes),
        _over=over,
    )
    return _handed_on(came, over, after, job.stop)


class HandingOnFailed(AfterExportFailed):
    """What comes after an export failed; ``exported`` is what came of the export, which is whole."""

    def __init__(self, problem: AfterExportFailed, came: Exported) -> None:
        super().__init__(problem.message, problem.notes)
        self.exported = came


def _handed_on(came: Exported, over: Handover, after: AfterExport, stop: StopCallback) -> Exported:
    if after is not None and not isinstance(after, str):
        if over.is_whole:
            return _taken_by(after, came, over)
        return _with_notes(came, (Message("not handed on to {hook}, as the export is not whole", hook=after),))
    try:
        return _with_notes(came, hand_on(over, hooks_of(after), stop))
    except AfterExportFailed as problem:
        raise HandingOnFailed(problem, came) from problem


def _taken_by(after: Callable[[Mapping[str, Any]], object], came: Exported, over: Handover) -> Exported:
    """Call a function of a script; whatever it raises takes nothing of the export along."""
    try:
        after(manifest_of(over))
    except Exception as error:
        cause = Message("{hook} failed: {cause}", hook=getattr(after, "__name__", after), cause=error)
        failed = AfterExportFailed(Message("the export is whole, but {what}", what=cause))
        raise HandingOnFailed(failed, came) from error
    return came


def _with_notes(came: Exported, notes: tuple[Message, ...]) -> Exported:
    return replace(came, notes=(*came.notes, *(str(each) for each in notes)))


def _files(made: tuple[MadeFile, ...], document: Document) -> tuple[ExportedFile, ...]:
    names = {each.id: each.name for each in document.layers} | {each.id: each.name for each in document.pieces}
    return tuple(
        ExportedFile(
            path=each.path,
            kind=each.kind,
            layer=names.get(each.owner),
            frame=each.frames[0] if each.frames else None,
            sha256=each.sha256 or None,
            is_new=each.is_new,
        )
        for each in made
    )
