"""A scene for Natron."""

from typing import Final

from kagezou.export.exchange.natron import NATRON
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message("Natron 2 builds the project when it is started with the script: Natron {file}", file=file),
        Message("Layers are merged as they are stored; the last nodes turn the sum to linear light."),
    )


NATRON_SCENE: Final = SceneFile(
    key="natron",
    label=Message("Natron"),
    purpose=Message("a script that builds readers and merges"),
    icon="target-nodes",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="natron",
    target=NATRON,
    steps=_steps,
)
