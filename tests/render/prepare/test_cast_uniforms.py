"""The numbers of a cast, read back as shaders read them, against the cast itself."""

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.card import CardPiece
from kagezou.geometry.ground import Plane, ground_plane, world_from_canvas_on
from kagezou.geometry.light import grazing_strength, lamp, sun
from kagezou.geometry.polygon import box_polygon
from kagezou.geometry.shadow import Cast, cast_card, cast_in_space, plane_coordinates
from kagezou.geometry.vectors import height_over
from kagezou.render.prepare.cast_uniforms import Edges, Frame, Grazing, card_switches, card_uniforms, piece_limits
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform
from kagezou.scene.scene import ShadowCast
from tests.render.prepare.filter_jobs import FIGURE, cast_of, scene_with

GROUND = ground_plane((500.0, 900.0), 4.0, 60.0)
BOX = Box(300, 700, 901, 1000)
FRAME = Frame(box_polygon(BOX))
PLACES = st.tuples(st.floats(BOX.left, BOX.right), st.floats(BOX.top, BOX.bottom))
FOLDED = {"layers.A.grounding": [[440.0, 898.0], [500.0, 885.0], [565.0, 900.0]], "camera.fov": 30.0}


def matrix(uniforms: dict[str, Uniform], name: str) -> np.ndarray:
    found = uniforms[name]
    assert isinstance(found, np.ndarray)
    return found


def from_origin(place: tuple[float, float]) -> np.ndarray:
    """A canvas place as shaders have it: px around the frame's origin, in float32."""
    return np.array([*(np.array(place) - FRAME.origin), 1.0], np.float32).astype(float)


def projected(homography: np.ndarray, place: np.ndarray) -> np.ndarray:
    h = homography @ place
    return np.asarray(h[:-1] / h[-1])


def casts_of(values: dict[str, object]) -> tuple[ShadowCast, tuple[Cast, ...]]:
    cast = cast_of(scene_with(values))
    return cast, cast_card(cast.camera, cast.receivers[0], cast.card, cast.lights[0])


def test_the_origin_is_the_middle_of_a_pixel_in_the_middle() -> None:
    assert FRAME.origin.tolist() == [600.5, 850.5]
    assert (FRAME.canvas_from_pixel @ [3.0, -4.0, 1.0]).tolist() == [603.5, 846.5, 1.0]


@given(PLACES, st.sampled_from([{}, FOLDED]))
def test_a_place_sees_the_same_texel_and_lies_as_far_from_the_limits(
    place: tuple[float, float], values: dict[str, object]
) -> None:
    _, casts = casts_of(values)
    assert len(casts) == (2 if values else 1)
    for cast in casts:
        edges = Edges(cast, FIGURE, FRAME)
        wanted = projected(cast.art_from_canvas, np.array([*place, 1.0])) - (FIGURE.box.left, FIGURE.box.top)
        texel_from_pixel = matrix(edges.uniforms(), "u_texel_from_pixel")
        assert projected(texel_from_pixel.astype(np.float32), from_origin(place)) == pytest.approx(wanted, abs=0.01)
        for name, form in {"u_side": cast.side, "u_horizon": cast.horizon}.items():
            assert matrix(edges.limits(), name) @ from_origin(place) == pytest.approx(form @ [*place, 1.0], abs=1e-3)
        assert len(cast.limits) == (1 if values else 0)
        assert edges.limit_switches() == {f"LIMITS {len(cast.limits)}"}
        for number, form in enumerate(cast.limits):
            limit = matrix(edges.limits(), "u_limits")[number, :3]
            assert limit @ from_origin(place) == pytest.approx(form @ [*place, 1.0], abs=1e-3)


def test_textures_and_levels_have_their_places() -> None:
    _, (cast,) = casts_of({})
    uniforms = Edges(cast, FIGURE, FRAME).uniforms()
    assert (uniforms["u_matte"], uniforms["u_means"], uniforms["u_last_level"]) == (0, 1, LAST_LEVEL)
    assert abs(matrix(uniforms, "u_texel_from_pixel")[2, 2]) == pytest.approx(1.0)


# ---- how high a light stands


def strength_by_angle(receiver: Plane, light: tuple[float, float, float, float], place: tuple[float, float]) -> float:
    """The strength from the angle at which the light is seen from a place of the receiver."""
    camera = cast_of(scene_with({})).camera
    lift = world_from_canvas_on(camera, receiver)
    assert lift is not None
    point = projected(lift, np.array([*place, 1.0]))
    toward = np.array(light[:3]) - light[3] * point
    return grazing_strength(float(toward @ receiver.normal / np.linalg.norm(toward)))


