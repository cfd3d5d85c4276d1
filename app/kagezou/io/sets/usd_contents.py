"""What is read of a USD stage, and how it goes from the process that reads to the one that asked: numbers and texts."""

import json
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, Final

import numpy as np

from kagezou.geometry.set_camera import SetCamera
from kagezou.io.sets.triangles import Triangles
from kagezou.message import Message

_PLAIN: Final = (str, int, float, bool)


@dataclass(frozen=True, slots=True, eq=False)
class UsdContents:
    """What a stage holds; where something of it cannot be read, there is a sentence instead.

    Parameters
    ----------
    triangles
        Of all its shapes.
    cameras
        As they are at ``rate``.
    rate
        Frames a second; None where nothing moves, so that the cameras are the same at all of them.
    is_z_up
        Whether its third axis points up.
    """

    triangles: Triangles | Message
    cameras: tuple[SetCamera, ...] | Message
    rate: Fraction | None
    is_z_up: bool


def save_contents(contents: UsdContents, path: Path) -> None:
    """Write contents to a file that holds no code."""
    arrays: dict[str, Any] = {}
    tree: dict[str, Any] = {"rate": None if contents.rate is None else str(contents.rate), "z": contents.is_z_up}
    if isinstance(contents.triangles, Message):
        tree["no triangles"] = _tree_of(contents.triangles)
    else:
        arrays["points"], arrays["corners"] = contents.triangles.points, contents.triangles.corners
        tree["notes"] = [_tree_of(note) for note in contents.triangles.notes]
    if isinstance(contents.cameras, Message):
        tree["no cameras"] = _tree_of(contents.cameras)
    else:
        tree["cameras"] = [[each.name, each.is_perspective, each.height, each.aspect] for each in contents.cameras]
        for number, camera in enumerate(contents.cameras):
            arrays[f"poses {number}"], arrays[f"heights {number}"] = camera.poses, np.array(camera.heights, float)
    np.savez(path, tree=np.frombuffer(json.dumps(tree).encode(), np.uint8), **arrays)


def load_contents(path: Path) -> UsdContents:
    """Read what `save_contents` wrote.

    Raises
    ------
    Exception
        It is no such file.
    """
    with path.open("rb") as stream, np.load(stream, allow_pickle=False) as arrays:
        tree = json.loads(arrays["tree"].tobytes())
        triangles: Triangles | Message
        cameras: tuple[SetCamera, ...] | Message
        if "no triangles" in tree:
            triangles = _message_of(tree["no triangles"])
        else:
            triangles = Triangles(arrays["points"], arrays["corners"], tuple(map(_message_of, tree["notes"])))
        if "no cameras" in tree:
            cameras = _message_of(tree["no cameras"])
        else:
            cameras = tuple(
                SetCamera(
                    name,
                    is_perspective,
                    height,
                    aspect,
                    arrays[f"poses {number}"],
                    tuple(arrays[f"heights {number}"].tolist()),
                )
                for number, (name, is_perspective, height, aspect) in enumerate(tree["cameras"])
            )
    return UsdContents(triangles, cameras, None if tree["rate"] is None else Fraction(tree["rate"]), tree["z"])


def _tree_of(message: Message) -> list[Any]:
    values = {
        name: _tree_of(value) if isinstance(value, Message) else value if isinstance(value, _PLAIN) else str(value)
        for name, value in message.values.items()
    }
    return [message.text, message.about, values]


def _message_of(tree: list[Any]) -> Message:
    text, about, values = tree
    return Message.retold(
        text, about, {name: _message_of(each) if isinstance(each, list) else each for name, each in values.items()}
    )
