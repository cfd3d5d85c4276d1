"""A video: the finished picture, or one layer's shadow alone."""

from typing import Final

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Exporter, ExportOutcome, Lack, Option, Work
from kagezou.export.exporters.importing_steps import laying_step, rate_words
from kagezou.export.exporters.numbered_frames import frames_chosen, workers
from kagezou.export.file_kinds import VIDEO, FileCount
from kagezou.export.made_files import VIDEO as VIDEO_WORD
from kagezou.export.made_files import MadeFile
from kagezou.export.names import safe_names
from kagezou.export.request import Cancelled, Missing, Progress
from kagezou.export.video import VideoRequest, VideoSummary, export_video, video_jobs
from kagezou.extras import VIDEO as VIDEO_PART
from kagezou.io.files.faults import output_problem
from kagezou.io.images.video import is_there
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


class VideoFile(Exporter[VideoRequest, VideoSummary]):
    """The cut as a video."""

    __slots__ = ()

    def lacks(self) -> Lack | None:
        """Return what is to be installed where videos cannot be written."""
        if is_there():
            return None
        return Lack(Message("writing videos needs a part that is not installed"), VIDEO_PART)

    def formats(self, _choices: ExportChoices) -> tuple[str, ...]:
        """Return every kind of video."""
        return ("mp4", "mov")

    def is_layered(self, _choices: ExportChoices) -> bool:
        """Return False."""
        return False

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return the file, how long and how large it is."""
        request = self.request(document, choices, place)
        length = sum(len(job.targets) for job in video_jobs(document, request))
        canvas = document.canvas
        rate = f"{float(canvas.frame_rate):.6g}"
        return (f"{request.path.name}  {length} @ {rate} fps  {canvas.width_px} × {canvas.height_px}",)

    def request(self, document: Document, choices: ExportChoices, place: Place) -> VideoRequest:
        """Return what the video is asked for with; it is called as the project, and as the layer it shows."""
        wanted = f"{place.name}_{choices.video_layer}_shadow" if choices.video_layer else place.name
        path = place.folder / f"{safe_names([wanted])[wanted]}.{choices.format}"
        frames, layer = frames_chosen(document, choices), choices.video_layer or None
        return VideoRequest(path, frames, layer, workers(), Missing(choices.missing))

    def export(
        self,
        document: Document,
        request: VideoRequest,
        open_context: OpenContext,
        progress: Progress,
        cancelled: Cancelled,
    ) -> VideoSummary:
        """Write the video."""
        return export_video(document, request, open_context, progress, cancelled)

    def outcome(self, made: VideoSummary, _place: Place) -> ExportOutcome:
        """Return what came of it; the file is what to look at."""
        there = int(made.is_whole)
        counts = (FileCount(VIDEO, there, 1),)
        where = made.path if made.is_whole else made.path.parent
        return ExportOutcome(counts, there, cancelled=not made.is_whole, problem=None, where=where, notes=made.notes)

    def made_files(self, made: VideoSummary) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""
        return (MadeFile(made.path, VIDEO_WORD),) if made.is_whole else ()

    def next_steps(self, document: Document, choices: ExportChoices, _place: Place) -> tuple[Message, ...]:
        """Return what the video is good for."""
        if choices.format == "mp4":
            return (
                Message("It plays in any player and browser: look at it, or send it round."),
                Message("H.264 has no alpha; for compositing, export shadow layers or a MOV."),
            )
        importing = Message(
            "Import it as footage of {rate} frames a second, with straight (unmatted) alpha.", rate=rate_words(document)
        )
        return (importing, laying_step(document)) if choices.video_layer else (importing,)

    def work(self, document: Document, choices: ExportChoices, place: Place) -> Work:
        """Return what carries the choices out; the folder is made, as it is for frames."""
        make = super().work(document, choices, place)

        def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
            try:
                place.folder.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise output_problem(place.folder, error) from error
            return make(open_context, progress, cancelled)

        return work


VIDEO_FILE: Final = VideoFile(
    key="video",
    label=Message("Video"),
    purpose=Message("a file to look at, or one with alpha"),
    icon="target-video",
    verb="video",
    options=frozenset((Option.VIDEO_LAYER, Option.ONLY_WORK_AREA, Option.MISSING)),
)
