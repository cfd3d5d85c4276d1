"""Names of rendered folders and files that every operating system accepts, whatever the layers are called."""

import re
import unicodedata
from collections.abc import Iterable
from typing import Final

MIN_DIGITS: Final = 4
_MAX_BYTES: Final = 120
_REPLACEMENT: Final = "_"
_FORBIDDEN: Final = re.compile(r'[<>:"/\\|?*]')
_DEVICES: Final = frozenset(
    ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"]
    + [f"{device}{digit}" for device in ("COM", "LPT") for digit in "0123456789¹²³"]
)


def safe_names(names: Iterable[str]) -> dict[str, str]:
    """Return for each name the one that its folder and files carry; no two are alike on any file system.

    A name stays as it is where it can. Otherwise forbidden characters become ``_``, names that Windows keeps for
    devices are set apart by a leading ``_``, and of names that differ only in case or in Unicode form the later ones
    get a number.

    Parameters
    ----------
    names
        Different names, in the order in which they have a right to their own.
    """
    chosen: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        plain = _cleaned(name)
        number = 2
        free = plain
        while _folded(free) in taken:
            free = f"{plain}_{number}"
            number += 1
        taken.add(_folded(free))
        chosen[name] = free
    return chosen


def digits_for(last_frame: int, least: int = MIN_DIGITS) -> int:
    """Return how many digits every frame number of a cut has: at least so many, and the same for all."""
    return max(least, len(str(last_frame)))


def _cleaned(name: str) -> str:
    """Return a name without what some file system refuses, hides or cuts off."""
    text = "".join(sign if sign.isprintable() else _REPLACEMENT for sign in name)
    text = _FORBIDDEN.sub(_REPLACEMENT, text).strip(" ")
    text = re.sub(r"^\.+|[. ]+$", _REPLACEMENT, text)
    if text.split(".")[0].rstrip().upper() in _DEVICES:
        text = _REPLACEMENT + text
    text = text.encode("utf-8")[:_MAX_BYTES].decode("utf-8", "ignore").rstrip(" .")
    return text or _REPLACEMENT


def _folded(name: str) -> str:
    """Return what file systems compare that mind neither case nor Unicode form."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", name).casefold())
