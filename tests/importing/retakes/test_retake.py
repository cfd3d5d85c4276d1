"""Retakes in a document: what was set stays where it makes sense, and nothing is lost without a word."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import Address, track_of, value_of
from kagezou.document.edits import set_exposures, set_key
from kagezou.document.feet_edits import judge_foot, place_foot
from kagezou.document.layer_marks import LayerMarks
from kagezou.document.linking import link
from kagezou.document.marking import set_marks
from kagezou.document.model import Document, Exposure, Marker
from kagezou.document.paper import paper_of, set_paper
from kagezou.document.properties import LIGHT_POSITION, OPACITY
from kagezou.document.review import add_note, set_marker
from kagezou.errors import InputProblem, UsageProblem
from kagezou.importing.feet import document_with_feet
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.retakes.matching import How
from kagezou.importing.retakes.prints import print_of, prints_of
from kagezou.importing.retakes.retake import Retaken, read_retake, retaken
from kagezou.importing.staging import new_document
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.picture_source import Paper
from kagezou.standing.foot import Verdict
from tests.importing.cel_files import write_cel, write_walk

A = "layer-1"


@pytest.fixture
def walk(tmp_path: Path) -> Document:
    """Six drawings on ones, their feet found."""
    folder = poses(tmp_path / "walk", [1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6])
    document = new_document([CharacterSource("Walker", folder)]).document
    return document_with_feet(document, [A]).document


def retake(document: Document, folder: Path) -> Retaken:
    return retaken(document, A, read_retake(document, A, [CharacterSource(None, folder)]))


def poses(folder: Path, at: list[int], numbers: list[int]) -> Path:
    """Write poses of the walk (0 is none of them) under numbers."""
    for pose, number in zip(at, numbers, strict=True):
        x = 150 + 10 * pose
        parts = ((x, 100, x + 40, 200), (x, 200, x + 10, 250), (x + 30, 200, x + 40, 248))
        write_cel(folder / f"{folder.name}_{number:04}.png", (400, 300), *(parts if pose else [(20, 60, 260, 90)]))
    return folder


def words(done: Retaken) -> str:
    return "\n".join(str(note) for note in done.imported.notes)


def names(document: Document) -> list[str | None]:
    cels = document.layer(A).cels
    return [None if each.drawing is None else cels.drawings[each.drawing].path.stem for each in cels.exposures]


def test_the_same_drawings_in_another_folder_change_nothing_but_their_place(walk: Document, tmp_path: Path) -> None:
    done = retake(walk, poses(tmp_path / "new", [1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6]))
    before, after = walk.layer(A), done.imported.document.layer(A)
    assert after.cels.exposures == before.cels.exposures
    assert [drawing.feet for drawing in after.cels.drawings] == [drawing.feet for drawing in before.cels.drawings]
    assert after.figure == before.figure
    assert {row.how for row in done.report.rows} == {How.SAME}
    assert done.report.frames == ()
    assert done.imported.document.markers == ()
    assert "6 drawings are as before, 0 are other pictures, 0 are new, 0 are gone" in words(done)


def test_three_put_in_take_keys_and_notes_along(walk: Document, tmp_path: Path) -> None:
    opacity = Address(OPACITY, A)
    document = set_key(set_key(walk, opacity, 2, 0.2), opacity, 5, 0.8)
    document = set_key(document, Address(LIGHT_POSITION), 5, (1.0, 2.0, 3.0))
    document = add_note(document, opacity, 5, "Darker")
    done = retake(document, poses(tmp_path / "new", [1, 2, 0, 0, 0, 3, 4, 5, 6], list(range(1, 10))))
    after = done.imported.document
    assert [key.frame for key in track_of(after, opacity).keys] == [2, 8], "the pose of frame 5 is on 8 now"
    assert [note.frame for note in after.notes] == [8]
    assert [key.frame for key in track_of(after, Address(LIGHT_POSITION)).keys] == [5], "the scene is not the layer's"
    assert after.canvas.length_frames == 9
    assert done.report.keys_moved == 1
    assert done.report.frames == (3, 4, 5)
    assert [marker.frame for marker in after.markers] == [3], "one marker where a run of frames begins"
    assert "new drawings: " in words(done)
    assert "1 keys went along with their drawings" in words(done)


def test_two_gone_close_the_gap_and_a_key_that_has_no_place_is_said(walk: Document, tmp_path: Path) -> None:
    opacity = Address(OPACITY, A)
    document = walk
    for frame, value in ((2, 0.2), (3, 0.3), (4, 0.4), (5, 0.5)):
        document = set_key(document, opacity, frame, value)
    done = retake(document, poses(tmp_path / "new", [1, 2, 5, 6], [1, 2, 5, 6]))
    after = done.imported.document
    keys = track_of(after, opacity).keys
    assert [(key.frame, key.value) for key in keys] == [(2, 0.2), (3, 0.5)], "that of its own drawing counts"
    assert done.report.keys_dropped == (("shadow.opacity", 3), ("shadow.opacity", 4))
    assert "keys that came upon another key and are left out: shadow.opacity 3, shadow.opacity 4" in words(done)
    assert "drawings that are gone: 3, 4" in words(done)
    assert after.canvas.length_frames == 6, "the cut stays as long, and the last drawing is held"


def test_linked_properties_are_of_all_layers_and_stay(walk: Document, tmp_path: Path) -> None:
    opacity = Address(OPACITY, A)
    document = link(set_key(walk, opacity, 5, 0.8), opacity)
    done = retake(document, poses(tmp_path / "new", [0, 1, 2, 3, 4, 5, 6], list(range(1, 8))))
    assert [key.frame for key in track_of(done.imported.document, opacity).keys] == [5]


def test_pins_go_with_their_pictures(walk: Document, tmp_path: Path) -> None:
    feet = walk.layer(A).cels.drawings[3].feet or ()
    document = judge_foot(walk, A, 3, feet[0].track, Verdict.LIFTED)
    document = place_foot(document, A, 4, feet[0].track, (205.0, 251.0))
    done = retake(document, poses(tmp_path / "new", [0, 1, 2, 3, 4, 5, 6], list(range(101, 108))))
    drawings = done.imported.document.layer(A).cels.drawings
    assert [drawing.path.stem for drawing in drawings if drawing.pins] == ["new_0105", "new_0106"]
    pin = drawings[4].pins[0]
    assert pin.verdict is Verdict.LIFTED
    (of_pin,) = [foot for foot in drawings[4].feet or () if foot.track == pin.track]
    assert of_pin.place == feet[0].place, "it is about the same foot, however feet are numbered now"
    assert drawings[5].pins[0].place == (205.0, 251.0)
    assert (done.report.pins_kept, done.report.pins_dropped) == (2, ())


def test_pins_of_feet_that_are_gone_are_said(walk: Document, tmp_path: Path) -> None:
    feet = walk.layer(A).cels.drawings[1].feet or ()
    document = judge_foot(walk, A, 1, feet[0].track, Verdict.LIFTED)
    document = judge_foot(document, A, 5, feet[0].track, Verdict.LIFTED)
    done = retake(document, poses(tmp_path / "new", [1, 0, 3, 4, 5], [1, 2, 3, 4, 5]))
    assert done.report.pins_dropped == (("2", 1), ("6", 1))
    assert "words about feet that are not there any more: 2 (1), 6 (1)" in words(done)


def test_a_contact_that_moved_is_to_be_looked_at(walk: Document, tmp_path: Path) -> None:
    folder = poses(tmp_path / "new", [1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6])
    x = 150 + 30
    shifted = ((x, 100, x + 40, 200), (x, 200, x + 10, 254), (x + 30, 200, x + 40, 252))
    write_cel(folder / "new_0003.png", (400, 300), *shifted)
    done = retake(walk, folder)
    moved = {contact.frame: contact for contact in done.report.contacts}
    assert 3 in moved
    assert moved[3].drawing == "3"
    assert moved[3].away is None or moved[3].away > 0.01
    assert 3 in done.report.frames


def test_markers_that_are_there_stay(walk: Document, tmp_path: Path) -> None:
    document = set_marker(walk, Marker(2, "Impact"))
    done = retake(document, poses(tmp_path / "new", [1, 0, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6]))
    assert Marker(2, "Impact") in done.imported.document.markers
    assert 2 in done.report.frames


def test_name_marks_and_paper_of_the_layer_stay_and_the_sheet_times_it(walk: Document, tmp_path: Path) -> None:
    document = set_marks(set_paper(walk, A, Paper.BORDER), (A,), lambda _: LayerMarks(label="red"))
    document = set_exposures(document, A, (Exposure(1, 2), Exposure(4, None), Exposure(5, 0)))
    done = retake(document, poses(tmp_path / "new", [1, 2, 3], [1, 2, 3]))
    layer = done.imported.document.layer(A)
    assert (layer.name, layer.marks.label, paper_of(layer)) == ("Walker", "red", Paper.BORDER)
    assert names(done.imported.document) == ["new_0003", None, "new_0001"]
    assert done.report.unseen == ("2",)
    assert "no timing shows these: 2" in words(done)


def test_other_drawings_altogether_are_exposed_as_before(walk: Document, tmp_path: Path) -> None:
    for file in (tmp_path / "walk").iterdir():
        file.unlink()
    done = retake(walk, poses(tmp_path / "new", [1, 2, 3, 4], [11, 12, 13, 14]))
    assert [row.how for row in done.report.rows[:4]] == [None] * 4
    assert names(done.imported.document) == [f"new_{number:04}" for number in (11, 12, 13, 14)]


def test_a_layer_without_feet_stays_without(tmp_path: Path) -> None:
    folder = write_walk(tmp_path / "walk", [1, 2])
    document = new_document([CharacterSource("Walker", folder)]).document
    done = retake(document, poses(tmp_path / "new", [1, 2], [1, 2]))
    assert all(drawing.feet is None for drawing in done.imported.document.layer(A).cels.drawings)
    assert done.report.contacts == ()


def test_of_several_characters_the_first_counts_and_without_one_nothing_happens(walk: Document, tmp_path: Path) -> None:
    one, two = poses(tmp_path / "one", [1, 2], [1, 2]), poses(tmp_path / "two", [3], [3])
    sources = [CharacterSource("one", one), CharacterSource("two", two)]
    done = retaken(walk, A, read_retake(walk, A, sources))
    assert "a layer holds one character; left out: two" in words(done)
    with pytest.raises(UsageProblem, match="no drawings"):
        read_retake(walk, A, [])
    with pytest.raises(InputProblem):
        read_retake(walk, A, [CharacterSource(None, tmp_path / "nowhere")])


def test_a_layer_that_got_others_meanwhile_is_that_of_then(walk: Document, tmp_path: Path) -> None:
    read = read_retake(walk, A, [CharacterSource(None, poses(tmp_path / "new", [1, 2, 3], [1, 2, 3]))])
    meanwhile = retake(walk, poses(tmp_path / "other", [4], [4])).imported.document
    assert names(retaken(meanwhile, A, read).imported.document) == names(retaken(walk, A, read).imported.document)


def test_prints_tell_pixels_not_files(tmp_path: Path) -> None:
    first = write_cel(tmp_path / "a.png", (40, 30), (5, 5, 20, 25))
    second = tmp_path / "b.tif"
    write_rgba(second, read_cel(first).rgba)
    clear, broken = write_cel(tmp_path / "clear.png", (40, 30)), tmp_path / "broken.png"
    broken.write_bytes(b"no picture")
    found = prints_of([first, second, clear, broken])
    assert set(found) == {first, second, clear}
    assert found[first].digest == found[second].digest != found[clear].digest
    assert found[clear].ratio == 0
    assert found[first].ratio == 0.75
    assert found[first].sketch[..., 3].mean() == 1.0
    one_px = np.zeros((1, 1, 4), np.uint8)
    one_px[..., 3] = 255
    tiny = tmp_path / "tiny.png"
    write_rgba(tiny, one_px)
    assert print_of(read_cel(tiny)).sketch[..., 3].min() == 1.0


def test_a_value_of_the_layer_is_the_same_on_the_frames_of_its_drawings(walk: Document, tmp_path: Path) -> None:
    opacity = Address(OPACITY, A)
    document = set_key(set_key(walk, opacity, 1, 0.1), opacity, 6, 0.6)
    done = retake(document, poses(tmp_path / "new", [1, 2, 0, 3, 4, 5, 6], list(range(1, 8))))
    assert value_of(done.imported.document, opacity, 7) == 0.6
    assert replace(done.report, name="x").name == "x"


def test_where_a_sheet_shows_a_drawing_that_is_gone_the_one_before_is_held_and_that_is_said(
    walk: Document, tmp_path: Path
) -> None:
    document = set_exposures(walk, A, (Exposure(1, 0), Exposure(3, 2), Exposure(5, 1)))
    done = retake(document, poses(tmp_path / "new", [1, 2, 4, 5, 6], [1, 2, 4, 5, 6]))
    assert names(done.imported.document) == ["new_0001", "new_0002"]
    assert "where a drawing is gone the one before is held (frames 3)" in words(done)
