"""Hand-offs of small cuts, and what After Effects makes of them against the picture."""

from pathlib import Path

import numpy as np

from kagezou.document.model import Document
from kagezou.export.after_effects.export import HandedOff, HandOffRequest, export_to_after_effects
from kagezou.io.images.reading import read_cel
from kagezou.render.gpu.context import open_headless_context
from tests.export.after_effects.compositing import composed
from tests.export.after_effects.extendscript import Run, run_script
from tests.export.small_cuts import export


def handed_off(document: Document, folder: Path, **options: object) -> HandedOff:
    request = HandOffRequest(folder=folder, name=str(options.pop("name", "cut")), **options)  # type: ignore[arg-type]
    return export_to_after_effects(document, request, open_headless_context, lambda _done, _all: None, lambda: False)


def script_of(done: HandedOff) -> Path:
    assert done.script is not None
    return done.script


def built(done: HandedOff, tmp_path: Path) -> Run:
    run = run_script(script_of(done), tmp_path / "ae.json")
    assert run.tree["alerts"] == []
    return run


def furthest(run: Run, document: Document, tmp_path: Path) -> int:
    """Return by how many levels of 8 bit the composition differs most from the picture; what is clear has no colour."""
    export(document, tmp_path / "out", composite=True)
    most = 0
    for frame in range(1, document.canvas.length_frames + 1):
        wanted = read_cel(tmp_path / f"out/composite/composite_{frame:04d}.png", white_is_clear=False).rgba
        found = composed(run, "cut", frame).astype(int)
        seen = (found[..., 3] > 0) | (wanted[..., 3] > 0)
        most = max(most, int(np.abs(found - wanted)[seen].max(initial=0)))
    return most


def names(run: Run, comp: str) -> list[str]:
    return [layer["name"] for layer in reversed(run.item(comp, "CompItem")["layers"])]
