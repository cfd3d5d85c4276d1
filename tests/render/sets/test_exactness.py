"""Sets against float64 rays: every kind of piece, as receiver, as blocker, and with a shadow of its own."""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise
from math import radians, sin
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.light import grazing_strength
from kagezou.geometry.sets.bodies import Solid
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.vectors import height_over
from kagezou.io.images.writing import ShadowImage
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene
from tests.render.reference import raycast, set_raycast
from tests.render.reference.figures import figure_alpha, standing, with_values
from tests.render.test_exactness import Agreement, random_light

Array = NDArray[np.float64]
Pieces = Mapping[str, Mapping[str, object]]

MIN_SHADOW_PX = 2000

ROOM: Pieces = {
    "wall": {"kind": "wall", "position": [500, 770], "width": 900, "height": 480, "angle": -8},
    "box": {"kind": "box", "position": [640, 850], "width": 150, "height": 110, "depth": 90, "angle": 30},
    "stairs": {"kind": "steps", "position": [400, 830], "width": 150, "height": 90, "depth": 100, "angle": 12},
    "slope": {"kind": "ramp", "position": [560, 860], "width": 90, "height": 50, "depth": 90, "angle": -20},
}


def in_a_set(figure: Path, pieces: Pieces, values: Mapping[str, object]) -> Document:
    document = standing(figure)
    for name, each in pieces.items():
        document = add_piece(document, name, str(each["kind"]), {k: v for k, v in each.items() if k != "kind"})
    return with_values(document, values)


def rays_of(scene: Scene) -> Callable[[Array, Array], Array]:
    cast = scene.layers[0].cast
    assert cast is not None
    art = raycast.Art(figure_alpha() / 255)
    return lambda x, y: set_raycast.shade(cast, art, x, y)


def own_rays_of(scene: Scene) -> Callable[[Array, Array], Array]:
    shadow = scene.set_shadow
    assert shadow is not None
    world = set_raycast.World(scene.camera, scene.ground, scene.pieces)
    return lambda x, y: set_raycast.own_shade(world, shadow.cast.lights, x, y)


def judged(got: Array, rays: Callable[[Array, Array], Array]) -> Agreement:
    """Compare with rays; with more of them where few leave it in doubt."""
    return Agreement.by_rays(got, partial(set_raycast.coverage, rays, got), 40, 240)


def random_piece(rng: np.random.Generator, kind: str) -> dict[str, object]:
    return {
        "kind": kind,
        "position": [float(rng.uniform(420, 640)), float(rng.uniform(760, 850))],
        "angle": float(rng.uniform(-60, 60)),
        "lean": float(rng.uniform(-15, 30)),
        "width": float(rng.uniform(150, 320)),
        "height": float(rng.uniform(80, 320)),
        "depth": float(rng.uniform(60, 200)),
        "count": float(rng.integers(2, 6)),
        "casts": True,
    }


def view(rng: np.random.Generator) -> dict[str, object]:
    return {
        "ground.declination": float(rng.uniform(40, 75)),
        "ground.roll": float(rng.uniform(-6, 6)),
        "camera.fov": float(rng.choice([0, 25, 45])),
        "layers.A.tilt": float(rng.uniform(-25, 25)),
    }


@pytest.mark.parametrize("kind", PieceKind)
@pytest.mark.parametrize("seed", [1, 2])
def test_every_kind_agrees_with_rays(renderer: Renderer, figure: Path, kind: PieceKind, seed: int) -> None:
    rng = np.random.default_rng(1000 * list(PieceKind).index(kind) + seed)
    pieces = {"one": random_piece(rng, kind), "wall": {"kind": "wall", "position": [500, 720], "width": 1200}}
    scene = evaluate(in_a_set(figure, pieces, view(rng) | random_light(rng)), 1)
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    if got.sum() >= MIN_SHADOW_PX:
        assert judged(got, rays_of(scene)).is_right
    own = renderer.set_coverage(scene) / 65535
    if own.sum() >= MIN_SHADOW_PX:
        assert judged(own, own_rays_of(scene)).is_right


