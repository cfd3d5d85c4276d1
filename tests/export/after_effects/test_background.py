"""The background in After Effects: its pictures when they are seen, and where it lies."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.animation.track import Interpolation
from kagezou.document.address import resolve
from kagezou.document.edits import set_background, set_background_cels, set_key
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.errors import OutputProblem
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.extendscript import place_at, property_of, run_edited
from tests.export.after_effects.hand_offs import built, furthest, handed_off, script_of
from tests.export.small_cuts import cut

FRAMES = 6
SIZE = (100, 60)


def pictures(folder: Path, count: int, size: tuple[int, int] = SIZE, name: str = "street") -> tuple[Drawing, ...]:
    """Draw opaque ramps, each of another brightness, without alpha in the file."""
    folder.mkdir(exist_ok=True)
    made = []
    for number in range(1, count + 1):
        rgb = np.full((size[1], size[0], 3), 30 * number, np.uint8)
        rgb[..., 0] = np.linspace(0, 255, size[0])
        rgb[4:9, :, :] = 255
        path = folder / f"{name}_{number:03d}.png"
        write_rgba(path, np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))
        made.append(Drawing(str(number), path))
    return tuple(made)


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """A street of three pictures that pans, with a picture twice and nothing on frame 5."""
    shown = pictures(tmp_path / "street", 3)
    held = tuple(Exposure(frame, index) for frame, index in ((1, 2), (2, 0), (3, 2), (5, None), (6, 1)))
    made = set_background_cels(cut(tmp_path / "a", FRAMES), Cels(shown, held))
    position = resolve(made, "background.position")
    for frame, place in ((1, (40.0, 30.0)), (6, (22.0, 20.5))):
        made = set_key(made, position, frame, place, Interpolation.BEZIER)
    return made


@pytest.mark.parametrize("copies", [True, False])
def test_the_composition_is_the_picture(document: Document, tmp_path: Path, *, copies: bool) -> None:
    done = handed_off(document, tmp_path / "ae", copies=copies)
    assert done.notes == ()
    assert (tmp_path / "ae" / "background").exists() == copies
    run = built(done, tmp_path)
    assert furthest(run, document, tmp_path) <= 1
    item = run.item("background", "FootageItem")
    assert (item["frames"], item["rate"], item["folder"]) == (3, 24, "Background")
    layer = run.layer("cut", "Background")
    assert [key["value"] for key in property_of(layer, "ADBE Transform Group", "ADBE Opacity")["keys"]][-2:] == [0, 100]
    assert place_at(layer, 5 / 24) == (22.0, 20.5)


def test_pictures_of_different_sizes_are_copied_whole(document: Document, tmp_path: Path) -> None:
    shown = (*document.behind.drawings[:2], *pictures(tmp_path / "street", 1, (70, 91), "other"))
    document = set_background_cels(document, replace(document.behind, drawings=shown))
    done = handed_off(document, tmp_path / "ae", copies=False)
    assert list(map(str, done.notes)) == [
        "the pictures of the background are not a sequence without gaps, so they were copied"
    ]
    run = built(done, tmp_path)
    assert run.item("background", "FootageItem")["height"] == 91
    assert furthest(run, document, tmp_path) <= 1


def test_a_still_that_pans(document: Document, tmp_path: Path) -> None:
    still = set_background(document, document.behind.drawings[0].path)
    for copies in (True, False):
        run = built(handed_off(still, tmp_path / f"ae {copies}", copies=copies), tmp_path)
        assert furthest(run, still, tmp_path) <= 1
    assert (tmp_path / "ae True" / "background" / "background.png").exists()


def test_a_picture_becomes_a_sequence_in_the_same_composition(document: Document, tmp_path: Path) -> None:
    still = set_background(cut(tmp_path / "a", FRAMES), document.behind.drawings[0].path)
    first, second = (script_of(handed_off(each, tmp_path / name)) for each, name in ((still, "1"), (document, "2")))
    run = run_edited(first, tmp_path / "ae.json", ("", second))
    assert run.left() == []
    assert furthest(run, document, tmp_path) <= 1


def test_copies_never_take_the_place_of_the_pictures(document: Document, tmp_path: Path) -> None:
    (tmp_path / "ae").mkdir()
    shown = pictures(tmp_path / "ae" / "background", 3, name="background")
    shown[1].path.unlink()
    cels = Cels((shown[2], shown[0]), (Exposure(1, 0), Exposure(2, 1)))
    with pytest.raises(OutputProblem, match="the pictures of the background lie there themselves"):
        handed_off(set_background_cels(document, cels), tmp_path / "ae")
