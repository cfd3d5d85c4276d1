"""The manifest of an export: what was written, from what, by which version, as JSON for a studio's pipeline."""

import hashlib
import platform
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from kagezou.document.model import Document, Drawing
from kagezou.document.value_words import Json
from kagezou.errors import Problem
from kagezou.export.made_files import MadeFile
from kagezou.io.files.faults import output_problem
from kagezou.io.project.file import dumps
from kagezou.message import Message
from kagezou.version import __version__

SCHEMA: Final = 1
"""Rises when a key goes or means something else; new keys come without it."""


@dataclass(frozen=True, slots=True)
class Handover:
    """An export that is over.

    Parameters
    ----------
    kind
        The key of its exporter.
    document
        What was exported.
    project
        The file it is kept in; None where it was never saved.
    files
        What is there.
    is_whole
        Whether everything that was asked for is.
    notes
        What was said, one sentence each.
    """

    kind: str
    document: Document
    project: Path | None
    files: tuple[MadeFile, ...]
    is_whole: bool
    notes: tuple[Message, ...] = ()


def manifest_of(over: Handover) -> dict[str, Json]:
    """Return the manifest; hashes that the export has made already are taken from it, the others are made now.

    Raises
    ------
    OutputProblem
        A file that was made cannot be read any more.
    """
    return {
        "kagezou_manifest": SCHEMA,
        "made_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "program": {"version": __version__, "python": platform.python_version(), "system": platform.system()},
        "export": {"kind": over.kind, "whole": over.is_whole, "notes": [str(each) for each in over.notes]},
        "project": _project(over),
        "drawings": list(_drawings(over.document)),
        "files": [_file(each, over.document) for each in over.files],
    }


def _project(over: Handover) -> dict[str, Json]:
    canvas, slate = over.document.canvas, over.document.slate
    where = None if over.project is None else over.project.absolute()
    return {
        "file": None if where is None else str(where),
        "sha256": _hash_of_project(over.document, where),
        "name": slate.name,
        "scene": slate.scene,
        "cut": slate.cut,
        "width_px": canvas.width_px,
        "height_px": canvas.height_px,
        "frame_rate": str(canvas.frame_rate),
        "frames": canvas.length_frames,
        "first_frame": canvas.first_frame,
    }


def _hash_of_project(document: Document, where: Path | None) -> str | None:
    """Return the hash of the project as it was exported: that of its file, if it was saved as it was."""
    if where is None:
        return None
    try:
        return hashlib.sha256(dumps(document, where.parent).encode("utf-8")).hexdigest()
    except Problem:  # It cannot be kept beside that file.
        return None


def _drawings(document: Document) -> Iterator[Json]:
    """Yield the files that the cut is drawn from: drawings, background and sets."""
    for drawing in document.behind.drawings:
        yield _drawing("background", None, drawing)
    for layer in document.layers:
        yield from (_drawing("drawing", layer.name, each) for each in layer.cels.drawings)
    for piece in document.pieces:
        if piece.source is not None:
            yield {"kind": "set", "layer": piece.name, "name": piece.source.stem, **_state(piece.source)}


def _drawing(kind: str, layer: str | None, drawing: Drawing) -> Json:
    part: Json = None if drawing.part is None else str(drawing.part)
    return {"kind": kind, "layer": layer, "name": drawing.name, "part": part, **_state(drawing.path)}


def _state(path: Path) -> dict[str, Json]:
    """Return a file, and the size and the time of change that it has; none where it is missing."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return {"path": str(path), "bytes": None, "modified": None}
    modified = datetime.fromtimestamp(found.st_mtime, UTC).isoformat(timespec="seconds")
    return {"path": str(path), "bytes": found.st_size, "modified": modified}


def _file(made: MadeFile, document: Document) -> Json:
    try:
        size = made.path.stat().st_size
        if made.sha256:
            digest = made.sha256
        else:
            with made.path.open("rb") as stream:
                digest = hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise output_problem(made.path, error) from error
    return {
        "path": str(made.path),
        "kind": made.kind,
        "sequence": made.sequence or None,
        "layer": _names(document).get(made.owner),
        "frame": made.frames[0] if made.frames else None,
        "bytes": size,
        "sha256": digest,
        "new": made.is_new,
    }


def _names(document: Document) -> Mapping[str, str]:
    layers = {each.id: each.name for each in document.layers}
    return layers | {each.id: each.name for each in document.pieces}
