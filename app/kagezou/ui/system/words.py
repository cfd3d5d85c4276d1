"""What the rooms below say, in the language of the window."""

from PySide6.QtCore import QCoreApplication

from kagezou.document.choice_labels import CHOICE_LABELS
from kagezou.document.local_name import LocalName
from kagezou.extras import HOW
from kagezou.io.clips.catalogues import MESSAGES
from kagezou.message import Translatable
from kagezou.ui.system.language import language_code


def translated(said: Translatable) -> str:
    """Return a message, or what a problem says, in the language of the window; it begins like a sentence."""
    return said.sentence(in_own_language)


def named(name: LocalName) -> str:
    """Return a name that a file brings, in the language of the window."""
    return name.in_language(language_code())


def choice_name(choice: str) -> str:
    """Return what a choice of a property is called; one that no property has is shown as it is."""
    label = CHOICE_LABELS.get(choice)
    return choice if label is None else translated(label)


def in_own_language(text: str, about: str) -> str:
    """Return an English text, with its places for values, in the language of the window.

    In the place of a command for a terminal stands where the window shows it.
    """
    if text in HOW:
        return QCoreApplication.translate("MissingParts", "“Missing Parts” in the Help menu shows how")
    return QCoreApplication.translate(MESSAGES, text, about or None)
