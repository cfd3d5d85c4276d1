"""Real drawings with no edits at all: planted feet touch their shadows, and areas change as those of a flat card."""

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.stances import FigureStances, stances_of

STEP = 3
"""Every third frame is looked at."""

SEQUENCES = ["animdraw_duo_dance/A", "animdraw_duo_dance/B", "lottie_funky_chicken/A", "lottie_girl_jump/A"]


@dataclass(frozen=True)
class Cut:
    document: Document
    stances: FigureStances

    @property
    def frames(self) -> range:
        return range(1, self.document.canvas.length_frames + 1, STEP)


@pytest.fixture(scope="module", params=SEQUENCES)
def cut(request: pytest.FixtureRequest, samples: Path) -> Cut:
    document = new_document([CharacterSource("Hero", samples / request.param)]).document
    document = document_with_feet(document, [document.layers[0].id]).document
    found = stances_of(document, document.layers[0].id)
    assert found is not None
    return Cut(document, found)


def covered(renderer: Renderer, document: Document, frame: int) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    scene = evaluate(document, frame)
    return renderer.coverage(scene, scene.layers[0]) / 65535


def test_planted_feet_touch_their_shadows(renderer: Renderer, cut: Cut) -> None:
    gaps = []
    for frame in cut.frames:
        rows, columns = np.nonzero(covered(renderer, cut.document, frame) > 0.5)
        for foot in cut.stances.at(frame).feet:
            if foot.is_planted:
                x, y = foot.place
                nearest = float(np.hypot(columns + 0.5 - x, rows + 1.0 - y).min())
                # From the edge of the nearest pixel, not from its middle.
                gaps.append(max(nearest - 0.71, 0.0) / cut.stances.height_px)
    assert len(gaps) >= 5
    assert max(gaps) <= 0.01
    assert float(np.mean(gaps)) <= 0.005


def test_areas_change_as_those_of_a_flat_card(renderer: Renderer, cut: Cut) -> None:
    flat = set_constant(cut.document, resolve(cut.document, "layers.Hero.stance"), "line")
    grounded = [frame for frame in cut.frames if cut.stances.at(frame).lift_px == 0]
    for before, after in pairwise(grounded):
        changes = []
        for document in (cut.document, flat):
            first, second = (covered(renderer, document, frame).sum() for frame in (before, after))
            changes.append(abs(second - first) / first)
        assert changes[0] <= changes[1] + 0.01 * STEP


def test_in_the_air_the_shadow_is_smaller_the_higher(renderer: Renderer, samples: Path) -> None:
    document = new_document([CharacterSource("Hero", samples / "lottie_girl_jump/A")]).document
    document = document_with_feet(document, [document.layers[0].id]).document
    found = stances_of(document, document.layers[0].id)
    assert found is not None
    lifts = [found.at(frame).lift_px for frame in range(1, 35)]
    areas = [float(covered(renderer, document, frame).sum()) for frame in range(1, 35)]
    top = max(range(34), key=lambda index: (lifts[index], -areas[index]))
    flight = [index for index in range(34) if lifts[index] > 0]
    assert flight == list(range(flight[0], flight[-1] + 1))
    rising, falling = areas[flight[0] - 1 : top + 1], areas[top : flight[-1] + 2]
    assert all(after <= before for before, after in pairwise(rising))
    assert all(after >= before for before, after in pairwise(falling))
    looks = [evaluate(document, frame).layers[0].look.opacity for frame in range(1, 35)]
    assert looks[top] == min(looks) < looks[0] == looks[-1]
