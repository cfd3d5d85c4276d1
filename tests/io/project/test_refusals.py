"""What a stranger or a bad disk may put into a project file: each is refused in one sentence with its place."""

import json
from pathlib import Path
from typing import Any

import pytest

import kagezou
from kagezou.errors import ProjectProblem
from kagezou.io.project import file as project_file
from kagezou.io.project.file import dumps, load, loads, save
from tests.documents import FOLDER
from tests.io.project.small_project import Tree, refusal, small_document, small_tree

OWN = f"Kagezou {kagezou.__version__}"


def test_a_newer_project_names_the_version_it_needs() -> None:
    tree = {**small_tree(), "version": 99, "app_version": "7.2.0", "surprise": {}}
    said = refusal(tree)
    assert said == f"$.version: this project needs Kagezou 7.2.0 or newer (format version 99); this is {OWN}"


@pytest.mark.parametrize("made_by", [None, 7, "", "\u202e7.2", "7.2.0" * 100, "<b>7</b>"])
def test_a_newer_project_is_not_believed_whatever_it_says_of_its_program(made_by: object) -> None:
    said = refusal({**small_tree(), "version": 99, "app_version": made_by})
    assert said == f"$.version: this project needs a newer Kagezou (format version 99); this is {OWN}"


@pytest.mark.parametrize(
    ("content", "cause"),
    [
        (b"", "the file is empty"),
        (b" \n", "the file is empty"),
        (b"\xef\xbb\xbf", "the file is empty"),
        (b'{"format": "kagezou-project"', "it is not complete JSON text (line 1, column 29)"),
        (b'{"format": "\xff"}', "it is not UTF-8 text (byte 13)"),
        ("{}".encode("utf-16"), "it is not UTF-8 text (byte 1)"),
        (b"[" * 200_000, "it is nested too deep"),
        (b'{"a":' * 200_000, "it is nested too deep"),
        (b"[]", "$: it is not a Kagezou project"),
        (b"null", "$: it is not a Kagezou project"),
        (b'{"format": "other"}', "$: it is not a Kagezou project"),
        (b'{"format": "kagezou-project"}', "$.version: null is not a whole number from 1 to 1000000000"),
        (b'{"a": 1, "b": 2, "a": 3}', "the key 'a' stands twice in one object"),
        (b'{"a": NaN}', "NaN is not a number of a project"),
        (b'{"a": -Infinity}', "-Infinity is not a number of a project"),
        (b'{"a": 1e999}', "the number '1e999' is out of range"),
        (b'{"a": ' + b"9" * 5000 + b"}", "is out of range"),
        ('{"a": １２}'.encode(), "it is not complete JSON text"),
        (b'{"a": "\x01"}', "it is not complete JSON text"),
        (b"\x89PNG\r\n\x1a\n", "it is not UTF-8 text"),
        (b"<html></html>", "it is not complete JSON text (line 1, column 1)"),
    ],
)
def test_what_is_no_project_is_refused_in_one_sentence(content: bytes, cause: str, tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    path.write_bytes(content)
    with pytest.raises(ProjectProblem) as caught:
        load(path)
    said = str(caught.value)
    assert said.startswith(f"{path}: ")
    assert cause in said
    assert "\n" not in said


def test_a_cut_off_project_is_refused_wherever_it_ends(tmp_path: Path) -> None:
    data = dumps(small_document(), FOLDER).encode()
    path = tmp_path / "p.kage"
    for end in range(len(data) - 2):
        path.write_bytes(data[:end])
        with pytest.raises(ProjectProblem):
            load(path)


def test_a_missing_file_a_folder_and_an_impossible_name_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ProjectProblem, match=r"none\.kage: it does not exist"):
        load(tmp_path / "none.kage")
    with pytest.raises(ProjectProblem, match="it is not a file"):
        load(tmp_path)
    with pytest.raises(ProjectProblem, match="cannot be the name of a file"):
        load(tmp_path / "a\0b.kage")


def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    with path.open("wb") as stream:
        stream.truncate(project_file.MAX_BYTES + 1)
    with pytest.raises(ProjectProblem, match="it is larger than 32 MB"):
        load(path)


