"""Round shadows of real drawings with no edits at all: under the feet, and beside a shadow an artist drew by hand.

That artist's shadow is a bar with round ends, 22 px high under a figure of 900: a ground that is seen at 87°. How high
a disc is seen is the ground's declination, so what is compared is where it lies, how wide it is and how it changes.
"""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.images.reading import read_matte
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.stances import FigureStances, stances_of

CHICKEN = "lottie_funky_chicken"


def standing_round(folder: Path) -> tuple[Document, FigureStances]:
    document = new_document([CharacterSource("Hero", folder)]).document
    layer = document.layers[-1]
    document = document_with_feet(document, [layer.id]).document
    found = stances_of(document, layer.id)
    assert found is not None
    return set_constant(document, resolve(document, f"layers.{layer.name}.shadow.shape"), "disc"), found


def covered(renderer: Renderer, document: Document, frame: int) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    scene = evaluate(document, frame)
    return renderer.coverage(scene, scene.layers[-1]) / 65535


@pytest.mark.parametrize(
    "name", ["animdraw_duo_dance/A", "animdraw_duo_dance/B", f"{CHICKEN}/A", "lottie_girl_jump/A", "kenney"]
)
def test_feet_that_carry_stand_on_it_on_every_drawing(renderer: Renderer, samples: Path, name: str) -> None:
    folder = samples / ("kenney_male_adventurer" if name == "kenney" else name)
    document, stances = standing_round(folder)
    feet = 0
    for frame in stances.frames:
        seen = covered(renderer, document, frame)
        for foot in stances.at(frame).feet:
            if foot.is_planted:
                column, row = int(foot.place[0]), min(int(foot.ground_row), seen.shape[0] - 1)
                assert seen[row, column] == 1, (frame, foot)
                feet += 1
    assert feet >= 5


def test_it_lies_where_an_artist_drew_one_and_is_about_as_wide(renderer: Renderer, samples: Path) -> None:
    document, stances = standing_round(samples / CHICKEN / "A")
    files = sorted((samples / CHICKEN / "ref_artist_shadow").glob("*.png"))
    assert len(files) == document.canvas.length_frames == 32
    spans = []
    for frame, file in enumerate(files, 1):
        artists = read_matte(file).whole()
        both = (covered(renderer, document, frame) > 0.5, artists > artists.max() / 2)
        columns = [np.flatnonzero(mask.any(axis=0)) for mask in both]
        spans.append([(each[0] + each[-1] + 1, each[-1] + 1 - each[0]) for each in columns])
    middles, widths = np.moveaxis(np.array(spans, dtype=float), 2, 0)
    assert np.abs(middles[:, 0] - middles[:, 1]).max() / 2 <= 0.025 * stances.height_px
    assert widths[:, 0].mean() == pytest.approx(widths[:, 1].mean(), rel=0.15)
    assert widths[:, 0] == pytest.approx(widths[:, 1], rel=0.25)
    # It is widest and narrowest where the artist's is: by the stance.
    assert np.corrcoef(widths[:, 0], widths[:, 1])[0, 1] > 0.5
