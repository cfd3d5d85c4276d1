"""The set of one frame: what its pieces are, and the shadow they cast themselves."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Vector4

if TYPE_CHECKING:  # what sets are made of is loaded with the first one
    from kagezou.geometry.sets.bodies import Body


@dataclass(frozen=True, slots=True)
class MeshPlacement:
    """Where the mesh of a file stands.

    Parameters
    ----------
    path
        The file.
    world_from_mesh
        (4, 4), row by row, affine: from the file's units and axes to the world, px.
    """

    path: Path
    world_from_mesh: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class PieceScene:
    """A set piece of one frame.

    Parameters
    ----------
    id, name
        Those of the document's piece.
    bodies
        What it is made of; nothing for a mesh.
    receives
        Whether the characters' shadows fall on it.
    blocks
        Whether they end where it takes the light.
    casts
        Whether its own shadow is drawn.
    mesh
        For an imported set, its mesh.
    display
        How a mesh is drawn: "none", "wireframe" (in the window only) or "clay" (in composites, too).
    is_under
        Whether it is drawn under the background picture rather than over it.
    """

    id: str
    name: str
    bodies: "tuple[Body, ...]"
    receives: bool
    blocks: bool
    casts: bool
    mesh: MeshPlacement | None = None
    display: str = "none"
    is_under: bool = False


@dataclass(frozen=True, slots=True)
class SetCast:
    """All that decides the shadow of the set itself; equal casts have equal pixels.

    Parameters
    ----------
    camera, ground
        What it is seen with and stands on.
    pieces
        All there are; those that cast throw the shadow, and all of them receive and hide it.
    lights
        Homogeneous, over the ground.
    ground_receives
        Whether the flat ground is there at all, or only the pieces are.
    """

    camera: Camera
    ground: Plane
    pieces: tuple[PieceScene, ...]
    lights: tuple[Vector4, ...]
    ground_receives: bool = True
