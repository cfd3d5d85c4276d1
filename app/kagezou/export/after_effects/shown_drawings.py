"""What of a document is shown as it was drawn, the characters' cels and the background, and its footage."""

from collections.abc import Container, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.model import Cels, Document
from kagezou.errors import OutputProblem
from kagezou.export.after_effects.drawings import (
    CelFootage,
    Copying,
    Step,
    are_within,
    copied,
    copied_still,
    exposed,
    have_alpha,
    referenced,
    still_where_it_lies,
)
from kagezou.export.after_effects.transforms import is_background_moved, is_moved
from kagezou.export.names import safe_names
from kagezou.io.files.faults import output_problem, shown
from kagezou.message import Message

BACKGROUND: Final = "background"
"""Stands where layers have their ids, and names folder and files."""


@dataclass(frozen=True, slots=True)
class Shown:
    """Drawings that become footage.

    Parameters
    ----------
    owner
        The id of their layer, or `BACKGROUND`.
    name
        What people call the layer.
    cels
        The drawings, and when each is seen.
    folder
        Where copies of them go.
    copying
        How they are copied.
    """

    owner: str
    name: str
    cels: Cels
    folder: Path
    copying: Copying

    @property
    def length(self) -> int:
        """The length of the cut, frames."""
        return self.copying.canvas.length_frames

    @property
    def is_still(self) -> bool:
        """Whether it is a background of one picture, whose file has no number."""
        return self.owner == BACKGROUND and len(exposed(self.cels, self.length)) == 1

    def where_they_lie(self) -> CelFootage | None:
        """Return the drawings where they are, None where After Effects cannot take them from there."""
        if self.is_still:
            return still_where_it_lies(self.cels, self.length)
        return referenced(self.cels, self.length, white_is_clear=self.copying.white_is_clear)

    @property
    def count(self) -> int:
        """How many of them are seen, each of which would become a copy."""
        return len(exposed(self.cels, self.length))

    def copy(self, step: Step) -> CelFootage | None:
        """Copy them; None where none is ever seen."""
        folder = _made(self.folder)
        if self.is_still:
            return copied_still(self.cels, folder / f"{BACKGROUND}.png", self.copying, step)
        return copied(self.cels, folder.name, folder, self.copying, step)

    def check_place(self) -> None:
        """Raise OutputProblem where copies would take the place of the drawings they are made of."""
        if self.is_still or not are_within(self.cels, self.folder) or self.where_they_lie() is not None:
            return
        if self.owner == BACKGROUND:
            raise OutputProblem(
                Message(
                    "{folder}: the pictures of the background lie there themselves and would be replaced by their "
                    "copies; please choose another folder",
                    folder=shown(self.folder),
                )
            )
        raise OutputProblem(
            Message(
                "{folder}: the drawings of {layer!r} lie there themselves and would be replaced by "
                "their copies; please choose another folder",
                folder=shown(self.folder),
                layer=self.name,
            )
        )

    def note_of_copies(self) -> Message | None:
        """Return why drawings that were to stay where they lie are copied, None where that needs no word."""
        if self.is_still or not exposed(self.cels, self.length):
            return None
        if self.owner == BACKGROUND:
            return Message("the pictures of the background are not a sequence without gaps, so they were copied")
        if not have_alpha(self.cels, self.length):
            return Message("the drawings of {layer!r} have no alpha, so they were copied with it", layer=self.name)
        return Message(
            "the drawings of {layer!r} are not a sequence without gaps, so they were copied", layer=self.name
        )


def shown_in(document: Document, folder: Path, workers: int = 2) -> tuple[Shown, ...]:
    """Return what is shown of a document, the layers from the bottom and the background last.

    Parameters
    ----------
    document
        With no file of it read.
    folder
        Where everything of the hand-off goes.
    workers
        How many drawings are copied at a time.
    """
    names = safe_names(layer.name for layer in document.layers)
    layers = [
        Shown(
            layer.id,
            layer.name,
            layer.cels,
            folder / "characters" / names[layer.name],
            Copying(document.canvas, is_moved=is_moved(document, layer), workers=workers),
        )
        for layer in document.layers
    ]
    if not document.behind.drawings:
        return tuple(layers)
    copying = Copying(document.canvas, is_moved=is_background_moved(document), white_is_clear=False, workers=workers)
    return (*layers, Shown(BACKGROUND, BACKGROUND, document.behind, folder / BACKGROUND, copying))


def staying_in(drawings: Iterable[Shown], *, copies: bool) -> dict[str, CelFootage]:
    """Return, by owner, the footage of what need not be copied because it can be taken from where it lies.

    Raises
    ------
    InputProblem
        A drawing cannot be read.
    """
    found = {each.owner: each.where_they_lie() for each in drawings if _should_stay(each, copies=copies)}
    return {owner: footage for owner, footage in found.items() if footage is not None}


def notes_on_copies(drawings: Iterable[Shown], staying: Container[str], *, copies: bool) -> tuple[Message, ...]:
    """Return what is to be said about drawings that are not in ``staying`` though they should be."""
    unwilling = (each for each in drawings if each.owner not in staying and _should_stay(each, copies=copies))
    return tuple(note for each in unwilling if (note := each.note_of_copies()) is not None)


def _should_stay(drawings: Shown, *, copies: bool) -> bool:
    return not copies or (are_within(drawings.cels, drawings.folder) and not drawings.is_still)


def _made(folder: Path) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    return folder
