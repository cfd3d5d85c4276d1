"""White of drawings without alpha, which is clear: all of it, or what reaches the border."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images.stored_pixels import full
from kagezou.io.pixels.paper import reaching_border
from kagezou.message import Message

_NO_ALPHA: Final = Message("no alpha channel: pure white was taken as clear")
_NO_ALPHA_BORDER: Final = Message("no alpha channel: white that reaches the border was taken as clear")
_NO_ALPHA_NO_WHITE: Final = Message("no alpha channel and no white: the whole frame would cast a shadow")


def white_of(rgba: NDArray[Any]) -> NDArray[np.bool_]:
    """Return where straight pixels (H, W, 4) are pure white, (H, W)."""
    most = full(rgba)
    white: NDArray[np.bool_] = (rgba[..., 0] & rgba[..., 1] & rgba[..., 2]) == most
    return white


def clear_white(rgba: NDArray[Any], *, is_outlined: bool) -> tuple[Message, ...]:
    """Make pure white clear in place, in (H, W, 4), all or what reaches the border; return the note about it."""
    white = white_of(rgba)
    if is_outlined:
        white = reaching_border(white)
    rgba[..., 3][white] = 0
    if not white.any():
        return (_NO_ALPHA_NO_WHITE,)
    return (_NO_ALPHA_BORDER if is_outlined else _NO_ALPHA,)
