"""A document of Open Cel Animation."""

from typing import Final

from kagezou.export.exchange.oca import OCA
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message(
            "OpenToonz imports {file} by File > Import > Open Cel Animation (OCA), without blend modes.", file=file
        ),
        Message("After Effects and Blender import it by RxLab's add-ons; holds, opacity and blend modes are in it."),
    )


OCA_SCENE: Final = SceneFile(
    key="oca",
    label=Message("Open Cel Animation"),
    purpose=Message("layers and holds for many programs"),
    icon="target-cels",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="oca",
    target=OCA,
    steps=_steps,
)
