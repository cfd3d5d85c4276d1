"""What whoever helps wants to know of this machine, as one text: versions, graphics, memory, and the end of the log.

Nothing is sent. The text is copied on a person's word, and names of their home folder are left out of it.
"""

import platform
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from platformdirs import user_log_path
from PySide6.QtCore import QLocale, qVersion
from PySide6.QtGui import QGuiApplication

from kagezou.io.files.crash_reports import LOG_NAME, end_of, report_folder, reports_in, without_home
from kagezou.io.files.memory import free_memory, whole_memory
from kagezou.io.files.processors import processors
from kagezou.ui.system.settings import Settings
from kagezou.version import __version__

_PACKAGES: Final = ("PySide6-Essentials", "numpy", "OpenImageIO", "PyOpenGL", "psd-tools", "pyqtgraph", "scipy", "av")


@dataclass(frozen=True, slots=True)
class Shown:
    """What the window shows.

    Parameters
    ----------
    graphics
        What draws; empty where nothing does.
    canvas
        Size and length of the cut, in words.
    layers, pieces
        How many there are.
    drawings_bytes, limit_bytes
        The memory that kept drawings take, and may take.
    """

    graphics: str
    canvas: str
    layers: int
    pieces: int
    drawings_bytes: int
    limit_bytes: int


def support_report(shown: Shown, settings: Settings, log_folder: Path | None = None) -> str:
    """Return the report in English, line by line; ``log_folder`` is where the window's log lies."""
    log = (log_folder or user_log_path("kagezou", appauthor=False)) / LOG_NAME
    lines = [
        f"Kagezou {__version__}",
        f"Python {platform.python_version()}, Qt {qVersion()}",
        ", ".join(f"{name} {_version(name)}" for name in _PACKAGES),
        f"system: {platform.platform()}, {platform.machine()}, {processors()} processors",
        f"memory: {_megabytes(free_memory())} free of {_megabytes(whole_memory())}",
        f"graphics: {shown.graphics or 'none'}",
        f"screens: {_screens()} ({QGuiApplication.platformName()})",
        f"language: {settings.language or QLocale.system().name()}",
        f"cut: {shown.canvas}, {shown.layers} layers, {shown.pieces} set pieces",
        f"drawings in memory: {_megabytes(shown.drawings_bytes)} of {_megabytes(shown.limit_bytes)}",
        f"unsaved work is kept in: {settings.recovery_folder}",
        f"log: {log}",
        *end_of(log),
        *_last_crash(log.with_name(report_folder().name)),
    ]
    return without_home("\n".join(lines) + "\n")


def memory_words(shown_bytes: int, limit_bytes: int) -> tuple[str, str, str]:
    """Return the memory that kept drawings take, that they may take, and that is free, each in MB."""
    return _megabytes(shown_bytes), _megabytes(limit_bytes), _megabytes(free_memory())


def _megabytes(count: int | None) -> str:
    return "?" if count is None else f"{count >> 20} MB"


def _version(package: str) -> str:
    from importlib import metadata  # slow, and for the few who ask

    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "-"


def _screens() -> str:
    sizes = ((each.size(), each.devicePixelRatio()) for each in QGuiApplication.screens())
    return ", ".join(f"{size.width()} x {size.height()} at {ratio:g}" for size, ratio in sizes)


def _last_crash(folder: Path) -> list[str]:
    """Return the newest report of a crash, if there is one."""
    newest = next(iter(reports_in(folder)), None)
    return [] if newest is None else [f"last crash: {newest}", *end_of(newest)]
