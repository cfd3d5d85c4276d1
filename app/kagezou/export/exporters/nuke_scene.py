"""A scene for Nuke."""

from typing import Final

from kagezou.export.exchange.nuke import NUKE
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message("In Nuke: File > Open Comp…, and choose {file}.", file=file),
        Message("Layers are merged as they are stored; the last nodes turn the sum to linear light."),
    )


NUKE_SCENE: Final = SceneFile(
    key="nuke",
    label=Message("Nuke"),
    purpose=Message("a script of Read and Merge nodes"),
    icon="target-nodes",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="nuke",
    target=NUKE,
    steps=_steps,
)
