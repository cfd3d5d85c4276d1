"""Waves, elongation and edges (spec 3, 4): against their formulas, and what they must never do."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from math import pi
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_key
from kagezou.document.model import Document
from kagezou.geometry.waves import Ripple
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import ShadowCast
from tests.effort import tries
from tests.render.reference import blurred, raycast
from tests.render.reference.blurred import ContactLine, Shape, Squares
from tests.render.reference.figures import figure_alpha, standing, with_values
from tests.render.reference.outlines import Shift
from tests.render.reference.raycast import Array

SHADOW = "layers.A.shadow."
PERSPECTIVE = {"camera.fov": 40.0, "ground.roll": 8.0, "layers.A.grounding": [[440.0, 890.0], [565.0, 888.0]]}
CALM = {"wave1.amplitude": 7.0, "wave1.wavelength": 90.0, "wave1.direction": 75.0}
TORN = {"wave1.amplitude": 16.0, "wave2.amplitude": 9.0, "wave1.wavelength": 70.0, "wave2.wavelength": 44.0}
STREAKS = {**CALM, "wave1.amplitude": 12.0, "wave1.sideways": 2.0, "wave1.depth": 0.3}
SHEARED = {
    **CALM,
    "wave1.sideways": -1.4,
    "wave1.sideways_shear": 0.8,
    "wave1.depth_shear": -0.6,
    "wave2.amplitude": 5.0,
    "wave2.wavelength": 70.0,
    "wave2.depth": -0.7,
    "wave2.sideways_shear": -1.1,
}


def document_with(figure: Path, look: Mapping[str, object], scene: Mapping[str, object] | None = None) -> Document:
    named = {SHADOW + name: value for name, value in look.items()}
    return with_values(with_values(standing(figure), scene or {}), named)


def cast_in(document: Document, frame: int = 1) -> ShadowCast:
    cast = evaluate(document, frame).layers[0].cast
    assert cast is not None
    return cast


def coverage(renderer: Renderer, document: Document, frame: int = 1) -> Array:
    scene = evaluate(document, frame)
    return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)


def displacement(ripples: tuple[Ripple, ...], u: Array, v: Array) -> tuple[Array, Array]:
    """Spec 4 letter by letter: λ is half the wavelength, (a, b) points against the direction."""
    du, dv = np.zeros_like(u), np.zeros_like(v)
    for ripple in ripples:
        wave = ripple.wave
        angle = wave.direction_deg * pi / 180
        a, b, half = -np.cos(angle), -np.sin(angle), wave.wavelength_px / 2
        psi = pi * (a * u + b * v) / half + ripple.phase
        a00, a01, a10, a11 = (wave.amplitude_px * each for each in wave.matrix)
        du += a00 * np.cos(psi) + a10 * np.sin(psi)
        dv += a01 * np.cos(psi) + a11 * np.sin(psi)
    return du, dv


@dataclass(frozen=True)
class Waved(Shape):
    """A shape that is read where the waves have moved it."""

    cast: ShadowCast

    def _excess(self, cast: ShadowCast, x: Array, y: Array) -> Array:
        u, v, area = blurred.ground_seen_at(cast, x, y)
        water = self.cast.water
        assert water is not None
        du, dv = displacement(water.ripples, u, v)
        if water.anchor_px > 0:
            part = np.minimum(np.abs(self.field.line.from_ground(u, v)[1]) / water.anchor_px, 1.0)
            du, dv = du * part, dv * part
        return np.where(area > 0, self.field.at(u + du, v + dv) - self.level, -1.0)


@cache
def fallen(cast: ShadowCast) -> Squares:
    return blurred.fallen(cast, raycast.Art(figure_alpha() / 255))


def exact(cast: ShadowCast) -> Shape:
    """The simplified shape, or the shadow itself."""
    # No ray knows of what comes afterwards, so that most looks have the same shadow.
    shadow = fallen(replace(cast, simplify=None, edge=None, water=None))
    if cast.simplify is None:
        return Shape(shadow, 0.5)
    return blurred.simplified(shadow, cast.simplify.amount_px, cast.simplify.distance_px)


class TestWaves:
    @pytest.mark.parametrize(
        ("look", "scene"),
        [
            ({**CALM, "simplify": 12.0}, {}),
            ({**CALM, "simplify": 30.0, "distance": 120.0, "wave_anchor": 80.0}, PERSPECTIVE),
            ({**TORN, "simplify": 30.0, "wave_seed": 7.0}, {}),
            (CALM, {}),
            ({**CALM, "wave_anchor": 100.0, "wave_seed": 3.0}, PERSPECTIVE),
            ({**STREAKS, "simplify": 12.0}, {}),
            ({**SHEARED, "simplify": 20.0}, {}),
            ({**SHEARED, "simplify": 30.0, "distance": 120.0, "wave_anchor": 80.0}, PERSPECTIVE),
            ({**SHEARED, "wave_seed": 5.0}, {}),
        ],
    )
    def test_they_are_the_formula(
        self, renderer: Renderer, figure: Path, look: Mapping[str, object], scene: Mapping[str, object]
    ) -> None:
        document = document_with(figure, look, scene)
        cast = cast_in(document)
        shape = exact(cast)
        wanted = Waved(shape.field, shape.level, cast).coverage(cast, 1000, 1000)
        shift = Shift.between(wanted, coverage(renderer, document))
        assert shift.mean <= 0.15, shift
        assert shift.p99 <= 0.5, shift

    def test_a_loop_leads_into_its_beginning(self, renderer: Renderer, figure: Path) -> None:
        """48 frames, in which whole crests pass."""
        look = {**TORN, "wave1.velocity": 70 * 3 / 48, "wave2.velocity": -44 * 2 / 48, "wave_seed": 11.0}
        document = document_with(figure, look)
        first, next_first, last = (coverage(renderer, document, frame) for frame in (1, 49, 48))
        assert np.abs(first - next_first).max() < 0.02
        step = [
            np.abs(coverage(renderer, document, frame + 1) - coverage(renderer, document, frame)).sum()
            for frame in (1, 2)
        ]
        assert np.abs(last - first).sum() < 1.5 * max(step)

    def test_a_seed_is_a_picture(self, renderer: Renderer, figure: Path) -> None:
        one, two = ({**TORN, "wave_seed": seed} for seed in (1.0, 2.0))
        first = coverage(renderer, document_with(figure, one))
        other = coverage(renderer, document_with(figure, two))
        assert np.abs(first - other).sum() > 0.05 * first.sum()
        assert np.array_equal(coverage(renderer, document_with(figure, one)), first)

    def test_an_anchor_holds_the_feet(self, renderer: Renderer, figure: Path) -> None:
        still = coverage(renderer, document_with(figure, {}))
        anchored = coverage(renderer, document_with(figure, {**CALM, "wave_anchor": 300.0}))
        feet = (slice(890, 902), slice(420, 600))
        assert np.abs(still[feet] - anchored[feet]).mean() < 0.02
        assert np.abs(still - anchored).sum() > 0.05 * still.sum()

    def test_off_is_none(self, renderer: Renderer, figure: Path) -> None:
        off = document_with(figure, {**TORN, "waves_on": False})
        assert np.array_equal(coverage(renderer, off), coverage(renderer, document_with(figure, {})))


class TestElongation:
    def test_the_kernel_is_the_shadow_s_own_ellipse(self, renderer: Renderer, figure: Path) -> None:
        """Fully elongated, the widest blur keeps the ratio and the direction of the shadow's axes."""
        document = document_with(figure, {"simplify": 400.0, "elongation": 1.0})
        cast = cast_in(document)
        shadow = fallen(cast)
        mean, covariance = blurred.moments_of(shadow)
        got = coverage(renderer, document)
        y, x = np.mgrid[0:1000, 0:1000] + 0.5
        u, v, area = blurred.ground_seen_at(cast, x, y)
        away = np.stack(ContactLine.of(cast).from_ground(u, v), axis=-1) - mean
        covariance *= shadow.area / (4 * np.pi) / np.sqrt(np.linalg.det(covariance))
        inside = np.einsum("hwi,ij,hwj->hw", away, np.linalg.inv(covariance), away) <= 4.0
        union, both = np.maximum(got, inside) * area, np.minimum(got, inside) * area
        assert both.sum() / union.sum() >= 0.97

    @pytest.mark.parametrize("elongation", [0.3, 1.0])
    def test_the_area_stays(self, renderer: Renderer, figure: Path, elongation: float) -> None:
        plain = document_with(figure, {})
        cast = cast_in(plain)
        y, x = np.mgrid[0:1000, 0:1000] + 0.5
        area = blurred.ground_seen_at(cast, x, y)[2]
        before = (coverage(renderer, plain) * area).sum()
        look = {"simplify": 60.0, "distance": 150.0, "elongation": elongation}
        after = (coverage(renderer, document_with(figure, look)) * area).sum()
        assert after == pytest.approx(before, rel=0.01)


