"""What OpenImageIO says went wrong, as one line."""

from typing import Any


def text_of(ask: Any) -> str:
    """Return the pending error as one line; damaged files may put bytes into it that are no text."""
    try:
        return first_line(ask())
    except UnicodeDecodeError:
        return "it cannot be decoded"


def first_line(text: str) -> str:
    """Return the first line of an error, which is the one that a person can use."""
    return text.strip().partition("\n")[0].strip() or ""
