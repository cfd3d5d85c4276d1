"""Effects, fills and strokes of Photoshop layers: drawn with the packages of the extra ``psd``, told without them."""

import platform
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image
from psd_tools import PSDImage
from psd_tools.constants import Tag
from psd_tools.psd.descriptor import (
    Bool,
    Descriptor,
    DescriptorBlock2,
    Double,
    Enumerated,
    Integer,
    List,
    UnitFloat,
)
from psd_tools.terminology import Unit

from kagezou.io.images.reading import read_cel, read_matte
from kagezou.io.psd import undrawn as psd_undrawn
from kagezou.io.psd.file import psd_tree
from kagezou.io.psd.undrawn import drawn_by_extra
from kagezou.picture_source import PicturePart
from tests.psd_files import SIZE, Leaf, block, figure, on_canvas

needs_scipy = pytest.mark.skipif(find_spec("scipy") is None, reason="scipy, of the extra psd, is not installed")

NORMAL = Enumerated(b"BlnM", b"Nrml")
PERCENT_100 = UnitFloat(unit=Unit.Percent, value=100.0)
ON = Bool(True)  # noqa: FBT003 - psd-tools' own order
OFF = Bool(False)  # noqa: FBT003 - as above


def described(kind: bytes, values: Mapping[bytes, Any]) -> Descriptor:
    """Return a descriptor as a drawing program stores it."""
    made = Descriptor(classID=kind)
    for key, value in values.items():
        made[key] = value
    return made


def rgb(red: float, green: float, blue: float) -> Descriptor:
    return described(b"RGBC", {b"Rd  ": Double(red), b"Grn ": Double(green), b"Bl  ": Double(blue)})


def effect(kind: bytes, values: Mapping[bytes, Any] | None = None) -> Descriptor:
    """Return an effect that is switched on."""
    return described(kind, {b"enab": ON, b"present": ON, b"Md  ": NORMAL, b"Opct": PERCENT_100, **(values or {})})


def stroke(style: bytes, size_px: float) -> Descriptor:
    """Return a blue outline, outside (``OutF``) or inside (``InsF``)."""
    return effect(
        b"FrFX",
        {
            b"Styl": Enumerated(b"FStl", style),
            b"PntT": Enumerated(b"FrFl", b"SClr"),
            b"Sz  ": UnitFloat(unit=Unit.Pixels, value=size_px),
            b"Clr ": rgb(0, 0, 255),
        },
    )


def gradient() -> Descriptor:
    """Return an overlay that goes from red at the left to green at the right."""
    stops: Any = [
        described(
            b"Clrt",
            {b"Clr ": color, b"Type": Enumerated(b"Clry", b"UsrS"), b"Lctn": Integer(place), b"Mdpn": Integer(50)},
        )
        for place, color in ((0, rgb(255, 0, 0)), (4096, rgb(0, 255, 0)))
    ]
    colors = described(
        b"Grdn", {b"GrdF": Enumerated(b"GrdF", b"CstS"), b"Intr": Double(4096.0), b"Clrs": List(items=stops)}
    )
    values = {
        b"Grad": colors,
        b"Angl": UnitFloat(unit=Unit.Angle, value=0.0),
        b"Type": Enumerated(b"GrdT", b"Lnr "),
        b"Rvrs": OFF,
        b"Algn": ON,
        b"Scl ": PERCENT_100,
    }
    return effect(b"GrFl", values)


def written(path: Path, layers: Mapping[str, tuple[NDArray[np.uint8], list[Descriptor]]]) -> Path:
    """Write a file of layers at (9, 7), each with its effects."""
    image = PSDImage.new("RGBA", SIZE)
    for name, (pixels, effects) in layers.items():
        layer = image.create_pixel_layer(Image.fromarray(pixels, "RGBA"), name=name, left=9, top=7)
        listed = DescriptorBlock2(version=0, data_version=16, classID=b"null")
        listed[b"masterFXSwitch"] = ON
        for each in effects:
            listed[each.classID] = each
        layer.tagged_blocks.set_data(Tag.OBJECT_BASED_EFFECTS_LAYER_INFO, listed)
    image.save(path)
    return path


def test_effects_that_cannot_be_drawn_are_told_and_leave_the_layer_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(psd_undrawn, "_is_there", lambda _package: False)
    leaf = Leaf("1", figure(1), (9, 7))
    kinds = {"1": [effect(b"FrFX")], "2": [effect(b"DrSh")], "3": [], "4": [gradient(), effect(b"DrSh")]}
    path = written(tmp_path / "a.psd", {name: (leaf.pixels, effects) for name, effects in kinds.items()})
    told = [("Stroke",), ("DropShadow",), (), ("GradientOverlay", "DropShadow")]
    tree = psd_tree(path)
    assert [node.undrawn for node in tree.layers] == told
    for node in tree.layers:
        drawn = read_cel(PicturePart(path, node.address)).rgba
        assert np.array_equal(drawn[..., 3], on_canvas(leaf)[..., 3])
    # What was switched off for drawing is on again.
    assert [node.undrawn for node in psd_tree(path).layers] == told


def test_what_the_extra_would_draw_is_told_from_what_nothing_draws(monkeypatch: pytest.MonkeyPatch) -> None:
    names = ("DropShadow", "Stroke", "Vibrance", "ColorOverlay", "Curves", "GradientFill", "VectorStroke")
    monkeypatch.setattr(platform, "system", lambda: "Darwin")
    monkeypatch.setattr(platform, "machine", lambda: "arm64")
    assert drawn_by_extra(names) == ("Stroke", "ColorOverlay", "Curves", "GradientFill", "VectorStroke")
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    assert drawn_by_extra(names) == ("Stroke", "ColorOverlay", "Curves", "GradientFill")


@needs_scipy
def test_a_stroke_makes_the_silhouette_larger_or_not_as_it_lies(tmp_path: Path) -> None:
    pixels = block(20, 16)
    path = written(
        tmp_path / "a.psd", {"out": (pixels, [stroke(b"OutF", 4.0)]), "in": (pixels, [stroke(b"InsF", 4.0)])}
    )
    assert [node.undrawn for node in psd_tree(path).layers] == [(), ()]
    outside, inside = (read_cel(PicturePart(path, name)).rgba for name in ("out", "in"))
    matte = read_matte(PicturePart(path, "out"))
    assert matte.box is not None
    assert (matte.box.left, matte.box.top, matte.box.right, matte.box.bottom) == (5, 3, 33, 27)
    assert outside[15, 6].tolist() == [0, 0, 255, 255], "the outline beside the layer"
    assert outside[15, 10].tolist() == [200, 120, 40, 255], "the layer itself"
    assert np.array_equal(inside[..., 3], on_canvas(Leaf("", pixels, (9, 7)))[..., 3])
    assert inside[15, 10].tolist() == [0, 0, 255, 255]
    assert inside[15, 19].tolist() == [200, 120, 40, 255]


@needs_scipy
def test_a_gradient_overlay_colours_the_layer_within_its_silhouette(tmp_path: Path) -> None:
    leaf = Leaf("1", figure(3), (9, 7))
    path = written(tmp_path / "a.psd", {"1": (leaf.pixels, [gradient()])})
    assert psd_tree(path).layers[0].undrawn == ()
    drawn = read_cel(PicturePart(path, "1")).rgba
    assert np.array_equal(drawn[..., 3], on_canvas(leaf)[..., 3])
    red, green, blue, _ = np.moveaxis(drawn[15:31, 14:24].astype(int), -1, 0)
    assert (np.diff(red, axis=1) < 0).all()
    assert (np.diff(green, axis=1) > 0).all()
    assert not blue.any()
