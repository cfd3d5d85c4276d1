"""Putting the window into a language: Qt's own texts and ours. A language is one catalogue; no list names them."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Final

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from kagezou.locations import resource_folder

ENGLISH: Final = "en"
"""The language of the sources; its catalogue holds plural forms alone."""


class Language:
    """The translators installed now; installing others takes these away.

    Parameters
    ----------
    application
        What speaks.
    """

    def __init__(self, application: QCoreApplication) -> None:
        self._application = application
        self._installed: list[QTranslator] = []
        self.code = ENGLISH

    def speak(self, chosen: str) -> None:
        """Speak a language by its code; an empty one means the system's, and English where we do not speak that."""
        self.fall_silent()
        self.code = chosen if chosen in languages() else system_language()
        # English is loaded too: it holds the plural forms.
        self._install(f"qtbase_{self.code}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
        self._install(f"kagezou_{self.code}", str(_folder()))

    def fall_silent(self) -> None:
        """Take the translators away again."""
        for translator in self._installed:
            self._application.removeTranslator(translator)
        self._installed.clear()

    def _install(self, name: str, folder: str) -> None:
        translator = QTranslator(self._application)
        if translator.load(name, folder):
            self._application.installTranslator(translator)
            self._installed.append(translator)


@cache
def languages() -> Mapping[str, str]:
    """Return the languages there are catalogues of, English first: by code, each in its own words."""
    own_names = {
        code: translator.translate("Language", "English", "what the language calls itself")
        for code, translator in _catalogues().items()
    }
    return MappingProxyType({ENGLISH: "English", **{code: name or code for code, name in own_names.items()}})


def language_code() -> str:
    """Return the code of the language that is translated to now; each catalogue says its own."""
    return QCoreApplication.translate("Language", "en", "the code of the language translated to")


def system_language() -> str:
    """Return the code of the system's language if we speak it, else English."""
    spoken = (locale.split("-")[0] for locale in QLocale.system().uiLanguages())
    return next((code for code in spoken if code in languages()), ENGLISH)


def in_all_languages(context: str, text: str) -> tuple[str, ...]:
    """Return a text of the window in English and as every catalogue says it, whatever the window speaks."""
    others = (translator.translate(context, text) for translator in _catalogues().values())
    return (text, *(other for other in others if other))


@cache
def _catalogues() -> Mapping[str, QTranslator]:
    found = {}
    for path in sorted(_folder().glob("kagezou_*.qm")):
        code = path.stem.removeprefix("kagezou_")
        translator = QTranslator()
        if code != ENGLISH and translator.load(str(path)):
            found[code] = translator
    return found


def _folder() -> Path:
    return resource_folder() / "translations"