def test_an_unreadable_file_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "p.kage"
    save(small_document(tmp_path), path)

    def refuse(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(ProjectProblem, match=r"p\.kage: permission denied"):
        load(path)


def at(tree: Tree, place: str, value: object) -> Tree:
    """Return the tree with the value at a place such as ``layers.0.name`` replaced."""
    here: Any = tree
    *path, last = [int(part) if part.isdecimal() else part for part in place.split("/")]
    for part in path:
        here = here[part]
    here[last] = value
    return tree


KEYED = {"keys": [{"frame": 1, "value": 0.5, "interpolation": "linear"}]}


@pytest.mark.parametrize(
    ("place", "value", "said"),
    [
        ("version", True, "$.version: true is not a whole number from 1 to 1000000000"),
        ("version", 0, "$.version: 0 is not a whole number"),
        ("version", 1.0, "$.version: 1.0 is not a whole number"),
        ("version", "1", "$.version: '1' is not a whole number"),
        ("app_version", 3, "$.app_version: 3 is not a text"),
        ("surprise", 1, "$: the key 'surprise' is not known"),
        ("sur\nprise", 1, "$: the key 'sur\\nprise' is not known"),
        ("canvas", [], "$.canvas: a list of 0 is not an object"),
        ("canvas/width_px", True, "$.canvas.width_px: true is not a whole number from 1 to 16384"),
        ("canvas/width_px", 1e3, "$.canvas.width_px: 1000.0 is not a whole number"),
        ("canvas/width_px", "１２", "$.canvas.width_px: '１２' is not a whole number"),
        ("canvas/height_px", 16385, "$.canvas.height_px: 16385 is not a whole number from 1 to 16384"),
        ("canvas/length_frames", 0, "$.canvas.length_frames: 0 is not a whole number"),
        ("canvas/frame_rate", "24/0", "$.canvas.frame_rate: '24/0' is not a frame rate"),
        ("canvas/frame_rate", "２４", "$.canvas.frame_rate: '２４' is not a frame rate"),
        ("canvas/frame_rate", "0", "$.canvas.frame_rate: '0' is not a frame rate"),
        ("canvas/frame_rate", 24, "$.canvas.frame_rate: 24 is not a text"),
        ("background", "", "$.background: '' is not a text of 1 to 4096 characters"),
        ("background", "a\0b", "$.background: it cannot be the name of a file"),
        ("background", "a\ud800b", "$.background: it cannot be the name of a file"),
        ("background", "//server/share/a.png", "$.background: a project may not name files on the network"),
        ("background", "\\\\server\\share\\a.png", "$.background: a project may not name files on the network"),
        ("tracks", None, "$.tracks: null is not an object"),
        ("tracks/shadow.opacity", 0.5, "$.tracks['shadow.opacity']: there is no such property"),
        ("tracks/camera.fov", 121, "$.tracks['camera.fov']: 121 is not a number from 0 to 120 °"),
        ("tracks/camera.fov", True, "$.tracks['camera.fov']: True is not a number"),
        ("tracks/camera.fov", {"keys": []}, "$.tracks['camera.fov'].keys: it has 0 items"),
        ("tracks/camera.fov", {}, "$.tracks['camera.fov']: the key 'keys' is missing"),
        ("layers", {}, "$.layers: an object is not a list"),
        ("layers", [{}] * 1001, "$.layers: it has 1001 items, not 0 to 1000"),
        ("layers/0", 5, "$.layers[0]: 5 is not an object"),
        ("layers/0/name", " ", "$.layers[0].name: ' ' is not a printable name"),
        ("layers/0/name", "a\nb", "$.layers[0].name: 'a\\nb' is not a printable name"),
        ("layers/0/name", "a" * 201, "... is not a text of 1 to 200 characters"),
        ("layers/0/figure", [0, 0, 4], "$.layers[0].figure: it has 3 items, not 4"),
        ("layers/0/figure", [4, 0, 4, 4], "$.layers[0].figure: a list of 4 is not a box with pixels in it"),
        ("layers/0/drawings", [["1"]], "$.layers[0].drawings[0]: it has 1 items, not 2"),
        ("layers/0/drawings", [], "$.layers[0].exposures[0][1]: the layer has no drawings"),
        ("layers/0/exposures/0/1", 1, "$.layers[0].exposures[0][1]: 1 is not a whole number from 0 to 0"),
        ("layers/0/exposures/0/1", -1, "$.layers[0].exposures[0][1]: -1 is not a whole number from 0 to 0"),
        ("layers/0/exposures/1/0", 1, "$.layers[0].exposures[1][0]: frame 1 does not come after frame 1"),
        ("layers/0/tracks/tilt", "12", "$.layers[0].tracks.tilt: '12' is not a number from -75 to 75 °"),
        ("layers/0/tracks/shadow.opacity", KEYED, ""),
    ],
)
def test_a_wrong_value_is_named_with_its_place(place: str, value: object, said: str) -> None:
    tree = at(small_tree(), place, value)
    if said:
        assert said in refusal(tree)
    else:
        loads(json.dumps(tree), FOLDER)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"frame": 0}, "keys[0].frame: 0 is not a whole number from 1 to 1000000"),
        ({"frame": True}, "keys[0].frame: true is not a whole number"),
        ({"interpolation": "ease"}, "keys[0].interpolation: 'ease' is not one of hold, linear, bezier"),
        ({"interpolation": ["hold"]}, "keys[0].interpolation: a list of 1 is not one of"),
        ({"value": None}, "keys[0].value: None is not a number from 0 to 1"),
        ({"ease_in": [[0, 2]]}, "keys[0].ease_in[0][1]: 2 is not a number from 0 to 1"),
        ({"ease_out": [[0, 0.3]] * 2}, "keys[0].ease_out: it has 2 items, not 0 to 1"),
        ({"command": "rm"}, "keys[0]: the key 'command' is not known"),
    ],
)
def test_a_wrong_key_is_named_with_its_place(changes: dict[str, object], said: str) -> None:
    tree = small_tree()
    tree["layers"][0]["tracks"]["shadow.opacity"] = {"keys": [{**KEYED["keys"][0], **changes}]}
    assert "$.layers[0].tracks['shadow.opacity']." + said in refusal(tree)