class TestEdge:
    def disc(self, renderer: Renderer, figure: Path, look: Mapping[str, object]) -> tuple[Array, Array]:
        """A shadow rounded to a disc on the ground: its coverage by the distance from its middle, in ground px."""
        document = document_with(figure, {"simplify": 500.0, **look})
        cast = cast_in(document)
        got = coverage(renderer, document)
        y, x = np.mgrid[0:1000, 0:1000] + 0.5
        u, v, area = blurred.ground_seen_at(cast, x, y)
        weights = got * area / (got * area).sum()
        radius = np.hypot(u - (weights * u).sum(), v - (weights * v).sum())
        # The ellipse of so wide a blur is a disc within 2 %; its own width counts, not where exactly its middle is.
        return radius, got

    @staticmethod
    def width(radius: Array, got: Array, low: float, high: float) -> float:
        """How far apart the middles of two coverages are, from the areas that are covered more than them."""
        outer, inner = (np.sqrt((got > each).sum()) for each in (low, high))
        return float(outer - inner) / float(np.sqrt((got > 0.5).sum())) * float(radius[got > 0.5].max())

    @pytest.mark.parametrize("softness", [10.0, 40.0])
    def test_softness_is_the_width_of_the_ramp(self, renderer: Renderer, figure: Path, softness: float) -> None:
        """A smooth ramp over 1.5 widths: between a quarter and three quarters lies 0.52 of a width."""
        radius, got = self.disc(renderer, figure, {"softness": softness})
        assert self.width(radius, got, 0.25, 0.75) == pytest.approx(0.52 * softness, rel=0.2)

    def test_softness_keeps_the_outline(self, renderer: Renderer, figure: Path) -> None:
        crisp = coverage(renderer, document_with(figure, {"simplify": 30.0}))
        soft = coverage(renderer, document_with(figure, {"simplify": 30.0, "softness": 12.0}))
        shift = Shift.between(crisp, soft)
        assert shift.mean < 0.6, shift

    @pytest.mark.parametrize("grow", [-6.0, 4.0, 10.0])
    def test_growing_moves_the_outline(self, renderer: Renderer, figure: Path, grow: float) -> None:
        before_radius, before = self.disc(renderer, figure, {})
        after = self.disc(renderer, figure, {"grow": grow})[1]
        moved = (np.sqrt((after > 0.5).sum() / (before > 0.5).sum()) - 1) * before_radius[before > 0.5].max()
        assert moved == pytest.approx(grow, abs=0.12 * abs(grow) + 0.3)

    def test_a_penumbra_is_crisp_at_the_feet_and_soft_at_the_tip(self, renderer: Renderer, figure: Path) -> None:
        got = coverage(renderer, document_with(figure, {"penumbra": 0.1}))
        half = (got > 0.1) & (got < 0.9)
        rows = half.sum(axis=1) / np.maximum((got > 0.5).sum(axis=1), 1)
        y = np.nonzero((got > 0.5).any(axis=1))[0]
        assert rows[y[-20:-5]].mean() < 0.3 * rows[y[5:60]].mean()

    @pytest.mark.parametrize("name", ["softness", "grow", "penumbra"])
    def test_a_little_changes_a_little(self, renderer: Renderer, figure: Path, name: str) -> None:
        before = coverage(renderer, document_with(figure, {}))
        for value in np.arange(1, tries(6, 13)) * (0.0005 if name == "penumbra" else 0.15):
            after = coverage(renderer, document_with(figure, {name: float(value)}))
            assert np.abs(after - before).sum() / before.sum() < 0.03
            before = after

    def test_no_edge_at_all_is_the_shadow_as_it_was(self, renderer: Renderer, figure: Path) -> None:
        plain = coverage(renderer, document_with(figure, {}))
        filtered = renderer.filters_drawn
        none = {"softness": 0.0, "grow": 0.0, "penumbra": 0.0, "simplify": 30.0, "simplify_on": False}
        assert np.array_equal(coverage(renderer, document_with(figure, none)), plain)
        assert renderer.filters_drawn == filtered


