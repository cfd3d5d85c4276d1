"""Which shadows unite over a whole cut, so that they can be handed over as the layers of one group."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from kagezou.document.model import Document
from kagezou.message import Message
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import ShadowLook
from kagezou.scene.uniting import shadow_groups


@dataclass(frozen=True, slots=True)
class CutGroup:
    """Layers whose shadows unite on every frame on which several of them are there.

    Parameters
    ----------
    ids
        Of the layers, from the bottom; one alone is a group, too.
    looks
        By frame: how the united shadow is laid; frames without any are left out.
    """

    ids: tuple[str, ...]
    looks: Mapping[int, ShadowLook] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True, slots=True)
class CutGroups:
    """The groups of a cut.

    Parameters
    ----------
    groups
        In the order of their lowest layers; every layer that casts at any time is in one of them.
    apart
        The names of layers that unite with a layer of another group on some frames of the picture.
    """

    groups: tuple[CutGroup, ...]
    apart: tuple[str, ...]

    def of_several(self) -> tuple[CutGroup, ...]:
        """Return the groups of two and more layers."""
        return tuple(group for group in self.groups if len(group.ids) > 1)

    def notes(self) -> tuple[Message, ...]:
        """Return what is to be said where the picture cannot be made of the groups."""
        if not self.apart:
            return ()
        return (
            Message(
                "the shadows of {layers} unite in the picture, but stay apart as layers, where they darken each other: "
                "their looks differ on some frames, or have a second colour",
                layers=", ".join(map(repr, self.apart)),
            ),
        )


def cut_groups(document: Document, *, of_one_color: bool) -> CutGroups:
    """Return what unites over a whole cut, whichever of its frames are asked for.

    Parameters
    ----------
    of_one_color
        Whether layers whose shadow ever has a second colour stay alone, as the maximum of alpha is not all of theirs.
    """
    frames = tuple(_frames(document))
    groups: list[CutGroup] = []
    for layer in document.layers:
        own = CutGroup((layer.id,), {frame: look for frame, looks, _ in frames if (look := looks.get(layer.id))})
        if own.looks:
            _put(groups, own, frames, of_one_color=of_one_color)
    place = {layer_id: index for index, group in enumerate(groups) for layer_id in group.ids}
    apart = {
        layer_id
        for _, _, united in frames
        for together in united
        if len({place[each] for each in together}) > 1
        for layer_id in together
    }
    return CutGroups(tuple(groups), tuple(layer.name for layer in document.layers if layer.id in apart))


_Frame = tuple[int, Mapping[str, ShadowLook], tuple[frozenset[str], ...]]
"""A frame, the looks of the shadows on it, and which of them unite."""


def _frames(document: Document) -> Iterator[_Frame]:
    for frame in range(1, document.canvas.length_frames + 1):
        groups = shadow_groups(evaluate(document, frame))
        looks = {layer.id: layer.look for group in groups for layer in group}
        yield frame, looks, tuple(frozenset(layer.id for layer in group) for group in groups)


def _put(groups: list[CutGroup], own: CutGroup, frames: tuple[_Frame, ...], *, of_one_color: bool) -> None:
    """Put a layer into the first group that it always unites with, else behind all as one of its own."""
    is_plain = not of_one_color or all(look.tip is None for look in own.looks.values())
    for index, group in enumerate(groups):
        ids = (*group.ids, *own.ids)
        if is_plain and _always_unites(frozenset(ids), own.ids[0], frames):
            groups[index] = replace(group, ids=ids, looks={**group.looks, **own.looks})
            return
    groups.append(own)


def _always_unites(ids: frozenset[str], own: str, frames: tuple[_Frame, ...]) -> bool:
    """Return whether a layer meets others of a group at all, and wherever it does all of them unite."""
    meetings = [
        any(there <= each for each in united)
        for _, looks, united in frames
        if own in looks and len(there := ids & looks.keys()) > 1
    ]
    return bool(meetings) and all(meetings)
