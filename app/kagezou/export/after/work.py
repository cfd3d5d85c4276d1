"""An export beside the window with what comes after it: its outcome is told whatever becomes of that."""

from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.document.model import Document
from kagezou.errors import AfterExportFailed, Problem
from kagezou.export.after.hooks import hand_on, hooks_of
from kagezou.export.after.manifest import Handover
from kagezou.export.exporters.exporter import ExportOutcome, Work
from kagezou.export.request import Cancelled, Progress
from kagezou.render.gpu.context import OpenContext


@dataclass(frozen=True, slots=True)
class HandedOnWork:
    """Work that is handed on when it is done.

    Parameters
    ----------
    work
        The export.
    kind
        The key of its exporter.
    document, project
        Of what it is, and the file that is kept in; None where it was never saved.
    command
        What runs after it, as for `hooks_of`.
    """

    work: Work
    kind: str
    document: Document
    project: Path | None
    command: str | None

    def __call__(self, open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
        """Carry it out; what becomes of what comes after it is among the notes."""
        came = self.work(open_context, progress, cancelled)
        over = Handover(self.kind, self.document, self.project, came.made, is_whole=came.is_whole, notes=came.notes)
        try:
            said = hand_on(over, hooks_of(self.command), cancelled)
        except AfterExportFailed as problem:
            said = (problem.message, *problem.notes)
        except Problem as problem:
            said = (problem.message,)
        return replace(came, notes=(*came.notes, *said))
