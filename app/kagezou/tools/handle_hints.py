"""What may be held while a handle is dragged, said before it is taken hold of."""

from typing import Final

from kagezou.message import Message
from kagezou.tools import (
    cel_placing,
    feet,
    filters,
    ground,
    grounding,
    light,
    matching,
    overhead,
    set_piece,
    set_size,
    shadow,
    sun,
    tilt,
)
from kagezou.tools.handle import Handle

_AXIS: Final = Message("Shift: one way")
_STEPS: Final = Message("Shift: steps of 15°")
_FREE: Final = Message("Ctrl: no snapping")
_FINE: Final = Message("Shift+Alt or Shift+A: slowly")

_HINTS: Final[dict[str, tuple[Message, ...]]] = {
    light.LAMP: (_AXIS, _FINE),
    light.FOOT: (_AXIS, _FINE),
    sun.SUN: (_STEPS, _FINE),
    shadow.TIP: (_AXIS, _FINE),
    overhead.OVERHEAD: (_FINE,),
    ground.POSITION: (_AXIS, _FREE, _FINE),
    ground.END: (_STEPS, _FREE, _FINE),
    ground.DECLINATION: (_STEPS, _FINE),
    tilt.TILT: (_STEPS, _FREE, _FINE),
    grounding.GROUNDING: (_AXIS, _FREE, Message("Alt or A: the other point goes the other way"), _FINE),
    feet.FOOT: (_AXIS, _FINE),
    feet.GROUND: (_FINE,),
    filters.DISTANCE: (_AXIS, _FINE),
    filters.WAVE1: (_STEPS, _FINE),
    filters.WAVE2: (_STEPS, _FINE),
    set_piece.POSITION: (_AXIS, _FREE, _FINE),
    set_piece.TURN: (_STEPS, _FREE, _FINE),
    set_piece.LEAN: (_STEPS, _FREE, _FINE),
    set_size.WIDTH: (Message("Shift: keeps its shape"), _FINE),
    set_size.DEPTH: (Message("Shift: keeps its shape"), _FINE),
    set_size.HEIGHT: (Message("Shift: keeps its shape"), _FINE),
    cel_placing.MOVE: (_AXIS, _FINE),
    cel_placing.ANCHOR_POINT: (_AXIS, _FINE),
    cel_placing.CORNER: (Message("Shift: keeps its shape"), _FINE),
    cel_placing.TURN: (_STEPS, _FREE, _FINE),
    matching.END: (_FINE,),
    matching.HORIZON: (_STEPS, _FINE),
    matching.HORIZON_END: (_STEPS, _FREE, _FINE),
}


def hints_of(handle: Handle) -> tuple[Message, ...]:
    """Return what the keys do while a handle is dragged."""
    whole, _, number = handle.id.rpartition(".")
    return _HINTS[whole if number.isdigit() else handle.id]
