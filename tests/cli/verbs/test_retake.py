"""Retakes and drawings that were moved, from the command line."""

import json
from pathlib import Path

import pytest

from kagezou.io.project.file import load
from tests.cli.projects import Shell
from tests.importing.retakes.test_retake import poses


@pytest.fixture
def walk(shell: Shell, tmp_path: Path) -> Path:
    path = tmp_path / "walk.kage"
    drawings = poses(tmp_path / "walk", [1, 2, 3, 4], [1, 2, 3, 4])
    assert shell("new", path, "--character", f"Hero={drawings}") == 0
    return path


def test_a_retake_is_matched_saved_and_told(shell: Shell, walk: Path, tmp_path: Path) -> None:
    assert shell("set", walk, "layers.Hero.shadow.opacity=0.2", "--frame", "2") == 0
    assert shell("set", walk, "layers.Hero.shadow.opacity=0.8", "--frame", "4") == 0
    poses(tmp_path / "r2", [1, 0, 2, 3, 4], [1, 2, 3, 4, 5])
    assert shell("retake", walk, f"Hero={tmp_path / 'r2'}") == 0
    lines = shell.out.splitlines()
    assert "Hero: 2 keys went along with their drawings" in shell.said
    assert lines == ["Hero\t-\t2\tnew", "Hero\t2\t3\tpicture", "Hero\t3\t4\tpicture", "Hero\t4\t5\tpicture"]
    layer = load(walk).layers[0]
    assert [drawing.path.name for drawing in layer.cels.drawings] == [f"r2_{number:04}.png" for number in range(1, 6)]
    assert [key.frame for key in layer.tracks["shadow.opacity"].keys] == [3, 5]


def test_json_tells_everything_and_a_dry_run_changes_nothing(shell: Shell, walk: Path, tmp_path: Path) -> None:
    before = walk.read_bytes()
    poses(tmp_path / "r2", [1, 2, 4], [1, 2, 3])
    assert shell("retake", walk, f"Hero={tmp_path / 'r2'}", "--json", "--dry-run") == 0
    told = json.loads(shell.out)
    assert walk.read_bytes() == before
    assert told["saved"] is False
    (layer,) = told["layers"]
    assert layer["layer"] == "Hero"
    assert {"before": "3", "after": None, "how": "gone"} in layer["drawings"]
    assert layer["gone_frames"] == [], "the drawings behind it come forward"
    assert set(layer) == {
        "layer", "drawings", "contacts_moved", "look_at", "pins_kept", "pins_dropped", "keys_moved", "keys_dropped",
        "gone_frames", "unseen",
    }  # fmt: skip


def test_what_was_meant_is_named(shell: Shell, walk: Path, tmp_path: Path) -> None:
    assert shell("retake", walk, f"Hera={tmp_path / 'walk'}") == 2
    assert "there is no layer 'Hera' in this project; did you mean 'Hero'?" in shell.said
    assert shell("retake", walk, f"Hero={tmp_path / 'nowhere'}") == 3
    assert shell("retake", walk, "Hero") == 2


def test_moved_folders_are_found_again(shell: Shell, walk: Path, tmp_path: Path) -> None:
    assert shell("relink", walk) == 0
    assert "no drawing is missing" in shell.said
    moved = tmp_path / "server" / "cels" / "walk"
    moved.parent.mkdir(parents=True)
    (tmp_path / "walk").rename(moved)
    (moved / "walk_0003.png").rename(tmp_path / "lost.png")
    before = walk.read_bytes()
    assert shell("relink", walk, "--search", tmp_path / "server", "--dry-run") == 3
    assert walk.read_bytes() == before
    assert shell("relink", walk, "--json") == 3
    told = json.loads(shell.out)
    assert len(told["found"]) == 3
    assert [Path(path).name for path in told["missing"]] == ["walk_0003.png"]
    drawings = load(walk).layers[0].cels.drawings
    assert [drawing.path for drawing in drawings if drawing.path.is_file()] == [
        moved / f"walk_000{number}.png" for number in (1, 2, 4)
    ]
    assert shell("relink", walk, "--layer", "Nobody") == 2


def test_the_background_is_found_too_unless_a_layer_is_meant(shell: Shell, tmp_path: Path) -> None:
    poses(tmp_path / "walk", [1, 2], [1, 2])
    poses(tmp_path / "behind", [1], [1])
    picture = tmp_path / "behind" / "behind_0001.png"
    path = tmp_path / "with.kage"
    assert shell("new", path, "--character", f"Hero={tmp_path / 'walk'}", "--background", picture) == 0
    (tmp_path / "moved").mkdir()
    picture.rename(tmp_path / "moved" / picture.name)
    assert shell("relink", path, "--layer", "Hero") == 0
    assert load(path).background == picture
    assert shell("relink", path) == 0
    assert load(path).background == tmp_path / "moved" / picture.name
