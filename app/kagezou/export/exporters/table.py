"""The table of exporters. A new kind of export is a module beside this one, and a line here."""

from dataclasses import replace
from typing import Any, Final

from kagezou.export.choices import AS_CUT, ExportChoices
from kagezou.export.exporters.blender_scene import BLENDER_SCENE
from kagezou.export.exporters.exporter import Exporter
from kagezou.export.exporters.farm_job import FARM_JOB
from kagezou.export.exporters.fusion_scene import FUSION_SCENE
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.layered_frames import LAYERED_FRAMES
from kagezou.export.exporters.natron_scene import NATRON_SCENE
from kagezou.export.exporters.nuke_scene import NUKE_SCENE
from kagezou.export.exporters.oca_scene import OCA_SCENE
from kagezou.export.exporters.opentoonz_scene import OPENTOONZ_SCENE
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS
from kagezou.export.exporters.video_file import VIDEO_FILE
from kagezou.export.file_names import MAX_FIRST
from kagezou.export.request import DEPTHS, Missing

AnyExporter = Exporter[Any, Any]
"""An exporter whose requests and results are its own matter."""

SCENES: Final = (BLENDER_SCENE, NUKE_SCENE, NATRON_SCENE, FUSION_SCENE, OPENTOONZ_SCENE, OCA_SCENE)
"""Those that write a scene for another program."""

EXPORTERS: Final[tuple[AnyExporter, ...]] = (
    SHADOW_LAYERS,
    LAYERED_FRAMES,
    VIDEO_FILE,
    HAND_OFF,
    *SCENES,
    FARM_JOB,
)
"""In the order in which they are offered; the first is the usual one."""

_BY_KEY: Final = {each.key: each for each in EXPORTERS}

MAX_CHUNK: Final = 1000
"""Frames a task of a farm that may be chosen."""


def exporter_of(choices: ExportChoices) -> AnyExporter:
    """Return the exporter that is chosen; KeyError where there is none of that key."""
    return _BY_KEY[choices.kind]


def depths_of(form: str) -> tuple[int, ...]:
    """Return the bits a channel that a format may have, the usual one first."""
    return DEPTHS.get(form, (8,))


def sound(choices: ExportChoices) -> ExportChoices:
    """Return the choices with an exporter that there is, a format of its, a depth of that, and words that are known."""
    kind = choices.kind if choices.kind in _BY_KEY else EXPORTERS[0].key
    choices = replace(choices, kind=kind)
    formats = exporter_of(choices).formats(choices)
    form = choices.format if choices.format in formats else formats[0]
    depth = choices.depth if choices.depth in depths_of(form) else depths_of(form)[0]
    chunk, start = min(max(choices.chunk, 1), MAX_CHUNK), min(max(choices.start, AS_CUT), MAX_FIRST)
    missing = choices.missing if choices.missing in list(Missing) else Missing.FAIL.value
    return replace(choices, format=form, depth=depth, chunk=chunk, start=start, missing=missing)
