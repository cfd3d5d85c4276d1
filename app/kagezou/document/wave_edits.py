"""Waves as they are set, and speeds at which they come back after the cut."""

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Document, Tracks
from kagezou.document.values import value_at
from kagezou.document.wave_properties import SLITS, WaveLines
from kagezou.geometry.waves import Wave
from kagezou.message import Message

WAVE_SETS = (properties.WAVE1, properties.WAVE2)


def wave_of(tracks: Tracks, lines: WaveLines, frame: int) -> Wave:
    """Return one set of waves of a layer as it is set at a frame."""
    numbers = (lines.amplitude, lines.wavelength, lines.direction, lines.velocity)
    amplitude, wavelength, direction, velocity = (value_at(tracks, prop, frame) for prop in numbers)
    elements = (lines.sideways, lines.depth_shear, lines.sideways_shear, lines.depth)
    a00, a01, a10, a11 = (value_at(tracks, prop, frame) for prop in elements)
    return Wave(amplitude, wavelength, direction, velocity, (a00, a01, a10, a11))


def has_waves(tracks: Tracks, frame: int) -> bool:
    """Whether a layer's waves move its shadow or open it at a frame, were they on."""
    return value_at(tracks, SLITS, frame) > 0 or any(wave_of(tracks, each, frame).reach_px > 0 for each in WAVE_SETS)


def loop_waves(document: Document, layer_ids: tuple[str, ...], frame: int) -> Document:
    """Set the speeds of both sets of waves of layers to the nearest at which they come back after the cut.

    The speeds of ``frame`` count; keyed speeds become constant.
    """
    for layer_id in layer_ids:
        for lines in WAVE_SETS:
            wave = wave_of(document.layer(layer_id).tracks, lines, frame).looping(document.canvas.length_frames)
            document = set_constant(document, Address(lines.velocity, layer_id), wave.velocity_px)
    return document


def loops_said(document: Document, layer_id: str) -> tuple[Message, ...]:
    """Return sentences about waves of a layer that loop: how fast each set goes, and what keeps one from looping."""
    layer, said = document.layer(layer_id), []
    for number, lines in enumerate(WAVE_SETS, 1):
        wave = wave_of(layer.tracks, lines, 1)
        crests = round(abs(wave.velocity_px) * document.canvas.length_frames / wave.wavelength_px)
        said.append(
            Message(
                "{layer}: wave {number} goes {velocity:g} px a frame; crests that pass in the cut: {crests}",
                layer=layer.name,
                number=number,
                velocity=wave.velocity_px,
                crests=crests,
            )
        )
        keyed = layer.tracks.get(lines.wavelength.name)
        if keyed is not None and keyed.keys:
            said.append(
                Message(
                    "{layer}: the length of wave {number} is keyed, so that the cut does not loop",
                    layer=layer.name,
                    number=number,
                )
            )
    return tuple(said)