@pytest.mark.parametrize("degrees", [1.4, 2.0, 2.6])
def test_a_piece_that_turns_away_from_the_sun_grows_dark_before_it_is_turned(
    renderer: Renderer, figure: Path, degrees: float
) -> None:
    wall = {"kind": "wall", "position": [500, 800], "width": 500, "height": 300, "casts": True}

    def lit_from(azimuth: float) -> Scene:
        values = {"light.kind": "sun", "light.azimuth": azimuth, "light.elevation": 35.0}
        return evaluate(in_a_set(figure, {"wall": wall}, values), 1)

    def height_of_sun(scene: Scene) -> float:
        assert scene.set_shadow is not None
        (body,), (light,) = scene.pieces[0].bodies, scene.set_shadow.cast.lights
        assert isinstance(body, Solid)
        plane = body.facets[0].equation
        return height_over(plane, light) if height_over(plane, scene.camera.eye) > 0 else -height_over(plane, light)

    # The sun before the wall, moved aside until its light only grazes the side that is seen.
    before, behind = 20.0, 160.0
    assert height_of_sun(lit_from(before)) > sin(radians(degrees)) > height_of_sun(lit_from(behind))
    for _ in range(40):
        middle = (before + behind) / 2
        is_before = height_of_sun(lit_from(middle)) > sin(radians(degrees))
        before, behind = (middle, behind) if is_before else (before, middle)
    scene = lit_from(before)
    own = renderer.set_coverage(scene) / 65535
    on_wall = own[600:700, 400:600]
    assert on_wall == pytest.approx(1 - grazing_strength(sin(radians(degrees))), abs=1e-3)
    assert judged(own, own_rays_of(scene)).is_right


@pytest.mark.parametrize(("kind", "z"), [("wall", -98.0), ("box", -63.5)])
def test_a_piece_grows_dark_where_a_lamp_only_grazes_it(renderer: Renderer, figure: Path, kind: str, z: float) -> None:
    """A lamp 15 px before the plane of the side that is seen: near it is lit, far from it dark, between it fades."""
    piece = {"kind": kind, "position": [500, 800], "width": 700, "height": 200, "depth": 60, "casts": True}
    scene = evaluate(in_a_set(figure, {"one": piece}, {"light.position": [100, 700, z]}), 1)
    own = renderer.set_coverage(scene) / 65535
    assert judged(own, own_rays_of(scene)).is_right


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_a_room_of_pieces_agrees_with_rays(renderer: Renderer, figure: Path, fov: float) -> None:
    scene = evaluate(in_a_set(figure, ROOM, {"camera.fov": fov, "light.position": [300, -150, 950]}), 1)
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    assert got.sum() > 10 * MIN_SHADOW_PX
    assert judged(got, rays_of(scene)).is_right


def test_four_lights_unite_on_a_wall(renderer: Renderer, figure: Path) -> None:
    values = {"light.position": [420.0, -500.0, 60.0], "light.overhead_radius": 300.0}
    scene = evaluate(in_a_set(figure, {"wall": ROOM["wall"]}, values), 1)
    cast = scene.layers[0].cast
    assert cast is not None
    assert len(cast.lights) == 4
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    assert judged(got, rays_of(scene)).is_right


def test_a_folded_card_falls_on_steps_and_a_ball(renderer: Renderer, figure: Path) -> None:
    pieces: Pieces = {
        "stairs": ROOM["stairs"],
        "ball": {"kind": "sphere", "position": [600, 850], "width": 160},
    }
    values = {"layers.A.grounding": [[440.0, 898.0], [500.0, 885.0], [565.0, 900.0]]}
    scene = evaluate(in_a_set(figure, pieces, values), 1)
    got = renderer.coverage(scene, scene.layers[0]) / 65535
    assert judged(got, rays_of(scene)).is_right


# ---- seams


def wall_seam(renderer: Renderer, figure: Path, values: Mapping[str, object]) -> tuple[Array, int]:
    """The coverage around the line in which an unturned wall stands, and its row."""
    wall = {"kind": "wall", "position": [500, 800.5], "width": 1000, "height": 500}
    scene = evaluate(in_a_set(figure, {"wall": wall}, {"light.position": [300, -150, 950]} | dict(values)), 1)
    return renderer.coverage(scene, scene.layers[0]) / 65535, 800


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_no_gap_and_no_double_edge_at_the_seam_of_a_wall(renderer: Renderer, figure: Path, fov: float) -> None:
    coverage, row = wall_seam(renderer, figure, {"camera.fov": fov})
    above, at, below = coverage[row - 2], coverage[row], coverage[row + 2]
    both = (above > 0.999) & (below > 0.999)
    assert both.sum() > 20
    assert coverage[row - 2 : row + 3, both].min() > 0.995
    # The outline goes on from the ground to the wall within a pixel.
    for line in (above, at, below):
        assert line.max() > 0.99
    starts = [np.nonzero(line > 0.5)[0] for line in coverage[row - 1 : row + 2]]
    for first, second in pairwise(starts):
        assert abs(int(first[0]) - int(second[0])) <= 1
        assert abs(int(first[-1]) - int(second[-1])) <= 1


