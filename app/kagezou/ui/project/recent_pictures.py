"""Small pictures of projects: drawn beside the window's own thread, and kept so that they are drawn once."""

import hashlib
from collections.abc import Iterable
from functools import partial
from pathlib import Path

import numpy as np
from PySide6.QtCore import QBuffer, QIODevice, QObject, QSize, Qt, Signal
from PySide6.QtGui import QImage, QImageWriter, QPainter

from kagezou.errors import Problem
from kagezou.export.small_first_frame import first_frame
from kagezou.io.files.atomic import write_bytes
from kagezou.io.images.reading import Steps
from kagezou.io.project import file as project_file
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.offscreen_context import OffscreenSurface
from kagezou.ui.system.theme import WELL

SIZE = QSize(256, 144)
_MOST_KEPT = 64


class ProjectPictures(QObject):
    """Draws the first frame of projects, one after the other.

    Parameters
    ----------
    folder
        Where the pictures are kept between two runs.
    """

    made = Signal(Path, QImage)

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._surface: OffscreenSurface | None = None
        # Without a second context the page shows names without pictures; the viewport says what is wrong.
        self._background = Queue[tuple[Path, QImage]](self._deliver, low_priority=True)

    def ask(self, projects: Iterable[Path]) -> None:
        """Send the pictures of projects: those that are kept at once, others when they are drawn."""
        missing = []
        for project in projects:
            kept = QImage(str(kept_at(self._folder, project)))
            if kept.isNull():
                missing.append(project)
            else:
                self.made.emit(project, kept)
        if missing and not self.is_busy:
            self._surface = self._surface or OffscreenSurface()
            self._background.ask(partial(_draw_all, self._surface, tuple(missing), self._folder))

    @property
    def is_busy(self) -> bool:
        """Whether pictures are being drawn."""
        return self._background.is_busy

    def finish(self) -> None:
        """Stop and wait, before the window goes."""
        self._background.drop()
        self._background.finish()

    def _deliver(self, made: tuple[Path, QImage]) -> None:
        self.made.emit(*made)


def kept_at(folder: Path, project: Path) -> Path:
    """Return where the picture of a project is kept; another content has another place."""
    try:
        status = project.stat()
    except OSError:
        return folder / "none.png"
    state = f"{project.absolute()}\n{status.st_mtime_ns}\n{status.st_size}"
    return folder / f"{hashlib.sha256(state.encode('utf-8', 'surrogateescape')).hexdigest()[:32]}.png"


def _draw_all(
    surface: OffscreenSurface, projects: tuple[Path, ...], folder: Path, turn: Turn[tuple[Path, QImage]]
) -> None:
    """Draw and keep the pictures of projects; on the worker's thread."""
    with surface.open():
        for project in projects:
            if turn.is_unwanted:
                return
            _draw(project, folder, turn)


def _draw(project: Path, folder: Path, turn: Turn[tuple[Path, QImage]]) -> None:
    try:
        place = kept_at(folder, project)
        picture = first_frame(project_file.load(project))
        if picture is None:
            return
        image = small(picture)
        turn.tell((project, image))
        folder.mkdir(parents=True, exist_ok=True)
        write_bytes(place, _png(image))
        _forget_oldest(folder)
    except (Problem, OSError):
        # A project that cannot be read says so when it is opened; one that cannot be kept is drawn again.
        return


def small(picture: Steps) -> QImage:
    """Return a whole picture small, in the middle of a dark card."""
    height, width = picture.shape[:2]
    whole = QImage(np.ascontiguousarray(picture).data, width, height, width * 4, QImage.Format.Format_RGBA8888)
    scaled = whole.scaled(SIZE, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
    card = QImage(SIZE, QImage.Format.Format_RGB32)
    card.fill(WELL)
    painter = QPainter(card)
    painter.drawImage((SIZE.width() - scaled.width()) // 2, (SIZE.height() - scaled.height()) // 2, scaled)
    painter.end()
    return card


def _png(image: QImage) -> bytes:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"png").write(image)
    return bytes(buffer.data().data())


def _forget_oldest(folder: Path) -> None:
    kept = sorted(folder.glob("*.png"), key=lambda path: path.stat().st_mtime, reverse=True)
    for path in kept[_MOST_KEPT:]:
        path.unlink(missing_ok=True)
