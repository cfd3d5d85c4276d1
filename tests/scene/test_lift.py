"""Jumps: what a figure in the air casts, and how that is laid on the picture."""

from dataclasses import replace

import numpy as np
import pytest

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.model import Cels, Document
from kagezou.document.properties import OF_LAYER
from kagezou.geometry.box import Box
from kagezou.geometry.placement import Placement
from kagezou.scene.evaluate import evaluate
from kagezou.scene.lift import Lift, faded, lift_at, lowered_cel
from kagezou.scene.scene import LayerScene, PlacedDrawing, ShadowCast
from kagezou.scene.stances import stances_of
from tests.scene.jumps import GROUND, RISES, TALL, jumping, standing_box, with_values

PEAK = 7
AIR = range(5, 10)


def layer_at(document: Document, frame: int, index: int = 0) -> LayerScene:
    return evaluate(document, frame).layers[index]


def cast_at(document: Document, frame: int) -> ShadowCast:
    cast = layer_at(document, frame).cast
    assert cast is not None
    return cast


def lift(document: Document, frame: int) -> Lift:
    found = lift_at(document, document.layers[0], frame)
    assert found is not None
    return found


def size_at(document: Document, frame: int) -> float:
    placement = cast_at(document, frame).placement
    return 1.0 if placement is None else placement.scale[0]


def test_the_height_is_found() -> None:
    found = stances_of(jumping(), "layer-1")
    assert found is not None
    assert [found.at(frame).lift_px for frame in range(1, len(RISES) + 1)] == pytest.approx(RISES)
    assert found.height_px == TALL
    assert found.around_jump(PEAK) == (PEAK, 4, 10)


def test_on_the_ground_nothing_changes() -> None:
    shrunk = {"shadow.lift_shrink": 1.0, "shadow.lift_soften": 1.0, "shadow.lift_fade": 1.0}
    document = jumping()
    for frame in (1, 4, 10, 13):
        assert lift_at(document, document.layers[0], frame) is None
        assert layer_at(document, frame) == layer_at(with_values(document, shrunk), frame)
        assert cast_at(document, frame).placement is None


def test_in_the_air_it_casts_as_if_it_stood_there() -> None:
    document = jumping(shadow__lift_shrink=0.5, shadow__lift_soften=0.4, shadow__lift_fade=0.2, shadow__opacity=0.5)
    part = 120 / TALL
    layer, cast = layer_at(document, PEAK), cast_at(document, PEAK)
    size = 1 - 0.5 * part
    placement = cast.placement
    assert placement is not None
    assert placement.scale == pytest.approx((size, size))
    assert placement.placed((500.0, 780.0)) == pytest.approx((500.0, 900.0))
    assert placement.placed((450.0, 780.0)) == pytest.approx((500.0 - 50 * size, 900.0))
    assert np.allclose(cast.card.contacts, [(500 - 50 * size, 900.0, 0.0), (500 + 50 * size, 900.0, 0.0)])
    assert cast.edge is not None
    assert cast.edge.softness_px == pytest.approx(0.4 * 0.25 * 120)
    assert layer.look.opacity == pytest.approx(0.5 * (1 - 0.2 * part))
    assert layer.drawing == PlacedDrawing(document.layers[0].cels.drawings[PEAK - 1].source)


def test_it_shrinks_fades_and_softens_while_it_rises() -> None:
    document = jumping()
    sizes = [size_at(document, frame) for frame in range(4, PEAK + 1)]
    looks = [layer_at(document, frame).look.opacity for frame in range(4, PEAK + 1)]
    edges = [cast_at(document, frame).edge for frame in range(4, PEAK + 1)]
    assert sizes == sorted(sizes, reverse=True)
    assert looks == sorted(looks, reverse=True)
    soft = [0.0 if edge is None else edge.softness_px for edge in edges]
    assert soft == sorted(soft)
    assert len(set(sizes)) == len(set(looks)) == len(set(soft)) == 4


def test_an_edge_that_is_there_becomes_wider() -> None:
    document = jumping(shadow__softness=7, shadow__lift_soften=1, shadow__penumbra=0.1)
    edge = cast_at(document, PEAK).edge
    assert edge is not None
    assert edge.softness_px == pytest.approx(7 + 30)
    assert edge.penumbra == 0.1


def test_what_is_switched_off_leaves_the_shadow_as_it_is() -> None:
    document = jumping(shadow__lift_shrink=0, shadow__lift_soften=0, shadow__lift_fade=0)
    cast = cast_at(document, PEAK)
    assert cast.edge is None
    assert cast.placement is not None
    assert cast.placement.scale == pytest.approx((1.0, 1.0))
    assert layer_at(document, PEAK).look == layer_at(document, 1).look
    assert cast.card == cast_at(document, 1).card


