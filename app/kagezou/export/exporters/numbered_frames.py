"""What exporters of numbered frames have in common: from choices to a request, and from summaries to an outcome."""

import os
from pathlib import Path

from kagezou.document.model import Document
from kagezou.export.choices import AS_CUT, ExportChoices, Place
from kagezou.export.exporters.exporter import Exporter, ExportOutcome
from kagezou.export.file_names import FileNames
from kagezou.export.frames import export_frames
from kagezou.export.made_files import MadeFile
from kagezou.export.request import Cancelled, ExportRequest, Missing, Progress, Summary
from kagezou.export.selection import chosen_frames
from kagezou.export.sequences import sequences_of
from kagezou.render.gpu.context import OpenContext


class NumberedFrames(Exporter[ExportRequest, Summary]):
    """An exporter of numbered frames; what it may write and asks for is left to its kinds."""

    __slots__ = ()

    def lacks(self) -> None:
        """Return nothing: every machine has what it needs."""

    def export(
        self,
        document: Document,
        request: ExportRequest,
        open_context: OpenContext,
        progress: Progress,
        cancelled: Cancelled,
    ) -> Summary:
        """Write the frames."""
        return export_frames(document, request, open_context, progress, cancelled)

    def outcome(self, made: Summary, place: Place) -> ExportOutcome:
        """Return what came of it; the folder is the one to look in."""
        return ExportOutcome(
            counts=made.counts,
            written=made.written,
            cancelled=made.cancelled,
            problem=made.failures[0].message if made.failures else None,
            where=place.folder,
            notes=made.notes,
        )

    def made_files(self, made: Summary) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""
        return made.made


def frames_request(document: Document, choices: ExportChoices, folder: Path, *, is_layered: bool) -> ExportRequest:
    """Return what numbered frames are asked for with.

    Parameters
    ----------
    folder
        Where the folders of the sequences are made.
    is_layered
        Whether each frame is one file that holds all layers; then nothing else is made beside it.
    """
    return ExportRequest(
        folder=folder,
        frames=frames_chosen(document, choices),
        format=choices.format,
        depth=choices.depth,
        composite=choices.composite and not is_layered,
        receivers=choices.receivers and not is_layered,
        united=choices.united and not is_layered,
        skip_existing=choices.skip_existing,
        workers=workers(),
        layered=is_layered,
        names=FileNames(choices.names, None if choices.start == AS_CUT else choices.start),
        missing=Missing(choices.missing),
    )


def frames_chosen(document: Document, choices: ExportChoices) -> tuple[int, ...] | None:
    """Return the frames of the work area where only it is chosen, None for the whole cut."""
    if not choices.only_work_area or document.work_area is None:
        return None
    first, last = document.played
    return tuple(range(first, last + 1))


def workers() -> int:
    """Return how many threads write: one core is left to the window."""
    return max((os.cpu_count() or 2) - 1, 1)


def sequence_lines(document: Document, request: ExportRequest) -> tuple[str, ...]:
    """Return a line for each sequence of a request: its first file, and how many there are."""
    frames = chosen_frames(document, request)
    files = [each.file(frames[0]).relative_to(request.folder) for each in sequences_of(document, request)]
    return tuple(f"{path.as_posix()}  × {len(frames)}" for path in files)
