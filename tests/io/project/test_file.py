"""The project file: what is saved loads equal, and nothing that a stranger writes does harm."""

import json
import os
import stat
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

import pytest
from hypothesis import given, settings

from kagezou.animation.track import Track
from kagezou.document.model import Canvas, Cels, Document, Layer
from kagezou.errors import OutputProblem, ProjectProblem
from kagezou.geometry.box import Box
from kagezou.io.project.file import dumps, load, loads, save
from kagezou.io.project.format import DESCRIPTION, description
from kagezou.io.project.versions import BROUGHT, CURRENT, UPGRADES, FormatVersion
from tests.documents import FOLDER, documents
from tests.io.project.small_project import small_document

DATA = Path(__file__).parent / "data"


# ---- round trip


@given(documents())
@settings(deadline=None)
def test_what_is_saved_loads_equal_and_saves_the_same_text(document: Document) -> None:
    text = dumps(document, FOLDER)
    loaded = loads(text, FOLDER)
    assert loaded == document
    assert dumps(loaded, FOLDER) == text
    text.encode("utf-8")


def test_the_text_is_made_for_comparing_by_line() -> None:
    text = dumps(small_document(), FOLDER)
    assert list(json.loads(text))[:3] == ["format", "version", "app_version"]
    assert text.endswith("}\n")
    assert "\r" not in text
    assert '        ["1", "A/A_0001.png"]\n' in text
    assert "        [1, 0],\n        [3, null]\n" in text
    assert '        "tilt": 12.5\n' in text


def test_the_order_of_edits_does_not_show() -> None:
    there = MappingProxyType({"tilt": Track(1.0), "shadow.opacity": Track(0.5)})
    back = MappingProxyType(dict(reversed(list(there.items()))))
    texts = {
        dumps(Document(Canvas(4, 4), layers=(Layer("a", "A", Cels(), Box(0, 0, 1, 1), tracks),)), FOLDER)
        for tracks in (there, back)
    }
    assert len(texts) == 1


def test_a_project_moves_with_its_folder(tmp_path: Path) -> None:
    (tmp_path / "one").mkdir()
    save(small_document(tmp_path / "one"), tmp_path / "one/p.kage")
    (tmp_path / "one").rename(tmp_path / "two")
    loaded = load(tmp_path / "two/p.kage")
    assert loaded == small_document(tmp_path / "two")


def test_a_relative_project_path_gives_absolute_pictures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    save(small_document(tmp_path), Path("p.kage"))
    assert load(Path("p.kage")) == small_document(tmp_path)


def test_a_byte_order_mark_and_windows_line_ends_are_read() -> None:
    text = "\ufeff" + dumps(small_document(), FOLDER).replace("\n", "\r\n")
    assert loads(text, FOLDER) == small_document()


def test_saving_keeps_the_previous_file(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    save(small_document(tmp_path), path)
    first = path.read_bytes()
    save(Document(Canvas(5, 5)), path)
    assert (tmp_path / "p.kage~").read_bytes() == first
    assert sorted(each.name for each in tmp_path.iterdir()) == ["p.kage", "p.kage~"]


def test_saving_into_no_folder_is_a_problem_of_output(tmp_path: Path) -> None:
    with pytest.raises(OutputProblem, match="its folder does not exist"):
        save(small_document(), tmp_path / "none/p.kage")


def test_a_document_that_would_not_load_is_not_saved(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    save(small_document(tmp_path), path)
    before = path.read_bytes()
    with pytest.raises(ProjectProblem, match=r"cannot be saved: \$\.canvas\.width_px: 0 is not a whole number"):
        save(Document(Canvas(0, 4)), path)
    assert path.read_bytes() == before


def test_loading_touches_only_the_project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "p.kage"
    save(small_document(tmp_path), path)
    looked_at: list[str] = []
    really: dict[str, Callable[..., Any]] = {name: getattr(os, name) for name in ("stat", "lstat", "open", "listdir")}

    def watched(name: str) -> Callable[..., Any]:
        def call(target: Any, *rest: Any, **options: Any) -> Any:
            looked_at.append(os.fspath(target))
            return really[name](target, *rest, **options)

        return call

    for name in really:
        monkeypatch.setattr(os, name, watched(name))
    load(path)
    monkeypatch.undo()
    assert {Path(each) for each in looked_at} <= {path}
    assert sorted(each.name for each in tmp_path.iterdir()) == ["p.kage"]
    assert stat.S_ISREG(path.stat().st_mode)


# ---- versions


def test_every_version_has_its_sample_its_words_and_its_step() -> None:
    assert {path.name for path in DATA.glob("*.kage")} == {
        f"version_{int(version)}_{version.name.lower()}.kage" for version in FormatVersion
    }
    assert set(BROUGHT) == set(FormatVersion)
    assert set(UPGRADES) == set(FormatVersion) - {CURRENT}


@pytest.mark.parametrize("version", FormatVersion, ids=lambda version: version.name)
def test_the_sample_of_a_version_loads(version: FormatVersion) -> None:
    path = DATA / f"version_{int(version)}_{version.name.lower()}.kage"
    assert json.loads(path.read_bytes())["version"] == version
    document = load(path)
    assert [layer.name for layer in document.layers] == ["A", "影.B"]
    assert document.canvas.frame_rate == Fraction(24000, 1001)
    assert document.tracks["light.position"].value_at(12) == pytest.approx((300.0, -120.0, 900.0), abs=1e-9)
    assert document.layers[0].cels.drawings[0].path == DATA / "A/A_0001.png"
    assert document.background == DATA.parent / "street.png"


def test_the_current_sample_saves_as_the_same_text() -> None:
    path = DATA / f"version_{int(CURRENT)}_{CURRENT.name.lower()}.kage"
    text = path.read_text(encoding="utf-8")
    again = json.loads(dumps(loads(text, DATA), DATA))
    assert {**again, "app_version": "0.1.0"} == json.loads(text)


def test_the_description_of_the_format_is_up_to_date() -> None:
    committed = DESCRIPTION.read_text(encoding="utf-8")
    assert committed == description(), "run: python -m kagezou.io.project.format"
