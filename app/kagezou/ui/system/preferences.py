"""What a person prefers of the program as a whole: kept among the settings, with a default for everything."""

import getpass
from dataclasses import dataclass
from typing import Final

from PySide6.QtGui import QColor

from kagezou.io.files.memory import whole_memory
from kagezou.io.images.cel_cache import DEFAULT_LIMIT_BYTES
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.theme import SURROUND

LEAST_MEMORY_MB: Final = 64
_MB: Final = 1 << 20
MOST_LETTERS: Final = 64
"""Of a name under a note."""

_MEMORY, _SURROUND, _AUTHOR, _AFTER_EXPORT = "memory_mb", "surround", "author", "after_export"


@dataclass(frozen=True, slots=True)
class Preferences:
    """What is preferred.

    Parameters
    ----------
    memory_mb
        How much memory decoded drawings may take.
    surround
        The colour around the picture, ``#rrggbb``.
    author
        Who signs notes; empty for whoever the system says sits here.
    after_export
        The command that runs after an export; empty for that of the environment, if any.
    """

    memory_mb: int
    surround: str
    author: str = ""
    after_export: str = ""

    @property
    def signature(self) -> str:
        """The name under a note."""
        return self.author or _user()

    @property
    def memory_bytes(self) -> int:
        """The same in bytes."""
        return self.memory_mb * _MB


def usual_preferences() -> Preferences:
    """Return what is preferred while nobody said anything."""
    return Preferences(DEFAULT_LIMIT_BYTES // _MB, SURROUND.name())


def most_memory_mb() -> int:
    """Return the most that drawings may take: three quarters of the machine's memory, 64 GB where it does not tell."""
    whole = whole_memory()
    return 65536 if whole is None else max(whole * 3 // 4 // _MB, LEAST_MEMORY_MB)


def preferences_in(settings: Settings) -> Preferences:
    """Return what is remembered; what cannot be read or used counts as never said."""
    usual = usual_preferences()
    memory, surround = settings.word(_MEMORY, ""), settings.word(_SURROUND, "")
    known = int(memory) if memory.isascii() and memory.isdigit() and len(memory) < 9 else usual.memory_mb
    color = QColor.fromString(surround)
    return Preferences(
        min(max(known, LEAST_MEMORY_MB), most_memory_mb()),
        color.name() if color.isValid() else usual.surround,
        settings.word(_AUTHOR, "")[:MOST_LETTERS],
        settings.word(_AFTER_EXPORT, ""),
    )


def remember_preferences(settings: Settings, preferences: Preferences) -> None:
    """Keep what is preferred."""
    settings.set_word(_MEMORY, str(preferences.memory_mb))
    settings.set_word(_SURROUND, preferences.surround)
    settings.set_word(_AUTHOR, preferences.author)
    settings.set_word(_AFTER_EXPORT, preferences.after_export)


def _user() -> str:
    """Return who sits here, as far as the system knows."""
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):
        return ""
