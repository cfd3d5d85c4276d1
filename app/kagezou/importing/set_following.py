"""The canvas camera following a camera of a set's file."""

from dataclasses import dataclass
from math import acos, atan2, degrees, radians, tan
from typing import Final

import numpy as np

from kagezou.animation.track import Value
from kagezou.document import set_properties as lines
from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_track
from kagezou.document.model import Document
from kagezou.document.properties import (
    FOV,
    GROUND_DECLINATION,
    GROUND_POSITION,
    GROUND_ROLL,
    LIGHT_AZIMUTH,
    LIGHT_POSITION,
)
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.vectors import Point2, Vector3
from kagezou.importing.set_placing import of_piece, placement, track_through
from kagezou.message import Message

_HARDLY_DEG: Final = 0.01
"""A level camera is turned so far by the digits of its file, and no more is seen of the ground for it."""


def follow_camera(document: Document, piece_id: str, camera: SetCamera) -> Document:
    """Return the document whose camera sees an imported set exactly as a camera of its file does.

    Field of view, ground and the placement of the piece follow from where the camera stands; the ground goes through
    the piece's anchor, which comes to lie in the plane of the drawings. For a camera that moves there is a key on
    every frame, so that each frame is exact; halfway between two frames all of it is interpolated. The light stays
    where it is in the set.

    Raises
    ------
    UsageProblem
        The camera sees the ground from below, or does not see the anchor before it.
    """
    piece = document.piece(piece_id)
    anchor, up = value_at(piece.tracks, lines.PIECE_ANCHOR, 1), value_at(piece.tracks, lines.PIECE_UP, 1)
    last = min(camera.length_frames, document.canvas.length_frames)
    sights = [_sight(document, camera, frame, anchor, up) for frame in range(1, last + 1)]
    angles = np.degrees(np.unwrap(np.radians([sight.angle for sight in sights])))
    fovs: list[Value] = [camera.height_at(frame) if camera.is_perspective else 0.0 for frame in range(1, last + 1)]
    columns: list[tuple[Address, list[Value]]] = [
        (Address(FOV), fovs),
        (Address(GROUND_POSITION), [sight.position for sight in sights]),
        (Address(GROUND_ROLL), [sight.roll for sight in sights]),
        (Address(GROUND_DECLINATION), [sight.declination for sight in sights]),
        (of_piece(lines.PIECE_POSITION, piece.id), [sight.position for sight in sights]),
        (of_piece(lines.PIECE_ANGLE, piece.id), [float(angle) for angle in angles]),
        (of_piece(lines.PIECE_SCALE, piece.id), [sight.scale for sight in sights]),
    ]
    for address, values in columns:
        document = set_track(document, address, track_through(address.property, enumerate(values, start=1)))
    return _light_kept_in_place(document, piece_id, [float(angle) for angle in angles])


def _light_kept_in_place(document: Document, piece_id: str, angles_deg: list[float]) -> Document:
    """Return the document whose lamp and sun stay, while the camera moves, where they are in the set on frame 1.

    They are told as the canvas and the ground have them, which turn and move with the camera. A light that is keyed
    is somebody's work and stays as it is.
    """
    lamp, azimuth = (track_of(document, Address(prop)) for prop in (LIGHT_POSITION, LIGHT_AZIMUTH))
    found = [placement(document, piece_id, frame) for frame in range(1, len(angles_deg) + 1)]
    placements = [each for each in found if each is not None]
    if len(placements) < max(len(angles_deg), 2) or lamp.is_keyed or azimuth.is_keyed:
        return document
    place, start = LIGHT_POSITION.typed(lamp.constant), LIGHT_AZIMUTH.typed(azimuth.constant)
    in_set = np.linalg.inv(placements[0]) @ np.array([*place, 1.0])
    places: list[Value] = [tuple((each @ in_set)[:3].tolist()) for each in placements]
    turns: list[Value] = [start - (angle - angles_deg[0]) for angle in angles_deg]
    for prop, values in ((LIGHT_POSITION, places), (LIGHT_AZIMUTH, turns)):
        document = set_track(document, Address(prop), track_through(prop, enumerate(values, start=1)))
    return document


@dataclass(frozen=True, slots=True)
class _Sight:
    """What follows from one pose of a camera."""

    position: Point2
    roll: float
    declination: float
    angle: float
    scale: float


def _sight(document: Document, camera: SetCamera, frame: int, anchor: Vector3, up: str) -> _Sight:
    pose = camera.pose(frame)
    # From the mesh's directions to the canvas', whose y points down.
    canvas_from_mesh = np.diag([1.0, -1.0, 1.0]) @ pose[:3, :3].T
    normal = canvas_from_mesh @ (np.array([0.0, 0.0, 1.0]) if up == "z" else np.array([0.0, 1.0, 0.0]))
    declination = degrees(acos(min(max(float(normal[2]), -1.0), 1.0)))
    nearest = min(max(declination, GROUND_DECLINATION.low), GROUND_DECLINATION.high)
    if abs(nearest - declination) > _HARDLY_DEG:
        raise UsageProblem(
            Message(
                "the camera {camera!r} sees the ground at {declination:.1f}° on frame {frame}; "
                "it can be followed from {low:g}° to {high:g}°",
                camera=camera.name,
                declination=declination,
                frame=frame,
                low=GROUND_DECLINATION.low,
                high=GROUND_DECLINATION.high,
            )
        )
    roll = degrees(atan2(normal[0], -normal[1]))
    ground = ground_plane((0.0, 0.0), roll, nearest)
    right = canvas_from_mesh[:, 0]
    angle = degrees(atan2(float(right @ ground.v), float(right @ ground.u)))
    depth = -float((np.linalg.inv(pose) @ np.array([*anchor, 1.0]))[2])
    if camera.is_perspective and depth <= 0:
        raise UsageProblem(
            Message(
                "the place to stand on is behind the camera {camera!r} on frame {frame}",
                camera=camera.name,
                frame=frame,
            )
        )
    width, height = float(document.canvas.width_px), float(document.canvas.height_px)
    own = camera.height_at(frame)
    focal = (height / 2) / tan(radians(own) / 2) if camera.is_perspective else 0.0
    scale = focal / depth if camera.is_perspective else height / own
    return _Sight(camera.sees(anchor, frame, (width, height)), roll, nearest, angle, scale)
