"""How much is tried: a part of every sweep each time, all of it where ``dev.py test --thorough`` asks for it."""

import os
from collections.abc import Iterable
from itertools import product
from typing import Any

THOROUGH = bool(os.environ.get("KAGEZOU_THOROUGH"))


def tries(usual: int, thorough: int) -> int:
    """Return how many seeds or examples a sweep goes over."""
    return thorough if THOROUGH else usual


def chequered(*axes: Iterable[Any]) -> list[tuple[Any, ...]]:
    """Return the combinations that a sweep goes over: usually every other one, like the fields of a chessboard.

    Every value comes up, and with three axes or more every pair of values.
    """
    placed = product(*(tuple(enumerate(axis)) for axis in axes))
    tried = (each for each in placed if THOROUGH or sum(place for place, _ in each) % 2 == 0)
    return [tuple(value for _, value in each) for each in tried]
