"""The numbers that frames bear: the first frame of a cut need not be 1 to people; to the program it is."""

from kagezou.document.model import Canvas


def number_of(canvas: Canvas, frame: int) -> int:
    """Return the number that people read for a frame, counted from 1."""
    return frame + canvas.first_frame - 1


def frame_of(canvas: Canvas, number: int) -> int:
    """Return the frame, counted from 1, that bears a number."""
    return number - canvas.first_frame + 1
