"""Exports of scripts, and what comes after them."""

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import kagezou
from kagezou.export.after.hooks import COMMAND_VARIABLE
from kagezou.interface.cut import Cut
from kagezou.io.images.video import is_there


def test_frames(cut: Cut, tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    wish = kagezou.Frames(tmp_path / "out", frames="1-2", composite=True, skip_existing=True)
    came = cut.export(wish, progress=lambda done, whole: told.append((done, whole)))
    assert (came.is_whole, came.is_stopped, came.failures, came.where) == (True, False, (), tmp_path / "out")
    assert {(each.kind, each.layer, each.frame) for each in came.files} == {
        ("shadow", "Hero", 1),
        ("shadow", "Hero", 2),
        ("composite", None, 1),
        ("composite", None, 2),
    }
    assert told[-1] == (4, 4)
    assert all(each.is_new and each.path.is_file() and len(each.sha256 or "") == 64 for each in came.files)
    assert not any(each.is_new for each in cut.export(wish).files)


def test_names_of_files(cut: Cut, tmp_path: Path) -> None:
    came = cut.export(
        kagezou.Frames(tmp_path / "out", "2", names="{kind}/{layer}.{frame}", start_frame=1001, padding=5)
    )
    assert [(each.path, each.frame) for each in came.files] == [(tmp_path / "out" / "shadow" / "Hero.01002.png", 2)]
    with pytest.raises(kagezou.UsageProblem):
        cut.export(kagezou.Frames(tmp_path / "out", names="{mood}"))


def test_every_other_kind(cut: Cut, tmp_path: Path) -> None:
    layered = cut.export(kagezou.Frames(tmp_path / "l", layered=True, depth=16))
    assert {each.path.suffix for each in layered.files} == {".psd"}
    script = cut.export(kagezou.AfterEffects(tmp_path / "ae", name="comp"))
    assert script.where == tmp_path / "ae" / "comp.jsx"
    assert {each.kind for each in script.files} == {"shadow", "drawing", "script"}
    scene = cut.export(kagezou.SceneFor(tmp_path / "nk", "nuke"))
    assert scene.where.suffix == ".nk"
    assert scene.manifest()["export"] == {"kind": "nuke", "whole": True, "notes": []}
    with pytest.raises(kagezou.UsageProblem, match="only for"):
        cut.export(kagezou.SceneFor(tmp_path / "x", "harmony"))


@pytest.mark.skipif(not is_there(), reason="PyAV is not installed")
def test_a_video(cut: Cut, tmp_path: Path) -> None:
    came = cut.export(kagezou.Video(tmp_path / "a.mov", layer="Hero"))
    assert [each.path for each in came.files] == [tmp_path / "a.mov"]


def test_what_is_stopped_and_what_fails_is_told(cut: Cut, tmp_path: Path, drawings: Path) -> None:
    stopped = cut.export(kagezou.Frames(tmp_path / "out"), stop=lambda: True, after=print)
    assert (stopped.is_whole, stopped.is_stopped) == (False, True)
    assert any("not handed on" in note for note in stopped.notes)
    (drawings / "walk_0002.png").write_bytes(b"no picture")
    with pytest.raises(kagezou.InputProblem):
        cut.export(kagezou.Frames(tmp_path / "out"))
    came = cut.export(kagezou.Frames(tmp_path / "out", keep_going=True))
    ((frames, why),) = came.failures
    assert (came.is_whole, came.is_stopped, frames) == (False, False, (2,))
    assert "walk_0002.png" in why


def test_what_stands_in_for_a_missing_drawing(cut: Cut, tmp_path: Path, drawings: Path) -> None:
    (drawings / "walk_0002.png").unlink()
    with pytest.raises(kagezou.InputProblem, match="missing"):
        cut.export(kagezou.Frames(tmp_path / "out"))
    for word, said in (("empty", "left empty"), ("hold", "is held")):
        came = cut.export(kagezou.Frames(tmp_path / word, missing=word))
        assert came.is_whole
        assert any(said in note for note in came.notes)
    for wish in (
        kagezou.Video(tmp_path / "a.mov", missing="hold"),
        kagezou.AfterEffects(tmp_path / "ae", missing="hold"),
        kagezou.SceneFor(tmp_path / "nk", "nuke", missing="hold"),
    ):
        with pytest.raises(kagezou.InputProblem, match="walk_0002"):
            cut.export(replace(wish, missing="fail"))
        came = cut.export(wish)
        assert came.is_whole
        assert any("is held" in note for note in came.notes)
    with pytest.raises(kagezou.UsageProblem, match="missing is one of fail, empty, hold, not 'none'"):
        cut.export(kagezou.Frames(tmp_path / "out", missing="none"))


def refuse(manifest: Mapping[str, Any]) -> None:
    raise KeyError(manifest["project"]["cut"])


def test_what_comes_after(cut: Cut, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    taken: list[Mapping[str, Any]] = []
    came = cut.export(kagezou.Frames(tmp_path / "out"), after=taken.append)
    assert [each["path"] for each in taken[0]["files"]] == [str(each.path) for each in came.files]
    assert json.loads(json.dumps(came.manifest()))["project"]["file"] == str(cut.path)
    with pytest.raises(kagezou.HandingOnFailed, match="the export is whole, but refuse failed: ") as raised:
        cut.export(kagezou.Frames(tmp_path / "out"), after=refuse)
    assert raised.value.exported.is_whole
    failing = tmp_path / "fail.py"
    failing.write_text("raise SystemExit('no such shot')")
    with pytest.raises(kagezou.HandingOnFailed, match="no such shot") as found:
        cut.export(kagezou.Frames(tmp_path / "out"), after=f"'{failing}'")
    assert found.value.exported.is_whole
    assert found.value.code == 9
    fine = tmp_path / "fine.py"
    fine.write_text("print('taken')")
    monkeypatch.setenv(COMMAND_VARIABLE, f"'{fine}'")
    assert cut.export(kagezou.Frames(tmp_path / "out")).notes == ("handed on to fine.py: taken",)
    assert cut.export(kagezou.Frames(tmp_path / "out"), after="").notes == ()
