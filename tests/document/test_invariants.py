"""What is never true of a document is found and named."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType

import pytest

from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document import invariants
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer
from kagezou.errors import ProjectProblem
from kagezou.geometry.box import Box

LAYER = Layer("a", "A", Cels((Drawing("1", Path("/1.png")),), (Exposure(1, 0),)), Box(0, 0, 4, 4))
MOVING_SWITCH = Key(2, value=False, interpolation=Interpolation.LINEAR)
SOUND = Document(Canvas(10, 10), layers=(LAYER,))


def with_tracks(name: str, track: Track) -> Document:
    table = MappingProxyType({name: track})
    if name.startswith(("shadow", "visible")):
        return replace(SOUND, layers=(replace(LAYER, tracks=table),))
    return replace(SOUND, tracks=table)


def with_exposures(*exposures: Exposure) -> Document:
    return replace(SOUND, layers=(replace(LAYER, cels=replace(LAYER.cels, exposures=exposures)),))


def test_a_sound_document_passes() -> None:
    invariants.check(SOUND)


@pytest.mark.parametrize(
    ("document", "said"),
    [
        (replace(SOUND, canvas=Canvas(0, 10)), "canvas: 0x10 is not within 1x1 to 16384x16384 px"),
        (replace(SOUND, canvas=Canvas(10, 20000)), "canvas: 10x20000 is not within"),
        (replace(SOUND, canvas=Canvas(10, 10, Fraction(0))), "canvas: 0 frames a second is not within 0 to 1000"),
        (replace(SOUND, canvas=Canvas(10, 10, length_frames=0)), "canvas: a cut of 0 frames is not within"),
        (replace(SOUND, layers=(LAYER, replace(LAYER, name="B"))), "layers: two layers have the same id"),
        (replace(SOUND, layers=(LAYER, replace(LAYER, id="b"))), "layers: two layers have the same name"),
        (with_exposures(Exposure(2, 0), Exposure(2, None)), "layers.A: exposures are out of order"),
        (with_exposures(Exposure(2, 1)), "layers.A: an exposure names a missing drawing"),
        (with_exposures(Exposure(2, -1)), "layers.A: an exposure names a missing drawing"),
        (with_tracks("camera.fov", Track(0.0, (Key(3, 1.0), Key(2, 1.0)))), "camera.fov: keys are out of order"),
        (with_tracks("camera.fov", Track(0.0, (Key(3, 1.0), Key(3, 1.0)))), "camera.fov: keys are out of order"),
        (with_tracks("camera.fov", Track(0.0, (Key(0, 1.0),))), "camera.fov: keys are out of order"),
        (with_tracks("camera.fov", Track(500.0)), "camera.fov: constant: camera.fov: 500.0 is not a number"),
        (with_tracks("shadow.color", Track("#abcdef")), "'#abcdef' is not kept in its canonical form"),
        (
            with_tracks("shadow.opacity", Track(0.0, (Key(2, 0.5), Key(4, 7.0)))),
            "layers.A.shadow.opacity: frame 4: shadow.opacity: 7.0 is not a number",
        ),
        (
            with_tracks(
                "visible", Track(constant=True, keys=(Key(2, value=False, interpolation=Interpolation.LINEAR),))
            ),
            "layers.A.visible: a switch or choice can only be held",
        ),
    ],
)
def test_what_is_not_sound_is_named(document: Document, said: str) -> None:
    with pytest.raises(ProjectProblem) as caught:
        invariants.check(document)
    assert said in str(caught.value)
