"""The water that a layer's shadow lies on at a frame: its waves, and the gaps that go with them."""

from typing import Final

from kagezou.document import properties
from kagezou.document.model import Tracks
from kagezou.document.values import value_at
from kagezou.document.wave_edits import WAVE_SETS, wave_of
from kagezou.document.wave_properties import SLIT_GROWTH, SLIT_SPACING, SLITS
from kagezou.geometry.slits import Slits
from kagezou.scene.filters import Water

_LEAST_PX: Final = 0.01
"""Waves that move an outline by less cannot be seen and are left out."""

_LEAST_SHARE: Final = 0.001

CLEAR_OF_FIGURE: Final = 0.2
"""No gap is nearer to the contact line, in figures' heights: a foot's length, and what feet stand off the line."""


def water_at(tracks: Tracks, frame: int, height_px: float, length_frames: int) -> Water | None:
    """Return the water of a layer at a frame, None for none.

    Parameters
    ----------
    height_px
        How tall the figure is.
    length_frames
        Of the cut, in which waves may loop.
    """
    if not value_at(tracks, properties.WAVES_ON, frame):
        return None
    seed = int(value_at(tracks, properties.WAVE_SEED, frame))
    waves = tuple(wave_of(tracks, lines, frame) for lines in WAVE_SETS)
    first = tuple(wave.varied(seed, number) for number, wave in enumerate(waves, 1))
    ripples = tuple(each.at(frame) for each in first if each.wave.reach_px >= _LEAST_PX)
    anchor = value_at(tracks, properties.WAVE_ANCHOR, frame)
    slits, share = None, value_at(tracks, SLITS, frame)
    if share >= _LEAST_SHARE:
        spacing, growth = value_at(tracks, SLIT_SPACING, frame), value_at(tracks, SLIT_GROWTH, frame)
        still = Slits(share, spacing, growth, max(anchor, CLEAR_OF_FIGURE * height_px), seed=seed)
        slits = still.upon(first[0], frame, length_frames)
    return Water(ripples, anchor, slits) if ripples or slits else None
