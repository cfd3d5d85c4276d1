"""Every sentence of the rooms below that may reach the window has its Japanese, and is known again with any value."""

import ast
import json
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.errors import InputProblem, UsageProblem
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.sequences import find_sequences
from kagezou.ui.system.language import Language
from kagezou.ui.system.sentences import japanese, patterns, sentence_of, spoken
from kagezou.ui.window.main_window import MainWindow
from tests.ui.system.sentence_sources import SOURCES, sentences

_JAPANESE = re.compile("[\u3041-\u30ff\u4e00-\u9fff]")
_HOLE = re.compile(r"\{\d*\}")
_TABLE = "app/resources/translations/sentences_ja.json"


def test_every_sentence_has_its_japanese() -> None:
    known = patterns()
    missing = [each for each in sentences() if each.template not in known]
    lines = "".join(f'\n  {json.dumps(each.template, ensure_ascii=False)}: "…",    ← {each.where}' for each in missing)
    assert not missing, f"these sentences may reach a Japanese window; give them their Japanese in {_TABLE}:{lines}"


def test_no_japanese_outlives_its_sentence() -> None:
    written = {each.template for each in sentences()}
    stale = [template for template in patterns() if template not in written]
    assert not stale, f"no source says these any more; take them out of {_TABLE}: {stale}"


@pytest.mark.parametrize("template", patterns())
def test_a_sentence_is_known_again_whatever_it_holds(template: str) -> None:
    holes = len(_HOLE.findall(template))
    values = [f"‹{index}›" for index in range(holes)]
    parts = template.split("{}")
    text = parts[0] + "".join(value + part for value, part in zip(values, parts[1:], strict=True))
    other = patterns()[template]

    said = japanese(text)

    assert _JAPANESE.search(said)
    assert all(said.count(value) == 1 for value in values), f"{other!r} does not say every value of {template!r} once"
    # Nothing English is left of what stands between the values.
    words = [word for word in re.findall(r"[a-z]{4,}", "".join(parts)) if word not in other]
    assert not [word for word in words if word in said]


@given(st.text(alphabet=st.characters(codec="utf-8", exclude_characters="\0/"), min_size=1, max_size=30))
def test_a_cause_is_known_behind_any_file_name(name: str) -> None:
    said = japanese(f"/cuts/{name}: it does not exist")
    assert said.endswith("：見つかりません")
    assert said.startswith("/cuts/")


def test_sentences_within_sentences_are_said_too() -> None:
    assert japanese("/a/b.kage: $.layers[0].name: 5 is not a printable name") == (
        "/a/b.kage：$.layers[0].name：5 は使えません（使えるのは 表示できる名前）"
    )
    assert japanese("there is no layer 'Hreo' in this project; did you mean 'Hero'?") == (
        "このプロジェクトにレイヤー 'Hreo' はありません（'Hero' ではありませんか？）"
    )
    assert (
        japanese("/a.png: libpng error: bad adaptive filter value") == "/a.png: libpng error: bad adaptive filter value"
    )


def test_the_log_of_a_driver_takes_no_time() -> None:
    log = "the graphics driver refuses cast.frag: " + "".join(f"0:{line}: error: it is not: " for line in range(30))
    assert japanese(log).startswith("グラフィックスドライバーが cast.frag を受け付けません：")


def test_english_stays_english_and_begins_like_a_sentence() -> None:
    assert spoken("there is no picture yet") == "There is no picture yet"
    assert spoken("/cuts/walk.kage: it does not exist") == "/cuts/walk.kage: it does not exist"


def test_what_really_happens_is_said_in_japanese(english: Language, tmp_path: Path) -> None:
    english.speak("ja")
    (tmp_path / "notes.txt").write_text("no picture", encoding="utf-8")
    with pytest.raises(InputProblem) as missing:
        CelCache().cel(tmp_path / "none.png")
    with pytest.raises(InputProblem) as other:
        find_sequences(tmp_path / "notes.txt")

    assert sentence_of(missing.value) == f"{tmp_path}/none.png：見つかりません"
    assert sentence_of(other.value) == f"{tmp_path}/notes.txt：「.txt」は読み込める画像形式ではありません"
    assert sentence_of(UsageProblem("there is already a layer named 'A'")) == "'A' という名前のレイヤーはすでにあります"


def test_the_japanese_window_says_why_a_project_does_not_open(
    english: Language, window: MainWindow, tmp_path: Path
) -> None:
    english.speak("ja")

    window.parts.project.open_path(tmp_path / "none.kage")

    assert window.parts.bar.text == f"{tmp_path}/none.kage：見つかりません"


def test_the_window_says_no_problem_but_in_its_own_language() -> None:
    """Whoever makes text of a problem in the window's room has forgotten ``sentence_of``."""
    raw = [
        f"{file.name}:{call.lineno}"
        for file in sorted((SOURCES / "ui").rglob("*.py"))
        for handler in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(handler, ast.ExceptHandler)
        for call in ast.walk(handler)
        if isinstance(call, ast.Call)
        and ast.unparse(call.func) in ("str", "repr")
        and str(handler.name) in map(ast.unparse, call.args)
    ]
    assert not raw