class TestNoBoiling:
    """A held drawing under slowly keyed values: the outline goes one way, and nowhere jumps."""

    FRAMES = 24

    @pytest.mark.parametrize(
        ("keyed", "held"),
        [
            ({"simplify": (50.0, 62.0)}, {"distance": 200.0}),
            ({"simplify": (50.0, 62.0)}, {}),
            ({"distance": (120.0, 190.0)}, {"simplify": 40.0}),
            ({"wave1.amplitude": (4.0, 10.0)}, {"simplify": 40.0, "wave1.velocity": 0.0}),
            ({"softness": (2.0, 8.0)}, {"simplify": 50.0}),
            ({"light": (200.0, 290.0)}, {"simplify": 40.0, "distance": 200.0}),
        ],
    )
    def test_the_outline_moves_steadily(
        self, renderer: Renderer, figure: Path, keyed: Mapping[str, tuple[float, float]], held: Mapping[str, object]
    ) -> None:
        document = document_with(figure, held)
        ((name, (start, end)),) = keyed.items()
        document = replace(document, canvas=replace(document.canvas, length_frames=self.FRAMES))
        path = "light.position" if name == "light" else SHADOW + name
        address = resolve(document, path)
        for frame, value in ((1, start), (self.FRAMES, end)):
            raw = [value, -200.0, 900.0] if name == "light" else value
            document = set_key(document, address, frame, raw)
        shapes = [coverage(renderer, document, frame) for frame in range(1, self.FRAMES + 1)]
        steps = [Shift.between(before, after) for before, after in pairwise(shapes)]
        assert max(step.largest for step in steps) < 4 * max(step.mean for step in steps) + 0.5
        assert max(step.mean for step in steps) < 3 * min(step.mean for step in steps) + 0.05
        gone = sum(float(np.abs(after - before).sum()) for before, after in pairwise(shapes))
        assert np.abs(shapes[-1] - shapes[0]).sum() > 0.9 * gone
