"""A job for a render farm, which makes shadow layers or layered frames on other machines."""

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Exporter, ExportOutcome, Option
from kagezou.export.exporters.numbered_frames import frames_request, sequence_lines
from kagezou.export.farm import ASSETS, PARAMETERS, TEMPLATE, FarmRequest, write_bundle
from kagezou.export.farm_program import program_here
from kagezou.export.file_kinds import JOB_FILES, FileCount
from kagezou.export.made_files import JOB, MadeFile
from kagezou.export.request import LAYERED_SUFFIXES, SUFFIXES, Cancelled, Progress
from kagezou.export.selection import chosen_frames
from kagezou.io.files.faults import shown
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


@dataclass(frozen=True, slots=True)
class BundleRequest:
    """A job, and the folder that its bundle is written into."""

    job: FarmRequest
    folder: Path


class FarmJob(Exporter[BundleRequest, tuple[Path, ...]]):
    """A job bundle."""

    __slots__ = ()

    def lacks(self) -> None:
        """Return nothing: a farm renders on machines of its own."""

    def formats(self, choices: ExportChoices) -> tuple[str, ...]:
        """Return the formats of what the job makes."""
        return tuple(LAYERED_SUFFIXES if self.is_layered(choices) else SUFFIXES)

    def is_layered(self, choices: ExportChoices) -> bool:
        """Return what is chosen."""
        return choices.in_one

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return the files of the bundle, its tasks, and what comes of them."""
        export = self.request(document, choices, place).job.export
        tasks = -(-len(chosen_frames(document, export)) // choices.chunk)
        files = (TEMPLATE, PARAMETERS, ASSETS, f"{tasks} × {choices.chunk}")
        return (*files, *(f"    {line}" for line in sequence_lines(document, export)))

    def request(self, document: Document, choices: ExportChoices, place: Place) -> BundleRequest:
        """Return what the job is asked for with; it renders beside the project."""
        if place.project is None:
            raise UsageProblem(Message("a farm renders a saved project; save this one first"))
        output = place.project.with_name(f"{place.project.stem}_shadows")
        export = frames_request(document, choices, output, is_layered=self.is_layered(choices))
        return BundleRequest(FarmRequest(place.project, export, choices.chunk, program_here()), place.folder)

    def export(
        self,
        document: Document,
        request: BundleRequest,
        _open_context: OpenContext,
        progress: Progress,
        _cancelled: Cancelled,
    ) -> tuple[Path, ...]:
        """Write the bundle; nothing is drawn here."""
        made = write_bundle(document, request.job, request.folder)
        progress(len(made), len(made))
        return made

    def outcome(self, made: tuple[Path, ...], place: Place) -> ExportOutcome:
        """Return what came of it; the folder is the one to look in."""
        counts = (FileCount(JOB_FILES, len(made), len(made)),)
        return ExportOutcome(counts, len(made), cancelled=False, problem=None, where=place.folder)

    def made_files(self, made: tuple[Path, ...]) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""
        return tuple(MadeFile(path.absolute(), JOB) for path in made)

    def next_steps(self, document: Document, choices: ExportChoices, place: Place) -> tuple[Message, ...]:
        """Return how the job is sent, and where its frames go."""
        job = self.request(document, choices, place).job
        output = shown(job.export.folder)
        return (
            Message("AWS Deadline Cloud: deadline bundle submit {folder}", folder=shown(place.folder)),
            Message("Other farms: openjd run {template} --step Render", template=shown(place.folder / TEMPLATE)),
            Message(
                "The farm calls {program} and renders the saved project into {output}: save before you send the job.",
                program=job.program,
                output=output,
            ),
        )


FARM_JOB: Final = FarmJob(
    key="farm",
    label=Message("Render farm job"),
    purpose=Message("frames made by other machines"),
    icon="target-farm",
    verb="farm",
    options=frozenset(
        (
            Option.DEPTH,
            Option.IN_ONE,
            Option.UNITED,
            Option.COMPOSITE,
            Option.RECEIVERS,
            Option.ONLY_WORK_AREA,
            Option.CHUNK,
            Option.NAMES,
            Option.MISSING,
        )
    ),
)
