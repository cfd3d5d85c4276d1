"""What the panel has stand in for drawings that are not there: chosen from a list, kept, and handed to the program."""

import sys
from pathlib import Path

import pytest

from kagezou.io.images.reading import read_cel
from tests.export.after_effects.extendscript import Run
from tests.export.after_effects.test_panel import Panel, panel, saved, system

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")
__all__ = ["panel", "saved", "system"]

LIST = "var list = () => panel.buttons[missing].parts[1]; var choose = (index) => { list().selection = index; };"
GAP = f"""
    {LIST}
    var cut = newComp('cut', 3); cut.put(file, 'A').selected = true;
    press(make);
    disk.unlinkSync(file.replace(/%25/g, '%').replace('0001', '0002'));
"""
"""A composition of three frames, whose second drawing is gone after the project was made."""


def shadows(run: Run) -> list[Path]:
    return sorted(Path(run.item("A shadow")["file"]).parent.glob("*.png"))


def test_at_first_what_is_missing_is_named_and_nothing_comes(panel: Panel) -> None:
    run = panel(f"{GAP} asked.push(list().selection.text); press(bring);")
    (said,) = run.tree["alerts"]
    assert "a__0002.png" in said
    assert run.tree["asked"] == ["読み込まずに名前を挙げる"]
    assert len(run.item("cut", "CompItem")["layers"]) == 1


@pytest.mark.usefixtures("system")
@pytest.mark.parametrize(("choice", "way"), [(1, "empty"), (2, "hold")])
def test_a_choice_is_what_the_program_does(panel: Panel, choice: int, way: str) -> None:
    run = panel(f"{GAP} choose({choice}); press(bring); asked.push(panel.buttons[status].text);")
    assert run.tree["alerts"] == []
    first, second, _ = (read_cel(path).rgba[..., 3] for path in shadows(run))
    assert bool(first.any())
    assert bool(second.any()) == (way == "hold")
    assert "a__0002.png" in run.tree["asked"][0], "which drawing it was stays in the panel"


def test_the_choice_is_kept_and_one_that_nobody_knows_is_the_first(panel: Panel) -> None:
    run = panel(f"""
        {LIST}
        choose(2);
        asked.push(app.settings.kept.missing);
        var again = () => {{ delete this.panel; $.evalFile({{ fsName: $.fileName }}); return list().selection.index; }};
        asked.push(String(again()));
        app.settings.kept.missing = 'later';
        asked.push(String(again()));
    """)
    assert run.tree["asked"] == ["hold", "2", "0"]


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("ja_JP", ["見つからないセル", "読み込まずに名前を挙げる", "フレームを空にする", "近くのセルで埋める"]),
        (
            "en_US",
            ["Missing drawings", "Bring nothing, name them", "Leave the frames empty", "Hold the nearest drawing"],
        ),
    ],
)
def test_the_choice_is_in_both_languages(panel: Panel, language: str, words: list[str]) -> None:
    run = panel(f"""
        app.isoLanguage = {language!r}; delete this.panel; $.evalFile({{ fsName: $.fileName }});
        var row = panel.buttons[missing].parts;
        asked.push(row[0].text); row[1].items.forEach((each) => asked.push(each.text));
    """)
    assert run.tree["asked"] == words
