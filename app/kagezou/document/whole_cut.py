"""What is said of a layer once for the whole cut and has no keys: ``layers.NAME.joins``, ``.paper`` and the like."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Final

from kagezou.document.edits import join_layer
from kagezou.document.layer_marks import LABELS
from kagezou.document.marking import set_marks
from kagezou.document.model import Document, Layer
from kagezou.document.paper import paper_of, set_paper, typed_paper
from kagezou.errors import UsageProblem
from kagezou.message import Message
from kagezou.picture_source import Paper

_YES_OR_NO: Final = ("false", "true")


@dataclass(frozen=True, slots=True)
class Saying:
    """One thing that is said of layers.

    Parameters
    ----------
    name
        The last part of its path.
    help
        What it does.
    value, choices
        The word that a layer of a document has now, and those that it may have.
    changed
        Returns the document in which a layer has another word; raises :class:`UsageProblem` for one it cannot have.
    """

    name: str
    help: Message
    value: Callable[[Document, Layer], str]
    choices: Callable[[Document, Layer], tuple[str, ...]]
    changed: Callable[[Document, Layer, object], Document]


@dataclass(frozen=True, slots=True)
class SaidOf:
    """What is said of one layer of a document."""

    document: Document
    layer: Layer
    saying: Saying

    @property
    def path(self) -> str:
        """What people write for it."""
        return f"layers.{self.layer.name}.{self.saying.name}"

    @property
    def value(self) -> str:
        """The word that is said now."""
        return self.saying.value(self.document, self.layer)

    @property
    def choices(self) -> tuple[str, ...]:
        """The words that may be said."""
        return self.saying.choices(self.document, self.layer)

    def changed(self, word: object, frame: int | None = None) -> Document:
        """Return the document in which another word is said.

        Raises
        ------
        UsageProblem
            It is none of the choices, or a key is asked for.
        """
        if frame is not None:
            raise UsageProblem(Message("{path} is the same on every frame and has no keys", path=self.path))
        return self.saying.changed(self.document, self.layer, word)


def sayings(document: Document) -> Iterator[SaidOf]:
    """Yield everything that is said of the layers, in their order."""
    return (SaidOf(document, layer, saying) for layer in document.layers for saying in SAYINGS)


def saying_at(document: Document, path: str) -> SaidOf | None:
    """Return what a path names; None where it names something else."""
    return next((said for said in sayings(document) if said.path == path), None)


def _joins(document: Document, layer: Layer) -> str:
    return "" if layer.joins is None else document.layer(layer.joins).name


def _figures(document: Document, layer: Layer) -> tuple[str, ...]:
    return ("", *(each.name for each in document.layers if each.joins is None and each is not layer))


def _joined(document: Document, layer: Layer, word: object) -> Document:
    if word == "":
        return join_layer(document, layer.id, None)
    found = [each.id for each in document.layers if each.name == word]
    if not found:
        raise UsageProblem(Message("there is no layer {name!r} to be joined", name=word))
    return join_layer(document, layer.id, found[0])


def _yes_or_no(*, is_yes: bool) -> str:
    return _YES_OR_NO[is_yes]


def _is_yes(name: str, word: object) -> bool:
    if isinstance(word, bool):
        return word
    if word not in _YES_OR_NO:
        raise UsageProblem(Message("{name} is true or false, not {word!r}", name=name, word=word))
    return word == _YES_OR_NO[1]


def _marked(document: Document, layer: Layer, **marks: object) -> Document:
    return set_marks(document, (layer.id,), lambda now: replace(now, **marks))  # type: ignore[arg-type] # by name


SAYINGS: Final = (
    Saying(
        "joins",
        Message("The layer whose figure this one is a part of; empty for a figure of its own."),
        _joins,
        _figures,
        _joined,
    ),
    Saying(
        "paper",
        Message("Where drawings have no alpha, white is clear everywhere, or only where it reaches the border."),
        lambda _, layer: paper_of(layer).value,
        lambda _, __: tuple(Paper),
        lambda document, layer, word: set_paper(document, layer.id, typed_paper(word)),
    ),
    Saying(
        "locked",
        Message("Whether the window refuses to change the layer; the command line changes it all the same."),
        lambda _, layer: _yes_or_no(is_yes=layer.marks.is_locked),
        lambda _, __: _YES_OR_NO,
        lambda document, layer, word: _marked(document, layer, is_locked=_is_yes("locked", word)),
    ),
    Saying(
        "solo",
        Message("Whether the window shows the layer alone; exports show all."),
        lambda _, layer: _yes_or_no(is_yes=layer.marks.is_solo),
        lambda _, __: _YES_OR_NO,
        lambda document, layer, word: _marked(document, layer, is_solo=_is_yes("solo", word)),
    ),
    Saying(
        "label",
        Message("The colour of the layer's label in the window."),
        lambda _, layer: layer.marks.label,
        lambda _, __: ("", *LABELS),
        lambda document, layer, word: _marked(document, layer, label=word if isinstance(word, str) else "?"),
    ),
)
"""All that is said of layers, in the order in which it is listed."""
