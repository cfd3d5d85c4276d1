"""What the renderer promises beside exactness: no pops, no needless work, no state of others, sound composites."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document import edits
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.errors import GraphicsProblem, InputProblem
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.gl import GL
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import figure_alpha, standing, with_values, write_figure


def coverage(renderer: Renderer, document: Document) -> NDArray[Any]:
    scene = evaluate(document, 1)
    return renderer.coverage(scene, scene.layers[0]) / 65535


def picture(renderer: Renderer, document: Document, backdrop: Backdrop = Backdrop.TRANSPARENT) -> NDArray[Any]:
    renderer.draw_picture(evaluate(document, 1), backdrop)
    return renderer.read_picture()


def changed_part(before: NDArray[Any], after: NDArray[Any]) -> float:
    """The coverage that changed, px², as a part of the larger shadow's."""
    return float(np.abs(after - before).sum() / max(before.sum(), after.sum(), 1.0))


class TestContinuity:
    @pytest.mark.parametrize("axis", [0, 1, 2])
    @pytest.mark.parametrize("start", [(200.0, -300.0, 700.0), (520.0, -900.0, 240.0), (500.0, -900.0, 130.0)])
    def test_a_light_moved_by_one_px_changes_little(
        self, renderer: Renderer, figure: Path, axis: int, start: tuple[float, float, float]
    ) -> None:
        """The last two places lie within the overhead area, and at its rim."""
        base = with_values(standing(figure), {"light.overhead_radius": 240.0})
        moved = list(start)
        moved[axis] += 1.0
        before = coverage(renderer, with_values(base, {"light.position": list(start)}))
        after = coverage(renderer, with_values(base, {"light.position": moved}))
        assert changed_part(before, after) < 0.05

    def test_nothing_pops_when_a_light_crosses_the_card(self, renderer: Renderer, figure: Path) -> None:
        base = with_values(standing(figure), {"light.overhead_radius": 150.0})
        places = [[430.0, -700.0, float(z)] for z in np.arange(-4, 5)]
        frames = [coverage(renderer, with_values(base, {"light.position": place})) for place in places]
        steps = [changed_part(a, b) for a, b in pairwise(frames)]
        # Thin shadows of lamps close by move fast, but evenly: no step stands out.
        assert max(steps) < 0.12
        assert max(steps) < 1.3 * float(np.median(steps))

    def test_the_rim_of_the_overhead_area_is_seamless(self, renderer: Renderer, figure: Path) -> None:
        base = with_values(standing(figure), {"light.overhead_radius": 200.0})
        inside = coverage(renderer, with_values(base, {"light.position": [500.0, -900.0, 199.999]}))
        outside = coverage(renderer, with_values(base, {"light.position": [500.0, -900.0, 200.001]}))
        assert changed_part(inside, outside) < 1e-3

    def test_a_setting_sun_fades_and_never_explodes(self, renderer: Renderer, figure: Path) -> None:
        base = with_values(standing(figure), {"light.kind": "sun", "light.azimuth": 30.0})
        areas = []
        previous = None
        for elevation in np.arange(6.0, -0.6, -0.5):
            now = coverage(renderer, with_values(base, {"light.elevation": float(elevation)}))
            areas.append(now.max())
            if previous is not None:
                assert np.abs(now.max() - previous.max()) < 0.5
            previous = now
        assert areas[0] == 1.0
        assert areas[-1] == 0.0
        assert areas == sorted(areas, reverse=True)


