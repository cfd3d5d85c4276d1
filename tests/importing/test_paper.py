"""The paper that is chosen for drawings without alpha."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from kagezou.importing.cels_of_files import held_by
from kagezou.importing.new_cels import CharacterSource
from kagezou.io.images.reading import read_cel
from kagezou.picture_source import Paper


def write(path: Path, *, shirt: int = 0, frame: bool = False, mode: str = "RGB") -> None:
    """Draw a figure of 30 × 60 px on white, with a white shirt of so many rows, perhaps in a frame."""
    pixels = np.full((90, 80, 3), 255, np.uint8)
    pixels[15:75, 25:55] = (190, 120, 60)
    pixels[30 : 30 + shirt, 30:50] = 255
    if frame:
        pixels[[0, -1]] = pixels[:, [0, -1]] = 0
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(pixels).convert(mode).save(path)


def chosen(path: Path) -> tuple[Paper, list[str]]:
    (layer,) = held_by(CharacterSource("Hero", path)).layers
    (paper,) = {drawing.paper for drawing in layer.cels.drawings}
    return paper, [str(note) for note in layer.notes]


def test_a_white_shirt_stays(tmp_path: Path) -> None:
    for number in (1, 2):
        write(tmp_path / "A" / f"a_{number}.png", shirt=12)
    paper, (note,) = chosen(tmp_path / "A")
    assert paper is Paper.BORDER
    assert note.startswith("Hero: its drawings have no alpha; white inside their outlines stays")
    assert "layers.Hero.paper" in note
    (layer,) = held_by(CharacterSource("Hero", tmp_path / "A")).layers
    cel = read_cel(layer.cels.drawings[0].source)
    assert cel.matte.whole()[30:42, 30:50].min() == 255
    assert cel.matte.whole()[:15].max() == 0


def test_the_gap_between_arm_and_body_is_clear_as_before(tmp_path: Path) -> None:
    write(tmp_path / "a.png", shirt=2)
    assert chosen(tmp_path / "a.png") == (
        Paper.WHITE,
        ["Hero: its drawings have no alpha; pure white is taken as clear"],
    )


def test_the_first_drawings_decide_together(tmp_path: Path) -> None:
    for number, shirt in enumerate((0, 0, 20, 40, 40), start=1):
        write(tmp_path / "A" / f"a_{number}.png", shirt=shirt)
    assert chosen(tmp_path / "A")[0] is Paper.BORDER
    write(tmp_path / "A" / "a_3.png", shirt=6)
    assert chosen(tmp_path / "A")[0] is Paper.WHITE


def test_a_frame_around_the_picture_is_no_outline(tmp_path: Path) -> None:
    write(tmp_path / "a.png", frame=True)
    assert chosen(tmp_path / "a.png")[0] is Paper.WHITE


def test_drawings_with_alpha_are_no_matter_of_paper(tmp_path: Path) -> None:
    write(tmp_path / "a.png", shirt=20, mode="RGBA")
    assert chosen(tmp_path / "a.png") == (Paper.WHITE, [])


@pytest.mark.parametrize("first_is_whole", [True, False])
def test_drawings_that_cannot_be_opened_are_passed_over(tmp_path: Path, *, first_is_whole: bool) -> None:
    numbers = (1, 2) if first_is_whole else (2, 1)
    write(tmp_path / "A" / f"a_{numbers[0]}.png", shirt=12)
    (tmp_path / "A" / f"a_{numbers[1]}.png").write_bytes(b"no picture")
    assert chosen(tmp_path / "A")[0] is Paper.BORDER
