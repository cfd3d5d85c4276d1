"""Takes the pictures of the real window that the manual shows, in both languages, and README's moving one.

::

    .venv/bin/python packaging/dev_window_pictures.py

The cut is the one that ``first-cut.md`` makes of the demo's drawings; each picture shows one of its steps.
"""

import math
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Final

from PIL import Image, ImageDraw
from PySide6.QtCore import QPoint, QTimer
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from dev_made_pictures import make_world
from dev_page_commands import ROOT
from dev_window import Pictured, opened, spin
from dev_words_picture import labelled
from kagezou.animation.track import Interpolation, Value
from kagezou.document.address import Address, resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.properties import DISTANCE, SIMPLIFY
from kagezou.document.styling import put_style
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.clips.style_files import bundled_styles
from kagezou.io.project.file import save
from kagezou.ui.application import make_application
from kagezou.ui.system.language import Language

FOLDER: Final = ROOT / "docs" / "pictures" / "window"
SIZE_PX: Final = (1280, 860)
MOVING_PX: Final = (1100, 800)
_MOVING_SHOWN_PX: Final = (825, 600)
_QUALITY: Final = 80
_MOVING_QUALITY: Final = 55
_MOVING_MS: Final = 84
SUN: Final = (-38.0, 55.0)
"""Azimuth and elevation to which the light is dragged, degrees; that of `first-cut.md`."""
_LAST: Final = 48
Step = Callable[[Pictured], QImage]


def main() -> None:
    """Take all pictures."""
    application = make_application()
    speaking = Language(application)
    # A folder of this name stands in the picture of the export; a random one would be another picture each time.
    world = Path(tempfile.gettempdir()) / "kagezou-pictures"
    shutil.rmtree(world, ignore_errors=True)
    try:
        make_world(world)
        for code in ("en", "ja"):
            speaking.speak(code)
            project = _project(world, code)
            with opened(world / f"settings-{code}", SIZE_PX) as pictured:
                pictured.open(project, 300)
                for name, step in STEPS.items():
                    _write(step(pictured), FOLDER / code / f"{name}.webp")
            with opened(world / f"words-{code}", SIZE_PX) as pictured:
                pictured.open(project, 120)
                _write(labelled(pictured, code), FOLDER / code / "words.webp")
        speaking.speak("en")
        with opened(world / "settings-moving", MOVING_PX) as pictured:
            pictured.open(_project(world, "moving"), 210)
            _moving(pictured, FOLDER / "moving.webp")
    finally:
        shutil.rmtree(world, ignore_errors=True)


def _project(world: Path, name: str) -> Path:
    demo = world / name / "kagezou-demo"
    shutil.copytree(world / "kagezou-demo", demo)
    drawings = CharacterSource("Child", demo / "drawings")
    document = new_document([drawings], background=demo / "meadow.png").document
    document = document_with_feet(document, [document.layers[0].id]).document
    path = world / name / "walk.kage"
    save(document, path)
    return path


def _set(pictured: Pictured, path: str, value: Value, frame: int | None = None) -> None:
    bridge = pictured.parts.bridge
    address = resolve(bridge.document, path)
    changed = (
        set_constant(bridge.document, address, value)
        if frame is None
        else set_key(bridge.document, address, frame, value, Interpolation.BEZIER)
    )
    bridge.session.edit(path, changed)
    spin(0.5)


def _cels(pictured: Pictured) -> QImage:
    pictured.go_to(10, 1.5)
    return pictured.picture()


def _light(pictured: Pictured) -> QImage:
    start, *way = _places_of_sun(pictured, [(31.0, 56.0), (0.0, 53.0), SUN])
    pictured.press(start)
    for place in way:
        pictured.move(place)
    seen = pictured.picture(pictured.parts.viewport)
    pictured.release(way[-1])
    _set_sun(pictured, *SUN)
    return seen


def _set_sun(pictured: Pictured, azimuth: float, elevation: float) -> None:
    _set(pictured, "light.azimuth", azimuth)
    _set(pictured, "light.elevation", elevation)


def _places_of_sun(pictured: Pictured, suns: list[tuple[float, float]]) -> list[QPoint]:
    """Return where on its dial the sun is for azimuths and elevations, degrees; the document stays."""
    session = pictured.parts.bridge.session
    places = []
    for azimuth, elevation in suns:
        _set_sun(pictured, azimuth, elevation)
        places.append(pictured.place("light.sun"))
        session.undo()
        session.undo()
    spin(0.3)
    return places


def _ground(pictured: Pictured) -> QImage:
    start = pictured.place("ground.declination")
    pictured.press(start)
    pictured.move(start + QPoint(0, 4))
    seen = pictured.picture(pictured.parts.viewport)
    pictured.release(start + QPoint(0, 4))
    _set(pictured, "ground.declination", 58.0)
    return seen