def test_nothing_jumps_on_take_off() -> None:
    low = jumping((*RISES[:4], 6, *RISES[5:]))
    assert lift(low, 5).height_px == 6
    assert size_at(low, 5) > 0.99
    assert layer_at(low, 5).look.opacity > 0.98 * layer_at(low, 4).look.opacity
    assert np.allclose(cast_at(low, 5).card.contacts, cast_at(low, 4).card.contacts, atol=0.5)


def test_however_high_something_is_left() -> None:
    rises = (*RISES[:4], 200, 500, 800, 500, 200, *RISES[9:])
    document = jumping(rises, shadow__lift_shrink=1, shadow__lift_fade=1)
    found = lift(document, PEAK)
    assert (found.size, found.opacity) == (0.05, 0.0)
    assert cast_at(document, PEAK).placement is not None


def test_a_stretched_pose_casts_no_more_than_those_on_the_ground() -> None:
    """Otherwise a crouch followed by a stretch lets the shadow grow while the figure rises."""
    stretched = [standing_box(up, TALL + (150 if up else 0)) for up in RISES]
    plain, tall = jumping(shadow__lift_shrink=0), jumping(boxes=stretched, shadow__lift_shrink=0)
    assert size_at(plain, PEAK) == pytest.approx(1.0)
    # Under the sun a box casts by its width times its height.
    assert size_at(tall, PEAK) == pytest.approx((TALL / (TALL + 150)) ** 0.5, rel=1e-3)
    crouched = [standing_box(up, TALL - (150 if up else 0)) for up in RISES]
    assert size_at(jumping(boxes=crouched, shadow__lift_shrink=0), PEAK) == 1.0


def test_poses_on_one_side_of_the_jump_are_enough() -> None:
    stretched = [standing_box(up, TALL + (150 if up else 0)) for up in RISES]
    late = jumping(RISES[:PEAK], boxes=stretched[:PEAK], shadow__lift_shrink=0)
    found = stances_of(late, "layer-1")
    assert found is not None
    assert found.around_jump(PEAK) == (PEAK, 4, None)
    assert size_at(late, PEAK) == pytest.approx((TALL / (TALL + 150)) ** 0.5, rel=1e-3)


def test_a_light_that_casts_nothing_leaves_the_size() -> None:
    low = jumping(light__elevation=-10, shadow__lift_shrink=0)
    assert size_at(low, PEAK) == 1.0
    assert cast_at(low, PEAK).lights == ()


def test_who_stands_on_a_line_or_on_points_does_not_jump() -> None:
    for values in ({"stance": "line"}, {"stance": "points"}, {"grounding": [[500, 900]]}):
        document = with_values(jumping(), values)
        assert lift_at(document, document.layers[0], PEAK) is None
        assert cast_at(document, PEAK).placement is None


def test_moved_cels_are_moved_and_lowered() -> None:
    placement = Placement((300.0, 400.0), (200.0, 100.0), (-2.0, 3.0), 30.0)
    found = Lift(100.0, (500.0, 900.0), 0.5, 0.0, 1.0, ((), 400.0))
    cel = lowered_cel(found, PlacedDrawing(jumping().layers[0].cels.drawings[0].source, placement))
    assert cel.placement is not None
    for point in ((0.0, 0.0), (200.0, 100.0), (77.0, -31.0)):
        assert cel.placement.placed(point) == pytest.approx(found.lowered(placement.placed(point)))


def test_a_held_drawing_that_is_moved_jumps() -> None:
    """One drawing, slid up by keys: the shadow stays below, and only its size changes."""
    document = jumping(RISES[:1])
    document = replace(document, canvas=replace(document.canvas, length_frames=13))
    address = Address(OF_LAYER["position"], "layer-1")
    for frame, up in enumerate(RISES, 1):
        document = edits.set_key(document, address, frame, (500.0, 500.0 - up))
    assert size_at(document, PEAK) == pytest.approx(1 - 0.3 * 120 / TALL)
    placement = cast_at(document, PEAK).placement
    assert placement is not None
    assert placement.placed((500.0, 900.0)) == pytest.approx((500.0, GROUND))


def test_cels_of_one_figure_are_lowered_together() -> None:
    document = jumping()
    document = edits.add_layer(document, "arm", _arm(document), Box(400, 500, 600, 600))
    document = edits.join_layer(document, document.layers[1].id, "layer-1")
    cast = cast_at(document, PEAK)
    one, other = (part.placement for part in cast.figure)
    assert one == other is not None
    assert layer_at(document, PEAK, 1).look == layer_at(document, PEAK).look
    assert layer_at(document, PEAK, 1).look.opacity < layer_at(document, 1).look.opacity


def _arm(document: Document) -> Cels:
    """Return one drawing without feet that is held."""
    cels = document.layers[0].cels
    return Cels((replace(cels.drawings[0], feet=()),), cels.exposures[:1])


def test_looks_fade_by_what_is_left() -> None:
    look = layer_at(jumping(), 1).look
    assert faded(Lift(1.0, (0.0, 0.0), 1.0, 0.0, 0.25, ((), 1.0)), look) == replace(look, opacity=look.opacity / 4)
