"""The language of the window, and the table's own words in it.

The interface's texts go through Qt's translations. The property table brings its words in both languages; which of
them to say is itself a translated word, so that no part of the window has to be told the language.
"""

from PySide6.QtCore import QCoreApplication

from kagezou.document.property import Words
from kagezou.geometry.sets.measures import PieceKind
from kagezou.ui.system.kind_words import kind_word


def said(words: Words) -> str:
    """Return a text of the property table in the language of the window."""
    return words.ja if is_japanese() else words.en


def is_japanese() -> bool:
    """Whether the window speaks Japanese."""
    return QCoreApplication.translate("Language", "en", "the code of the language translated to") == "ja"


def choice_word(choice: str) -> str:
    """Return what the window calls a choice of the property table."""
    spoken = {
        "point": QCoreApplication.translate("Choice", "Lamp"),
        "sun": QCoreApplication.translate("Choice", "Sun"),
        "solid": QCoreApplication.translate("Choice", "Solid"),
        "translucent": QCoreApplication.translate("Choice", "Translucent"),
        "multiply": QCoreApplication.translate("Choice", "Multiply"),
        "normal": QCoreApplication.translate("Choice", "Normal"),
        "ones": QCoreApplication.translate("Choice", "On ones"),
        "exposures": QCoreApplication.translate("Choice", "With the drawings"),
        **{kind.value: kind_word(kind) for kind in PieceKind},
        "none": QCoreApplication.translate("Choice", "Not at all"),
        "wireframe": QCoreApplication.translate("Choice", "Wireframe"),
        "clay": QCoreApplication.translate("Choice", "Clay"),
        "y": "Y",
        "z": "Z",
    }
    return spoken.get(choice, choice)
