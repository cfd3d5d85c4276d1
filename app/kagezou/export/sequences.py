"""The sequences of an export: what each shows, and by which names it lies where."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.model import Document, Layer
from kagezou.errors import UsageProblem
from kagezou.export.layered import LayerOfFrame
from kagezou.export.names import digits_for, safe_names
from kagezou.export.receivers import receivers_of
from kagezou.export.request import CONTACTS, RECEIVED, RECEIVERS, REFLECTIONS, SHADOWS, ExportRequest
from kagezou.export.selection import (
    chosen_layers,
    ever_has_contact,
    ever_is_mirrored,
    ever_receives,
    set_ever_casts,
    with_shadows,
)
from kagezou.export.subjects import (
    CompositeSubject,
    ContactSubject,
    LayeredSubject,
    ReceivedSubject,
    ReflectionSubject,
    SetShadowSubject,
    ShadowSubject,
    Subject,
    UnitedSubject,
)
from kagezou.export.uniting import CutGroups, cut_groups
from kagezou.message import Message

COMPOSITE: Final = "composite"
"""The folder and the first part of the files of composites."""
UNITED: Final = "shadows"
"""The same of the shadows of one look as one."""
LAYERED: Final = "layered"
"""The same of frames that hold all layers in one file."""


@dataclass(frozen=True, slots=True)
class OutputSequence:
    """Numbered files of one subject in a folder of their own.

    Parameters
    ----------
    subject
        What they show.
    label
        The name of the folder, and the first part of the files'.
    folder
        The folder itself.
    digits
        How many the number of each file has.
    suffix
        The suffix of the files.
    """

    subject: Subject
    label: str
    folder: Path
    digits: int
    suffix: str

    def file(self, number: int) -> Path:
        """Return the path of a file."""
        return self.folder / f"{self.label}_{number:0{self.digits}d}{self.suffix}"


def sequences_of(document: Document, request: ExportRequest) -> tuple[OutputSequence, ...]:
    """Return the sequences that a request asks for, never none.

    Raises
    ------
    UsageProblem
        A layer is asked for that the document does not have, or there is nothing to make.
    """
    layered: list[tuple[str, Subject]] = [(LAYERED, layered_subject(document, request))] if request.layered else []
    subjects = layered or list(_apart(document, request))
    if not subjects:
        raise _nothing()
    digits = digits_for(document.canvas.length_frames)
    return tuple(
        OutputSequence(each, label, request.folder / label, digits, request.suffix) for label, each in subjects
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
    groups = _group_names(document, layers)
    characters = tuple(
        LayerOfFrame(
            layer.id,
            layer.name,
            receives=ever_receives(layer),
            group=groups.get(layer.id, ""),
            has_shadow=layer.joins is None,
            has_contact=ever_has_contact(layer),
            is_mirrored=ever_is_mirrored(layer),
        )
        for layer in layers
    )
    return LayeredSubject(characters, is_whole and set_ever_casts(document), is_whole)


def _group_names(document: Document, layers: tuple[Layer, ...]) -> dict[str, str]:
    """Return, by their ids, what the groups of layers are called whose shadows unite."""
    names = {layer.id: layer.name for layer in layers}
    united = _chosen(cut_groups(document, of_one_color=True), names)
    groups = [ids for ids in united if len(ids) > 1]
    return {each: label for label, ids in zip(_labels(groups, names), groups, strict=True) for each in ids}


def _chosen(groups: CutGroups, names: dict[str, str]) -> list[tuple[str, ...]]:
    """Return groups without the layers that are not in ``names``, and without those of which none is left."""
    kept = (tuple(each for each in group.ids if each in names) for group in groups.groups)
    return [ids for ids in kept if ids]


def _labels(groups: list[tuple[str, ...]], names: dict[str, str]) -> list[str]:
    """Return a name for each group: where there are several, each has that of its lowest layer in it.

    No other name ends in ``_shadows``.
    """
    return [UNITED] if len(groups) == 1 else [f"{names[ids[0]]}_{UNITED}" for ids in groups]


def _nothing() -> UsageProblem:
    return UsageProblem(Message("there is nothing to render: the project has no visible character layer"))


def _apart(document: Document, request: ExportRequest) -> Iterator[tuple[str, Subject]]:
    """Yield each sequence that has a folder of its own."""
    layers = chosen_layers(document, request)
    names = safe_names(layer.name for layer in document.layers)
    if request.only in (None, SHADOWS):
        figures = with_shadows(document, request)
        yield from ((f"{names[layer.name]}_shadow", ShadowSubject(layer.id)) for layer in figures)
    if request.only in (None, RECEIVED):
        receiving = filter(ever_receives, layers)
        yield from ((f"{names[layer.name]}_received", ReceivedSubject(layer.id)) for layer in receiving)
    if request.only in (None, CONTACTS):
        touching = filter(ever_has_contact, layers)
        yield from ((f"{names[layer.name]}_contact", ContactSubject(layer.id)) for layer in touching)
    if request.only in (None, REFLECTIONS):
        mirrored = filter(ever_is_mirrored, layers)
        yield from ((f"{names[layer.name]}_reflection", ReflectionSubject(layer.id)) for layer in mirrored)
    if request.only in (None, SHADOWS) and request.layers is None and set_ever_casts(document):
        yield _set_label(document, names), SetShadowSubject()
    if request.united:
        yield from _united(document, {layer.id: names[layer.name] for layer in layers})
    if request.receivers or request.only == RECEIVERS:
        yield from ((each.label, each.subject) for each in receivers_of(document))
    if request.composite:
        yield COMPOSITE, CompositeSubject(request.guides)


def _united(document: Document, names: dict[str, str]) -> Iterator[tuple[str, Subject]]:
    """Yield the shadows of each look as one, of the layers in ``names`` (id → name)."""
    groups = _chosen(cut_groups(document, of_one_color=False), names)
    yield from zip(_labels(groups, names), map(UnitedSubject, groups), strict=True)


def _set_label(document: Document, names: dict[str, str]) -> str:
    """Return the name of the set's folder and files, which no layer's may be."""
    wanted = "set"
    while wanted in names:
        wanted += "_"
    return f"{safe_names((*(layer.name for layer in document.layers), wanted))[wanted]}_shadow"
