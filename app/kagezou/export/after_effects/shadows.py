"""The shadow layers of the composition, and the compositions within it in which shadows of like look unite.

The maximum of alphas is no blend mode. So within such a composition each shadow is an opaque picture of its alpha,
white on black, laid on those below it by the mode that takes the lighter; in the main composition the brightness of all
of them is the alpha of one layer, which has their colour, opacity and blend mode.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from kagezou.document import properties
from kagezou.document.address import Address, track_of
from kagezou.document.model import Document
from kagezou.document.set_properties import SET_BLEND, SET_OPACITY
from kagezou.document.values import value_at
from kagezou.export.after_effects import comp as ae
from kagezou.export.after_effects.channels import baked, channel_of, seconds
from kagezou.export.subjects import SET
from kagezou.export.uniting import CutGroup
from kagezou.scene.scene import ShadowLook

_NEAR = 1e-9


@dataclass(frozen=True, slots=True)
class ShadowFootage:
    """Where a shadow's pictures are shown.

    Parameters
    ----------
    remap, markers
        As of `CompLayer`.
    """

    remap: tuple[tuple[float, int | None], ...] = ()
    markers: tuple[ae.CompMarker, ...] = ()


Shown = dict[str, ShadowFootage]
"""By whose shadow it is: a layer's id, or `SET`."""


def shadow_layers(document: Document, groups: tuple[CutGroup, ...], shown: Shown) -> Iterator[ae.CompLayer]:
    """Yield the shadow layers of the main composition: that of the set, then each group's in its place."""
    rate = document.canvas.frame_rate
    if SET in shown:
        opacity = channel_of(track_of(document, Address(SET_OPACITY)), 0, rate, 100.0)
        yield _alone(SET, "Set", value_at(document.tracks, SET_BLEND, 1), opacity, shown[SET])
    lowest = {group.ids[0]: group for group in groups}
    united = {layer_id for group in groups for layer_id in group.ids}
    for layer in document.layers:
        opacity = channel_of(track_of(document, Address(properties.OPACITY, layer.id)), 0, rate, 100.0)
        if layer.id in lowest:
            yield _united(document, lowest[layer.id], opacity)
        elif layer.id in shown and layer.id not in united:
            yield _alone(layer.id, layer.name, value_at(layer.tracks, properties.BLEND, 1), opacity, shown[layer.id])


def united_comps(document: Document, groups: tuple[CutGroup, ...], shown: Shown) -> tuple[ae.Comp, ...]:
    """Return a composition for each group, with the shadow of each of its layers."""
    names = {layer.id: layer.name for layer in document.layers}
    full = ae.Channel(100.0)
    return tuple(
        ae.Comp(
            _tag(group),
            _name(document, group),
            tuple(
                ae.CompLayer(
                    f"shadow:{each}",
                    f"{names[each]} shadow",
                    f"shadow:{each}",
                    "LIGHTEN",
                    full,
                    shown[each].remap,
                    shown[each].markers,
                    alpha_shown=True,
                )
                for each in group.ids
            ),
        )
        for group in groups
    )


def _alone(owner: str, name: str, blend: str, opacity: ae.Channel, shown: ShadowFootage) -> ae.CompLayer:
    return ae.CompLayer(
        tag=f"shadow:{owner}",
        name=f"{name} shadow",
        footage=f"shadow:{owner}",
        blend=blend.upper(),
        opacity=opacity,
        remap=shown.remap,
        markers=shown.markers,
    )


def _united(document: Document, group: CutGroup, of_lowest: ae.Channel) -> ae.CompLayer:
    """Return the layer of a united shadow; its opacity has the lowest layer's keys where they are the group's, too."""
    canvas = document.canvas
    looks = [_look_at(group, frame) for frame in range(1, canvas.length_frames + 1)]
    track = track_of(document, Address(properties.OPACITY, group.ids[0]))
    is_lowests = all(
        abs(value_at({properties.OPACITY.name: track}, properties.OPACITY, frame) - look.opacity) < _NEAR
        for frame, look in enumerate(looks, start=1)
    )
    baked_opacity = baked(lambda frame: 100 * looks[frame - 1].opacity, canvas.length_frames, canvas.frame_rate)
    return ae.CompLayer(
        tag=f"shadow:{_tag(group)}",
        name=_name(document, group),
        footage=f"comp:{_tag(group)}",
        blend="MULTIPLY" if looks[0].multiply else "NORMAL",
        opacity=of_lowest if is_lowests else baked_opacity,
        colors=tuple(_held_colors(looks, canvas.frame_rate)),
    )


def _look_at(group: CutGroup, frame: int) -> ShadowLook:
    """Return the look of a frame; while no shadow is there that of the last one before, else of the first."""
    before = [each for each in group.looks if each <= frame]
    return group.looks[max(before) if before else min(group.looks)]


def _held_colors(looks: list[ShadowLook], rate: Fraction) -> Iterator[tuple[float, tuple[float, ...]]]:
    """Yield when each colour begins; between keys shadows have colours of 8 bit, from frame to frame."""
    last: tuple[int, int, int] | None = None
    for frame, look in enumerate(looks, start=1):
        if look.color != last:
            last = look.color
            yield seconds(frame, rate), tuple(part / 255 for part in last)


def _tag(group: CutGroup) -> str:
    return f"united:{group.ids[0]}"


def _name(document: Document, group: CutGroup) -> str:
    names = {layer.id: layer.name for layer in document.layers}
    return f"{', '.join(names[each] for each in group.ids)} shadows"
