"""Patches of contact and reflections as layers of their own, in every kind of export."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_background
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.request import CONTACTS, REFLECTIONS, SHADOWS
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.io.psd.file import psd_tree
from kagezou.picture_source import PicturePart
from tests.export.after_effects.hand_offs import built, furthest, handed_off, names
from tests.export.small_cuts import HEIGHT, WIDTH, bytes_below, cut, export, with_key, with_values


@pytest.fixture
def plain(tmp_path: Path) -> Document:
    return with_values(cut(tmp_path / "in", count=4), layers__A__grounding=[[16, 36]])


@pytest.fixture
def companions(plain: Document) -> Document:
    """A block with a patch under it, mirrored in colours of its own."""
    return with_values(
        plain,
        **{
            "layers.A.grounding": [[16, 36]],
            "layers.A.contact.strength": 0.8,
            "layers.A.contact.size": 4.0,
            "layers.A.contact.softness": 0.0,
            "layers.A.reflection.opacity": 0.5,
            "layers.A.reflection.tone": 0.25,
        },
    )


def test_each_has_a_folder_of_its_own_where_it_is_asked_for(
    tmp_path: Path, plain: Document, companions: Document
) -> None:
    assert [folder.name for folder in export(plain, tmp_path / "no").folders] == ["A_shadow"]
    summary = export(companions, tmp_path / "out", composite=True)
    assert [folder.name for folder in summary.folders] == ["A_shadow", "A_contact", "A_reflection", "composite"]
    assert summary.files == 16
    patch = read_cel(tmp_path / "out/A_contact/A_contact_0001.png").rgba
    assert patch[..., 3].max() == round(0.8 * 255)
    assert patch[0, 0].tolist() == [0x20, 0x20, 0x3A, 0]
    mirrored = read_cel(tmp_path / "out/A_reflection/A_reflection_0001.png", white_is_clear=False).rgba
    assert mirrored[..., 3].max() == 128
    solid = mirrored[mirrored[..., 3] == 128]
    wanted = 0.75 * np.array([200, 120, 40]) + 0.25 * np.array([0x3A, 0x5A, 0x7A])
    assert np.abs(solid[:, :3] - wanted).max() <= 1


def test_each_may_be_asked_for_alone(tmp_path: Path, plain: Document, companions: Document) -> None:
    for only, name in ((SHADOWS, "A_shadow"), (CONTACTS, "A_contact"), (REFLECTIONS, "A_reflection")):
        assert [folder.name for folder in export(companions, tmp_path / only, only=only).folders] == [name]
    with pytest.raises(UsageProblem, match="there is nothing to render"):
        export(plain, tmp_path / "none", only=REFLECTIONS)


def test_frames_without_it_are_empty_and_the_sequence_has_no_gap(tmp_path: Path, companions: Document) -> None:
    for frame, value in ((1, 0.0), (3, 0.5)):
        companions = with_key(companions, "layers.A.reflection.opacity", frame, value)
    export(companions, tmp_path / "out", only=REFLECTIONS)
    shown = [read_cel(path).rgba[..., 3].max() for path in sorted((tmp_path / "out/A_reflection").glob("*.png"))]
    assert shown == [0, 64, 128, 128]
    assert export(companions, tmp_path / "out", only=REFLECTIONS, skip_existing=True).drawn == 0


def test_its_look_alone_draws_it_anew(tmp_path: Path, companions: Document) -> None:
    export(companions, tmp_path / "out")
    toned = with_values(companions, layers__A__reflection__tone=0.5)
    assert export(toned, tmp_path / "out", skip_existing=True).drawn == 4, "the reflections and no shadow"
    larger = with_values(toned, layers__A__contact__size=5.0)
    assert export(larger, tmp_path / "out", skip_existing=True).drawn == 1, "the patches, which stay"
    assert bytes_below(tmp_path / "out") == bytes_below_of(larger, tmp_path / "anew")


def bytes_below_of(document: Document, folder: Path) -> dict[str, bytes]:
    export(document, folder)
    return bytes_below(folder)


@pytest.mark.parametrize("per_drawing", [False, True])
def test_after_effects_shows_the_picture_and_keeps_the_opacity_for_itself(
    tmp_path: Path, companions: Document, *, per_drawing: bool
) -> None:
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    write_rgba(tmp_path / "ramp.png", ramp)
    keyed = with_key(set_background(companions, tmp_path / "ramp.png"), "layers.A.reflection.opacity", 1, 0.2)
    keyed = with_key(keyed, "layers.A.reflection.opacity", 4, 0.8)
    run = built(handed_off(keyed, tmp_path / "ae", per_drawing=per_drawing), tmp_path)
    assert names(run, "cut")[:5] == ["Background", "A shadow", "A contact", "A reflection", "A"]
    assert furthest(run, keyed, tmp_path) <= 1
    assert read_cel(tmp_path / "ae/shadows/A_contact/A_contact_0001.png").rgba[..., 3].max() == 255


def test_a_frame_of_layers_has_them_between_shadow_and_character(tmp_path: Path, companions: Document) -> None:
    export(companions, tmp_path / "out", layered=True, format="psd")
    frame = next((tmp_path / "out/layered").glob("*_0001.psd"))
    assert [node.name for node in psd_tree(frame).layers] == ["A_shadow", "A_contact", "A_reflection", "A"]
    alone = with_values(companions, layers__A__reflection__opacity=1.0, layers__A__contact__strength=1.0)
    export(alone, tmp_path / "alone")
    for name in ("A_contact", "A_reflection"):
        wanted = read_cel(tmp_path / f"alone/{name}/{name}_0001.png", white_is_clear=False).rgba
        found = read_cel(PicturePart(frame, name), white_is_clear=False).rgba
        # Its opacity is kept beside it, which a reader of one layer puts on.
        opacity = {"A_contact": 0.8, "A_reflection": 0.5}[name]
        assert np.abs(found[..., 3] - opacity * wanted[..., 3]).max() <= 1
        assert np.abs(found[..., :3].astype(int) - wanted[..., :3])[found[..., 3] > 0].max() <= 1
