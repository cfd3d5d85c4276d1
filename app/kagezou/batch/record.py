"""What is kept of a cut beside its output: how it went, what it was made of, and small pictures of it.

The file lies in the folder of the cut. It holds no language, so that a report in any can be made of it, and paths
relative to that folder.
"""

import base64
import binascii
import json
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import Any, Final

from kagezou.batch.told import Json, json_of_message, message_of_json
from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.json_text import parse
from kagezou.io.project.file_state import NEVER_SEEN, FileState
from kagezou.message import Message

RECORD_NAME: Final = ".kagezou-cut.json"
REPORT_NAME: Final = "report.html"
_VERSION: Final = 1
_MAX_BYTES: Final = 64 << 20


class State(StrEnum):
    """How a cut went."""

    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"
    KEPT = "kept"
    STOPPED = "stopped"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Thumbnail:
    """A small picture of a frame.

    Parameters
    ----------
    frame
        From 1.
    jpeg
        The bytes of its file.
    is_doubtful
        Whether which foot carries is doubtful there.
    """

    frame: int
    jpeg: bytes
    is_doubtful: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class CutRecord:
    """What is known of a cut.

    Parameters
    ----------
    name
        That of its folder.
    state
        How it went.
    problem
        Why it failed, or what of it did.
    notes
        What was said, one sentence each.
    doubtful
        For each layer with doubtful feet its name and the frames of the drawings.
    layers
        The names of its characters.
    frames, rate, size_px
        The length of the cut, frames a second, and its canvas.
    seconds
        How long it took.
    project, where
        The project and what is to be looked at, relative to the cut's folder; empty where there is none.
    saved
        The project's file as it was written by the program.
    seen
        The project's file as the output was made of it.
    made_of
        Changes with anything that decides what comes of the cut.
    folders
        The folders that are looked at for `made_of`, absolute.
    files
        The files of the output and their sizes, relative.
    counts
        What the output is, in words, with how many of how many files.
    thumbnails
        Frames spread over the cut, and doubtful ones.
    """

    name: str
    state: State
    problem: Message | None = None
    notes: tuple[Message, ...] = ()
    doubtful: tuple[tuple[str, tuple[int, ...]], ...] = ()
    layers: tuple[str, ...] = ()
    frames: int = 0
    rate: float = 0.0
    size_px: tuple[int, int] = (0, 0)
    seconds: float = 0.0
    project: str = ""
    where: str = ""
    saved: FileState = NEVER_SEEN
    seen: FileState = NEVER_SEEN
    made_of: str = ""
    folders: tuple[str, ...] = ()
    files: tuple[tuple[str, int], ...] = ()
    counts: tuple[tuple[Message, int, int], ...] = ()
    thumbnails: tuple[Thumbnail, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether everything that was asked for is there."""
        return self.state in (State.DONE, State.KEPT)


def read_record(folder: Path) -> CutRecord | None:
    """Return the record in the folder of a cut; None where there is none that can be read."""
    try:
        path = folder / RECORD_NAME
        if path.stat().st_size > _MAX_BYTES:
            return None
        return _record(folder.name, parse(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, ProjectProblem, LookupError, TypeError, binascii.Error):
        return None


def write_record(record: CutRecord, folder: Path) -> None:
    """Write the record of a cut into its folder.

    Raises
    ------
    OutputProblem, DiskFullProblem
        It cannot be written.
    """
    write_bytes(folder / RECORD_NAME, json.dumps(_tree(record), ensure_ascii=False).encode("utf-8", "replace"))


def kept(record: CutRecord) -> CutRecord:
    """Return the record of a cut that was left alone."""
    return replace(record, state=State.KEPT)


def _tree(record: CutRecord) -> Json:
    return {
        "kagezou_cut": _VERSION,
        "state": record.state.value,
        "problem": None if record.problem is None else json_of_message(record.problem),
        "notes": [json_of_message(each) for each in record.notes],
        "doubtful": [[name, list(frames)] for name, frames in record.doubtful],
        "layers": list(record.layers),
        "frames": record.frames,
        "rate": record.rate,
        "size_px": list(record.size_px),
        "seconds": round(record.seconds, 3),
        "project": record.project,
        "where": record.where,
        "saved": _tree_of_state(record.saved),
        "seen": _tree_of_state(record.seen),
        "made_of": record.made_of,
        "folders": list(record.folders),
        "files": [[name, size] for name, size in record.files],
        "counts": [[json_of_message(kind), there, whole] for kind, there, whole in record.counts],
        "thumbnails": [
            [each.frame, each.is_doubtful, base64.b64encode(each.jpeg).decode("ascii")] for each in record.thumbnails
        ],
    }


def _tree_of_state(state: FileState) -> Json:
    return [state.size, state.sha256, state.modified_s]


def _record(name: str, tree: Any) -> CutRecord:
    """Return a record of its JSON; LookupError, TypeError or ValueError where it is none."""
    if tree["kagezou_cut"] != _VERSION:
        raise ValueError
    width, height = tree["size_px"]
    return CutRecord(
        name=name,
        state=State(tree["state"]),
        problem=None if tree["problem"] is None else message_of_json(tree["problem"]),
        notes=tuple(message_of_json(each) for each in tree["notes"]),
        doubtful=tuple((str(layer), tuple(int(each) for each in frames)) for layer, frames in tree["doubtful"]),
        layers=tuple(str(each) for each in tree["layers"]),
        frames=int(tree["frames"]),
        rate=float(tree["rate"]),
        size_px=(int(width), int(height)),
        seconds=float(tree["seconds"]),
        project=_inside(tree["project"]),
        where=_inside(tree["where"]),
        saved=_state(tree["saved"]),
        seen=_state(tree["seen"]),
        made_of=str(tree["made_of"]),
        folders=tuple(str(each) for each in tree["folders"]),
        files=tuple((_inside(each), int(size)) for each, size in tree["files"]),
        counts=tuple((message_of_json(kind), int(there), int(whole)) for kind, there, whole in tree["counts"]),
        thumbnails=tuple(
            Thumbnail(int(frame), base64.b64decode(data, validate=True), bool(doubt))
            for frame, doubt, data in tree["thumbnails"]
        ),
    )


def _inside(text: Any) -> str:
    """Return a relative path; ValueError where it leads out of the folder, as it becomes a link of a page."""
    path = str(text)
    if Path(path).is_absolute() or ".." in Path(path).parts or ":" in path:
        raise ValueError
    return path


def _state(tree: Any) -> FileState:
    size, digest, modified = tree
    return FileState(int(size), str(digest), int(modified))