def _feet(pictured: Pictured) -> QImage:
    pictured.go_to(14)
    pictured.leave()
    return pictured.picture(pictured.parts.time.timeline)


def _simple(pictured: Pictured) -> QImage:
    bridge = pictured.parts.bridge
    layer = bridge.document.layers[-1].id
    (simple,) = (each.style for each in bundled_styles() if each.path.stem == "2-simple")
    bridge.session.edit("Simple", put_style(bridge.document, [layer], simple, 1).document)
    _set(pictured, "layers.Child.shadow.distance", 200.0)
    pictured.go_to(10)
    pictured.parts.panels.inspector.reveal([Address(SIMPLIFY, layer), Address(DISTANCE, layer)])
    spin(0.8)
    return pictured.picture()


def _keys(pictured: Pictured) -> QImage:
    _set(pictured, "light.azimuth", SUN[0], 1)
    _set(pictured, "light.azimuth", -SUN[0], _LAST)
    pictured.parts.actions["reveal_light"].trigger()
    pictured.parts.actions["reveal_animated"].trigger()
    pictured.go_to(30)
    return pictured.picture(pictured.parts.time.timeline)


def _curves(pictured: Pictured) -> QImage:
    pictured.parts.actions["curves"].trigger()
    spin(0.8)
    editor = pictured.parts.curves.made()
    editor.take_snapshot()
    _set(pictured, "light.azimuth", 10.0, 30)
    editor.graph.fit_all()
    spin(0.5)
    seen = pictured.picture(pictured.parts.curves)
    pictured.parts.bridge.session.undo()
    pictured.parts.actions["timeline"].trigger()
    return seen


def _export(pictured: Pictured) -> QImage:
    taken: list[QImage] = []

    def take() -> None:
        dialog = QApplication.activeModalWidget()
        if dialog is None:
            QTimer.singleShot(200, take)
            return
        spin(1.0)
        taken.append(dialog.grab().toImage())
        dialog.close()

    QTimer.singleShot(800, take)
    pictured.parts.actions["export"].trigger()
    spin(10.0, lambda: bool(taken))
    return taken[0]


STEPS: Final[dict[str, Step]] = {
    "cels": _cels,
    "light": _light,
    "ground": _ground,
    "feet": _feet,
    "simple": _simple,
    "keys": _keys,
    "curves": _curves,
    "export": _export,
}


def _moving(pictured: Pictured, target: Path) -> None:
    """Film the light being dragged around and the cut being played."""
    pictured.go_to(28, 1.5)
    turns = [55.0 * math.cos(part / 23 * math.tau * 0.75) for part in range(24)]
    places = _places_of_sun(pictured, [(31.0, 56.0), *((turn, 54.0) for turn in turns)])
    frames = []
    pictured.press(places[0])
    for place in places[1:]:
        pictured.move(place)
        frames.append(_with_pointer(pictured, place))
    pictured.release(places[-1])
    _set_sun(pictured, *SUN)
    pictured.leave()
    for frame in range(1, 49, 2):
        pictured.go_to(frame, 0.25)
        frames.append(_pillow(pictured.picture()).resize(_MOVING_SHOWN_PX, Image.Resampling.LANCZOS))
    target.parent.mkdir(parents=True, exist_ok=True)
    frames[0].save(
        target, save_all=True, append_images=frames[1:], duration=_MOVING_MS, loop=0, quality=_MOVING_QUALITY, method=6
    )
    sys.stdout.write(f"{target}  {target.stat().st_size // 1000} kB\n")


def _with_pointer(pictured: Pictured, place: QPoint) -> Image.Image:
    seen = _pillow(pictured.picture())
    tip = pictured.parts.viewport.mapTo(pictured.window, place)
    x, y = tip.x(), tip.y()
    arrow = [(x, y), (x, y + 20), (x + 5, y + 16), (x + 9, y + 23), (x + 12, y + 21), (x + 8, y + 14), (x + 14, y + 13)]
    ImageDraw.Draw(seen).polygon(arrow, fill="white", outline="black")
    return seen.resize(_MOVING_SHOWN_PX, Image.Resampling.LANCZOS)


def _pillow(image: QImage) -> Image.Image:
    plain = image.convertToFormat(QImage.Format.Format_RGB888)
    size = (plain.width(), plain.height())
    return Image.frombytes("RGB", size, bytes(plain.constBits()), "raw", "RGB", plain.bytesPerLine())


def _write(image: QImage, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    _pillow(image).save(target, quality=_QUALITY, method=6)
    sys.stdout.write(f"{target}  {image.width()} x {image.height()}, {target.stat().st_size // 1000} kB\n")
    sys.stdout.flush()


if __name__ == "__main__":
    os.environ.setdefault("XDG_CONFIG_HOME", tempfile.mkdtemp())
    main()
