"""Documents of Open Cel Animation: as specified, as programs bend them, and what is said of the rest."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kagezou.errors import InputProblem
from kagezou.io.oca.document import OcaDocument
from kagezou.io.oca.reading import oca_file, read_oca


def frame(number: int, duration: int = 1, name: str = "", **more: Any) -> dict[str, Any]:
    name = name or f"a_{number:05d}"
    return {"name": name, "fileName": f"a/{name}.png", "frameNumber": number, "duration": duration, **more}


def layer(name: str = "a", *frames: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"name": name, "frames": list(frames) or [frame(0)], "type": "paintlayer", "animated": True, **more}


def document(*layers: dict[str, Any], **more: Any) -> dict[str, Any]:
    root = {"frameRate": 12, "width": 64, "height": 48, "startTime": 0, "endTime": 8, "layers": list(layers)}
    return {key: value for key, value in {**root, **more}.items() if value is not None}


def read(folder: Path, value: Any, encoding: str = "utf-8") -> OcaDocument:
    path = folder / "cut.oca"
    path.write_bytes((value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)).encode(encoding))
    return read_oca(path)


def said(found: OcaDocument) -> list[str]:
    return [str(note) for note in found.notes]


def test_a_plain_document_is_read_whole_and_without_a_word(tmp_path: Path) -> None:
    blank = {"name": "_blank", "fileName": "", "frameNumber": 4, "duration": 2, "opacity": 1.0}
    placed = frame(1, 3, position=[32, 24], width=10, height=6, opacity=1.0)
    found = read(tmp_path, document(layer("影 A", placed, blank), name="カット"))
    assert (found.name, found.frame_rate, found.size_px, found.length_frames) == ("カット", Fraction(12), (64, 48), 8)
    (only,) = found.layers
    assert (only.name, only.group) == ("影 A", ())
    first, second = only.frames
    assert (first.frame, first.duration_frames, first.name, first.middle_px) == (2, 3, "a_00001", (32.0, 24.0))
    assert (first.file, first.size_px) == (tmp_path / "a" / "a_00001.png", (10, 6))
    assert (second.frame, second.duration_frames, second.file) == (5, 2, None)
    assert said(found) == []


@pytest.mark.parametrize(
    ("rate", "wanted"), [(23.976023976, Fraction(24000, 1001)), (12.5, Fraction(25, 2)), (29.97, Fraction(30000, 1001))]
)
def test_rates_are_those_that_are_meant(rate: float, wanted: Fraction, tmp_path: Path) -> None:
    assert read(tmp_path, document(layer(), frameRate=rate)).frame_rate == wanted


def test_what_is_missing_is_as_usual_and_said(tmp_path: Path) -> None:
    found = read(tmp_path, {"layers": [{"name": "a", "frames": [{"name": "one", "frameNumber": 0}]}]})
    assert (found.size_px, found.frame_rate, found.length_frames) == ((1920, 1080), Fraction(24), 240)
    assert [note for note in said(found) if "does not say its" in note] == [
        "it does not say its width; 1920 was taken",
        "it does not say its height; 1080 was taken",
        "it does not say its startTime; 0 was taken",
        "it does not say its endTime; 240 was taken",
        "it does not say its frameRate; 24 was taken",
    ]
    assert found.layers[0].frames[0].file == tmp_path / "a" / "one.png", "as the specification has it"


@pytest.mark.parametrize(("last", "length"), [(7, 8), (8, 9), (12, 8)])
def test_the_end_is_the_last_frame_or_the_one_behind_it(last: int, length: int, tmp_path: Path) -> None:
    assert read(tmp_path, document(layer("a", frame(0), frame(last)))).length_frames == length


def test_a_start_moves_all_frames(tmp_path: Path) -> None:
    found = read(
        tmp_path, document(layer("a", frame(99), frame(95, 3), frame(98), frame(102)), startTime=100, endTime=104)
    )
    assert [(each.frame, each.duration_frames) for each in found.layers[0].frames] == [(3, 1)]
    assert said(found) == ["a: what is before the document's first frame is not used"]
    held = read(tmp_path, document(layer("a", frame(98, 4)), startTime=100, endTime=104))
    assert [(each.frame, each.duration_frames) for each in held.layers[0].frames] == [(1, 2)]
    assert said(held) == []


def test_frames_in_disorder_are_ordered_and_of_two_the_later_one_counts(tmp_path: Path) -> None:
    found = read(tmp_path, document(layer("a", frame(4), frame(0, name="x"), frame(4, name="y"))))
    assert [(each.frame, each.name) for each in found.layers[0].frames] == [(1, "x"), (5, "y")]
    assert said(found) == ["a: two frames begin at 5; the later one is used"]


def test_a_still_is_seen_for_the_whole_document(tmp_path: Path) -> None:
    found = read(tmp_path, document(layer("a", frame(3), animated=False)))
    assert [(each.frame, each.duration_frames) for each in found.layers[0].frames] == [(1, 0)]


@pytest.mark.parametrize(
    ("more", "note"),
    [
        ({"visible": False}, "left out, as they are hidden: b"),
        ({"visible": 0}, "left out, as they are hidden: b"),
        ({"reference": True}, "left out, as they are guides: b"),
        ({"inheritAlpha": True}, "left out, as they are cut to what is below them: b"),
        ({"blendingMode": "multiply"}, "left out, as they do not lie plainly on what is below them: b (multiply)"),
        ({"type": "vectorlayer"}, "left out, as they are of a kind that is not read: b (vectorlayer)"),
        ({"type": "fxlayer"}, "left out, as they are of a kind that is not read: b (fxlayer)"),
        ({"frames": []}, "left out, as they are empty: b"),
        ({"frames": [{"name": "_blank", "frameNumber": 0}]}, "left out, as they are empty: b"),
    ],
)
def test_what_is_left_out_is_said(more: dict[str, Any], note: str, tmp_path: Path) -> None:
    found = read(tmp_path, document(layer(), {**layer("b"), **more}))
    assert [each.name for each in found.layers] == ["a"]
    assert said(found) == [note]


def test_what_is_not_used_of_layers_is_said(tmp_path: Path) -> None:
    half = layer("b", frame(0, opacity=0.5))
    by_layer = layer("c", opacity=0.25)
    red = read(tmp_path, document(layer("a", opacity=0.5), half, by_layer, backgroundColor=[1.0, 0, 0, 1.0]))
    assert said(red) == [
        "the opacity of these layers is not used: a, b, c",
        "its background colour is not used",
    ]
    clear = read(tmp_path, document(layer("a", frame(0, opacity=1.0), opacity=0.5), backgroundColor=[0, 0, 0, 0]))
    assert said(clear) == [], "the opacity of a frame is that of its layer there"


def test_groups_are_opened_and_hide_what_is_in_them(tmp_path: Path) -> None:
    def group(name: str, *children: dict[str, Any], **more: Any) -> dict[str, Any]:
        return {"name": name, "type": "grouplayer", "frames": [], "childLayers": list(children), **more}

    deep = group("Hero", layer("line"), group("arms", layer("left"), passThrough=True, blendingMode="multiply"))
    found = read(tmp_path, document(deep, group("notes", layer("b"), visible=False)))
    assert [(each.name, each.group) for each in found.layers] == [("line", ("Hero",)), ("left", ("Hero", "arms"))]
    assert said(found) == ["left out, as they are hidden: notes"]


@pytest.mark.parametrize("place", ["cut.oca/a/a_00000.png", "a\\a_00000.png", "a_00000.png"])
def test_pictures_are_found_where_programs_say(place: str, tmp_path: Path) -> None:
    folder = tmp_path / "cut.oca"
    at = folder if place == "a_00000.png" else folder / "a"
    at.mkdir(parents=True)
    (at / "a_00000.png").write_bytes(b"")
    found = read(folder, document(layer("a", frame(0) | {"fileName": place})))
    assert found.layers[0].frames[0].file == at / "a_00000.png"


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "cp932"])
def test_other_encodings_are_read_too(encoding: str, tmp_path: Path) -> None:
    assert read(tmp_path, document(layer("影")), encoding).layers[0].name == "影"


def test_a_folder_stands_for_the_document_in_it(tmp_path: Path) -> None:
    folder = tmp_path / "Cut.OCA"
    folder.mkdir()
    assert oca_file(folder) is None
    for name in ("other.json", "b.oca", "Cut.json"):
        (folder / name).write_text("{}", encoding="utf-8")
    assert oca_file(folder) == folder / "Cut.json"
    (folder / "Cut.json").unlink()
    assert oca_file(folder) == folder / "b.oca"
    assert oca_file(tmp_path / "a.oca") == tmp_path / "a.oca"
    assert oca_file(tmp_path) is None


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "the file is empty"),
        ("[1, 2]", "is not an object"),
        ("{", "not complete JSON"),
        ('{"layers": {}}', "is not a list"),
        ('{"width": 64}', "the key 'layers' is missing"),
        ('{"layers": [], "width": 0}', "is not a whole number from 1"),
        ('{"layers": [], "frameRate": -1}', "is not a number from 0"),
        ('{"layers": [], "frameRate": 0}', "is not a number of frames a second"),
        ('{"layers": [], "startTime": 9, "endTime": 3}', "is not a whole number from 9"),
        ('{"layers": [{"frames": [{"position": [1]}]}]}', "it has 1 items, not 2"),
        ('{"layers": [{"frames": [{"frameNumber": "x"}]}]}', "is not a whole number"),
    ],
)
def test_what_is_no_document_is_refused_with_its_place(text: str, why: str, tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match=r"cut\.oca: ") as refused:
        read(tmp_path, text)
    assert why in str(refused.value)


def test_what_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match="it does not exist"):
        read_oca(tmp_path / "none.oca")
