"""The sequences of an export: what each shows, and by which names it lies where."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.document.model import Document, Layer
from kagezou.errors import UsageProblem
from kagezou.export.file_names import Label, NumberedName
from kagezou.export.layers_of_frame import CLAY_NAMES, OVER, LayerOfFrame
from kagezou.export.names import safe_names
from kagezou.export.receivers import receivers_of
from kagezou.export.request import CLAY, CONTACTS, RECEIVED, RECEIVERS, REFLECTIONS, SHADOWS, TOGETHER, ExportRequest
from kagezou.export.selection import (
    chosen_layers,
    ever_clay,
    ever_has_contact,
    ever_is_mirrored,
    received_ways,
    set_ever_casts,
    with_shadows,
)
from kagezou.export.subjects import (
    ClaySubject,
    CompositeSubject,
    ContactSubject,
    LayeredSubject,
    ReceivedSubject,
    ReflectionSubject,
    SetShadowSubject,
    ShadowSubject,
    Subject,
    TogetherSubject,
    UnitedSubject,
)
from kagezou.export.uniting import CutGroup, cut_groups
from kagezou.message import Message

COMPOSITE: Final = "composite"
"""The folder and the first part of the files of composites."""
UNITED: Final = "shadows"
"""The same of the shadows of one look as one."""
LAYERED: Final = "layered"
"""The same of frames that hold all layers in one file."""


@dataclass(frozen=True, slots=True)
class OutputSequence:
    """Numbered files of one subject.

    Parameters
    ----------
    subject
        What they show.
    label
        What it is called.
    name
        How the files are called, and where they lie.
    """

    subject: Subject
    label: str
    name: NumberedName

    @property
    def folder(self) -> Path:
        """Where the files lie."""
        return self.name.folder

    def file(self, frame: int) -> Path:
        """Return the path of the file for a frame, counted from 1."""
        return self.name.file(frame)


def sequences_of(document: Document, request: ExportRequest) -> tuple[OutputSequence, ...]:
    """Return the sequences that a request asks for, never none.

    Raises
    ------
    UsageProblem
        A layer is asked for that the document does not have, there is nothing to make, or two sequences would have
        the same files.
    """
    whole: list[tuple[Label, Subject]] = []
    if request.layered:
        whole.append((Label("", LAYERED), layered_subject(document, request)))
    subjects = whole or list(_apart(document, request))
    if not subjects:
        raise _nothing()
    names = request.names.named([label for label, _ in subjects], document, request.folder, request.suffix)
    return tuple(
        OutputSequence(subject, label.text, name) for (label, subject), name in zip(subjects, names, strict=True)
    )


def layered_subject(document: Document, request: ExportRequest) -> LayeredSubject:
    """Return what layered frames show: with some layers chosen they hold those alone.

    Raises
    ------
    UsageProblem
        As for `sequences_of`.
    """
    layers = chosen_layers(document, request)
    if not layers:
        raise _nothing()
    is_whole = request.layers is None
    groups = {each: (label, group) for label, group in _named_groups(document, layers) for each in group.ids}
    alone = ("", CutGroup(()))
    characters = tuple(
        LayerOfFrame(
            layer.id,
            layer.name,
            received=received_ways(document, layer),
            group=groups.get(layer.id, alone)[0],
            together=_together_ways(groups.get(layer.id, alone)[1]),
            has_shadow=layer.joins is None,
            has_contact=ever_has_contact(layer),
            is_mirrored=ever_is_mirrored(layer),
        )
        for layer in layers
    )
    clay = ever_clay(document) if is_whole else ()
    return LayeredSubject(characters, is_whole and set_ever_casts(document), is_whole, clay)


def _together_ways(group: CutGroup) -> tuple[bool, ...]:
    return group.laid if group.is_together else ()


def _named_groups(document: Document, layers: tuple[Layer, ...]) -> Iterator[tuple[str, CutGroup]]:
    """Yield the groups of several of the layers that are laid as one, and what each is called."""
    names = {layer.id: layer.name for layer in layers}
    groups = [group for group in _chosen(cut_groups(document, of_one_color=True).groups, names) if len(group.ids) > 1]
    yield from ((label.text, group) for label, group in zip(_labels(groups, names), groups, strict=True))


def _chosen(groups: tuple[CutGroup, ...], names: dict[str, str]) -> list[CutGroup]:
    """Return groups without the layers that are not in ``names``, and without those of which none is left."""
    kept = (replace(group, ids=tuple(each for each in group.ids if each in names)) for group in groups)
    return [group for group in kept if group.ids]


def _labels(groups: list[CutGroup], names: dict[str, str]) -> list[Label]:
    """Return a name for each group: where there are several, each has that of its lowest layer in it.

    No other name ends in ``_shadows``.
    """
    return [Label("" if len(groups) == 1 else names[group.ids[0]], UNITED) for group in groups]


def _nothing() -> UsageProblem:
    return UsageProblem(Message("there is nothing to render: the project has no visible character layer"))


def _apart(document: Document, request: ExportRequest) -> Iterator[tuple[Label, Subject]]:
    """Yield each sequence that has a folder of its own."""
    layers = chosen_layers(document, request)
    names = safe_names(layer.name for layer in document.layers)
    if request.only in (None, SHADOWS):
        figures = with_shadows(document, request)
        yield from ((Label(names[layer.name], "shadow"), ShadowSubject(layer.id)) for layer in figures)
    yield from _on_and_beside(document, request, [(layer, names[layer.name]) for layer in layers])
    if request.layers is None:
        yield from _of_set(document, request, names)
    if request.united or request.only == TOGETHER:
        of_layers = {layer.id: names[layer.name] for layer in layers}
        yield from _united(document, of_layers, is_apart=request.only == TOGETHER)
    if request.receivers or request.only == RECEIVERS:
        yield from ((Label(each.name, "matte"), each.subject) for each in receivers_of(document))
    if request.composite:
        yield Label("", COMPOSITE), CompositeSubject(request.guides)


def _on_and_beside(
    document: Document, request: ExportRequest, named: list[tuple[Layer, str]]
) -> Iterator[tuple[Label, Subject]]:
    """Yield what falls on characters, the patches under their feet, and their reflections."""
    if request.only in (None, RECEIVED):
        for layer, name in named:
            for over, way in _by_place(received_ways(document, layer)):
                yield Label(name, "received" + OVER * over), ReceivedSubject(layer.id, way, over)
    if request.only in (None, CONTACTS):
        touching = (each for each in named if ever_has_contact(each[0]))
        yield from ((Label(name, "contact"), ContactSubject(layer.id)) for layer, name in touching)
    if request.only in (None, REFLECTIONS):
        mirrored = (each for each in named if ever_is_mirrored(each[0]))
        yield from ((Label(name, "reflection"), ReflectionSubject(layer.id)) for layer, name in mirrored)


def _of_set(document: Document, request: ExportRequest, names: dict[str, str]) -> Iterator[tuple[Label, Subject]]:
    """Yield the shadow of the set, and sets as they are drawn themselves."""
    if request.only in (None, SHADOWS) and set_ever_casts(document):
        yield Label(_set_name(document, names), "shadow"), SetShadowSubject()
    if request.only in (None, CLAY):
        yield from ((Label("", CLAY_NAMES[is_under]), ClaySubject(is_under)) for is_under in ever_clay(document))


def _by_place(ways: tuple[bool, ...]) -> Iterator[tuple[bool, bool]]:
    """Yield ways of laying something, each behind whether it lies over another."""
    return ((bool(place), way) for place, way in enumerate(ways))


def _united(document: Document, names: dict[str, str], *, is_apart: bool) -> Iterator[tuple[Label, Subject]]:
    """Yield the shadows of each look as one, of the layers in ``names`` (id → name), and those that go together.

    With ``is_apart`` these alone, besides groups that are layers of their own.
    """
    groups = _chosen(cut_groups(document, of_one_color=is_apart).groups, names)
    groups = [group for group in groups if len(group.ids) > 1] if is_apart else groups
    for label, group in zip(_labels(groups, names), groups, strict=True):
        if group.is_together:
            for over, way in _by_place(group.laid):
                yield replace(label, kind=label.kind + OVER * over), TogetherSubject(group.ids, way, over)
        elif not is_apart:
            yield label, UnitedSubject(group.ids)


def _set_name(document: Document, names: dict[str, str]) -> str:
    """Return the name of the set's files, which no layer's may be."""
    wanted = "set"
    while wanted in names:
        wanted += "_"
    return safe_names((*(layer.name for layer in document.layers), wanted))[wanted]
