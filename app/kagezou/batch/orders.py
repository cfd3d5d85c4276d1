"""What is asked for of every cut of a batch."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kagezou.document.style import Style
from kagezou.document.taking import Part
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.layered_frames import LAYERED_FRAMES
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS
from kagezou.export.exporters.table import AnyExporter
from kagezou.export.exporters.video_file import VIDEO_FILE
from kagezou.export.request import Missing

EXPORTS: Final[Mapping[str, AnyExporter]] = MappingProxyType(
    {"frames": SHADOW_LAYERS, "ae": HAND_OFF, "layered": LAYERED_FRAMES, "video": VIDEO_FILE}
)
"""The kinds of output that a batch makes, by the words that they are asked for with."""


@dataclass(frozen=True, slots=True)
class Orders:
    """What is asked for.

    Parameters
    ----------
    output
        The folder in which each cut gets one of its name, absolute.
    export
        A key of `EXPORTS`.
    style
        The look of every character; None for the one that new characters have.
    with_light
        Whether the style's own light is taken, too.
    template
        A project that every cut is made like, as by `new_cut`; None without one.
    parts
        What alone is taken of it; empty for all.
    skip_existing
        Whether a cut is left alone that would come out the same.
    renew
        Whether projects are made anew that somebody changed since.
    workers
        Threads that read and write files for one cut.
    after
        What runs after the output of each cut, as for `hooks_of`.
    missing
        What stands in for a drawing that is not there.
    """

    output: Path
    export: str = "frames"
    style: Style | None = None
    with_light: bool = False
    template: Path | None = None
    parts: frozenset[Part] = frozenset()
    skip_existing: bool = False
    renew: bool = False
    workers: int = 2
    after: str | None = None
    missing: Missing = Missing.FAIL
