"""A scene for OpenToonz."""

from typing import Final

from kagezou.export.exchange.opentoonz import OPENTOONZ
from kagezou.export.exporters.scene_file import SCENE_OPTIONS, SceneFile
from kagezou.message import Message


def _steps(file: str) -> tuple[Message, ...]:
    return (
        Message("In OpenToonz: File > Load Scene…, and choose {file}.", file=file),
        Message("A column for each layer; effects in the schematic have its blend mode and its opacity."),
    )


OPENTOONZ_SCENE: Final = SceneFile(
    key="opentoonz",
    label=Message("OpenToonz"),
    purpose=Message("a scene with a column for each layer"),
    icon="target-xsheet",
    verb="export-scene",
    options=SCENE_OPTIONS,
    program="opentoonz",
    target=OPENTOONZ,
    steps=_steps,
)
