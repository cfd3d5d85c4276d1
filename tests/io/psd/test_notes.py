"""What is said about PSD files: what is not used, what was assumed, and how far they are from their own picture."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageCms
from psd_tools import PSDImage
from psd_tools.constants import BlendMode, Resource
from psd_tools.psd.image_resources import ImageResource, VersionInfo

from kagezou.importing.cels_of_files import held_by
from kagezou.importing.new_cels import CharacterSource
from kagezou.io.images.reading import read_cel
from kagezou.io.psd.file import psd_notes, psd_tree
from kagezou.picture_source import PicturePart
from tests.psd_files import SIZE, Cut, Folder, Leaf, block, with_picture, write_flat, write_psd

BASE = Leaf("base", block(20, 20, (200, 100, 50, 255)), (10, 10))


def said(path: Path) -> str:
    return " | ".join(str(note) for note in psd_notes(path))


def test_a_file_that_is_drawn_as_it_was_saved_says_nothing(tmp_path: Path) -> None:
    assert said(write_psd(tmp_path / "a.psd", [BASE, Folder("A", [Leaf("1", block(9, 9))], opacity=128)])) == ""


def test_a_difference_from_the_saved_picture_is_said(tmp_path: Path) -> None:
    picture = np.asarray(PSDImage.open(write_psd(tmp_path / "b.psd", [BASE])).composite(force=True)).copy()
    assert picture.shape == (SIZE[1], SIZE[0], 4)
    picture[12:15, 12:16, 0] = 190
    words = said(with_picture(write_psd(tmp_path / "a.psd", [BASE]), picture))
    assert words == (
        "its layers, put together here, differ from the picture saved with them by up to 10 of 255 levels; "
        f"by more than 2 in {12 / (SIZE[0] * SIZE[1]):.1%} of the picture"
    )


@pytest.mark.parametrize("levels", [1, 2])
def test_rounding_is_no_difference(tmp_path: Path, levels: int) -> None:
    picture = np.asarray(PSDImage.open(write_psd(tmp_path / "b.psd", [BASE])).composite(force=True)).copy()
    picture[12:15, 12:16, 0] -= levels
    assert said(with_picture(write_psd(tmp_path / "a.psd", [BASE]), picture)) == ""


def test_a_file_without_layers_has_nothing_to_compare(tmp_path: Path) -> None:
    assert said(write_flat(tmp_path / "a.psd", Image.new("RGB", SIZE, (1, 2, 3)))) == ""


def test_layers_of_other_colours_are_not_compared_and_it_is_said(tmp_path: Path) -> None:
    image = PSDImage.new("CMYK", SIZE)
    image.create_pixel_layer(Image.new("CMYK", (9, 9), (9, 9, 9, 9)), name="1")
    image.save(tmp_path / "a.psd")
    assert "were not compared" in said(tmp_path / "a.psd")


CLIPPED: list[Leaf | Folder] = [BASE, Folder("shade", [Leaf("in", block(*SIZE, (10, 20, 30, 255)))], is_clipped=True)]


def test_a_clipped_group_is_cut_to_what_lies_below_it(tmp_path: Path) -> None:
    path = write_psd(tmp_path / "a.psd", CLIPPED)
    image = PSDImage.open(path)
    image.image_resources[Resource.VERSION_INFO.value] = ImageResource(
        key=Resource.VERSION_INFO.value, data=VersionInfo(has_composite=False).tobytes()
    )
    image.save(path)
    assert said(path).startswith("groups are clipped to the layer below them, as Clip Studio Paint does: shade")
    assert "no picture was saved with its layers" in said(path)
    made = read_cel(PicturePart(path, "base")).rgba
    assert made[15, 15].tolist() == [10, 20, 30, 255]
    assert made[..., 3].sum() == 255 * 400
    assert psd_tree(path).layers[1].is_clipped


def test_the_saved_picture_decides_whether_groups_are_clipped(tmp_path: Path) -> None:
    wanted = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    wanted[10:30, 10:30] = (10, 20, 30, 255)
    clips = with_picture(write_psd(tmp_path / "csp.psd", CLIPPED), wanted)
    assert said(clips) == "groups are clipped to the layer below them, as Clip Studio Paint does: shade"
    covers = with_picture(write_psd(tmp_path / "ps.psd", CLIPPED), block(*SIZE, (10, 20, 30, 255)))
    assert said(covers) == ""
    assert not psd_tree(covers).layers[1].is_clipped


def resource(key: Resource, data: bytes) -> Callable[[PSDImage], None]:
    def put(image: PSDImage) -> None:
        image.image_resources[key.value] = ImageResource(key=key.value, data=data)

    return put


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            resource(Resource.PLUGIN_RESOURCE_0, b"maniIRFR....FrInVlLs\0\0\0\7"),
            "its animation of 7 frames is not used",
        ),
        (resource(Resource.ALPHA_NAMES_PASCAL, b"\x04Mask"), "extra channels are not used: Mask"),
    ],
)
def test_what_a_file_has_beside_its_layers_is_said(
    tmp_path: Path, change: Callable[[PSDImage], None], words: str
) -> None:
    image = PSDImage.open(write_psd(tmp_path / "a.psd", [BASE], mode="RGB"))
    change(image)
    image.save(tmp_path / "a.psd")
    assert words in said(tmp_path / "a.psd")


def test_a_profile_that_is_not_srgb_is_said(tmp_path: Path) -> None:
    image = PSDImage.open(write_psd(tmp_path / "a.psd", [BASE]))
    for made, is_said in ((ImageCms.createProfile("sRGB"), False), (ImageCms.createProfile("XYZ"), True)):
        profile = ImageCms.ImageCmsProfile(made).tobytes()
        resource(Resource.ICC_PROFILE, profile)(image)
        image.save(tmp_path / "a.psd")
        assert ("is not used: colours are taken as sRGB" in said(tmp_path / "a.psd")) == is_said


def test_blending_by_brightness_is_said(tmp_path: Path) -> None:
    image = PSDImage.open(write_psd(tmp_path / "a.psd", [BASE]))
    image[0]._record.blending_ranges.composite_ranges = [(10, 65535), (0, 65535)]
    image.save(tmp_path / "a.psd")
    assert "blending by brightness is not done: base" in said(tmp_path / "a.psd")


def told(path: Path) -> str:
    return " | ".join(str(note) for note in held_by(CharacterSource(None, path)).notes)


def test_adjustments_beside_drawings_are_said_and_those_within_are_not(tmp_path: Path) -> None:
    path = write_psd(tmp_path / "a.psd", [Folder("A", [Leaf("1", block(9, 9)), Leaf("2", block(9, 9))]), BASE])
    image = PSDImage.open(path)
    from psd_tools.constants import Tag

    extra = image.create_pixel_layer(Image.new("RGBA", (1, 1)), name="x")
    extra.name = "Invert 1"
    extra.tagged_blocks.set_data(Tag.INVERT)
    image.save(path)
    assert "adjustment layers over drawings are not used: Invert 1" in told(path)
    assert "empty" not in told(path)


def test_ways_of_blending_with_what_is_below_are_said(tmp_path: Path) -> None:
    cels = [Leaf("1", block(9, 9)), Leaf("2", block(9, 9), blend=BlendMode.SCREEN)]
    path = write_psd(tmp_path / "a.psd", [BASE, Folder("A", cels, blend=BlendMode.MULTIPLY)])
    assert "these lie simply over what is below them here: A (multiply), 2 (screen)" in told(path)


def test_what_is_lost_of_a_clipped_layer_is_said_of_what_it_is_clipped_to(tmp_path: Path) -> None:
    from psd_tools.constants import Tag

    shade = Leaf("shade", block(*SIZE), is_clipped=True, cut=Cut(np.full((4, 4), 255, np.uint8)))
    path = write_psd(tmp_path / "a.psd", [BASE, shade])
    image = PSDImage.open(path)
    image[1].tagged_blocks.set_data(Tag.COLOR_BALANCE)
    image.save(path)
    (layer,) = held_by(CharacterSource(None, path)).layers
    assert any("ColorBalance" in str(note) for note in layer.notes)


def test_an_empty_picture_is_not_compared(tmp_path: Path) -> None:
    path = with_picture(write_psd(tmp_path / "a.psd", [BASE]), np.zeros((SIZE[1], SIZE[0], 4), np.uint8))
    assert said(path) == "the picture saved with its layers is empty, so they could not be compared with it"