class TestWork:
    def test_opacity_and_colour_do_not_cast_again(self, renderer: Renderer, figure: Path) -> None:
        document = standing(figure)
        picture(renderer, document)
        cast = renderer.casts_drawn
        for opacity in (0.2, 0.4):
            picture(renderer, with_values(document, {"layers.A.shadow.opacity": opacity}))
        picture(renderer, with_values(document, {"layers.A.shadow.color": "#FF0000"}))
        assert renderer.casts_drawn == cast
        picture(renderer, with_values(document, {"light.position": [210.0, -200.0, 900.0]}))
        assert renderer.casts_drawn == cast + 1

    def test_the_same_picture_twice_is_the_same_bytes(self, renderer: Renderer, figure: Path) -> None:
        document = standing(figure)
        first = picture(renderer, document, Backdrop.CHECKER)
        picture(renderer, with_values(document, {"light.position": [900.0, -300.0, 500.0]}), Backdrop.WHITE)
        assert np.array_equal(picture(renderer, document, Backdrop.CHECKER), first)

    def test_state_left_behind_by_others_changes_nothing(self, renderer: Renderer, figure: Path) -> None:
        document = standing(figure)
        first = picture(renderer, document, Backdrop.GREY)
        other = with_values(document, {"light.position": [900.0, -300.0, 500.0]})
        picture(renderer, other, Backdrop.GREY)
        for state in (GL.GL_BLEND, GL.GL_DEPTH_TEST, GL.GL_SCISSOR_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST):
            GL.glEnable(state)
        GL.glScissor(3, 3, 5, 5)
        GL.glBlendFunc(GL.GL_DST_COLOR, GL.GL_ZERO)
        GL.glBlendEquation(GL.GL_FUNC_REVERSE_SUBTRACT)
        GL.glColorMask(*(True, False, True, False))
        GL.glViewport(1, 2, 3, 4)
        GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 8)
        assert np.array_equal(picture(renderer, document, Backdrop.GREY), first)


class TestPicture:
    def test_multiply_over_grey_follows_the_formula(self, renderer: Renderer, figure: Path) -> None:
        values = {"layers.A.shadow.color": "#406080", "layers.A.shadow.opacity": 0.5}
        document = with_values(standing(figure), values)
        covered = coverage(renderer, document)
        shown = picture(renderer, document, Backdrop.GREY)
        full = (covered == 1.0) & (figure_alpha() == 0)
        wanted = [118 * (0.5 + 0.5 * part / 255) for part in (0x40, 0x60, 0x80)]
        assert full.sum() > 1000
        assert np.abs(shown[full][:, :3] - np.array(wanted)).max() <= 1.0

    def test_normal_over_grey_follows_the_formula(self, renderer: Renderer, figure: Path) -> None:
        values = {"layers.A.shadow.color": "#406080", "layers.A.shadow.blend": "normal"}
        document = with_values(standing(figure), values)
        full = (coverage(renderer, document) == 1.0) & (figure_alpha() == 0)
        shown = picture(renderer, document, Backdrop.GREY)
        wanted = [118 * 0.4 + 0.6 * part for part in (0x40, 0x60, 0x80)]
        assert np.abs(shown[full][:, :3] - np.array(wanted)).max() <= 1.0

    def test_without_a_backdrop_the_character_is_untouched(self, renderer: Renderer, figure: Path) -> None:
        """Straight colours survive, so that soft edges show no fringe."""
        document = with_values(standing(figure), {"layers.A.shadow.opacity": 0.0})
        shown = picture(renderer, document)
        alpha = figure_alpha()
        assert np.array_equal(shown[..., 3], alpha)
        assert (shown[alpha > 0][:, :3] == [200, 120, 60]).all()

    def test_a_background_lies_under_everything(self, renderer: Renderer, figure: Path, tmp_path: Path) -> None:
        ramp = np.zeros((1000, 1000, 4), np.uint8)
        ramp[..., 0] = np.arange(1000) % 256
        ramp[..., 3] = 255
        write_rgba(tmp_path / "ramp.png", ramp)
        document = edits.set_background(standing(figure), tmp_path / "ramp.png")
        shown = picture(renderer, document, Backdrop.BACKGROUND)
        clear = (coverage(renderer, document) == 0) & (figure_alpha() == 0)
        assert np.array_equal(shown[clear], ramp[clear])

    def test_shadows_of_two_layers_lie_under_both_characters(self, renderer: Renderer, figure: Path) -> None:
        document = standing(figure)
        cels = Cels((Drawing("1", figure),), (Exposure(1, 0),))
        document = edits.add_layer(document, "B", cels, document.layers[0].figure)
        shown = picture(renderer, document)
        assert (shown[figure_alpha() == 255][:, :3] == [200, 120, 60]).all()


