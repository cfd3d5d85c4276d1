"""Round shadows: where the disc lies, how wide it is, and what of a cast it replaces."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import cos, radians
from pathlib import Path

import numpy as np
import pytest

from kagezou.document import edits
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.refitting import Refit, refitted
from kagezou.geometry.box import Box
from kagezou.geometry.camera import project
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.vectors import Point2
from kagezou.scene.disc import DISC_RADIUS_PX, Disc
from kagezou.scene.evaluate import evaluate
from kagezou.scene.receiving import without_drawings
from kagezou.scene.scene import ShadowCast
from kagezou.standing.foot import Foot
from tests.scene.jumps import GROUND, RISES, TALL, jumping, with_values

TIPPED_DEG = 60.0


def standing(feet: Sequence[tuple[Point2, ...]]) -> Document:
    """Return a cut whose figure, 400 px high, has these feet in its drawings."""
    document = jumping([0] * len(feet))
    (layer,) = document.layers
    drawings = tuple(
        replace(drawing, feet=tuple(Foot(track, place) for track, place in enumerate(each)))
        for drawing, each in zip(layer.cels.drawings, feet, strict=True)
    )
    document = replace(document, layers=(replace(layer, cels=replace(layer.cels, drawings=drawings)),))
    return with_values(document, {"shadow.shape": "disc"})


def round_cast(document: Document, frame: int = 1) -> ShadowCast:
    cast = evaluate(document, frame).layers[0].cast
    assert cast is not None
    assert cast.is_round
    return cast


def width(document: Document, frame: int = 1) -> float:
    """Return the width of the disc: what floats over the ground is as wide as what lies on it, seen straight on."""
    placement = round_cast(document, frame).placement
    assert placement is not None
    return 2 * DISC_RADIUS_PX * placement.scale[0]


def middle(document: Document, frame: int = 1) -> tuple[float, float]:
    x, y, z = round_cast(document, frame).card.contacts[0]
    return x, y + 0 * z


@pytest.mark.parametrize("has_feet", [True, False])
def test_on_a_canvas_that_is_scaled_the_disc_is_as_much_larger(*, has_feet: bool) -> None:
    document = standing([((500.0, 700.0), (560.0, 700.0))])
    if not has_feet:
        (layer,) = document.layers
        bare = tuple(replace(drawing, feet=None) for drawing in layer.cels.drawings)
        document = replace(document, layers=(replace(layer, cels=replace(layer.cels, drawings=bare)),))
    canvas = document.canvas
    twice = refitted(document, 2 * canvas.width_px, 2 * canvas.height_px, Refit.SCALE).document
    assert width(twice) == pytest.approx(2 * width(document), rel=1e-3)


def test_it_replaces_what_the_light_casts() -> None:
    plain = jumping(shadow__matte="translucent")
    cast, scene = round_cast(with_values(plain, {"shadow.shape": "disc"})), evaluate(plain, 1)
    assert [type(part) for part in cast.figure] == [Disc]
    assert cast.sources == ()
    assert cast.lights == ((*scene.ground.normal, 0.0),)
    assert not cast.translucent
    assert evaluate(with_values(plain, {"shadow.shape": "disc"}), 1).layers[0].drawing == scene.layers[0].drawing


def test_it_lies_under_the_feet_as_wide_as_artists_draw_it() -> None:
    document = standing([((480.0, 900.0), (540.0, 900.0))])
    assert middle(document) == pytest.approx((510.0, 900.0))
    # Of the two whose shadows were measured one drew 0.64 to 0.74 of the height, the other 0.48 to 0.59.
    assert 0.85 * 0.64 * TALL <= width(document) <= 1.15 * 0.59 * TALL
    placement = round_cast(document).placement
    assert placement is not None
    assert placement.scale[1] / placement.scale[0] == pytest.approx(cos(radians(TIPPED_DEG)))


def test_it_reaches_under_both_feet_of_a_wide_stance() -> None:
    narrow, wide = standing([((480.0, 900.0), (520.0, 900.0))]), standing([((300.0, 900.0), (700.0, 900.0))])
    assert width(wide) >= 400.0 + 2 * 0.04 * TALL
    assert width(narrow) < width(standing([((430.0, 900.0), (570.0, 900.0))])) < width(wide)


def test_it_does_not_depend_on_the_light() -> None:
    document = with_values(jumping(), {"shadow.shape": "disc"})
    for light in ({"light.kind": "point", "light.position": [0, 0, 500]}, {"light.elevation": -10.0}):
        assert round_cast(with_values(document, light)) == round_cast(document)


def test_a_foot_that_is_lost_for_a_drawing_hardly_moves_it() -> None:
    both, one = ((440.0, 900.0), (560.0, 900.0)), ((440.0, 900.0),)
    document = standing([both] * 8 + [one] + [both] * 8)
    widths = [width(document, frame) for frame in range(1, 18)]
    middles = [middle(document, frame)[0] for frame in range(1, 18)]
    assert max(abs(b / a - 1) for a, b in pairwise(widths)) < 0.02
    assert max(abs(b - a) for a, b in pairwise(middles)) < 0.02 * TALL


def test_a_kick_does_not_take_it_away() -> None:
    still, kick = ((450.0, 900.0), (550.0, 900.0)), ((450.0, 900.0), (700.0, 700.0))
    document = standing([still] * 8 + [kick] * 20 + [still] * 8)
    assert middle(document, 18)[0] == pytest.approx(450.0, abs=1.0)
    assert width(document, 18) < 0.7 * TALL


def test_it_stays_while_a_drawing_is_held() -> None:
    document = standing([((440.0 + 5 * index, 900.0), (560.0 + 5 * index, 900.0)) for index in range(6)])
    (layer,) = document.layers
    exposures = tuple(Exposure(1 + 3 * index, index) for index in range(6))
    layer = replace(layer, cels=replace(layer.cels, exposures=exposures))
    document = replace(document, layers=(layer,), canvas=replace(document.canvas, length_frames=18))
    casts = [round_cast(document, frame) for frame in range(1, 19)]
    assert all(casts[frame] == casts[frame - frame % 3] for frame in range(18))
    assert len(set(casts)) == 6


def test_it_shrinks_in_a_jump_and_stays_below() -> None:
    document = with_values(jumping(), {"shadow.shape": "disc", "shadow.lift_shrink": 0.5})
    widths = [width(document, frame) for frame in range(1, len(RISES) + 1)]
    assert widths[6] == pytest.approx(widths[0] * (1 - 0.5 * 120 / TALL))
    assert widths[3:7] == sorted(widths[3:7], reverse=True)
    assert len(set(widths[3:7])) == 4
    assert widths[9] == widths[3]
    assert middle(document, 7) == pytest.approx((500.0, GROUND))
    assert round_cast(document, 7).edge is not None
    assert round_cast(document, 1).edge is None


def test_a_figure_without_feet_has_one_too() -> None:
    cels = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0), Exposure(5, None)))
    document = edits.add_layer(jumping([0] * 8), "B", cels, Box(200, 300, 300, 700))
    document = with_values(document, {"shadow.shape": "disc"}, document.layers[1].id)
    casts = [evaluate(document, frame).layers[1].cast for frame in (1, 4, 5)]
    assert casts[0] == casts[1] is not None
    assert casts[2] is None
    assert casts[0] is not None
    assert casts[0].card.contacts[0] == pytest.approx((250.0, GROUND, 0.0))
    assert casts[0].placement is not None
    assert 2 * DISC_RADIUS_PX * casts[0].placement.scale[0] == pytest.approx(0.55 * 400)


@pytest.mark.parametrize("view", [{}, {"camera.fov": 50.0, "ground.roll": 10.0, "tilt": 20.0}])
def test_without_feet_it_goes_with_the_figure(view: dict[str, object]) -> None:
    """Along the contact line, and evenly, however the box around the figure changes from drawing to drawing."""
    document = with_values(jumping([0] * 17), {"shadow.shape": "disc", "stance": "line"} | view)
    (layer,) = document.layers
    boxes = [Box(300 + 20 * index, 500, 400 + 20 * index + 60 * (index % 2), 900) for index in range(17)]
    drawings = (replace(each, figure=box) for each, box in zip(layer.cels.drawings, boxes, strict=True))
    document = replace(document, layers=(replace(layer, cels=replace(layer.cels, drawings=tuple(drawings))),))
    columns = []
    for frame in range(7, 12):
        scene, place = evaluate(document, frame), round_cast(document, frame).card.contacts[0]
        columns.append(project(scene.camera.canvas_from_world(), (*place, 1.0))[0])
        line = contact_plane(evaluate(document, frame).layers[0].card, scene.ground)
        assert np.cross(np.subtract(place, line.origin), line.u) == pytest.approx([0, 0, 0], abs=1e-6)
    assert np.diff(columns) == pytest.approx([20.0] * 4, abs=5.0)
    assert columns[2] == pytest.approx(510.0 + 15.0, abs=5.0)


def test_grounding_points_carry_it() -> None:
    document = with_values(jumping(), {"shadow.shape": "disc", "grounding": [[300, 900], [420, 900]]})
    assert middle(document) == pytest.approx((360.0, 900.0))


def test_a_ground_seen_edge_on_shows_none() -> None:
    document = with_values(jumping(), {"shadow.shape": "disc", "ground.declination": 90})
    assert evaluate(document, 1).layers[0].cast is None


def test_it_falls_on_no_character_and_needs_no_file() -> None:
    document = with_values(jumping(), {"shadow.shape": "disc"})
    cels = Cels((Drawing("1", Path("/c/b.png")),), (Exposure(1, 0),))
    document = edits.add_layer(document, "B", cels, Box(200, 300, 300, 700))
    document = with_values(document, {"receives": True}, document.layers[1].id)
    lower, upper = evaluate(document, 1).layers
    assert upper.received is not None
    assert upper.received.shades == ()
    assert lower.drawing is not None
    assert without_drawings(lower, {lower.drawing.source}).cast == lower.cast
