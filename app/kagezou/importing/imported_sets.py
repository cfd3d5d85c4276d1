"""Sets from files: where they stand at first, the canvas camera following theirs, and characters standing on them."""

from dataclasses import dataclass
from math import radians, tan
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.animation.track import Value
from kagezou.document import set_properties as lines
from kagezou.document.address import Address
from kagezou.document.edits import set_constant, set_track
from kagezou.document.model import Document
from kagezou.document.properties import (
    FOV,
    GROUND_DECLINATION,
    GROUND_POSITION,
    GROUND_ROLL,
)
from kagezou.document.set_pieces import add_piece, stood_up, stood_up_notes
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.geometry.mesh import Mesh
from kagezou.geometry.mesh_ray import first_hit
from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.vectors import Matrix, Point2, Vector3
from kagezou.importing.file_notes import said_once
from kagezou.importing.set_following import follow_camera
from kagezou.importing.set_placing import of_piece, placement, track_through
from kagezou.io.files.faults import shown
from kagezou.io.sets.cameras import cameras_of, notes_on_up, up_axis_of
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.message import Message
from kagezou.scene.evaluate import camera_at

PERSON_UNITS: Final = 1.6
"""How high a character is taken to be in a file's units, which most programs write as metres."""

_NATURAL_HEIGHTS: Final = (0.2, 200.0)
"""A set between these many character heights is believed to be in metres; any other is fitted to the canvas."""


@dataclass(frozen=True, slots=True)
class SetImport:
    """How a file is to be brought in.

    Parameters
    ----------
    path
        The file.
    name
        What the piece is called.
    camera
        The name of the file's camera to follow, None for none.
    stand
        Where a character stands, canvas px; None for the ground there is, which is at its feet.
    up
        "y" or "z"; None for what the file says.
    scale
        Canvas px a unit where it stands; None for a natural size. A camera that is followed settles it.
    """

    path: Path
    name: str
    camera: str | None = None
    stand: Point2 | None = None
    up: str | None = None
    scale: float | None = None


@dataclass(frozen=True, slots=True)
class ImportedSet:
    """What came of an import: the document, the new piece, and what one should know of it."""

    document: Document
    piece_id: str
    notes: tuple[Message, ...] = ()


def import_set(document: Document, wanted: SetImport, meshes: MeshCache) -> ImportedSet:
    """Put the set of a file behind the characters, who stand up as it does, the flat ground giving way to it.

    Raises
    ------
    InputProblem
        The file cannot be read.
    UsageProblem
        It has no such camera, or one that the canvas camera cannot follow.
    """
    mesh = meshes.mesh(wanted.path)
    camera = None if wanted.camera is None else _camera_named(document, wanted)
    up = wanted.up or up_axis_of(wanted.path)
    stand = wanted.stand or value_at(document.tracks, GROUND_POSITION, 1)
    values: dict[str, object] = {
        lines.PIECE_UP.name: up,
        lines.PIECE_POSITION.name: stand,
        lines.PIECE_ANCHOR.name: _floor_middle(mesh, up),
        lines.PIECE_SCALE.name: wanted.scale or _natural_scale(document, mesh, up),
        lines.PIECE_DISPLAY.name: "clay" if document.background is None else "wireframe",
    }
    added = add_piece(document, wanted.name, PieceKind.MESH, values, wanted.path)
    document = stood_up(added)
    read = (*meshes.notes(wanted.path), *_assumed(wanted))
    notes = (*said_once(wanted.name, [(wanted.path, read)]), *stood_up_notes(added, document))
    piece_id = document.pieces[-1].id
    document = set_constant(document, Address(lines.GROUND_RECEIVES), raw=False)
    if camera is None:
        return ImportedSet(document, piece_id, notes)
    size = (float(document.canvas.width_px), float(document.canvas.height_px))
    met = first_hit(mesh, *_ray_of(camera, stand, size))
    if met is not None:
        document = set_constant(document, Address(lines.PIECE_ANCHOR, piece_id=piece_id), met)
    said = (*_notes(document, camera, met), *notes)
    return ImportedSet(follow_camera(document, piece_id, camera), piece_id, said)


def point_under(document: Document, piece_id: str, mesh: Mesh, canvas_px: Point2, frame: int) -> Vector3 | None:
    """Return the point of an imported set, in its file's units, seen at a place of the canvas; None for none."""
    world_from_mesh = placement(document, piece_id, frame)
    if world_from_mesh is None:
        return None
    ex, ey, ez, ew = camera_at(document, frame).eye
    x, y = canvas_px
    far = 4 * float(np.abs(world_from_mesh @ _corners(mesh)).max()) + 1
    start = np.array([ex, ey, ez, 1.0]) if ew else np.array([x, y, far, 1.0])
    through = np.array([x - ex, y - ey, -ez, 0.0]) if ew else np.array([0.0, 0.0, -1.0, 0.0])
    mesh_from_world = np.linalg.inv(world_from_mesh)
    return first_hit(mesh, (mesh_from_world @ start)[:3], (mesh_from_world @ through)[:3])


