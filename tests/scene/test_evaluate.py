"""From document and frame to the numbers that are drawn."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import sun
from kagezou.picture_source import PicturePart
from kagezou.scene.evaluate import contact_of, evaluate, light_at
from kagezou.scene.figure_card import card_at
from kagezou.scene.receiving import without_drawings
from kagezou.scene.scene import PlacedDrawing, ShadowLook
from tests.documents import documents

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0), Exposure(9, None)))


def document_with(**values: object) -> Document:
    """Return a one-layer document; keywords are property names with ``__`` for dots."""
    document = edits.add_layer(Document(Canvas(400, 300)), "A", CELS, Box(100, 50, 200, 250))
    for key, raw in values.items():
        name = key.replace("__", ".")
        address = Address(OF_DOCUMENT[name]) if name in OF_DOCUMENT else Address(OF_LAYER[name], "layer-1")
        document = edits.set_constant(document, address, raw)
    return document


def set_constant_on(document: Document, layer_id: str, **values: object) -> Document:
    for name, raw in values.items():
        document = edits.set_constant(document, Address(OF_LAYER[name], layer_id), raw)
    return document


def test_defaults() -> None:
    scene = evaluate(document_with(ground__position=[150, 250], light__position=[50, -100, 300]), 1)
    (layer,) = scene.layers
    assert scene.canvas == Box(0, 0, 400, 300)
    assert scene.camera == Camera(400, 300, 0.0)
    assert scene.ground == ground_plane((150.0, 250.0), 0.0, 60.0)
    assert scene.background is None
    assert (layer.id, layer.name, layer.drawing) == ("layer-1", "A", PlacedDrawing(CELS.drawings[0].source))
    assert layer.look == ShadowLook(color=(0x20, 0x20, 0x3A), opacity=0.6, multiply=True)
    assert layer.cast is not None
    assert layer.cast.lights == ((50.0, -100.0, 300.0, 1.0),)
    assert layer.cast.receivers == (scene.ground,)
    assert not layer.cast.translucent
    assert layer.cast.card.pieces[0].normal == (0.0, 0.0, 1.0)


def test_values_that_were_set() -> None:
    scene = evaluate(
        document_with(
            camera__fov=30,
            ground__position=[150, 250],
            ground__roll=5,
            ground__declination=70,
            shadow__matte="translucent",
            shadow__color="#010203",
            shadow__opacity=1,
            shadow__blend="normal",
            tilt=45,
        ),
        1,
    )
    (layer,) = scene.layers
    assert scene.camera.fov_deg == 30.0
    assert scene.ground == ground_plane((150.0, 250.0), 5.0, 70.0)
    assert layer.look == ShadowLook(color=(1, 2, 3), opacity=1.0, multiply=False)
    assert layer.cast is not None
    assert layer.cast.translucent
    assert layer.cast.card.pieces[0].normal == pytest.approx((-1.0, 0.0, 1.0))


def test_the_sun() -> None:
    document = document_with(light__kind="sun", light__azimuth=20, light__elevation=40)
    ground = evaluate(document, 1).ground
    assert light_at(document, 1, ground) == sun(ground, 20.0, 40.0)
    cast = evaluate(document, 1).layers[0].cast
    assert cast is not None
    assert cast.lights == (sun(ground, 20.0, 40.0),)
    below = evaluate(document_with(light__kind="sun", light__elevation=-5), 1).layers[0].cast
    assert below is not None
    assert below.lights == ()


def test_a_lamp_overhead_becomes_four() -> None:
    values = {"ground__position": [150, 250], "light__position": [150, -400, 0], "light__overhead_radius": 50}
    cast = evaluate(document_with(**values), 1).layers[0].cast
    assert cast is not None
    assert len(cast.lights) == 4
    beside = evaluate(document_with(**{**values, "grounding": [[350, 250]]}), 1).layers[0].cast
    assert beside is not None
    assert len(beside.lights) == 1


def test_the_contact_is_the_middle_of_the_grounding_points() -> None:
    document = document_with(ground__position=[150, 250], grounding=[[120, 250], [200, 250]])
    scene = evaluate(document, 1)
    card = card_at(document, document.layers[0], 1, scene.camera, scene.ground)
    assert contact_of(card, scene.ground) == pytest.approx((160.0, 250.0, 0.0))


def test_keyed_values_move() -> None:
    document = document_with()
    address = Address(OF_LAYER["shadow.opacity"], "layer-1")
    document = edits.set_key(edits.set_key(document, address, 1, 0), address, 5, 1)
    assert [evaluate(document, frame).layers[0].look.opacity for frame in (1, 2, 5, 8)] == [0.0, 0.25, 1.0, 1.0]


def test_hidden_layers_are_left_out_and_empty_cels_cast_nothing() -> None:
    document = document_with()
    visible = Address(OF_LAYER["visible"], "layer-1")
    blinking = edits.set_key(edits.set_key(document, visible, 1, raw=True), visible, 3, raw=False)
    assert len(evaluate(blinking, 2).layers) == 1
    assert evaluate(blinking, 3).layers == ()
    (empty,) = evaluate(document, 9).layers
    assert empty.drawing is None
    assert empty.cast is None


def test_layers_stay_in_their_order() -> None:
    document = edits.add_layer(document_with(), "B", CELS, Box(0, 0, 9, 9))
    assert [layer.name for layer in evaluate(document, 1).layers] == ["A", "B"]


@given(documents(), st.integers(1, 200))
@settings(deadline=None)
def test_every_sound_document_can_be_evaluated_and_equally_twice(document: Document, frame: int) -> None:
    scene = evaluate(document, frame)
    assert evaluate(document, frame) == scene
    shown = {layer.id for layer in scene.layers}
    for layer in document.layers:
        track = layer.tracks.get("visible")
        assert (layer.id in shown) == (track is None or track.value_at(frame))


class TestTiming:
    """A shadow on ones moves every frame; with the exposures it waits for the next drawing."""

    def lights(self, timing: str) -> list[object]:
        cels = Cels((Drawing("1", Path("/c/1.png")), Drawing("2", Path("/c/2.png"))), (Exposure(1, 0), Exposure(4, 1)))
        document = edits.add_layer(Document(Canvas(400, 300, length_frames=6)), "A", cels, Box(100, 50, 200, 250))
        light = Address(OF_DOCUMENT["light.position"])
        document = edits.set_key(document, light, 1, [0, -500, 900])
        document = edits.set_key(document, light, 6, [500, -500, 900])
        document = edits.set_constant(document, Address(OF_LAYER["shadow.timing"], "layer-1"), timing)
        casts = [evaluate(document, frame).layers[0].cast for frame in range(1, 7)]
        return [cast.lights for cast in casts if cast is not None]

    def test_on_ones(self) -> None:
        assert len(set(self.lights("ones"))) == 6

    def test_with_the_exposures(self) -> None:
        lights = self.lights("exposures")
        assert [lights.index(each) for each in lights] == [0, 0, 0, 3, 3, 3]
        ones = self.lights("ones")
        assert (lights[0], lights[3]) == (ones[0], ones[3])

    @pytest.mark.parametrize(
        ("part", "ends"),
        [
            ("look", {"shadow.opacity": (0.1, 0.9)}),
            ("look", {"shadow.color": ("#000000", "#FFFFFF")}),
            ("look", {"shadow.fade": (100.0, 600.0), "shadow.fade_curve": (1.0, 6.0)}),
            ("look", {"shadow.tip_distance": (100.0, 600.0), "shadow.tip_color": ("#000000", "#FFFFFF")}),
            ("card", {"tilt": (-50.0, 50.0)}),
            ("simplify", {"shadow.simplify": (10.0, 60.0)}),
            ("edge", {"shadow.softness": (1.0, 60.0)}),
            ("water", {"shadow.wave1.amplitude": (10.0, 60.0)}),
        ],
        ids=lambda value: value if isinstance(value, str) else "+".join(value),
    )
    def test_all_of_a_shadow_waits(self, part: str, ends: dict[str, tuple[object, object]]) -> None:
        """What is keyed of the look, the card and the filters changes with every frame, or with the drawings."""
        ones, waiting = self.seen(part, ends, "ones"), self.seen(part, ends, "exposures")
        assert len({repr(each) for each in ones}) == 6
        assert waiting == [ones[0]] * 3 + [ones[3]] * 3

    def seen(self, part: str, ends: dict[str, tuple[object, object]], timing: str) -> list[object]:
        cels = Cels((Drawing("1", Path("/c/1.png")), Drawing("2", Path("/c/2.png"))), (Exposure(1, 0), Exposure(4, 1)))
        document = edits.add_layer(Document(Canvas(400, 300, length_frames=6)), "A", cels, Box(100, 50, 200, 250))
        for name, values in {"shadow.timing": (timing, timing), **ends}.items():
            address = Address(OF_LAYER[name], "layer-1")
            for frame, value in zip((1, 6), values, strict=True):
                document = edits.set_key(document, address, frame, value)
        layers = [evaluate(document, frame).layers[0] for frame in range(1, 7)]
        return [getattr(layer if part == "look" else layer.cast, part) for layer in layers]


def test_a_layer_receives_the_plain_shadows_of_the_others() -> None:
    document = document_with(receives=True, light__position=[50, -100, 300], shadow__color="#FF0000")
    for name in "BC":
        document = edits.add_layer(document, name, CELS, Box(0, 0, 9, 9))
    fading = {"shadow.fade": 100, "shadow.simplify": 20, "shadow.tip_distance": 30}
    for name, value in fading.items():
        document = edits.set_constant(document, Address(OF_LAYER[name], "layer-2"), value)
    a, b, _ = evaluate(document, 1).layers
    assert b.received is None
    assert a.received is not None
    assert a.cast is not None
    assert (a.received.drawing, a.received.card) == (a.drawing, a.cast.card)
    (shade,) = a.received.shades
    assert shade.look == ShadowLook(color=(0x20, 0x20, 0x3A), opacity=0.6, multiply=True)
    assert [(cast.receivers, cast.is_filtered) for cast in shade.casts] == [((), False), ((), False)]
    apart = edits.set_constant(document, Address(OF_LAYER["shadow.opacity"], "layer-3"), 0.3)
    received = evaluate(apart, 1).layers[0].received
    assert received is not None
    assert [each.look.opacity for each in received.shades] == [0.6, 0.3]
    assert evaluate(document, 9).layers[0].received is None


def test_what_cannot_be_read_casts_on_nobody() -> None:
    document = document_with(receives=True, light__position=[50, -100, 300])
    other = Cels((Drawing("1", Path("/c/2.psd"), "A/1"),), (Exposure(1, 0),))
    for name, cels in (("B", CELS), ("C", other)):
        document = edits.add_layer(document, name, cels, Box(0, 0, 9, 9))
    layer = evaluate(document, 1).layers[0]
    assert without_drawings(layer, set()) is layer
    kept = without_drawings(layer, {PicturePart(Path("/c/2.psd"), "A/1")}).received
    assert kept is not None
    assert [cast.sources for shade in kept.shades for cast in shade.casts] == [(CELS.drawings[0].source,)]
    third = evaluate(set_constant_on(document, "layer-3", receives=True), 1).layers[2]
    nothing = without_drawings(third, {Path("/c/1.png")}).received
    assert nothing is not None
    assert nothing.shades == ()
    gone = without_drawings(layer, {Path("/c/1.png")})
    assert (gone.drawing, gone.cast, gone.received) == (None, None, None)