class TestShadowImage:
    def test_alpha_is_coverage_times_opacity(self, renderer: Renderer, figure: Path) -> None:
        document = standing(figure)
        scene = evaluate(document, 1)
        image = renderer.shadow(scene, scene.layers[0], depth=16)
        box = image.box
        covered = renderer.coverage(scene, scene.layers[0])
        assert np.abs(image.alpha - covered[box.top : box.bottom, box.left : box.right] * 0.6).max() <= 1.0
        assert image.color == (0x20, 0x20, 0x3A)
        outside = covered.copy()
        outside[box.top : box.bottom, box.left : box.right] = 0
        assert not outside.any()

    def test_an_empty_cel_gives_an_empty_shadow(self, renderer: Renderer, figure: Path) -> None:
        document = edits.set_exposures(standing(figure), "layer-1", (Exposure(1, None),))
        scene = evaluate(document, 1)
        assert renderer.shadow(scene, scene.layers[0]).alpha.size == 0

    def test_a_clear_drawing_gives_an_empty_shadow(self, renderer: Renderer, tmp_path: Path) -> None:
        path = write_figure(tmp_path / "clear.png", np.zeros((1000, 1000), np.uint8))
        scene = evaluate(standing(path), 1)
        assert renderer.shadow(scene, scene.layers[0]).alpha.size == 0

    def test_a_light_under_the_ground_casts_nothing(self, renderer: Renderer, figure: Path) -> None:
        document = with_values(standing(figure), {"light.position": [500.0, 2000.0, 0.0]})
        assert not coverage(renderer, document).any()

    def test_a_missing_drawing_is_told_and_the_next_one_drawn(self, renderer: Renderer, figure: Path) -> None:
        missing = standing(figure.with_name("gone.png"))
        with pytest.raises(InputProblem, match=r"gone\.png"):
            picture(renderer, missing)
        assert picture(renderer, standing(figure)).any()


class TestMattes:
    def test_binary_edges_are_smoothed(self, renderer: Renderer, tmp_path: Path) -> None:
        """A slanting edge of binary paint data, magnified, has no stairs: it stays near a straight line."""
        y, x = np.mgrid[0:100, 0:100]
        wedge = ((x > 30 + 0.31 * (y - 20)) & (x < 70) & (y >= 20) & (y < 90)).astype(np.uint8) * 255
        values = {"ground.position": [50.0, 90.0], "ground.declination": 30.0}
        values |= {"light.kind": "sun", "light.azimuth": 0.0, "light.elevation": 55.0}
        document = with_values(standing(write_figure(tmp_path / "wedge.png", wedge), 100), values)
        shadow = coverage(renderer, document)
        rows = np.nonzero(shadow.sum(axis=1) > 5)[0][6:-6]
        half = 50
        left = half - shadow[rows][:, :half].sum(axis=1)
        assert len(rows) > 30
        straight = np.polyval(np.polyfit(rows, left, 1), rows)
        assert np.abs(left - straight).max() < 0.2

    def test_translucent_casts_alpha_as_it_is(self, renderer: Renderer, tmp_path: Path) -> None:
        path = write_figure(tmp_path / "smoke.png", (figure_alpha() * 0.25).astype(np.uint8))
        document = standing(path)
        assert not coverage(renderer, document).any()
        smoke = with_values(document, {"layers.A.shadow.matte": "translucent"})
        assert coverage(renderer, smoke).max() == pytest.approx(63 / 255, abs=0.002)

    def test_drawings_of_other_sizes_lie_centred(self, renderer: Renderer, tmp_path: Path) -> None:
        cut = figure_alpha()[100:950, 150:850]
        path = write_figure(tmp_path / "cut.png", np.ascontiguousarray(cut))
        document = standing(path)
        left, top = (1000 - cut.shape[1]) // 2, (1000 - cut.shape[0]) // 2
        shown = picture(renderer, with_values(document, {"layers.A.shadow.opacity": 0.0}))
        assert np.array_equal(shown[top : top + cut.shape[0], left : left + cut.shape[1], 3], cut)

    def test_sixteen_bit_drawings_cast(self, renderer: Renderer, figure: Path, tmp_path: Path) -> None:
        rgba = np.zeros((1000, 1000, 4), np.uint16)
        rgba[..., 3] = figure_alpha().astype(np.uint16) * 257
        write_rgba(tmp_path / "deep.png", rgba)
        deep, plain = (coverage(renderer, standing(path)) for path in (tmp_path / "deep.png", figure))
        assert np.abs(deep - plain).max() < 0.01


def test_a_picture_over_the_drivers_limit_is_one_sentence(renderer: Renderer, figure: Path) -> None:
    document = standing(figure)
    huge = replace(document, canvas=Canvas(20000, 10))
    with pytest.raises(GraphicsProblem, match="20000x10"):
        picture(renderer, huge)
    assert picture(renderer, document).any()
