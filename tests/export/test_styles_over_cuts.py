"""What an artist asks of each style over whole cuts of four figures: a dance, a chicken, a jump and a walk.

Lengths and areas are those of figures made small, so that whole cuts are looked at in seconds.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from OpenImageIO import ROI, UINT8, ImageBuf, ImageBufAlgo

from kagezou.cli.contact_sheet import roomy
from kagezou.cli.cut_sheet import swing_deg
from kagezou.document.model import Document, Exposure
from kagezou.document.style import Style
from kagezou.document.styling import put_style
from kagezou.export.cut_measures import ShadowSeen
from kagezou.export.portraits import Portraits
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource
from kagezou.io.clips.style_files import bundled_styles
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.writing import write_rgba
from kagezou.io.pixels.connected import part_areas
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.effort import tries

FIGURES = {
    "dance": "animdraw_duo_dance/A",
    "chicken": "lottie_funky_chicken/A",
    "jump": "lottie_girl_jump/A",
    "walk": "kenney_male_adventurer/maleAdventurer_walk#.png",
}
SIDE_PX = 110
MOST_FRAMES = tries(12, 24)

OF_ONE_PIECE = ("Natural", "Simple", "Round shadow", "Long evening", "Water", "High key")


@dataclass(frozen=True)
class OverCut:
    figure_px2: float
    seen: tuple[ShadowSeen, ...]


@cache
def cut(samples: Path, figure: str) -> Document:
    source = samples / FIGURES[figure]
    document = roomy([CharacterSource(figure, source)]).document
    return document_with_feet(document, [document.layers[0].id]).document


@cache
def style_named(name: str) -> Style:
    return next(each.style for each in bundled_styles() if each.style.name.en == name)


@pytest.fixture(scope="module")
def looked_at(samples: Path) -> dict[tuple[str, str], OverCut]:
    """Every style on every figure, with its light; frame after frame."""
    found = {}
    with open_headless_context():
        for figure in FIGURES:
            document = cut(samples, figure)
            frames = range(1, min(document.canvas.length_frames, MOST_FRAMES) + 1)
            portraits = Portraits(document, document.layers[0].id, 1, SIDE_PX)
            for each in bundled_styles():
                dressed = put_style(document, [document.layers[0].id], each.style, 1, with_light=True).document
                seen = portraits.over_cut(dressed, frames)
                height = document.layers[0].figure.height / max(document.layers[0].figure.height // SIDE_PX, 1)
                found[each.style.name.en, figure] = OverCut(height**2, seen)
            portraits.close()
    return found


def of(looked_at: dict[tuple[str, str], OverCut], style: str) -> list[tuple[str, OverCut]]:
    return [(figure, looked_at[style, figure]) for figure in FIGURES]


def mean(numbers: Sequence[float | None]) -> float:
    return float(np.mean([each for each in numbers if each is not None]))


@pytest.mark.parametrize("style", [each.style.name.en for each in bundled_styles()])
class TestEveryStyle:
    def test_no_frame_is_without_a_shadow(self, looked_at: dict[tuple[str, str], OverCut], style: str) -> None:
        for figure, over in of(looked_at, style):
            assert min(each.area_px2 for each in over.seen) > 0.02 * over.figure_px2, figure

    def test_nothing_sparkles(self, looked_at: dict[tuple[str, str], OverCut], style: str) -> None:
        """No island is a speck: 60 px² on a figure 560 px high, and as much less on a small one."""
        for figure, over in of(looked_at, style):
            least = min(each.part_areas_px2[-1] for each in over.seen)
            assert least >= 60 / 560**2 * over.figure_px2, figure

    def test_the_outline_is_no_busier_than_the_drawing(
        self, looked_at: dict[tuple[str, str], OverCut], style: str
    ) -> None:
        for figure, over in of(looked_at, style):
            moved = mean([each.outline_px for each in over.seen])
            assert moved <= 1.25 * mean([each.drawing_px for each in over.seen]) + 0.1, figure

    def test_it_does_not_swell_and_shrink_from_frame_to_frame(
        self, looked_at: dict[tuple[str, str], OverCut], style: str
    ) -> None:
        """What the drawing does not do the shadow does not do: its area changes by a fifth a frame at most."""
        for figure, over in of(looked_at, style):
            if figure != "jump":
                assert max(abs(b.area_px2 / a.area_px2 - 1) for a, b in pairwise(over.seen)) < 0.2, figure

    def test_the_figure_does_not_hide_it(self, looked_at: dict[tuple[str, str], OverCut], style: str) -> None:
        for figure, over in of(looked_at, style):
            assert mean([each.hidden for each in over.seen]) < 0.6, figure


@pytest.mark.parametrize("style", OF_ONE_PIECE)
def test_it_is_one_piece(looked_at: dict[tuple[str, str], OverCut], style: str) -> None:
    """Nearly all of the shadow hangs together on every frame, and no more than two islands are beside it."""
    for figure, over in of(looked_at, style):
        assert min(each.main_share for each in over.seen) > 0.9, figure
        assert max(len(each.part_areas_px2) for each in over.seen) <= 3, figure


def test_a_simple_shadow_has_no_holes_that_blink(looked_at: dict[tuple[str, str], OverCut]) -> None:
    for figure, over in of(looked_at, "Simple"):
        assert max(len(each.hole_areas_px2) for each in over.seen) <= 1, figure


def test_a_round_shadow_is_a_calm_whole_disc_under_the_figure(looked_at: dict[tuple[str, str], OverCut]) -> None:
    for figure, over in of(looked_at, "Round shadow"):
        assert {len(each.part_areas_px2) for each in over.seen} == {1}, figure
        assert not any(each.hole_areas_px2 for each in over.seen), figure
        moved, drawing = (mean([getattr(each, name) for each in over.seen]) for name in ("outline_px", "drawing_px"))
        assert moved <= 0.85 * drawing, figure


def test_evening_shadows_are_long_and_keep_their_direction(looked_at: dict[tuple[str, str], OverCut]) -> None:
    for figure, over in of(looked_at, "Long evening"):
        assert swing_deg(over.seen) <= 30, figure
        natural = mean([each.area_px2 for each in looked_at["Natural", figure].seen])
        assert mean([each.area_px2 for each in over.seen]) > 1.2 * natural, figure


def test_water_is_calmer_than_the_bare_shadow(looked_at: dict[tuple[str, str], OverCut]) -> None:
    for figure, over in of(looked_at, "Water"):
        natural = mean([each.outline_px for each in looked_at["Natural", figure].seen])
        assert mean([each.outline_px for each in over.seen]) <= 1.1 * natural, figure


def test_torn_water_opens_the_body_into_stripes_that_last(looked_at: dict[tuple[str, str], OverCut]) -> None:
    """Several parts, none of them nearly all; from frame to frame few are torn off or grow together."""
    for figure, over in of(looked_at, "Torn water"):
        counts = [len(each.part_areas_px2) for each in over.seen]
        assert mean([float(each) for each in counts]) >= 4, figure
        assert mean([each.main_share for each in over.seen]) < 0.75, figure
        assert max(abs(b - a) for a, b in pairwise(counts)) <= 4, figure
        assert mean([float(abs(b - a)) for a, b in pairwise(counts)]) <= 1.5, figure


def test_torn_water_opens_a_walk_of_usual_size_on_every_frame(samples: Path, tmp_path: Path) -> None:
    """At least six parts of 60 px² and more while the walk goes round three times, and none of less."""
    for number in range(8):
        small = ImageBuf(str(samples / f"kenney_male_adventurer/maleAdventurer_walk{number}.png"))
        wide, high = 5 * small.spec().width, 5 * small.spec().height
        large = ImageBufAlgo.resize(small, roi=ROI(0, wide, 0, high, 0, 1, 0, 4))
        write_rgba(tmp_path / f"walk_{number + 1:04d}.png", np.ascontiguousarray(large.get_pixels(UINT8)))
    document = roomy([CharacterSource("walk", tmp_path)]).document
    document = document_with_feet(document, [document.layers[0].id]).document
    walk = replace(document.layers[0].cels, exposures=tuple(Exposure(1 + at, at % 8) for at in range(24)))
    document = replace(document, layers=(replace(document.layers[0], cels=walk),))
    document = replace(document, canvas=replace(document.canvas, length_frames=24))
    document = put_style(document, [document.layers[0].id], style_named("Torn water"), 1).document
    with open_headless_context():
        renderer = Renderer(CelCache())
        for frame in range(1, 25):
            scene = evaluate(document, frame)
            areas = part_areas(renderer.coverage(scene, scene.layers[0]) >= 32768, diagonal=True)
            assert len(areas) >= 6, frame
            assert areas.min() >= 60, frame
        renderer.close()


def test_only_round_shadows_lie_under_their_figures(looked_at: dict[tuple[str, str], OverCut]) -> None:
    for figure, over in of(looked_at, "Round shadow"):
        assert sum(each.is_under_figure for each in over.seen) > 0.7 * len(over.seen), figure
    for figure, over in of(looked_at, "Long evening"):
        assert not any(each.is_under_figure for each in over.seen), figure
