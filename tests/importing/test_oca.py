"""Projects of Open Cel Animation: what a document of it shows is what the project shows."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.cli.main import run as run_cli
from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.export.exchange.oca import OCA
from kagezou.importing.imported import Imported
from kagezou.importing.inspection import inspected
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.oca_project import document_of_sources
from kagezou.io.images.writing import write_rgba
from tests.export.exchange.cuts import composites, levels_apart, made, pixels_of, rich_cut
from tests.export.small_cuts import with_values

WIDTH, HEIGHT = 64, 48


def picture(path: Path, size: tuple[int, int], seed: int = 1, alpha: int = 255) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    pixels = np.random.default_rng(seed).integers(0, 255, (size[1], size[0], 4)).astype(np.uint8)
    pixels[..., 3] = alpha
    write_rgba(path, pixels)
    return path


def frame(name: str, number: int, duration: int = 1, **more: Any) -> dict[str, Any]:
    return {"name": name, "fileName": f"p/{name}.png", "frameNumber": number, "duration": duration, **more}


def paint(name: str, *frames: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"name": name, "frames": list(frames), "type": "paintlayer", "animated": len(frames) > 1, **more}


def project(folder: Path, *layers: dict[str, Any], **more: Any) -> Imported:
    folder.mkdir(parents=True, exist_ok=True)
    root = {"frameRate": 12, "width": WIDTH, "height": HEIGHT, "startTime": 0, "endTime": 8, "layers": list(layers)}
    path = folder / "cut.oca"
    path.write_text(json.dumps({**root, **more}), encoding="utf-8")
    return document_of_sources((CharacterSource(None, path),))


def bare(document: Document) -> Document:
    """Return the document without shadows."""
    return with_values(document, **{f"layers.{layer.name}.shadow.opacity": 0.0 for layer in document.layers})


def test_a_document_that_was_written_is_read_as_it_was_seen(tmp_path: Path) -> None:
    written = with_values(bare(rich_cut(tmp_path / "in")), **{"layers.相棒.shadow.blend": "multiply"})
    done = made(written, tmp_path / "out", OCA)
    assert done.scene is not None
    imported = document_of_sources((CharacterSource(None, done.scene),))
    read = imported.document
    assert (read.canvas.width_px, read.canvas.height_px, read.canvas.length_frames) == (64, 48, 8)
    assert read.canvas.frame_rate == Fraction(24000, 1001)
    assert [layer.name for layer in read.layers] == ["主役 #1", "相棒"]
    for one, other in zip(composites(bare(read), tmp_path / "a"), composites(written, tmp_path / "b"), strict=True):
        assert levels_apart(one, other) <= 1


@pytest.mark.parametrize("app", ["Krita", "OpenToonz", ""])
@pytest.mark.parametrize(("left", "top", "size"), [(5, 7, (10, 12)), (-6, -3, (11, 9)), (40, 30, (17, 30))])
def test_a_smaller_picture_lies_where_its_document_says(
    app: str, left: int, top: int, size: tuple[int, int], tmp_path: Path
) -> None:
    file = picture(tmp_path / "p" / "one.png", size)
    sums = (2 * left + size[0] - 1, 2 * top + size[1] - 1)
    krita = [int(each / 2) for each in sums]
    others = [left + size[0] // 2, top + size[1] // 2]
    placed = frame("one", 0, 8, position=krita if app == "Krita" else others, width=size[0], height=size[1])
    imported = project(tmp_path, paint("a", placed), paint("b", placed), originApp=app)
    shown = composites(bare(imported.document), tmp_path / "ref")[0]
    wanted = np.zeros((HEIGHT, WIDTH, 4))
    rows = slice(max(top, 0), min(top + size[1], HEIGHT))
    columns = slice(max(left, 0), min(left + size[0], WIDTH))
    stored = pixels_of(file)
    wanted[rows, columns] = stored[rows.start - top : rows.stop - top, columns.start - left : columns.stop - left]
    assert levels_apart(shown, wanted) == 0


def test_frames_that_lie_elsewhere_are_held_there(tmp_path: Path) -> None:
    for name in ("one", "two"):
        picture(tmp_path / "p" / f"{name}.png", (10, 10), seed=len(name))
    frames = [frame("one", 0, 2, position=[10, 10]), frame("two", 2, 2, position=[10, 10])]
    frames += [frame("one", 5, 3, position=[50, 20])]
    imported = project(tmp_path, paint("a", *frames))
    (layer,) = imported.document.layers
    assert [(each.frame, each.drawing) for each in layer.cels.exposures] == [(1, 0), (3, 1), (5, None), (6, 0)]
    shown = composites(bare(imported.document), tmp_path / "ref")
    assert [bool(each[..., 3].any()) for each in shown] == [True, True, True, True, False, True, True, True]
    assert shown[3][5:15, 5:15, 3].all()
    assert shown[5][15:25, 45:55, 3].all()
    assert not any("differ in size" in str(note) for note in imported.notes)


def test_the_lowest_layer_is_the_background_where_it_fills_the_canvas(tmp_path: Path) -> None:
    picture(tmp_path / "p" / "sky.png", (90, 60))
    picture(tmp_path / "p" / "one.png", (10, 10), alpha=200)
    sky = paint("sky", frame("sky", 0, 8, position=[40, 28]))
    imported = project(tmp_path, sky, paint("a", frame("one", 0, 8)))
    assert [layer.name for layer in imported.document.layers] == ["a"]
    shown = composites(bare(imported.document), tmp_path / "ref")[0]
    stored = pixels_of(tmp_path / "p" / "sky.png")
    assert levels_apart(shown[0, :10], stored[2, 5:15]) == 0, "its left top corner lies at -5, -2"
    away = project(tmp_path, paint("sky", frame("sky", 0, 8, position=[70, 28])), paint("a", frame("one", 0, 8)))
    assert [layer.name for layer in away.document.layers] == ["sky", "a"], "it leaves canvas free"


def test_a_group_of_several_is_one_figure(tmp_path: Path) -> None:
    picture(tmp_path / "p" / "one.png", (10, 10), alpha=200)
    parts = [paint(name, frame("one", 0, 8)) for name in ("line", "arm")]
    group = {"name": "Hero", "type": "grouplayer", "childLayers": parts}
    alone = {"name": "Props", "type": "grouplayer", "childLayers": [paint("box", frame("one", 0, 8))]}
    imported = project(tmp_path, group, alone)
    hero, arm, box = imported.document.layers
    assert [each.name for each in (hero, arm, box)] == ["Hero", "Hero arm", "box"]
    assert (hero.joins, arm.joins, box.joins) == (None, hero.id, None)
    assert any("one figure with one shadow: Hero, Hero arm" in str(note) for note in imported.notes)


def test_what_a_document_says_is_held_against_its_pictures(tmp_path: Path) -> None:
    picture(tmp_path / "p" / "one.png", (10, 10), alpha=200)
    imported = project(tmp_path, paint("a", frame("one", 0, 4, width=12, height=10), frame("gone", 4, 4)))
    said = [str(note) for note in imported.notes]
    assert any("these are of other sizes than the document says" in note and "one.png" in note for note in said)
    assert any("gone.png: it does not exist" in note for note in said)
    with pytest.raises(InputProblem, match=r"gone\.png"):
        project(tmp_path, paint("a", frame("gone", 0, 8)))
    with pytest.raises(InputProblem, match="every layer in it is hidden or empty"):
        project(tmp_path, paint("a", frame("one", 0, 8), visible=False))


def test_the_command_line_makes_a_project_of_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    picture(tmp_path / "p" / "one.png", (10, 10), alpha=200)
    project(tmp_path, paint("a", frame("one", 0, 2), frame("one", 4, 2), blendingMode="normal"), paint("b"))
    about = inspected(tmp_path / "cut.oca")
    assert about.kind == "drawings"
    assert any("left out, as they are empty: b" in str(note) for note in about.notes)
    monkeypatch.chdir(tmp_path)
    from kagezou.cli.entry_points import EntryPoints
    from kagezou.io.project.file import load
    from kagezou.render.gpu.context import open_headless_context

    entry = EntryPoints(open_headless_context, lambda _path: 0, False)  # noqa: FBT003 - as it is called
    assert run_cli(["new", "cut.kage", "--oca", "cut.oca", "--no-feet"], entry) == 0
    canvas = load(tmp_path / "cut.kage").canvas
    assert (canvas.frame_rate, canvas.length_frames, canvas.width_px) == (Fraction(12), 8, 64)
    assert run_cli(["new", "cut.kage", "--oca", "cut.oca", "--no-feet", "--fps", "25", "--force"], entry) == 0
    assert load(tmp_path / "cut.kage").canvas.frame_rate == Fraction(25)
