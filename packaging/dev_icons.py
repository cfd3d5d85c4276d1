"""The program's icon in the sizes that systems ask for, from the one drawing of it.

``PYTHONPATH=app:packaging python packaging/dev_icons.py`` writes the pictures that the program carries for Linux;
``... dev_icons.py build`` writes kagezou.ico and kagezou.icns into build/ for bundles of Windows and macOS.
"""

import sys
from pathlib import Path
from typing import Final

from PIL import Image
from PySide6.QtCore import QRectF
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

ROOT: Final = Path(__file__).resolve().parents[1]
DRAWING: Final = ROOT / "app" / "resources" / "icons" / "kagezou.svg"
SIZES: Final = (16, 22, 24, 32, 48, 64, 128, 256, 512)
_OF_WINDOWS: Final = (16, 24, 32, 48, 64, 128, 256)


def drawn(size_px: int) -> Image.Image:
    """Return the icon, as wide and high as that."""
    picture = QImage(size_px, size_px, QImage.Format.Format_RGBA8888)
    picture.fill(0)
    painter = QPainter(picture)
    QSvgRenderer(str(DRAWING)).render(painter, QRectF(0, 0, size_px, size_px))
    painter.end()
    return Image.frombytes(
        "RGBA", (size_px, size_px), bytes(picture.constBits()), "raw", "RGBA", picture.bytesPerLine()
    )


def write_pictures(folder: Path) -> None:
    """Write a PNG for every size."""
    folder.mkdir(parents=True, exist_ok=True)
    for size in SIZES:
        drawn(size).save(folder / f"kagezou_{size}.png", optimize=True)


def write_for_bundles(folder: Path) -> None:
    """Write the files of several sizes that Windows and macOS have."""
    folder.mkdir(parents=True, exist_ok=True)
    pictures = [drawn(size) for size in _OF_WINDOWS]
    pictures[-1].save(folder / "kagezou.ico", sizes=[each.size for each in pictures], append_images=pictures[:-1])
    drawn(1024).save(folder / "kagezou.icns", append_images=[drawn(size) for size in (512, 256, 128, 64, 32, 16)])


if __name__ == "__main__":
    application = QGuiApplication(["icons", "-platform", "offscreen"])
    if sys.argv[1:] == ["build"]:
        write_for_bundles(ROOT / "build")
    else:
        write_pictures(ROOT / "app" / "resources" / "desktop" / "icons")