def strength_in_shader(uniforms: dict[str, Uniform], switches: frozenset[str], place: tuple[float, float]) -> float:
    strength = uniforms["u_strength"]
    assert isinstance(strength, float)
    if "LAMP_IS_LOW" not in switches:
        return strength
    foot_u, foot_v, height = uniforms["u_lamp_on_receiver"]  # type: ignore[misc]
    low, high = uniforms["u_grazing_sine"]  # type: ignore[misc]
    u, v = projected(matrix(uniforms, "u_receiver_from_pixel"), from_origin(place))
    t = min(max((height / hypot(height, u - foot_u, v - foot_v) - low) / (high - low), 0.0), 1.0)
    return float(strength * t * t * (3 - 2 * t))


def receiver_from_canvas() -> np.ndarray:
    lift = world_from_canvas_on(cast_of(scene_with({})).camera, GROUND)
    assert lift is not None
    return plane_coordinates(GROUND) @ lift


@given(
    st.one_of(
        st.builds(lambda u, v, up: lamp(_over(u, v, up)), st.floats(-900, 900), st.floats(-900, 900), st.floats(5, 90)),
        st.builds(lambda turn, up: sun(GROUND, turn, up), st.floats(-180, 180), st.floats(0.5, 5.0)),
    ),
    PLACES,
)
def test_a_shadow_is_as_strong_as_the_angle_says(
    light: tuple[float, float, float, float], place: tuple[float, float]
) -> None:
    grazing = Grazing.of(GROUND, light)
    switches = grazing.switches(receiver_from_canvas(), FRAME)
    uniforms = grazing.uniforms(receiver_from_canvas(), FRAME)
    wanted = strength_by_angle(GROUND, light, place)
    assert strength_in_shader(uniforms, switches, place) == pytest.approx(wanted, abs=2e-3)
    assert height_over(GROUND.equation, light) == pytest.approx(grazing.height)


def _over(u: float, v: float, up: float) -> tuple[float, float, float]:
    x, y, z = (p + up * n for p, n in zip(GROUND.point(u, v), GROUND.normal, strict=True))
    return (x, y, z)


def test_a_lamp_is_low_only_where_it_fades() -> None:
    high, low = (Grazing.of(GROUND, lamp(_over(0.0, 0.0, up))) for up in (900.0, 10.0))
    assert high.switches(receiver_from_canvas(), FRAME) == frozenset()
    assert low.switches(receiver_from_canvas(), FRAME) == {"LAMP_IS_LOW"}
    sunny = Grazing.of(GROUND, sun(GROUND, 30.0, 2.0))
    assert sunny.switches(receiver_from_canvas(), FRAME) == frozenset()


# ---- a card in space


@given(st.tuples(*[st.floats(-300, 300)] * 3))
def test_a_card_is_met_by_a_place_in_space_as_it_is_in_the_world(place: tuple[float, float, float]) -> None:
    cast, _ = casts_of(FOLDED)
    world_from_local = np.eye(4)
    world_from_local[:3, 3] = (520.0, 700.0, -150.0)
    world = world_from_local @ [*place, 1.0]
    for piece in cast.card.pieces:
        space = cast_in_space(cast.camera, piece, cast.lights[0])
        assert space is not None
        uniforms = card_uniforms(space, FIGURE, world_from_local)
        rows, limits = matrix(uniforms, "u_texel_rows"), matrix(uniforms, "u_limits")
        h, wanted = rows @ [*place, 1.0], space.art_from_world @ world
        assert np.sign(h[2]) == np.sign(wanted[2])
        if abs(wanted[2]) > 1e-3 * np.abs(space.art_from_world[2]).max():
            assert h[:2] / h[2] + (FIGURE.box.left, FIGURE.box.top) == pytest.approx(wanted[:2] / wanted[2], rel=1e-6)
        assert np.abs(rows[2]).max() == pytest.approx(1.0)
        assert card_switches(space, translucent=False) == {"LIMITS 2"}
        for limit, form in zip(limits, (space.side, *space.limits), strict=True):
            assert limit @ [*place, 1.0] == pytest.approx(form @ world, rel=1e-9, abs=1e-6)


@given(st.tuples(st.floats(0, 500), st.floats(0, 500)))
def test_a_drawing_lies_on_a_piece_where_its_limits_say(place: tuple[float, float]) -> None:
    piece = CardPiece((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), ((3.0, 4.0, -1000.0), (-1.0, 0.0, 400.0)))
    switches, uniforms = piece_limits(piece, (-256, -256))
    assert switches == {"LIMITS 2"}
    limits = matrix(uniforms, "u_limits")
    assert limits.shape == (2, 4)
    values = limits[:, :3] @ [place[0] + 256, place[1] + 256, 1.0]
    assert values == pytest.approx([(3 * place[0] + 4 * place[1] - 1000) / 5, 400 - place[0]], abs=1e-9)
    assert piece_limits(CardPiece((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))) == (frozenset({"LIMITS 0"}), {})
