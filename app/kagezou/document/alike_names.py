"""When two names are one to a person: letters of any case, and of any Unicode form."""

import unicodedata
from collections.abc import Iterable


def folded(name: str) -> str:
    """Return what alike names have in common."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", name).casefold()).strip()


def unlike(name: str, taken: Iterable[str]) -> str:
    """Return a name, or with a number behind it where one that is like it is taken."""
    others = {folded(each) for each in taken}
    number, free = 1, name
    while folded(free) in others:
        number += 1
        free = f"{name} {number}"
    return free
