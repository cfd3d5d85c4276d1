"""Small cuts for the tests of exports: a block that walks over a canvas of 64 × 48 px."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, set_canvas, set_constant, set_key
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.export.frames import export_frames
from kagezou.export.request import ExportRequest, Summary
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import OpenContext, open_headless_context

WIDTH, HEIGHT = 64, 48


def drawings(folder: Path, count: int, name: str = "a") -> tuple[Drawing, ...]:
    """Draw a block of 8 × 20 px that stands on y = 40 and goes 2 px to the right with each drawing."""
    folder.mkdir(parents=True, exist_ok=True)
    made = []
    for number in range(1, count + 1):
        pixels = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
        left = 10 + 2 * number
        pixels[20:40, left : left + 8] = (200, 120, 40, 255)
        pixels[20:40, left - 1] = (200, 120, 40, 100)
        path = folder / f"{name}_{number:04d}.png"
        write_rgba(path, pixels)
        made.append(Drawing(str(number), path))
    return tuple(made)


def cut(folder: Path, count: int = 6, length: int | None = None, name: str = "A") -> Document:
    """Return a cut of one layer whose drawings follow each other frame by frame; the last one holds."""
    document = set_canvas(Document(Canvas(1, 1)), Canvas(WIDTH, HEIGHT))
    cels = Cels(drawings(folder / "drawings", count), tuple(Exposure(n + 1, n) for n in range(count)))
    document = add_layer(document, name, cels, Box(12, 20, 20, 40))
    document = set_constant(document, resolve(document, "ground.position"), [32, 40])
    document = set_constant(document, resolve(document, "light.position"), [10, -20, 40])
    return set_canvas(document, replace(document.canvas, length_frames=length or count))


def with_values(document: Document, **values: object) -> Document:
    """Return the document with constants; ``__`` stands for a dot."""
    for name, value in values.items():
        document = set_constant(document, resolve(document, name.replace("__", ".")), value)
    return document


def with_key(document: Document, path: str, frame: int, value: object) -> Document:
    return set_key(document, resolve(document, path), frame, value)


def export(
    document: Document,
    folder: Path,
    *,
    open_context: OpenContext = open_headless_context,
    stop_after: int | None = None,
    **wishes: object,
) -> Summary:
    """Export with one worker unless told otherwise, stopping after so many finished files."""
    done = 0

    def progress(finished: int, _total: int) -> None:
        nonlocal done
        done = finished

    request = ExportRequest(folder, **wishes)  # type: ignore[arg-type]
    return export_frames(
        document, request, open_context, progress, lambda: stop_after is not None and done >= stop_after
    )


def bytes_below(folder: Path) -> dict[str, bytes]:
    """Return every frame below a folder by its relative name; the ledger is no frame."""
    found = sorted(path for path in folder.rglob("*") if path.is_file() and not path.name.startswith("."))
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}
