"""The guided first cut: five steps from a light to files for After Effects, each checked when it is done.

A step compares the document with the one with which it began, so that any way of doing it counts: a handle in the
picture, a field of the inspector, a key.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, TypeAlias

from PySide6.QtCore import QCoreApplication, QObject, Signal

from kagezou.document import properties
from kagezou.document.address import Address, addresses, track_of
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty

IsDone: TypeAlias = Callable[[Document, Document], bool]
"""From the document at the step's beginning and the one now to whether the step is done."""


@dataclass(frozen=True, slots=True)
class Step:
    """One thing to do.

    Parameters
    ----------
    words
        What to do, to be translated.
    is_done
        Whether it is done; None for a step that ends with an export.
    about
        The properties that it changes, to be pointed at.
    """

    words: str
    is_done: IsDone | None
    about: tuple[AnyProperty, ...]


def translate(_context: str, text: str) -> str:
    """Mark a text for the translators where it is written, to be translated where it is shown."""
    return text


def changes(*props: AnyProperty) -> IsDone:
    """Return whether one of these properties is another, of the scene or of any layer."""

    def is_done(before: Document, now: Document) -> bool:
        return any(
            track_of(before, each) != track_of(now, each)
            for each in addresses(now)
            if each.property in props and _is_in(before, each)
        )

    return is_done


def sets_keys(before: Document, now: Document) -> bool:
    """Return whether some property changes over time that did not, or did by fewer keys."""
    return any(
        len(track_of(now, each).keys) > max(len(track_of(before, each).keys), 1)
        for each in addresses(now)
        if _is_in(before, each)
    )


def _is_in(document: Document, address: Address) -> bool:
    layers, pieces = {each.id for each in document.layers}, {each.id for each in document.pieces}
    return address.layer_id in {None, *layers} and address.piece_id in {None, *pieces}


STEPS: Final = (
    Step(
        translate(
            "FirstCut", "Drag the light in the picture, here the sun on its dial under the feet: the shadow follows."
        ),
        changes(properties.LIGHT_POSITION, properties.LIGHT_AZIMUTH, properties.LIGHT_ELEVATION),
        (properties.LIGHT_POSITION, properties.LIGHT_AZIMUTH, properties.LIGHT_ELEVATION),
    ),
    Step(
        translate("FirstCut", "Say from how high the ground is seen: drag the lever under the feet, or Declination."),
        changes(properties.GROUND_DECLINATION),
        (properties.GROUND_DECLINATION,),
    ),
    Step(
        translate("FirstCut", "Make the shape as simple as it would be drawn: drag Simplify, under Shape."),
        changes(properties.SIMPLIFY, properties.DISTANCE),
        (properties.SIMPLIFY,),
    ),
    Step(
        translate(
            "FirstCut",
            "Let it change over time: click the diamond before Opacity, go to another frame, and change the value.",
        ),
        sets_keys,
        (properties.OPACITY,),
    ),
    Step(
        translate("FirstCut", "Hand it over: press Export at the top right, choose After Effects, and export."),
        None,
        (),
    ),
)


class FirstCut(QObject):
    """Which step is at hand; it moves on by itself, and says so.

    Attributes
    ----------
    number
        The step from 0; as many as there are steps when all are done, and None while nobody is guided.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.number: int | None = None
        self._before: Document | None = None

    @property
    def step(self) -> Step | None:
        """The step at hand."""
        return None if self.number is None or self.number >= len(STEPS) else STEPS[self.number]

    @property
    def words(self) -> str:
        """What to do now."""
        if self.step is not None:
            return QCoreApplication.translate("FirstCut", self.step.words)
        return QCoreApplication.translate(
            "FirstCut", "That was a whole cut. F1 opens the page of the manual about whatever is under the pointer."
        )

    def begin(self, document: Document) -> None:
        """Begin with the first step."""
        self._go(0, document)

    def see(self, document: Document) -> None:
        """Move on if a document is what the step asks for."""
        step = self.step
        if step is not None and step.is_done and self._before is not None and step.is_done(self._before, document):
            self.skip(document)

    def see_export(self, document: Document) -> None:
        """Move on if the step asks for an export; one that was made."""
        if self.step is not None and self.step.is_done is None:
            self.skip(document)

    def skip(self, document: Document) -> None:
        """Go on to the next step."""
        if self.number is not None:
            self._go(min(self.number + 1, len(STEPS)), document)

    def end(self) -> None:
        """Guide nobody any more."""
        if self.number is not None:
            self.number = self._before = None
            self.changed.emit()

    def _go(self, number: int, document: Document) -> None:
        self.number, self._before = number, document
        self.changed.emit()
