"""The messages of the sources, as they are handed to Qt's tools."""

import ast
from pathlib import Path

import pytest

import dev_translations

HARD = 'one "two"\nthree \\ four 影'


def test_messages_are_handed_over_as_calls_that_hold_them_unchanged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "kagezou_ja.ts").write_text("", encoding="utf-8")
    (tmp_path / "kagezou_en.ts").write_text("", encoding="utf-8")
    found = {(HARD, ""): "app/kagezou/a.py:1", ("Open", "a door"): "app/kagezou/b.py:2"}
    calls: list[str] = []
    ran: list[tuple[str, ...]] = []

    def run(program: Path, *arguments: object) -> None:
        ran.append((program.name, *map(str, arguments)))
        calls.extend(
            Path(str(each)).read_text(encoding="utf-8") for each in arguments if str(each).endswith("messages.py")
        )

    monkeypatch.setattr(dev_translations, "messages", lambda: found)
    monkeypatch.setattr(dev_translations, "_run", run)
    dev_translations.update(Path("tools"), tmp_path)
    assert calls[0] == calls[1]
    handed = [ast.literal_eval(line.removeprefix("translate")) for line in calls[0].splitlines()]
    assert sorted(handed) == [("Message", "Open", "a door"), ("Message", HARD)]
    assert [each[0] for each in ran] == ["lupdate", "lrelease"] * 2
    assert ["-pluralonly" in each for each in ran] == [True, False, False, False]


def test_rooms_that_only_the_terminal_shows_are_left_out(tmp_path: Path) -> None:
    (tmp_path / "cli").mkdir()
    (tmp_path / "io").mkdir()
    (tmp_path / "cli" / "a.py").write_text("Message('terminal')\nMessage(text)\n", encoding="utf-8")
    (tmp_path / "__main__.py").write_text("Message('main')\n", encoding="utf-8")
    (tmp_path / "io" / "b.py").write_text(
        "x = 1\nMessage('shown', 'a door', path=x)\nMessage('shown')\n", encoding="utf-8"
    )
    assert dev_translations.messages(tmp_path) == {
        ("shown", "a door"): "app/kagezou/io/b.py:2",
        ("shown", ""): "app/kagezou/io/b.py:3",
    }
