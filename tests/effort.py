"""How much is tried: a part of every sweep each time, all of it where ``dev.py test --thorough`` asks for it."""

import os

THOROUGH = bool(os.environ.get("KAGEZOU_THOROUGH"))


def tries(usual: int, thorough: int) -> int:
    """Return how many seeds or examples a sweep goes over."""
    return thorough if THOROUGH else usual
