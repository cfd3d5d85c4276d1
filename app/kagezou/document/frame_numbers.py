"""The numbers that frames bear: the first frame of a cut need not be 1 to people; to the program it is."""

from kagezou.document.model import Canvas
from kagezou.message import Message


def number_of(canvas: Canvas, frame: int) -> int:
    """Return the number that people read for a frame, counted from 1."""
    return frame + canvas.first_frame - 1


def at_shown_number(said: Message, canvas: Canvas) -> Message:
    """Return what is said of a frame, its value ``frame``, with the number that people read for it."""
    frame = said.values.get("frame")
    if not isinstance(frame, int) or canvas.first_frame == 1:
        return said
    return Message.retold(said.text, said.about, {**said.values, "frame": number_of(canvas, frame)})


def frame_of(canvas: Canvas, number: int) -> int:
    """Return the frame, counted from 1, that bears a number."""
    return number - canvas.first_frame + 1
