"""What an export is to make: each different picture once, with every file that holds it."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.contents import Content
from kagezou.export.made_files import MadeFile, word_of
from kagezou.export.names import safe_names
from kagezou.export.request import ExportRequest
from kagezou.export.selection import chosen_frames
from kagezou.export.sequences import OutputSequence, sequences_of
from kagezou.export.uniting import cut_groups
from kagezou.io.files.memory import free_memory
from kagezou.message import Message
from kagezou.scene.evaluate import evaluate

_SHADOW_BYTES: Final = 5
PIXEL_BYTES: Final = 25
"""So much memory is taken for a pixel of the canvas while shadows, and while whole pictures are drawn: measured."""


@dataclass(frozen=True, slots=True)
class OutputFile:
    """One file of a sequence; ``frame`` is the first that it is for."""

    sequence: OutputSequence
    frame: int
    path: Path

    def made(self, sha256: str, *, is_new: bool) -> MadeFile:
        """Return what is told of it when it is there."""
        subject, label = self.sequence.subject, self.sequence.label
        return MadeFile(self.path, word_of(subject), label, subject.owner, (self.frame,), sha256, is_new)


@dataclass(frozen=True, slots=True)
class FrameJob:
    """One picture and the files it goes into.

    Parameters
    ----------
    content
        What it shows.
    targets
        In the order of their frames, never empty.
    """

    content: Content
    targets: tuple[OutputFile, ...]

    def only(self, targets: tuple[OutputFile, ...]) -> "FrameJob":
        """Return the job with some of its targets."""
        return replace(self, targets=targets)


@dataclass(frozen=True, slots=True)
class Plan:
    """Everything an export is to make: the pictures in the order of their first frames, sequences and names.

    ``names`` holds, for the name of each layer that has sequences of its own, the one that they carry; ``notes`` what
    is to be said, one sentence each.
    """

    jobs: tuple[FrameJob, ...]
    sequences: tuple[OutputSequence, ...]
    names: dict[str, str]
    notes: tuple[Message, ...] = ()

    @property
    def files(self) -> int:
        """How many files that are."""
        return sum(len(job.targets) for job in self.jobs)

    @property
    def folders(self) -> tuple[Path, ...]:
        """The folders of the sequences, each once."""
        return tuple(dict.fromkeys(sequence.folder for sequence in self.sequences))

    def pictures_of(self, sequence: OutputSequence) -> tuple[int, ...]:
        """Return which picture, from 0 in the order in which they appear, a sequence shows on each of its frames."""
        shown: dict[int, int] = {}
        number = 0
        for job in self.jobs:
            frames = [target.frame for target in job.targets if target.sequence == sequence]
            shown.update(dict.fromkeys(frames, number))
            number += bool(frames)
        return tuple(shown[frame] for frame in sorted(shown))


def planned(document: Document, request: ExportRequest) -> Plan:
    """Return what an export is to make.

    Raises
    ------
    UsageProblem
        A layer or a frame is asked for that the document does not have, there is nothing to make, or the canvas
        is too large to be drawn.
    """
    frames = chosen_frames(document, request)
    _check_memory(document, request)
    sequences = sequences_of(document, request)
    jobs = jobs_of(document, frames, sequences)
    if request.once:
        jobs = tuple(_each_once(jobs))
    owners = {sequence.subject.owner for sequence in sequences}
    names = safe_names(layer.name for layer in document.layers)
    carried = {each.name: names[each.name] for each in document.layers if each.id in owners}
    return Plan(jobs, sequences, carried, _notes(document, request))


def _check_memory(document: Document, request: ExportRequest) -> None:
    """Refuse a canvas that the machine cannot draw, before anything is allocated for it."""
    canvas, free = document.canvas, free_memory()
    of_pixel = PIXEL_BYTES if request.composite or request.layered else _SHADOW_BYTES
    needed = canvas.width_px * canvas.height_px * of_pixel
    if free is not None and needed > free:
        raise UsageProblem(
            Message(
                "a canvas of {width} × {height} px needs about {needed} MB of memory to be drawn, "
                "of which {free} MB are free",
                width=canvas.width_px,
                height=canvas.height_px,
                needed=needed >> 20,
                free=free >> 20,
            )
        )


def _notes(document: Document, request: ExportRequest) -> tuple[Message, ...]:
    """Return what is to be said about shadows that unite in the picture but not in what is made."""
    if not request.united and not request.layered:
        return ()
    return cut_groups(document, of_one_color=request.layered).notes()


def jobs_of(document: Document, frames: Iterable[int], sequences: tuple[OutputSequence, ...]) -> tuple[FrameJob, ...]:
    """Return the different pictures of some sequences in the order of their first frames."""
    targets: dict[Content, list[OutputFile]] = {}
    for frame in frames:
        scene = evaluate(document, frame)
        for sequence in sequences:
            content = sequence.subject.content_at(document, scene, frame)
            targets.setdefault(content, []).append(OutputFile(sequence, frame, sequence.file(frame)))
    # A dictionary keeps the key that came first: a picture is drawn from the first frame that shows it.
    return tuple(FrameJob(content, tuple(files)) for content, files in targets.items())


def in_order(jobs: Iterable[FrameJob]) -> tuple[FrameJob, ...]:
    """Return the jobs of one sequence one after the other: a picture that comes again is one more job."""
    shown = [(target, job) for job in jobs for target in job.targets]
    shown.sort(key=lambda each: each[0].frame)
    return tuple(
        run[0][1].only(tuple(target for target, _ in run))
        for run in (list(group) for _, group in groupby(shown, key=lambda each: id(each[1])))
    )


def _each_once(jobs: tuple[FrameJob, ...]) -> Iterator[FrameJob]:
    """Yield the jobs with one target in each sequence they go to, numbered from 1."""
    numbers: dict[OutputSequence, int] = {}
    for job in jobs:
        first = {target.sequence: target for target in reversed(job.targets)}
        targets = []
        for sequence in dict.fromkeys(target.sequence for target in job.targets):
            numbers[sequence] = numbers.get(sequence, 0) + 1
            targets.append(replace(first[sequence], path=sequence.file(numbers[sequence])))
        yield job.only(tuple(targets))
