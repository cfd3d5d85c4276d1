"""Which shadows unite over a whole cut, so that they can be handed over as the layers of one group.

Others are handed over together, as one picture a frame: those that unite on some frames only, have a second colour, or
change places with others.
"""

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
        By frame: how the united shadow is laid; frames without any are left out. Empty for those together.
    blends
        The ways in which shadows are laid at any time: True for multiplying what is under them.
    is_together
        Whether they do not, and no layers make the picture but pictures of all of them.
    """

    ids: tuple[str, ...]
    looks: Mapping[int, ShadowLook] = field(default_factory=lambda: MappingProxyType({}))
    blends: frozenset[bool] = frozenset()
    is_together: bool = False

    @property
    def laid(self) -> tuple[bool, ...]:
        """The ways in which they are laid, as of ``blends``, the lower first."""
        return tuple(each for each in (True, False) if each in self.blends)


@dataclass(frozen=True, slots=True)
class CutGroups:
    """The groups of a cut.

    Parameters
    ----------
    groups
        In the order of their lowest layers; every layer that casts at any time is in one of them.
    names
        Layer id → name.
    """

    groups: tuple[CutGroup, ...]
    names: Mapping[str, str]

    def of_several(self) -> tuple[CutGroup, ...]:
        """Return the groups of two and more layers that are layers of their own."""
        return tuple(group for group in self.groups if len(group.ids) > 1 and not group.is_together)

    def together(self) -> tuple[CutGroup, ...]:
        """Return those that are handed over together."""
        return tuple(group for group in self.groups if group.is_together)

    def notes(self) -> tuple[Message, ...]:
        """Return what is to be said of those that are handed over together."""
        return tuple(
            Message(
                "the shadows of {layers} are handed over as one, with their opacity in it, for no layers make the "
                "picture: they unite on some frames only, have a second colour, or change places with others",
                layers=", ".join(repr(self.names[each]) for each in group.ids),
            )
            for group in self.together()
        )


def cut_groups(document: Document, *, of_one_color: bool) -> CutGroups:
    """Return what unites over a whole cut, whichever of its frames are asked for.

    Parameters
    ----------
    of_one_color
        Whether layers with a second colour make no group, as the maximum of alpha is not all of theirs.
    """
    frames = tuple(_frames(document))
    groups: list[CutGroup] = []
    for layer in document.layers:
        looks = {frame: look for frame, looks, _ in frames if (look := looks.get(layer.id))}
        if looks:
            own = CutGroup((layer.id,), looks, frozenset(look.multiply for look in looks.values()))
            _put(groups, own, frames, of_one_color=of_one_color)
    order = {layer.id: place for place, layer in enumerate(document.layers)}
    joined = _joined(tuple(groups), frames, order)
    return CutGroups(joined, {layer.id: layer.name for layer in document.layers})


_Frame = tuple[int, Mapping[str, ShadowLook], tuple[frozenset[str], ...]]
"""A frame, the looks of the shadows on it, and which of them unite, in the order in which they are laid."""


def _joined(groups: tuple[CutGroup, ...], frames: tuple[_Frame, ...], order: Mapping[str, int]) -> tuple[CutGroup, ...]:
    """Return the groups, with those as one that are handed over together; ``order`` is of layers, from the bottom."""
    place = {layer_id: index for index, group in enumerate(groups) for layer_id in group.ids}
    # The lowest group that each is together with.
    lowest = list(range(len(groups)))
    before: list[int] = []
    while before != lowest:
        before = list(lowest)
        for _, looks, united in frames:
            _merge_in(lowest, [({place[each] for each in ids}, looks[next(iter(ids))].multiply) for ids in united])
    made = ([at for at, low in enumerate(lowest) if low == wanted] for wanted in sorted(set(lowest)))
    return tuple(_as_one(groups, places, order) for places in made)


def _merge_in(lowest: list[int], laid: list[tuple[set[int], bool]]) -> None:
    """Put together groups that one frame unites, or lays the other way round than the cut does.

    ``laid`` has the groups in each united shadow, in the order in which they are laid, and whether it multiplies; only
    shadows that all do so may change places.
    """
    above = {True: -1, False: -1}
    for places, multiply in laid:
        own = {lowest[place] for place in places}
        # Below one that multiplies others may lie that do so too, below another one none.
        under = above[False] if multiply else max(above.values())
        if under > min(own):
            own.add(under)
        low = min(own)
        for at, each in enumerate(lowest):
            lowest[at] = low if each in own else each
        above[multiply] = max(above[multiply], low)


def _as_one(groups: tuple[CutGroup, ...], places: list[int], order: Mapping[str, int]) -> CutGroup:
    if len(places) == 1:
        return groups[places[0]]
    ids = sorted((each for place in places for each in groups[place].ids), key=lambda each: order[each])
    blends = frozenset[bool]().union(*(groups[place].blends for place in places))
    return CutGroup(tuple(ids), blends=blends, is_together=True)


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
            looks = {**group.looks, **own.looks}
            groups[index] = replace(group, ids=ids, looks=looks, blends=group.blends | own.blends)
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
