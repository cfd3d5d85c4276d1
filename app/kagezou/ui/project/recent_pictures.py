"""Small pictures of projects: drawn beside the window's own thread, and kept so that they are drawn once."""

import hashlib
import threading
from collections import deque
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from PySide6.QtCore import QBuffer, QIODevice, QObject, QSize, Qt, QThread, Signal
from PySide6.QtGui import QImage, QImageWriter, QPainter

from kagezou.errors import Problem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.io.project import file as project_file
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
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
        self._job: _Job | None = None

    def ask(self, projects: Iterable[Path]) -> None:
        """Send the pictures of projects: those that are kept at once, others when they are drawn."""
        missing = []
        for project in projects:
            kept = QImage(str(kept_at(self._folder, project)))
            if kept.isNull():
                missing.append(project)
            else:
                self.made.emit(project, kept)
        if missing and self._job is None:
            self._surface = self._surface or OffscreenSurface()
            self._job = _Job(self, self._surface, missing, self._folder)
            self._job.finished.connect(self._end)
            self._job.start(QThread.Priority.LowPriority)

    @property
    def is_busy(self) -> bool:
        """Whether pictures are being drawn."""
        return self._job is not None

    def finish(self) -> None:
        """Stop and wait, before the window goes."""
        if self._job is not None:
            self._job.stop.set()
            self._job.wait()

    def _end(self) -> None:
        self._job = None


def kept_at(folder: Path, project: Path) -> Path:
    """Return where the picture of a project is kept; another content has another place."""
    try:
        status = project.stat()
    except OSError:
        return folder / "none.png"
    state = f"{project.absolute()}\n{status.st_mtime_ns}\n{status.st_size}"
    return folder / f"{hashlib.sha256(state.encode('utf-8', 'surrogateescape')).hexdigest()[:32]}.png"


class _Job(QThread):
    def __init__(
        self, owner: ProjectPictures, surface: OffscreenSurface, projects: Iterable[Path], folder: Path
    ) -> None:
        super().__init__()
        self._owner, self._surface, self._folder = owner, surface, folder
        self._projects = deque(projects)
        self.stop = threading.Event()

    def run(self) -> None:
        try:
            with self._surface.open():
                cels = CelCache()
                renderer = Renderer(cels)
                try:
                    while self._projects and not self.stop.is_set():
                        self._draw(renderer, self._projects.popleft())
                finally:
                    renderer.close()
        except Problem:
            # Without a second context the page shows names without pictures; the viewport says what is wrong.
            return

    def _draw(self, renderer: Renderer, project: Path) -> None:
        try:
            place = kept_at(self._folder, project)
            renderer.draw_picture(evaluate(project_file.load(project), 1), Backdrop.WHITE)
            image = small(renderer.read_picture())
            self._owner.made.emit(project, image)
            self._folder.mkdir(parents=True, exist_ok=True)
            write_bytes(place, _png(image))
            _forget_oldest(self._folder)
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
