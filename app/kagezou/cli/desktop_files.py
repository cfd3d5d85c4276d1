"""The files by which a Linux desktop knows the program: its place in menus, its files, its icons, small pictures."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem
from kagezou.locations import resource_folder
from kagezou.version import __version__

_LICENSE: Final = "Apache-2.0"
_TEXTS: Final = {
    "kagezou.desktop": "applications/kagezou.desktop",
    "kagezou-mime.xml": "mime/packages/kagezou.xml",
    "org.kagezou.Kagezou.metainfo.xml": "metainfo/org.kagezou.Kagezou.metainfo.xml",
    "kagezou.thumbnailer": "thumbnailers/kagezou.thumbnailer",
}
"""Where each lies under a folder of shared data."""
_CACHES: Final = (
    ("update-desktop-database", "applications"),
    ("update-mime-database", "mime"),
    ("gtk-update-icon-cache", "icons/hicolor"),
)
"""What brings a desktop's own lists up to date; a desktop that lacks it looks by itself."""


@dataclass(frozen=True, slots=True)
class DesktopFiles:
    """The files under a folder of shared data.

    Parameters
    ----------
    share
        Such as ``~/.local/share`` or ``/usr/share``.
    program
        The words that call the program.
    """

    share: Path
    program: tuple[str, ...]

    def write(self) -> tuple[Path, ...]:
        """Write them all, and return them.

        Raises
        ------
        DiskFullProblem, OutputProblem
            One cannot be written.
        """
        written = []
        for path, data in self._contents():
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise output_problem(path.parent, error) from error
            write_bytes(path, data)
            written.append(path)
        return tuple(written)

    def remove(self) -> tuple[Path, ...]:
        """Take away those that are there, and return them.

        Raises
        ------
        OutputProblem
            One cannot be removed.
        """
        removed = []
        for path, _ in self._contents():
            try:
                path.unlink()
            except FileNotFoundError:
                continue
            except OSError as error:
                raise output_problem(path, error) from error
            removed.append(path)
        return tuple(removed)

    def bring_lists_up_to_date(self) -> None:
        """Let the desktop look again, where it has what does so."""
        for name, folder in _CACHES:
            if shutil.which(name) is not None and (self.share / folder).is_dir():
                words = [name, *(["-q", "-t", "-f"] if name.startswith("gtk") else []), str(self.share / folder)]
                subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)

    def _contents(self) -> Iterator[tuple[Path, bytes]]:
        folder = resource_folder() / "desktop"
        for name, place in _TEXTS.items():
            text = (folder / name).read_text(encoding="utf-8")
            yield self.share / place, self._filled(text).encode("utf-8")
        icons = self.share / "icons" / "hicolor"
        for picture in sorted((folder / "icons").glob("kagezou_*.png")):
            size = picture.stem.removeprefix("kagezou_")
            yield icons / f"{size}x{size}" / "apps" / "kagezou.png", picture.read_bytes()
        drawing = resource_folder() / "icons" / "kagezou.svg"
        yield icons / "scalable" / "apps" / "kagezou.svg", drawing.read_bytes()

    def _filled(self, text: str) -> str:
        made = os.environ.get("SOURCE_DATE_EPOCH")
        day = datetime.fromtimestamp(int(made), UTC) if made and made.isdigit() else datetime.now(UTC)
        words = {
            "PROGRAM": " ".join(map(quoted, self.program)),
            "PROGRAM_FILE": self.program[0],
            "LICENSE": _LICENSE,
            "VERSION": __version__,
            "DATE": day.strftime("%Y-%m-%d"),
        }
        for name, word in words.items():
            text = text.replace(f"@{name}@", word)
        return text


def quoted(word: str) -> str:
    """Return a word of a command as desktop entries have it: quoted where it holds what they take for themselves."""
    plain = word.replace("%", "%%")
    if not any(sign in plain for sign in " \t\n\"'\\><~|&;$*?#()`"):
        return plain
    for sign in '\\"`$':
        plain = plain.replace(sign, f"\\{sign}")
    # Backslashes are read twice: as in every text of the entry, and as in quotes.
    return '"' + plain.replace("\\", "\\\\") + '"'
