"""Gaps that waves leave open in a shadow: against their formula, on ground and walls, and where there are none."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.document.styling import put_style
from kagezou.geometry.slits import Slits
from kagezou.io.clips.style_files import bundled_styles
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import ShadowCast
from tests.render.passes.test_filter import cast_in, document_with
from tests.render.prepare.test_least_parts import parts_of
from tests.render.reference import blurred, raycast, set_raycast
from tests.render.reference.blurred import ContactLine, Shape
from tests.render.reference.figures import figure_alpha, standing
from tests.render.reference.outlines import Shift
from tests.render.reference.raycast import Array
from tests.render.reference.unfolded import FoldedGround
from tests.render.sets.test_exactness import Pieces, in_a_set

SHADOW = "layers.A.shadow."
SLITS = {"slits": 0.7, "slit_growth": 0.1, "wave1.wavelength": 60.0}
WIDE = {**SLITS, "slit_spacing": 32.0, "slit_growth": 0.5}
PERSPECTIVE = {"camera.fov": 40.0, "ground.roll": 8.0, "layers.A.grounding": [[440.0, 890.0], [565.0, 888.0]]}
WALL: Pieces = {
    "wall": {"kind": "wall", "position": [500, 750], "width": 2400, "height": 1100, "angle": -8, "lean": 25}
}


def slits_of(cast: ShadowCast) -> Slits:
    assert cast.water is not None
    assert cast.water.slits is not None
    return cast.water.slits


def coverage(renderer: Renderer, document: Document, frame: int = 1) -> Array:
    scene = evaluate(document, frame)
    return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


@dataclass(frozen=True)
class Opened(Shape):
    """A shape without the gaps."""

    slits: Slits

    def _excess(self, cast: ShadowCast, x: Array, y: Array) -> Array:
        u, v, _ = blurred.ground_seen_at(cast, x, y)
        away = np.abs(ContactLine.of(cast).from_ground(u, v)[1])
        return np.where(self.slits.inside_px(u, v, away) > 0, -1.0, super()._excess(cast, x, y))


class TestFormula:
    @pytest.mark.parametrize(
        ("look", "scene"),
        [
            (SLITS, {}),
            ({**SLITS, "simplify": 12.0}, {}),
            ({**SLITS, "simplify": 30.0, "distance": 120.0, "slit_spacing": 40.0}, PERSPECTIVE),
            ({**SLITS, "wave1.direction": 55.0, "wave_seed": 9.0}, PERSPECTIVE),
        ],
    )
    def test_they_are_the_formula(
        self, renderer: Renderer, figure: Path, look: Mapping[str, object], scene: Mapping[str, object]
    ) -> None:
        document = document_with(figure, look, scene)
        cast = cast_in(document)
        shadow = blurred.fallen(cast, raycast.Art(figure_alpha() / 255))
        shape = Shape(shadow, 0.5)
        if cast.simplify is not None:
            shape = blurred.simplified(shadow, cast.simplify.amount_px, cast.simplify.distance_px)
        wanted = Opened(shape.field, shape.level, slits_of(cast)).coverage(cast, 1000, 1000)
        got = coverage(renderer, document)
        plain = coverage(renderer, document_with(figure, {**look, "slits": 0.0}, scene))
        assert plain.sum() - got.sum() > 0.05 * plain.sum()
        assert np.abs(got - wanted).sum() < 0.01 * got.sum()
        shift = Shift.between(wanted, got)
        # The tip of a gap is a needle: where it ends is known along it only to some pixels.
        assert shift.mean <= 0.15, shift
        assert shift.p99 <= 1.0, shift

    def test_they_lie_on_a_wall_as_on_the_ground(self, renderer: Renderer, figure: Path) -> None:
        """Ground and wall laid flat: well within a gap nothing is left, well outside everything."""
        light: dict[str, object] = {"light.position": [300, -400, 950]}
        look: dict[str, object] = {SHADOW + name: value for name, value in {**WIDE, "simplify": 10.0}.items()}
        plain, got = (
            coverage(renderer, in_a_set(figure, WALL, light | look | {SHADOW + "slits": share})) for share in (0.0, 0.7)
        )
        cast = cast_in(in_a_set(figure, WALL, light | look))
        rows, columns = (each.astype(np.float64) + 0.5 for each in np.nonzero(plain > 0.999))
        seen = set_raycast.World(cast.camera, cast.receivers[0], cast.pieces).look(columns, rows)
        folded = FoldedGround.of(cast)
        flat = folded.flat(seen.point, seen.body == 0)
        u, v = folded.line.to_ground(flat[:, 0], flat[:, 1])
        within = slits_of(cast).inside_px(u, v, np.abs(flat[:, 1]))
        shown = got[plain > 0.999]
        for on_wall in (seen.body == 0, seen.body != 0):
            assert (on_wall & (within > 3)).sum() > 200
            assert shown[on_wall & (within > 3)].max() < 0.02
            assert shown[on_wall & (within < -3)].min() > 0.98

    @pytest.mark.parametrize(
        ("filters", "scene", "lights"),
        [
            ({}, {"light.position": [502.0, -300.0, 40.0], "light.overhead_radius": 260.0}, 4),
            ({"simplify": 20.0, "elongation": 1.0}, {}, 1),
            ({"wave1.amplitude": 6.0, "wave1.sideways": 2.0, "softness": 8.0, "simplify": 12.0}, PERSPECTIVE, 1),
        ],
        ids=["lamp overhead", "elongated", "soft in waves"],
    )
    def test_other_filters_and_lights_leave_them_as_they_are(
        self, renderer: Renderer, figure: Path, filters: Mapping[str, object], scene: Mapping[str, object], lights: int
    ) -> None:
        look = {**SLITS, "wave1.wavelength": 30.0, **filters}
        document = document_with(figure, look, scene)
        cast = cast_in(document)
        assert len(cast.lights) == lights
        got = coverage(renderer, document)
        solid = coverage(renderer, document_with(figure, {**look, "slits": 0.0}, scene)) > 0.9999
        y, x = (each.astype(np.float64) + 0.5 for each in np.nonzero(solid))
        u, v, _ = blurred.ground_seen_at(cast, x, y)
        within = slits_of(cast).inside_px(u, v, np.abs(ContactLine.of(cast).from_ground(u, v)[1]))
        assert (within > 3).sum() > 50
        assert got[solid][within > 3].max() < 0.02
        assert got[solid][within < -3].min() > 0.98


class TestNone:
    def test_without_slits_nothing_is_filtered(self, renderer: Renderer, figure: Path) -> None:
        plain = coverage(renderer, document_with(figure, {}))
        filtered = renderer.filters_drawn
        for look in ({**SLITS, "slits": 0.0}, {**SLITS, "waves_on": False}):
            assert np.array_equal(coverage(renderer, document_with(figure, look)), plain)
        assert renderer.filters_drawn == filtered

    @pytest.mark.parametrize("simplify", [0.0, 20.0])
    def test_near_the_feet_the_shadow_stays_as_it_was(self, renderer: Renderer, figure: Path, simplify: float) -> None:
        """The figure is 702 px high: no gap within 140 px, nor within the anchor; seen at 60° that is half as high."""
        plain = coverage(renderer, document_with(figure, {"simplify": simplify}))
        for anchor, top in ((0.0, 831), (200.0, 801)):
            look = {**SLITS, "slits": 1.0, "wave_anchor": anchor, "simplify": simplify}
            got = coverage(renderer, document_with(figure, look))
            assert np.array_equal(got[top:], plain[top:])
            assert (got < plain)[:top].any()


class TestTime:
    def test_a_loop_leads_into_its_beginning(self, renderer: Renderer, figure: Path) -> None:
        look = {**SLITS, "wave1.velocity": 60 * 2 / 48, "slit_spacing": 45.0, "wave_seed": 4.0}
        document = document_with(figure, look)
        document = replace(document, canvas=replace(document.canvas, length_frames=48))
        first, second, half, next_first = (coverage(renderer, document, frame) for frame in (1, 2, 25, 49))
        assert np.abs(first - next_first).max() < 0.02
        assert np.abs(first - half).sum() > 3 * np.abs(first - second).sum() > 0

    def test_the_same_seed_is_the_same_water(self, renderer: Renderer, figure: Path) -> None:
        first, again, other = (
            coverage(renderer, document_with(figure, {**SLITS, "wave_seed": seed})) for seed in (1.0, 1.0, 2.0)
        )
        assert np.array_equal(first, again)
        assert np.abs(first - other).sum() > 0.02 * first.sum()


@pytest.mark.parametrize("frame", [1, 9, 30])
def test_torn_water_opens_the_body_and_leaves_no_specks(renderer: Renderer, figure: Path, frame: int) -> None:
    style = next(each.style for each in bundled_styles() if each.style.name.en == "Torn water")
    document = put_style(standing(figure), ("layer-1",), style, frame).document
    parts = parts_of(coverage(renderer, document, frame) >= 0.5, diagonal=True)
    assert len(parts) >= 6
    assert min(len(part) for part in parts) >= 60
    assert max(len(part) for part in parts) < 0.5 * sum(len(part) for part in parts)
