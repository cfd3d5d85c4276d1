"""Putting the window into a language: Qt's own texts and ours."""

from collections.abc import Callable
from functools import cache

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from kagezou.locations import resource_folder

LANGUAGES = {"en": "English", "ja": "日本語"}
"""The languages there are, each in its own words."""


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
        self.code = "en"

    def speak(self, chosen: str) -> None:
        """Speak a language by its code; an empty one means the system's, and English where we do not speak that."""
        self.fall_silent()
        self.code = chosen if chosen in LANGUAGES else system_language()
        # English is loaded too: it holds the plural forms.
        self._install(f"qtbase_{self.code}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
        self._install(f"kagezou_{self.code}", str(resource_folder() / "translations"))

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


def system_language() -> str:
    """Return the code of the system's language if we speak it, else English."""
    spoken = (locale.split("-")[0] for locale in QLocale.system().uiLanguages())
    return next((code for code in spoken if code in LANGUAGES), "en")


@cache
def words_in(code: str) -> Callable[[str, str], str]:
    """Return what says the window's texts in a language whatever the window speaks; untranslated ones stay English."""
    translator = QTranslator()
    translator.load(f"kagezou_{code}", str(resource_folder() / "translations"))
    return lambda context, text: translator.translate(context, text) or text