def test_keys_out_of_order_and_moving_switches_are_refused() -> None:
    tree = small_tree()
    hold = {"frame": 2, "value": True, "interpolation": "hold"}
    tree["layers"][0]["tracks"]["visible"] = {"keys": [hold, {**hold, "frame": 1}]}
    assert "tracks.visible.keys[1].frame: frame 1 does not come after frame 2" in refusal(tree)
    tree["layers"][0]["tracks"]["visible"] = {"keys": [{**hold, "interpolation": "linear"}]}
    assert "tracks.visible.keys[0].interpolation: a switch or choice can only be held" in refusal(tree)


def test_layers_must_differ_in_id_and_name() -> None:
    tree = small_tree()
    tree["layers"] *= 2
    assert "two layers have the same id" in refusal(tree)
    tree["layers"][1] = {**tree["layers"][1], "id": "layer-2"}
    assert "two layers have the same name" in refusal(tree)


def test_rows_are_counted_over_the_whole_project(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kagezou.io.project.fields.MAX_ROWS", 3)
    assert loads(dumps(small_document(), FOLDER), FOLDER) == small_document()
    tree = small_tree()
    tree["layers"][0]["tracks"]["shadow.opacity"] = KEYED
    assert refusal(tree) == "$: more than 3 drawings, exposures and keys"


def test_a_key_is_missing() -> None:
    for name in ("app_version", "canvas", "background", "tracks", "layers"):
        tree = small_tree()
        del tree[name]
        assert refusal(tree) == f"$: the key '{name}' is missing"


def test_a_loaded_project_knows_its_constant_under_keys() -> None:
    tree = small_tree()
    tree["layers"][0]["tracks"]["shadow.opacity"] = KEYED
    assert loads(json.dumps(tree), FOLDER).layers[0].tracks["shadow.opacity"].constant == 0.5


# ---- what is said about the cut


@pytest.mark.parametrize(
    ("key", "value", "sentence"),
    [
        ("work_area", [5, 4], "$.work_area: frame 4 does not come after frame 5"),
        ("work_area", [0, 4], "$.work_area[0]: 0 is not a whole number from 1 to 1000000"),
        ("markers", [[5, "a", 0], [5, "b", 0]], "$.markers[1][0]: frame 5 does not come after frame 5"),
        ("markers", [[5, 7, 0]], "$.markers[0][1]: 7 is not a text of 0 to 4000 characters"),
        ("notes", [{"frame": 1}], "$.notes[0]: the key 'layer' is missing"),
    ],
)
def test_what_is_said_wrongly_about_a_cut_is_refused(key: str, value: object, sentence: str) -> None:
    assert refusal({**small_tree(), key: value}) == sentence


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"layer": "gone"}, "$.notes[0].layer: there is no such layer"),
        ({"layer": None}, "$.notes[0].property: 'tilt' is not one of "),
        ({"text": ""}, "$.notes[0].text: '' is not a text of 1 to 4000 characters"),
        ({"done": 1}, "$.notes[0].done: 1 is not true or false"),
        ({"answers": [["Kim"]]}, "$.notes[0].answers[0]: it has 1 items, not 2"),
        ({"answers": [["Kim", ""]]}, "$.notes[0].answers[0][1]: '' is not a text of 1 to 4000 characters"),
        ({"answers": [["", "a"]] * 201}, "$.notes[0].answers: it has 201 items"),
    ],
)
def test_a_note_about_nothing_is_refused(change: dict[str, object], sentence: str) -> None:
    note = {"frame": 1, "layer": "layer-1", "property": "tilt", "text": "Straighter", "author": ""}
    loads(json.dumps({**small_tree(), "notes": [note]}), FOLDER)
    assert refusal({**small_tree(), "notes": [{**note, **change}]}).startswith(sentence)
