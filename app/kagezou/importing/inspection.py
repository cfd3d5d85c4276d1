"""What a file, a folder or a pattern is understood to be, before anything is made of it."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.animation.frames import format_frames
from kagezou.importing.cels_of_files import held_by
from kagezou.importing.file_notes import notes_on_files
from kagezou.importing.new_cels import CharacterSource, Held, NewCels
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES, sources_beside
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.images.reading import Cel, Matte, probe, read_cel
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.project.file import load
from kagezou.io.project.paths import absolute
from kagezou.io.sets.cameras import cameras_of, notes_on_up, up_axis_of
from kagezou.io.sets.mesh_cache import MeshCache, is_mesh
from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.message import Message, first_names
from kagezou.picture_source import PicturePart, file_of

Fact = str | int | float | bool | None | Sequence["Fact"] | Mapping[str, "Fact"]

_RATE: Final = Fraction(24)
"""At which cameras are read where no cut says how fast it is."""

_SHOWN_CELS: Final = 12


@dataclass(frozen=True, slots=True)
class Inspection:
    """What something is understood to be.

    Parameters
    ----------
    path
        What was asked for.
    kind
        ``drawings``, ``timesheet``, ``set`` or ``project``.
    facts
        By name, for programs.
    lines
        The same for people.
    notes
        What of it is not used, what had to be assumed and what is odd.
    """

    path: Path
    kind: str
    facts: Mapping[str, Fact]
    lines: tuple[Message, ...]
    notes: tuple[Message, ...]


def inspected(path: Path) -> Inspection:
    """Return what is understood of a folder, a pattern such as ``walk_#.png``, or a file of any kind that is read.

    Pictures are read as a whole, the first of each character; of the others the headers.

    Raises
    ------
    InputProblem, ProjectProblem
        It cannot be read; one sentence with name and cause.
    """
    path = absolute(path)
    suffix = path.suffix.lower()
    if path.is_dir() or "#" in path.name:
        return _drawings(path)
    if not path.exists():
        raise input_problem(path, Message("it does not exist"))
    if suffix == ".kage":
        return _project(path)
    by_kind: Callable[[Path], Inspection] = _timesheet if suffix in TIMESHEET_SUFFIXES else _drawings
    return _set(path) if is_mesh(path) else by_kind(path)


def _drawings(path: Path) -> Inspection:
    held = held_by(CharacterSource(None, path))
    firsts = [read_cel(layer.cels.drawings[0].source) for layer in held.layers]
    lines = [_said_of(layer) for layer in held.layers]
    facts: dict[str, Fact] = {
        "characters": [_facts_of(layer, first) for layer, first in zip(held.layers, firsts, strict=True)]
    }
    if held.backgrounds:
        names = [each.address if isinstance(each, PicturePart) else each.name for each in held.backgrounds]
        facts["backgrounds"] = names
        lines.append(Message("background: {names}", names=", ".join(names)))
    return Inspection(path, "drawings", facts, tuple(lines), _notes_on(held, firsts))


def _said_of(layer: NewCels) -> Message:
    names = [drawing.name for drawing in layer.cels.drawings]
    width, height = layer.size_px
    joins = Message(", joins {figure}", figure=layer.joins) if layer.joins else ""
    return Message(
        "character {name}{joins}: {drawings} of {width} × {height} px, seen to frame {last}: {names}",
        name=layer.name,
        joins=joins,
        drawings=_count(len(names)),
        width=width,
        height=height,
        last=layer.length_frames,
        names=first_names(names, _SHOWN_CELS),
    )


def _count(drawings: int) -> Message:
    return Message("1 drawing") if drawings == 1 else Message("{count} drawings", count=drawings)


def _facts_of(layer: NewCels, first: Cel) -> dict[str, Fact]:
    drawing = layer.cels.drawings[0]
    about = probe(drawing.source)
    depth = {"channels": about.channels, "bit_depth": about.bit_depth, "has_alpha": about.has_alpha}
    return {
        "name": layer.name,
        "joins": layer.joins,
        "width_px": layer.size_px[0],
        "height_px": layer.size_px[1],
        "last_frame": layer.length_frames,
        "covered_px": _covered(first.matte),
        **({} if is_psd(drawing.path) else depth),
        "drawings": [{"name": each.name, "file": shown(each.path), "part": each.part} for each in layer.cels.drawings],
        "exposures": [[each.frame, each.drawing] for each in layer.cels.exposures],
    }


def _covered(matte: Matte) -> float:
    """Return how many pixels a matte covers, parts of pixels added up."""
    return round(float(matte.alpha.sum(dtype=float)) / np.iinfo(matte.alpha.dtype).max, 2)


def _notes_on(held: Held, firsts: Sequence[Cel]) -> tuple[Message, ...]:
    """Return what is said of all of it, and what only the pixels of the first drawings tell."""
    notes = list(held.notes)
    for layer, first in zip(held.layers, firsts, strict=True):
        notes += layer.notes
        source = layer.cels.drawings[0].source
        # Of a drawing without alpha its layer tells what was taken as clear.
        if probe(source).has_alpha:
            notes += (Message("{path}: {note}", path=shown(file_of(source)), note=note) for note in first.notes)
    return tuple(dict.fromkeys(notes))


def _timesheet(path: Path) -> Inspection:
    sheet = read_timesheet(path)
    found = {source.name: shown(source.path) for source in sources_beside(path, sheet)}
    facts: dict[str, Fact] = {
        "name": sheet.name,
        "length_frames": sheet.length_frames,
        "columns": [{"name": track.name, "entries": [list(each) for each in track.entries]} for track in sheet.tracks],
        "drawings": [{"column": name, "file": file} for name, file in found.items()],
    }
    lines = [
        Message("timesheet {name!r} of {frames} frames", name=sheet.name, frames=sheet.length_frames),
        *_columns(sheet),
        *(
            Message("drawings of {column}: {path}", column=name or Message("its columns"), path=file)
            for name, file in found.items()
        ),
    ]
    notes = tuple(Message("{path}: {note}", path=shown(path), note=note) for note in sheet.notes)
    return Inspection(path, "timesheet", facts, tuple(lines), notes)


def _columns(sheet: Timesheet) -> Iterator[Message]:
    for track in sheet.tracks:
        cels = list(dict.fromkeys(cel for _, cel in track.entries if cel is not None))
        yield Message(
            "column {name!r}: {count} entries of {cels} cels: {names}",
            name=track.name,
            count=len(track.entries),
            cels=len(cels),
            names=first_names(cels, _SHOWN_CELS),
        )


def _set(path: Path) -> Inspection:
    meshes = MeshCache()
    mesh = meshes.mesh(path)
    cameras = cameras_of(path, _RATE)
    low, high = mesh.corners
    size = [float(each) for each in high - low]
    facts: dict[str, Fact] = {
        "triangles": len(mesh.triangles),
        "low": [float(each) for each in low],
        "high": [float(each) for each in high],
        "up": up_axis_of(path),
        "cameras": [
            {"name": each.name, "is_perspective": each.is_perspective, "frames": each.length_frames} for each in cameras
        ],
    }
    lines = [
        Message(
            "set of {count} triangles, {x:.6g} × {y:.6g} × {z:.6g} units, {up} points up",
            count=len(mesh.triangles),
            x=size[0],
            y=size[1],
            z=size[2],
            up=facts["up"],
        ),
        *(
            Message(
                "camera {name}: {kind}, {moving}",
                name=each.name,
                kind=Message("perspective") if each.is_perspective else Message("orthographic"),
                moving=Message("moving for {frames} frames", frames=each.length_frames)
                if each.is_animated
                else Message("standing still"),
            )
            for each in cameras
        ),
    ]
    notes = tuple(
        Message("{path}: {note}", path=shown(path), note=note) for note in (*notes_on_up(path), *meshes.notes(path))
    )
    return Inspection(path, "set", facts, tuple(lines), notes)


def _project(path: Path) -> Inspection:
    document = load(path)
    canvas = document.canvas
    facts: dict[str, Fact] = {
        "width_px": canvas.width_px,
        "height_px": canvas.height_px,
        "frame_rate": str(canvas.frame_rate),
        "last_frame": canvas.length_frames,
        "layers": [layer.name for layer in document.layers],
        "set": [piece.name for piece in document.pieces],
    }
    lines = [
        Message(
            "project of {width} × {height} px, frames {frames} at {rate:g} a second",
            width=canvas.width_px,
            height=canvas.height_px,
            frames=format_frames(range(1, canvas.length_frames + 1)),
            rate=float(canvas.frame_rate),
        ),
        *(
            Message("layer {name}: {drawings}", name=layer.name, drawings=_count(len(layer.cels.drawings)))
            for layer in document.layers
        ),
        *(Message("set piece {name}", name=piece.name) for piece in document.pieces),
    ]
    return Inspection(path, "project", facts, tuple(lines), notes_on_files(document, MeshCache()))
