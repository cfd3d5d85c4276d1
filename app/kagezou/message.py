"""What is said to a person: an English text with named places for values, translated where it is shown.

A room that finds out what is wrong, or what a thing is called, makes a `Message`; it knows no language. The command
line shows ``str(message)``; the window looks the text up in its catalogue and puts the same values in. The text stands
literally in the call, so that the catalogues are filled from the sources.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Protocol, runtime_checkable

Translate = Callable[[str, str], str]
"""From an English text, places for values still in it, and what it is about, to the text of a language."""


@runtime_checkable
class Translatable(Protocol):
    """What can be said in any language: a message, and whatever holds one."""

    def formatted(self, translate: Translate) -> str:
        """Return it in the language of ``translate``."""

    def sentence(self, translate: Translate) -> str:
        """Return it as a sentence of its own."""


class Message:
    """A text and its values; equal ones are equal.

    Parameters
    ----------
    text
        English; ``{name}`` is a place for a value, with a format or conversion as in `str.format`: ``{share:.1f}``.
    about
        Tells a text from an equal one that another language says differently.
    values
        By name. A message within a message is translated with it; anything else is shown as `str.format` shows it.
    """

    __slots__ = ("about", "text", "values")

    def __init__(self, text: str, about: str = "", /, **values: object) -> None:
        self.text = text
        self.about = about
        self.values = values

    @classmethod
    def retold(cls, text: str, about: str, values: Mapping[str, object]) -> "Message":
        """Return a message that another process made, from its parts."""
        return cls(text, about, **values)

    def formatted(self, translate: Translate) -> str:
        """Return the text in the language of ``translate``, with its values."""
        return self._filled(translate(self.text, self.about), translate)

    def sentence(self, translate: Translate) -> str:
        """Return the same for a place of its own: an English text begins with a capital, a name stays as it is."""
        text = translate(self.text, self.about)
        return self._filled(text[:1].upper() + text[1:] if text == self.text else text, translate)

    def _filled(self, text: str, translate: Translate) -> str:
        values = {name: _formatted(value, translate) for name, value in self.values.items()}
        return text.format_map(values)

    def __str__(self) -> str:
        """Return it in English."""
        return self.formatted(_as_written)

    def __repr__(self) -> str:
        values = "".join(f", {name}={value!r}" for name, value in self.values.items())
        return f"Message({self.text!r}{values})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Message) and self._parts == other._parts

    def __hash__(self) -> int:
        return hash((self.text, self.about, *self.values))

    @property
    def _parts(self) -> tuple[str, str, dict[str, object]]:
        return self.text, self.about, self.values


def _formatted(value: object, translate: Translate) -> object:
    return value.formatted(translate) if isinstance(value, Translatable) else value


def _as_written(text: str, _about: str) -> str:
    return text


def first_names(names: Iterable[str], most: int = 3) -> str:
    """Return the first of many names as one enumeration, with dots where there are more."""
    known = list(names)
    return ", ".join(known[:most]) + (", …" if len(known) > most else "")


def nearest(word: str, known: Iterable[str]) -> str | None:
    """Return what someone may have meant who has typed a word; None where nothing known is near it."""
    from difflib import get_close_matches  # of no use to those who make no mistake

    return next(iter(get_close_matches(word, list(known), n=1)), None)
