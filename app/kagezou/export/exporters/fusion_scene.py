"""A scene for Fusion."""

from typing import Final

from kagezou.export.exchange.fusion import FUSION
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message(
            "In Fusion: File > Open…, and choose {file}; DaVinci Resolve imports it as a Fusion composition.", file=file
        ),
        Message("Loaders read the pictures as they are stored: set no colour space for them."),
    )


FUSION_SCENE: Final = SceneFile(
    key="fusion",
    label=Message("Fusion"),
    purpose=Message("a composition of Loaders and Merges"),
    icon="target-nodes",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="fusion",
    target=FUSION,
    steps=_steps,
)
