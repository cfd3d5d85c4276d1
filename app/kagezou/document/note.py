"""What people say about a cut while they look it through: notes on properties, with answers."""

from dataclasses import dataclass, replace


@dataclass(frozen=True, slots=True)
class NoteAnswer:
    """What somebody says to a note; ``author`` may be empty."""

    text: str
    author: str = ""


@dataclass(frozen=True, slots=True)
class Note:
    """What a lead says about one property on one frame.

    Parameters
    ----------
    frame
        From 1.
    property
        The property's name; for a layer's property the part after ``layers.NAME.``.
    text
        What is said; may have lines.
    layer_id
        Whose property it is; None for one of the scene.
    author
        Who says it, may be empty.
    answers
        What was said to it, the latest last.
    is_done
        Whether it is ticked off.
    """

    frame: int
    property: str
    text: str
    layer_id: str | None = None
    author: str = ""
    answers: tuple[NoteAnswer, ...] = ()
    is_done: bool = False

    def is_as(self, other: "Note") -> bool:
        """Return whether another is the same note, though it may have been answered or ticked off meanwhile."""
        return replace(self, answers=(), is_done=False) == replace(other, answers=(), is_done=False)
