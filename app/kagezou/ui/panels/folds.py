"""Which sections of the inspector are open, remembered between two runs."""

from kagezou.ui.panels.groups import OPEN_AT_FIRST, Group
from kagezou.ui.system.settings import Settings


class Folds:
    """What is open and what is folded away, of sections and of the rarer lines in them.

    Parameters
    ----------
    settings
        Where it is remembered; without them only while the program runs.
    """

    def __init__(self, settings: Settings | None = None) -> None:
        self._settings = settings
        self._known: dict[str, bool] = {}

    def is_open(self, group: Group) -> bool:
        """Whether a section is open."""
        return self._is(f"section_{group.name}", default=group in OPEN_AT_FIRST)

    def shows_more(self, group: Group) -> bool:
        """Whether a section shows its rarer lines."""
        return self._is(f"more_{group.name}", default=False)

    def set_open(self, group: Group, *, opened: bool) -> None:
        """Remember whether a section is open."""
        self._set(f"section_{group.name}", on=opened)

    def set_more(self, group: Group, *, shown: bool) -> None:
        """Remember whether a section shows its rarer lines."""
        self._set(f"more_{group.name}", on=shown)

    def _is(self, name: str, *, default: bool) -> bool:
        if name not in self._known:
            settings = self._settings
            self._known[name] = default if settings is None else settings.flag(name, default=default)
        return self._known[name]

    def _set(self, name: str, *, on: bool) -> None:
        self._known[name] = on
        if self._settings is not None:
            self._settings.set_flag(name, on=on)
