"""The shadow layers of the composition, and the compositions within it in which shadows of like look unite.

The maximum of alphas is no blend mode. So within such a composition each shadow is an opaque picture of its alpha,
white on black, laid on those below it by the mode that takes the lighter; in the main composition the brightness of all
of them is the alpha of one layer, which has their colour, opacity and blend mode.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce

from kagezou.document import properties
from kagezou.document.address import Address, track_of
from kagezou.document.model import Document
from kagezou.document.set_properties import SET_BLEND, SET_OPACITY
from kagezou.document.values import value_at
from kagezou.export.after_effects import comp as ae
from kagezou.export.after_effects.channels import seconds
from kagezou.export.after_effects.laying import Laying, either
from kagezou.export.subjects import SET, TogetherSubject
from kagezou.export.uniting import CutGroup, CutGroups
from kagezou.scene.scene import ShadowLook


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
"""By whose shadow it is: a layer's id, `SET`, or as `TogetherSubject` has it."""


def shadow_layers(document: Document, groups: CutGroups, shown: Shown, laying: Laying) -> Iterator[ae.CompLayer]:
    """Yield the shadow layers of the main composition: that of the set, then each group's in its place."""
    if SET in shown:
        multiply = value_at(document.tracks, SET_BLEND, 1) == "multiply"
        track = track_of(document, Address(SET_OPACITY))
        yield from laying.layers(laying.of_set(), track, _plain(SET, "Set", shown[SET]), default=multiply)
    lowest = {group.ids[0]: group for group in (*groups.of_several(), *groups.together())}
    united = {layer_id for group in lowest.values() for layer_id in group.ids}
    for layer in document.layers:
        group = lowest.get(layer.id)
        if group is not None and group.is_together:
            yield from _together(document, group, shown)
        elif group is not None:
            yield from _united(document, group, laying)
        elif layer.id in shown and layer.id not in united:
            multiply = value_at(layer.tracks, properties.BLEND, 1) == "multiply"
            track = track_of(document, Address(properties.OPACITY, layer.id))
            plain = _plain(layer.id, layer.name, shown[layer.id])
            yield from laying.layers(laying.of_shadow(layer.id), track, plain, default=multiply)


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


def _plain(owner: str, name: str, shown: ShadowFootage) -> ae.CompLayer:
    tag = f"shadow:{owner}"
    return ae.CompLayer(tag, f"{name} shadow", tag, "NORMAL", ae.Channel(100.0), shown.remap, shown.markers)


def _together(document: Document, group: CutGroup, shown: Shown) -> Iterator[ae.CompLayer]:
    """Yield the layers of shadows that are handed over together, with their opacity in them."""
    for place, multiply in enumerate(group.laid):
        subject = TogetherSubject(group.ids, multiply, bool(place))
        layer = _plain(subject.owner, "", shown[subject.owner])
        title = _name(document, group) + (" normal" if subject.is_over else "")
        yield replace(layer, name=title, blend="MULTIPLY" if multiply else "NORMAL")


def _united(document: Document, group: CutGroup, laying: Laying) -> Iterator[ae.CompLayer]:
    """Yield the layers of a united shadow, with the keys of the lowest layer's opacity where they are the group's."""
    canvas = document.canvas
    looks = [_look_at(group, frame) for frame in range(1, canvas.length_frames + 1)]
    track = track_of(document, Address(properties.OPACITY, group.ids[0]))
    plain = ae.CompLayer(
        tag=f"shadow:{_tag(group)}",
        name=_name(document, group),
        footage=f"comp:{_tag(group)}",
        blend="NORMAL",
        opacity=ae.Channel(100.0),
        colors=tuple(_held_colors(looks, canvas.frame_rate)),
    )
    ways = reduce(either, map(laying.of_shadow, group.ids))
    yield from laying.layers(ways, track, plain, default=looks[0].multiply)


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
