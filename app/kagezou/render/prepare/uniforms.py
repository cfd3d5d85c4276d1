"""What is handed to shaders."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

Uniform = bool | int | float | Sequence[float] | NDArray[np.float64] | NDArray[np.float32]
"""(3, 3) or (N, 3, 3) matrices, (N, 4) vectors, a vector, a number or a switch."""

LAST_LEVEL: Final = 5
"""The coarsest mipmap; a texture whose sides are multiples of 2 to this power has exact means in every level."""
