"""From the document to the JSON of a project of the current version."""

from collections.abc import Mapping
from pathlib import Path

from kagezou.animation.ease import Ease
from kagezou.animation.track import Key, Track
from kagezou.document.model import BroughtLight, Cels, Document, Drawing, Exposure, Layer, Piece, Tracks
from kagezou.document.paper import paper_of
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty
from kagezou.document.slate import NO_SLATE, Slate
from kagezou.geometry.vanishing import VanishingLines
from kagezou.io.files.json_text import JsonRow
from kagezou.io.project.feet import feet_tree
from kagezou.io.project.paths import stored_path
from kagezou.io.project.review import review_tree
from kagezou.io.project.versions import CURRENT, FORMAT_NAME, Tree
from kagezou.picture_source import Paper
from kagezou.version import __version__


def tree_of(document: Document, folder: Path) -> Tree:
    """Return the project, for a file in ``folder``, as JSON values and rows in the order in which people read them."""
    canvas = document.canvas
    return {
        "format": FORMAT_NAME,
        "version": int(CURRENT),
        "app_version": __version__,
        "canvas": {
            "width_px": canvas.width_px,
            "height_px": canvas.height_px,
            "frame_rate": str(canvas.frame_rate),
            "length_frames": canvas.length_frames,
            **({"first_frame": canvas.first_frame} if canvas.first_frame != 1 else {}),
        },
        "background": _background(document.behind, folder),
        "tracks": _tracks(document.tracks, OF_DOCUMENT),
        "layers": [_layer(layer, folder) for layer in document.layers],
        **review_tree(document),
        # Left out where there is none, so that a cut without a set reads as it always did.
        **({"set": [_piece(piece, folder) for piece in document.pieces]} if document.pieces else {}),
        **({"vanishing": [JsonRow(line) for line in document.vanishing.all]} if document.vanishing else {}),
        **_kept_fov(document.vanishing),
        **({"linked": JsonRow([name for name in OF_LAYER if name in document.linked])} if document.linked else {}),
        **({"brought_light": _brought_light(document.brought_light)} if document.brought_light else {}),
        **({"timesheet": document.timesheet} if document.timesheet else {}),
        **({"slate": JsonRow(_slate(document.slate))} if document.slate != NO_SLATE else {}),
    }


def _kept_fov(lines: VanishingLines | None) -> dict[str, object]:
    return {} if lines is None or lines.kept_fov_deg is None else {"vanishing_fov": lines.kept_fov_deg}


def _slate(slate: Slate) -> dict[str, str]:
    words = {"name": slate.name, "scene": slate.scene, "cut": slate.cut}
    return {key: word for key, word in words.items() if word}


def _brought_light(brought: BroughtLight) -> dict[str, object]:
    return {"tracks": _tracks(brought.tracks, OF_DOCUMENT), "before": _tracks(brought.before, OF_DOCUMENT)}


def _background(behind: Cels, folder: Path) -> object:
    """Return one picture for the whole cut as it always read, and pictures over time as a layer's are."""
    if not behind.drawings:
        return None
    first = behind.drawings[0]
    if len(behind.drawings) == 1 and behind.exposures == (Exposure(1, 0),):
        path = stored_path(first.path, folder)
        return path if first.part is None else JsonRow([path, first.part])
    return {
        "drawings": [JsonRow(_drawing(drawing, folder)) for drawing in behind.drawings],
        "exposures": [JsonRow([exposure.frame, exposure.drawing]) for exposure in behind.exposures],
    }


def _drawing(drawing: Drawing, folder: Path) -> list[str]:
    # Without its part where it is a file of its own, so that a cut of such drawings reads as it always did.
    return [drawing.name, stored_path(drawing.path, folder), *([] if drawing.part is None else [drawing.part])]


def _piece(piece: Piece, folder: Path) -> dict[str, object]:
    made: dict[str, object] = {"id": piece.id, "name": piece.name, "tracks": _tracks(piece.tracks, OF_PIECE)}
    return made if piece.source is None else {**made, "source": stored_path(piece.source, folder)}


def _layer(layer: Layer, folder: Path) -> dict[str, object]:
    figure, cels = layer.figure, layer.cels
    return {
        "id": layer.id,
        "name": layer.name,
        "figure": JsonRow([figure.left, figure.top, figure.right, figure.bottom]),
        "drawings": [JsonRow(_drawing(drawing, folder)) for drawing in cels.drawings],
        "exposures": [JsonRow([exposure.frame, exposure.drawing]) for exposure in cels.exposures],
        "tracks": _tracks(layer.tracks, OF_LAYER),
        **({} if layer.joins is None else {"joins": layer.joins}),
        **({} if paper_of(layer) is Paper.WHITE else {"paper": paper_of(layer).value}),
        **({"locked": True} if layer.marks.is_locked else {}),
        **({"solo": True} if layer.marks.is_solo else {}),
        **({"label": layer.marks.label} if layer.marks.label else {}),
        **feet_tree(cels.drawings),
    }


def _tracks(tracks: Tracks, table: Mapping[str, AnyProperty]) -> dict[str, object]:
    """Return the tracks in table order, so that the order of edits never shows in the file."""
    return {name: _track(tracks[name]) for name in table if name in tracks}


def _track(track: Track) -> object:
    if not track.keys:
        return JsonRow(track.constant)
    return {"constant": JsonRow(track.constant), "keys": [JsonRow(key_tree(key)) for key in track.keys]}


def key_tree(key: Key) -> dict[str, object]:
    """Return a key as JSON values."""
    row: dict[str, object] = {"frame": key.frame, "value": key.value, "interpolation": str(key.interpolation)}
    if key.ease_in:
        row["ease_in"] = _eases(key.ease_in)
    if key.ease_out:
        row["ease_out"] = _eases(key.ease_out)
    return row


def _eases(eases: tuple[Ease, ...]) -> list[list[float]]:
    return [[ease.speed, ease.influence] for ease in eases]
