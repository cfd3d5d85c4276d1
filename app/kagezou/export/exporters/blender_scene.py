"""A scene for Blender."""

from typing import Final

from kagezou.export.exchange.blender import BLENDER
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message("In Blender 3.4 or newer: Scripting > Open {file}, then Run Script.", file=file),
        Message("It builds a scene of its own: cards, camera, frame rate, and View Transform Raw, which must stay."),
    )


BLENDER_SCENE: Final = SceneFile(
    key="blender",
    label=Message("Blender"),
    purpose=Message("cards before a camera, shadows among them"),
    icon="target-cards",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="blender",
    target=BLENDER,
    steps=_steps,
)
