"""``kagezou info``: what is in a project, and what is missing."""

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give, give_json, one_line

if TYPE_CHECKING:
    from kagezou.document.address import Address
    from kagezou.document.cut_words import CutWord
    from kagezou.document.model import Document, Layer, Piece
    from kagezou.document.whole_cut import SaidOf
    from kagezou.message import Message, Translate

DESCRIPTION = """\
Say what is in a project: canvas, layers, drawings, missing files, which properties have keys, and what people noted.
The exit code is 3 while a file is missing."""
EXAMPLES = """\
  kagezou info walk.kage
  kagezou info walk.kage --properties        every property: value, unit, range and what it does
  kagezou info walk.kage --json
"""


FILES_MISSING = 3
"""The exit code where a file that is needed is missing."""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("--properties", action="store_true", help="list every property instead")
    parser.add_argument("--json", action="store_true", help="print one object")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Load the project and describe it."""
    from kagezou.io.project.file import load

    document = load(options.project)
    if options.json:
        table = {"properties": _property_table(document)} if options.properties else {}
        give_json({**_about(document, options.project), **table}, indent=2)
    else:
        for line in _property_lines(document) if options.properties else _lines(document, options.project):
            give(one_line(line))
    return FILES_MISSING if any(True for _ in _missing(document)) else 0


def _about(document: "Document", project: Path) -> dict[str, Json]:
    from kagezou.document.piece_kinds import kind_of
    from kagezou.document.properties import OF_LAYER

    canvas = document.canvas
    return {
        "width_px": canvas.width_px,
        "height_px": canvas.height_px,
        "frame_rate": str(canvas.frame_rate),
        "first_frame": 1,
        "last_frame": canvas.length_frames,
        "shown_first_frame": canvas.first_frame,
        "slate": {"name": document.slate.name, "scene": document.slate.scene, "cut": document.slate.cut},
        "background": _background(document),
        "background_pictures": len(document.behind.drawings),
        "layers": [_about_layer(document, layer) for layer in document.layers],
        "set": [
            {"name": piece.name, "kind": kind_of(piece), **_about_file(document, piece)} for piece in document.pieces
        ],
        "linked": [name for name in OF_LAYER if name in document.linked],
        "keyed": [_keyed(document, address) for address in _keyed_addresses(document)],
        "missing": list(_missing(document)),
        "notes": [str(note) for note in _notes(document, project)],
        "remarks": {"all": len(document.notes), "open": sum(not each.is_done for each in document.notes)},
    }


def _about_layer(document: "Document", layer: "Layer") -> Json:
    exposed = [exposure for exposure in layer.cels.exposures if exposure.drawing is not None]
    return {
        "name": layer.name,
        "drawings": len(layer.cels.drawings),
        "exposures": len(exposed),
        "first_exposure": exposed[0].frame if exposed else None,
        "figure_px": [layer.figure.left, layer.figure.top, layer.figure.right, layer.figure.bottom],
        "joins": document.layer(layer.joins).name if layer.joins else "",
    }


def _about_file(document: "Document", piece: "Piece") -> dict[str, Json]:
    from kagezou.io.files.faults import shown

    if piece.source is None:
        return {}
    return {"file": shown(piece.source), "cameras": list(_camera_names(document, piece))}


def _camera_names(document: "Document", piece: "Piece") -> tuple[str, ...]:
    """Return the cameras of an imported set; none of a file that cannot be read, which rendering will tell."""
    from kagezou.errors import InputProblem
    from kagezou.io.sets.cameras import cameras_of

    if piece.source is None:
        return ()
    try:
        return tuple(camera.name for camera in cameras_of(piece.source, document.canvas.frame_rate))
    except InputProblem:
        return ()


def _keyed_addresses(document: "Document") -> "Iterator[Address]":
    from kagezou.document.address import addresses, track_of

    return (address for address in addresses(document) if track_of(document, address).is_keyed)


def _keyed(document: "Document", address: "Address") -> dict[str, Json]:
    from kagezou.document.address import path_of, track_of

    return {"path": path_of(document, address), "frames": [key.frame for key in track_of(document, address).keys]}


def _background(document: "Document") -> str | None:
    from kagezou.io.files.faults import shown
    from kagezou.picture_source import file_of

    return None if document.background is None else shown(file_of(document.background))


def _missing(document: "Document") -> Iterator[str]:
    """Yield the files that are not there, and the layers that are not in their files."""
    from kagezou.importing.missing_files import missing_names

    return missing_names(document)


def _lines(document: "Document", project: Path) -> Iterator[str]:
    from kagezou.animation.frames import format_frames
    from kagezou.document.address import path_of, track_of
    from kagezou.document.piece_kinds import kind_of
    from kagezou.document.properties import OF_LAYER
    from kagezou.io.files.faults import shown

    canvas = document.canvas
    seconds = float(canvas.length_frames / canvas.frame_rate)
    rate = f"{float(canvas.frame_rate):g}"
    yield f"canvas      {canvas.width_px} x {canvas.height_px} px"
    numbers = f", shown from {canvas.first_frame}" if canvas.first_frame != 1 else ""
    yield f"frames      1-{canvas.length_frames} at {rate} frames/s ({seconds:.2f} s){numbers}"
    slate = {"name": document.slate.name, "scene": document.slate.scene, "cut": document.slate.cut}
    if any(slate.values()):
        yield "slate       " + ", ".join(f"{key} {word}" for key, word in slate.items() if word)
    count = len(document.behind.drawings)
    more = f" and {count - 1} more picture{'s' * (count > 2)}" if count > 1 else ""
    yield f"background  {_background(document) or 'none'}{more}"
    for layer in document.layers:
        count = len(layer.cels.drawings)
        box = layer.figure
        joins = f", joins {document.layer(layer.joins).name}" if layer.joins else ""
        drawings = f"{count} drawing{'s' * (count != 1)}"
        yield f"layer       {layer.name}: {drawings}, figure {box.width} x {box.height} px{joins}"
    for piece in document.pieces:
        file = "" if piece.source is None else f" of {shown(piece.source)}"
        yield f"set piece   {piece.name}: {kind_of(piece)}{file}"
        for name in _camera_names(document, piece):
            yield f"  camera    {name}"
    for name in (each for each in OF_LAYER if each in document.linked):
        yield f"linked      layers.*.{name}"
    for address in _keyed_addresses(document):
        frames = format_frames(key.frame for key in track_of(document, address).keys)
        yield f"keys        {path_of(document, address)} on {frames}"
    yield from _doubtful_lines(document, project)


def _doubtful_lines(document: "Document", project: Path) -> Iterator[str]:
    """Yield what people noted, what is missing, and what of the files is not used."""
    if document.notes:
        left = sum(not each.is_done for each in document.notes)
        yield f"remarks     {len(document.notes)}, {left} of them open (kagezou notes)"
    for name in _missing(document):
        yield f"missing     {name}"
    for note in _notes(document, project):
        yield f"note        {note}"


def _notes(document: "Document", project: Path) -> "tuple[Message, ...]":
    """Return what the readers of its files did not use or had to assume, and which lie elsewhere."""
    from kagezou.importing.file_notes import notes_on_files
    from kagezou.importing.outside_files import note_on_outside_files
    from kagezou.io.sets.mesh_cache import MeshCache

    outside = note_on_outside_files(document, project)
    return (*notes_on_files(document, MeshCache()), *(() if outside is None else (outside,)))


def _property_table(document: "Document") -> Json:
    from kagezou.document.address import addresses, path_of, track_of, usual_value
    from kagezou.document.cut_words import CUT_WORDS
    from kagezou.document.property import Kind
    from kagezou.document.value_words import json_of_keys, json_of_value
    from kagezou.document.whole_cut import sayings
    from kagezou.io.clips.catalogues import messages_in

    japanese = messages_in("ja")
    table: list[Json] = []
    for address in addresses(document):
        prop, track = address.property, track_of(document, address)
        row: dict[str, Json] = {
            "path": path_of(document, address),
            "kind": prop.kind.value,
            "unit": prop.unit,
            "default": json_of_value(usual_value(document, address)),
            "value": None if track.is_keyed else json_of_value(track.constant),
            "keys": json_of_keys(track.keys),
            "help": str(prop.help),
            "help_ja": prop.help.formatted(japanese),
        }
        if prop.kind is Kind.NUMBER:
            row["range"] = [json_of_value(prop.low), json_of_value(prop.high)]
        if prop.choices:
            row["choices"] = list(prop.choices)
        table.append(row)
    settings = [_setting_row(document, word, japanese) for word in CUT_WORDS]
    return [*table, *(_said_row(said, japanese) for said in sayings(document)), *settings]


def _setting_row(document: "Document", word: "CutWord", japanese: "Translate") -> Json:
    from kagezou.document.cut_settings import CutSettings

    return {
        "path": word.path,
        "kind": "setting",
        "unit": "",
        "default": word.usual,
        "value": word.value(CutSettings.of(document)),
        "keys": [],
        "help": str(word.help),
        "help_ja": word.help.formatted(japanese),
    }


def _said_row(said: "SaidOf", japanese: "Translate") -> Json:
    return {
        "path": said.path,
        "kind": "choice",
        "unit": "",
        "default": said.choices[0],
        "value": said.value,
        "keys": [],
        "help": str(said.saying.help),
        "help_ja": said.saying.help.formatted(japanese),
        "choices": list(said.choices),
    }


def _property_lines(document: "Document") -> Iterator[str]:
    import json

    from kagezou.document.address import addresses, path_of, track_of
    from kagezou.document.cut_settings import CutSettings
    from kagezou.document.cut_words import CUT_WORDS
    from kagezou.document.property import Kind
    from kagezou.document.value_words import json_of_value
    from kagezou.document.whole_cut import sayings

    for word in CUT_WORDS:
        yield f"{word.path} = {json.dumps(word.value(CutSettings.of(document)), ensure_ascii=False)}  (no keys)"
        yield f"    {word.help}"
    for address in addresses(document):
        prop, track = address.property, track_of(document, address)
        count = len(track.keys)
        value = json.dumps(json_of_value(track.constant), ensure_ascii=False)
        shown = f"{count} key{'s' * (count != 1)}" if track.is_keyed else value
        allowed = " | ".join(prop.choices) or (f"{prop.low:g} to {prop.high:g}" if prop.kind is Kind.NUMBER else "")
        limits = " ".join(part for part in (allowed, prop.unit) if part)
        yield f"{path_of(document, address)} = {shown}" + (f"  ({limits})" if limits else "")
        yield f"    {prop.help}"
    for said in sayings(document):
        choices = " | ".join(word or '""' for word in said.choices)
        yield f"{said.path} = {json.dumps(said.value, ensure_ascii=False)}  ({choices}; no keys)"
        yield f"    {said.saying.help}"
