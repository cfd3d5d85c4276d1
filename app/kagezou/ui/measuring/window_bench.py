"""Measuring the window: a light is dragged, a cut played, a key of a curve dragged, time scrubbed."""

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from PySide6.QtCore import QPoint, QPointF, QSettings
from PySide6.QtWidgets import QApplication, QWidget

from kagezou.document.model import Document
from kagezou.session.session import Session
from kagezou.tools.handle import place_in_view
from kagezou.ui.application import make_application
from kagezou.ui.measuring.paints import Response, Watch, response
from kagezou.ui.measuring.pointer import Hand, Place
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow

SIZES_PX = ((1280, 800), (1920, 1080))
MOVES = 250
EVERY_S = 1 / 100
PLAYED_S = 5.0


def measured(walk: Document, crowd: Document) -> tuple[str, tuple[Response, ...]]:
    """Return what draws, and how the window answers.

    Parameters
    ----------
    walk
        A cut with a light to drag and frames to play.
    crowd
        A cut of many layers with keys on one property each.

    Raises
    ------
    UsageProblem
        There is no X server with the test extension.
    """
    application = QApplication.instance() or make_application()
    assert isinstance(application, QApplication)
    with Hand() as hand:
        found = []
        device = ""
        for size_px in SIZES_PX:
            with _window(walk, size_px) as window:
                name = f"{size_px[0]}x{size_px[1]}"
                found.append(_light_drag(window, hand, f"light drag {name}"))
                found.append(_playback(window, f"playback {name}"))
                device = window.parts.viewport.device
        with _window(crowd, SIZES_PX[0]) as window:
            found += [*_scrubbing(window, hand), _curve_drag(window, hand)]
    return device, tuple(found)


@contextmanager
def _window(document: Document, size_px: tuple[int, int]) -> Iterator[MainWindow]:
    """Open a window of its own settings with a document, and wait until it has settled."""
    with TemporaryDirectory(prefix="kagezou-window-") as folder:
        places = [Path(folder, name) for name in ("styles", "unsaved", "pictures", "spare")]
        settings = Settings(QSettings(str(Path(folder, "settings.ini")), QSettings.Format.IniFormat), *places)
        project = OpenProject()
        window = MainWindow(project, settings, SystemClipboard())
        window.setGeometry(0, 0, *size_px)
        window.show()
        project.bridge.open(Session(document))
        for layer in document.layers:
            for drawing in layer.cels.drawings:
                project.cels.cel(drawing.source)
        _pass(2.0)
        try:
            yield window
        finally:
            window.close_unasked()
            window.deleteLater()
            _pass(0.2)


def _pass(seconds: float, is_over: Callable[[], bool] = lambda: False) -> None:
    """Let the window work for some time, or until something is so."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and not is_over():
        QApplication.processEvents()
        time.sleep(0.0005)


def _dragged(window: MainWindow, hand: Hand, name: str, places: list[Place], seen: Callable[[], object]) -> Response:
    """Drag along places and return how it was answered."""
    for step in (lambda: hand.go(places[:1], 0.2), lambda: hand.press(down=True)):
        step()
        _pass(5.0, lambda: hand.is_done)
        hand.sent()
        _pass(0.3)
    watch, began_s = Watch(window, seen), time.monotonic()
    hand.go(places, EVERY_S)
    _pass(60.0, lambda: hand.is_done)
    sent = hand.sent()
    paints, took_s = watch.finish(), time.monotonic() - began_s
    hand.press(down=False)
    _pass(5.0, lambda: hand.is_done)
    hand.sent()
    _pass(0.5)
    return response(name, paints, took_s, sent)


def _around(middle: Place, across: int, up: int) -> list[Place]:
    """Return places on a figure of eight, none like the one before."""
    turns = [2 * math.pi * index / MOVES * 2 for index in range(MOVES)]
    return [(middle[0] + round(across * math.sin(t)), middle[1] + round(up * math.sin(2 * t))) for t in turns]


def _light_drag(window: MainWindow, hand: Hand, name: str) -> Response:
    viewport, bridge = window.parts.viewport, window.parts.bridge
    light = next(each for each in viewport.controller.handles.handles if each.id.startswith("light"))
    (x, y), _ = place_in_view(light, viewport.viewpoint.view, viewport.viewpoint.size)
    return _dragged(window, hand, name, _around(_on_screen(viewport, (x, y)), 90, 30), lambda: bridge.document)


def _playback(window: MainWindow, name: str) -> Response:
    player, bridge = window.parts.time.player, window.parts.bridge
    player.start()
    # Once through and more, so that whatever can be kept is.
    _pass(3 * bridge.document.canvas.length_frames / float(bridge.document.canvas.frame_rate) + 4)
    watch = Watch(window, lambda: bridge.frame)
    _pass(PLAYED_S)
    paints = watch.finish()
    player.stop()
    _pass(0.3)
    return response(name, paints, PLAYED_S)


def _scrubbing(window: MainWindow, hand: Hand) -> tuple[Response, ...]:
    ruler, bridge = window.parts.time.timeline.ruler, window.parts.bridge
    length = ruler.width() - 40
    places = [
        _on_screen(ruler, (20 + length * (0.5 - 0.5 * math.cos(4 * math.pi * i / MOVES)), 8)) for i in range(MOVES)
    ]
    return (_dragged(window, hand, "scrubbing, playhead", places, lambda: bridge.frame),)


def _curve_drag(window: MainWindow, hand: Hand) -> Response:
    bridge = window.parts.bridge
    ids = [layer.id for layer in bridge.document.layers]
    bridge.session.select(ids[0], (), frozenset(ids[1:]))
    window.parts.actions["curves"].trigger()
    _pass(1.0)
    editor = window.parts.curves.made()
    editor.graph.fit_all()
    _pass(1.0)
    marks = editor.graph.pictures[0].keys
    mark = marks[len(marks) // 2]
    scene = editor.graph.view.mapViewToScene(QPointF(mark.frame, mark.ordinate))
    place = editor.graph.mapFromScene(scene)
    middle = _on_screen(editor.graph.viewport(), (place.x(), place.y()))
    return _dragged(window, hand, "curve key drag", _around(middle, 5, 30), lambda: bridge.document)


def _on_screen(widget: QWidget, place: tuple[float, float]) -> Place:
    at = widget.mapToGlobal(QPoint(round(place[0]), round(place[1])))
    return at.x(), at.y()