def stand_at(document: Document, piece_id: str, point: Vector3) -> Document:
    """Return the document whose ground goes through a point of an imported set, which the picture does not show.

    The set is seen as before; the world is only made larger or smaller about the eye, until the point lies in the
    plane of the drawings. Keys are moved on every frame that has some.

    Raises
    ------
    UsageProblem
        The point is not before the camera.
    """
    moved = (lines.PIECE_POSITION, lines.PIECE_SCALE)
    frames = _keyed_frames(document, piece_id) or (1,)
    positions: list[Value] = []
    scales: list[Value] = []
    for frame in frames:
        world_from_mesh = placement(document, piece_id, frame)
        if world_from_mesh is None:
            raise UsageProblem(Message("the set is not before the camera on every frame"))
        x, y, w = camera_at(document, frame).canvas_from_world() @ world_from_mesh @ np.array([*point, 1.0])
        if w <= 0:
            raise UsageProblem(Message("this point of the set is not before the camera on every frame"))
        positions.append((float(x / w), float(y / w)))
        scales.append(float(np.linalg.norm(world_from_mesh[:3, 0]) / w))
    document = set_constant(document, of_piece(lines.PIECE_ANCHOR, piece_id), point)
    is_still = frames == (1,) and not _keyed_frames(document, piece_id)
    for address, values in (
        (Address(GROUND_POSITION), positions),
        (of_piece(moved[0], piece_id), positions),
        (of_piece(moved[1], piece_id), scales),
    ):
        if is_still:
            document = set_constant(document, address, values[0])
        else:
            document = set_track(document, address, track_through(address.property, zip(frames, values, strict=True)))
    return document


def _ray_of(camera: SetCamera, canvas_px: Point2, size_px: Point2) -> tuple[Matrix, Matrix]:
    """Return the ray, in the mesh's coordinates, on which a camera sees a place of the canvas on the first frame."""
    pose, (width, height) = camera.pose(1), size_px
    x, y = canvas_px[0] - width / 2, height / 2 - canvas_px[1]
    if camera.is_perspective:
        focal = (height / 2) / tan(radians(camera.height) / 2)
        return pose[:3, 3], pose[:3, :3] @ np.array([x, y, -focal])
    scale = camera.height / height
    return pose[:3, 3] + pose[:3, :3] @ np.array([x * scale, y * scale, 0.0]), -pose[:3, 2]


def _notes(document: Document, camera: SetCamera, met: Vector3 | None) -> tuple[Message, ...]:
    canvas, notes = document.canvas, list[Message]()
    aspect = canvas.width_px / canvas.height_px
    if met is None:
        notes.append(
            Message("the camera {camera!r} sees nothing of the set where the character stands", camera=camera.name)
        )
    if camera.aspect and abs(camera.aspect / aspect - 1) > 0.01:
        notes.append(
            Message(
                "the camera {camera!r} is for a picture of {camera_aspect:.3f} to 1, the canvas is {aspect:.3f} to 1: "
                "the height was kept, the sides differ",
                camera=camera.name,
                camera_aspect=camera.aspect,
                aspect=aspect,
            )
        )
    if camera.is_animated and camera.length_frames != canvas.length_frames:
        notes.append(
            Message(
                "the camera {camera!r} moves for {camera_frames} frames, the cut has {cut_frames}",
                camera=camera.name,
                camera_frames=camera.length_frames,
                cut_frames=canvas.length_frames,
            )
        )
    return tuple(notes)


def _assumed(wanted: SetImport) -> tuple[Message, ...]:
    return () if wanted.up is not None else notes_on_up(wanted.path)


def _camera_named(document: Document, wanted: SetImport) -> SetCamera:
    cameras = cameras_of(wanted.path, document.canvas.frame_rate)
    for camera in cameras:
        if camera.name == wanted.camera:
            return camera
    values = {"path": shown(wanted.path), "camera": wanted.camera}
    if not cameras:
        raise UsageProblem(Message("{path}: there is no camera {camera!r} in it, only none at all", **values))
    known = ", ".join(repr(camera.name) for camera in cameras)
    raise UsageProblem(Message("{path}: there is no camera {camera!r} in it, only {known}", known=known, **values))


def _floor_middle(mesh: Mesh, up: str) -> Vector3:
    low, high = mesh.corners
    middle = (low + high) / 2
    middle[2 if up == "z" else 1] = low[2 if up == "z" else 1]
    x, y, z = (float(part) for part in middle)
    return (x, y, z)


def _natural_scale(document: Document, mesh: Mesh, up: str) -> float:
    low, high = mesh.corners
    figure = document.layers[0].figure.height if document.layers else document.canvas.height_px / 2
    least, most = (PERSON_UNITS * heights for heights in _NATURAL_HEIGHTS)
    size = high - low
    if least <= float(size.max()) <= most:
        return figure / PERSON_UNITS
    widest = max(float(np.delete(size, 2 if up == "z" else 1).max()), 1e-6)
    return document.canvas.width_px / widest


def _keyed_frames(document: Document, piece_id: str) -> tuple[int, ...]:
    """Return every frame on which something is keyed that decides how an imported set is seen."""
    own = document.piece(piece_id).tracks
    names = (lines.PIECE_POSITION, lines.PIECE_SCALE, lines.PIECE_ANGLE)
    tracks = [own[prop.name] for prop in names if prop.name in own]
    of_scene = (FOV, GROUND_POSITION, GROUND_ROLL, GROUND_DECLINATION)
    tracks += [document.tracks[prop.name] for prop in of_scene if prop.name in document.tracks]
    return tuple(sorted({key.frame for track in tracks for key in track.keys}))


def _corners(mesh: Mesh) -> Matrix:
    low, high = mesh.corners
    return np.array([[*np.where([pick & 1, pick & 2, pick & 4], high, low), 1.0] for pick in range(8)]).T
