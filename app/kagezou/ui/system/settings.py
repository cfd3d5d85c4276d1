"""What the window remembers between two runs; everything has a default, so that a lost file costs nothing."""

import getpass
import os
from pathlib import Path

from platformdirs import user_cache_path, user_config_path, user_state_path
from PySide6.QtCore import QByteArray, QDir, QSettings

MAX_RECENT = 8


class Settings:
    """The remembered choices, kept in a Qt settings store.

    Parameters
    ----------
    store
        Where they are kept; by default the user's own store of this program.
    style_folder
        Where styles are kept; by default the folder of the user's own settings.
    recovery_folder
        Where unsaved work is put aside; by default in the folder of the user's own state.
    picture_folder
        Where pictures of projects are kept; by default the user's own cache.
    spare_recovery_folder
        Where unsaved work is put aside while its own folder takes none; by default among the temporary files.
    """

    def __init__(
        self,
        store: QSettings | None = None,
        style_folder: Path | None = None,
        recovery_folder: Path | None = None,
        picture_folder: Path | None = None,
        spare_recovery_folder: Path | None = None,
    ) -> None:
        self._store = store or QSettings("Kagezou", "Kagezou")
        self._style_folder = style_folder or user_config_path("kagezou", appauthor=False) / "styles"
        self._picture_folder = picture_folder or user_cache_path("kagezou", appauthor=False) / "projects"

        self._recovery_folder = recovery_folder or user_state_path("kagezou", appauthor=False) / "unsaved"
        self._spare_recovery_folder = spare_recovery_folder or Path(QDir.tempPath()) / f"kagezou-unsaved-{_user()}"

    @property
    def recovery_folder(self) -> Path:
        """Where unsaved work is put aside."""
        return self._recovery_folder

    @property
    def spare_recovery_folder(self) -> Path:
        """Where unsaved work is put aside while its own folder takes none."""
        return self._spare_recovery_folder

    @property
    def style_folder(self) -> Path:
        """Where the user's own styles are kept."""
        return self._style_folder

    @property
    def preset_folder(self) -> Path:
        """Where the user's ways to export are kept, beside the styles."""
        return self._style_folder.with_name("export presets")

    @property
    def picture_folder(self) -> Path:
        """Where pictures of projects are kept; losing them costs nothing but drawing them again."""
        return self._picture_folder

    @property
    def language(self) -> str:
        """The chosen language's code, empty for the system's own."""
        return str(self._store.value("language", ""))

    @language.setter
    def language(self, code: str) -> None:
        self._store.setValue("language", code)

    @property
    def recent(self) -> list[Path]:
        """Projects opened before, the latest first."""
        kept = self._store.value("recent", [])
        lines = [kept] if isinstance(kept, str) else kept if isinstance(kept, list) else []
        return [Path(str(line)) for line in lines if line]

    def remember_project(self, path: Path) -> None:
        """Put a project first among the recent ones."""
        path = path.absolute()
        others = [old for old in self.recent if old != path]
        self._store.setValue("recent", [str(each) for each in [path, *others][:MAX_RECENT]])

    def forget_projects(self) -> None:
        """Empty the list of recent projects."""
        self._store.remove("recent")

    def folder(self, purpose: str) -> str:
        """Return the folder to begin in for a purpose: the settled one, else the one last used, else empty."""
        return self.settled_folder(purpose) or str(self._store.value(f"folders/{purpose}", ""))

    def settled_folder(self, purpose: str) -> str:
        """Return the folder in which to begin always for a purpose, empty if none."""
        return str(self._store.value(f"settled folders/{purpose}", ""))

    def settle_folder(self, purpose: str, folder: str) -> None:
        """Begin always in a folder for a purpose; with an empty one in the last used."""
        self._store.setValue(f"settled folders/{purpose}", folder)

    def remember_folder(self, purpose: str, folder: Path) -> None:
        """Keep the folder used for a purpose."""
        self._store.setValue(f"folders/{purpose}", str(folder))

    def flag(self, name: str, *, default: bool) -> bool:
        """Return a remembered switch."""
        return str(self._store.value(f"flags/{name}", default)).lower() == "true"

    def set_flag(self, name: str, *, on: bool) -> None:
        """Remember a switch."""
        self._store.setValue(f"flags/{name}", "true" if on else "false")

    def word(self, name: str, default: str) -> str:
        """Return a remembered word."""
        return str(self._store.value(f"words/{name}", default))

    def set_word(self, name: str, word: str) -> None:
        """Remember a word."""
        self._store.setValue(f"words/{name}", word)

    def layout(self, name: str) -> QByteArray:
        """Return the bytes Qt made of a window's layout, empty if none."""
        kept = self._store.value(f"layout/{name}", QByteArray())
        return kept if isinstance(kept, QByteArray) else QByteArray()

    def set_layout(self, name: str, layout: QByteArray) -> None:
        """Remember a window's layout."""
        self._store.setValue(f"layout/{name}", layout)


def _user() -> str:
    """Return what tells the user from others who share the folder for temporary files."""
    return str(os.getuid()) if hasattr(os, "getuid") else getpass.getuser()