def test_a_shadow_stops_at_a_platform_s_edge_and_goes_on_below(renderer: Renderer, figure: Path) -> None:
    """Under a light from the front the back of a low box is not seen: what it hides of the ground is missing there."""
    values = {"light.kind": "sun", "light.azimuth": 20.0, "light.elevation": 40.0}
    box = {"kind": "box", "position": [560, 800], "width": 500, "height": 40, "depth": 120}
    flat = evaluate(in_a_set(figure, {}, values), 1)
    stepped = evaluate(in_a_set(figure, {"platform": box}, values), 1)
    plain = renderer.coverage(flat, flat.layers[0]) / 65535
    got = renderer.coverage(stepped, stepped.layers[0]) / 65535
    # Before the platform nothing has changed, on it the shadow is moved, and behind it some of it is left.
    front = int(np.nonzero(np.abs(got - plain).max(axis=1) > 0.02)[0].max())
    assert 800 < front < 860
    assert judged(got, rays_of(stepped)).is_right


def test_a_piece_far_away_changes_nothing(renderer: Renderer, figure: Path) -> None:
    far = {"kind": "box", "position": [120, 950], "width": 60, "height": 40, "depth": 40}
    plain, with_box = (evaluate(in_a_set(figure, pieces, {}), 1) for pieces in ({}, {"far": far}))
    first = renderer.coverage(plain, plain.layers[0]).astype(int)
    second = renderer.coverage(with_box, with_box.layers[0]).astype(int)
    assert np.abs(first - second).max() == 0


def test_a_light_that_moves_a_little_moves_the_shadow_a_little(renderer: Renderer, figure: Path) -> None:
    def seen(x: float) -> Array:
        scene = evaluate(in_a_set(figure, ROOM, {"light.position": [x, -150, 950]}), 1)
        return np.asarray(renderer.coverage(scene, scene.layers[0]) / 65535)

    before = seen(300.0)
    for x in (301.0, 302.0):
        after = seen(x)
        assert np.abs(after - before).sum() < 0.02 * before.sum()
        before = after


# ---- switches


def test_switches_say_who_receives_blocks_and_casts(renderer: Renderer, figure: Path) -> None:
    def shown(values: Mapping[str, object]) -> tuple[Array, Array]:
        box = {**ROOM["box"], "position": [560, 845]}
        scene = evaluate(in_a_set(figure, {"wall": ROOM["wall"], "box": box}, values), 1)
        return renderer.coverage(scene, scene.layers[0]) / 65535, renderer.set_coverage(scene) / 65535

    plain, nothing = shown({})
    assert nothing.max() == 0
    bare, _ = shown({"set.wall.receives": False})
    assert bare[:700].sum() == 0
    assert plain[:700].sum() > 1000
    assert bare[890:].sum() == plain[890:].sum()
    through, _ = shown({"set.box.blocks": False})
    assert through.sum() > plain.sum()
    absent, _ = shown({"set.wall.present": False, "set.box.present": False})
    flat = evaluate(standing(figure), 1)
    assert (absent * 65535 == renderer.coverage(flat, flat.layers[0])).all()
    _, own = shown({"set.box.casts": True})
    assert own.sum() > 1000
    # What the box takes of the light is in its own shadow, not in the character's too.
    both, dark = shown({"set.box.casts": True, "set.wall.casts": True})
    assert (both + dark).max() < 1.01


def test_a_set_shadow_is_drawn_and_laid_on_the_picture(renderer: Renderer, figure: Path) -> None:
    values = {"set.box.casts": True, "set.shadow.color": "#FF0000", "set.shadow.opacity": 0.5}
    scene = evaluate(in_a_set(figure, {"box": ROOM["box"]}, values), 1)
    assert scene.set_shadow is not None
    image = renderer.set_shadow(scene, scene.set_shadow)
    assert isinstance(image, ShadowImage)
    assert image.alpha.max() == pytest.approx(127.5, abs=1)
    renderer.draw_picture(scene)
    picture = renderer.read_picture()
    covered = renderer.set_coverage(scene) == 65535
    assert covered.sum() > 500
    reds = picture[covered & (picture[..., 1] == 0)]
    assert (reds[:, 0] == 255).all()
    assert len(reds) > 200


def test_filters_round_the_shadow_on_the_ground_before_a_wall(renderer: Renderer, figure: Path) -> None:
    values = {"layers.A.shadow.simplify": 15.0}
    scene = evaluate(in_a_set(figure, {"wall": ROOM["wall"]}, values), 1)
    flat = evaluate(in_a_set(figure, {}, values), 1)
    got, plain = (renderer.coverage(each, each.layers[0]) / 65535 for each in (scene, flat))
    # One level holds for the ground and the wall together, which moves the outline by a part of a px.
    assert np.abs(got[860:] - plain[860:]).max() < 0.3
    assert got[:760].sum() > 1000
