"""What a jump does to a shadow's opacity: part of the shadow's frames, and of no matte."""

import pytest

from kagezou.export.after_effects.mattes import at_full_opacity, matte_document
from kagezou.scene.evaluate import evaluate
from tests.scene.jumps import jumping

PEAK = 7


@pytest.mark.parametrize("matte", ["shadow", "core", "distance"])
def test_mattes_are_full_in_the_air(matte: str) -> None:
    document = matte_document(jumping(), matte)
    assert evaluate(document, PEAK).layers[0].look.opacity == 1.0


def test_frames_hold_what_the_height_makes_of_opacity() -> None:
    document = at_full_opacity(jumping(shadow__lift_fade=0.5))
    opacities = [evaluate(document, frame).layers[0].look.opacity for frame in (1, PEAK)]
    assert opacities == pytest.approx([1.0, 1 - 0.5 * 120 / 400])
