"""Small pictures of drawings are kept within a budget of memory."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from kagezou.ui.system import thumbnails as module
from kagezou.ui.system.thumbnails import Thumbnails


def test_the_least_lately_seen_go_first(qtbot: QtBot, cels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = sorted(cels.glob("*.png"))
    made = Thumbnails()
    for file in files[:3]:
        made.image(file)
    qtbot.waitUntil(lambda: all(made.image(file) is not None for file in files[:3]))
    first = made.image(files[0])
    assert first is not None
    monkeypatch.setattr(module, "BUDGET_BYTES", made.nbytes)
    made.image(files[3])
    qtbot.waitUntil(lambda: files[3] in made.kept)
    assert files[1] not in made.kept, "the first one was looked at since"
    assert made.kept == {files[0], files[2], files[3]}
    assert made.nbytes <= module.BUDGET_BYTES
    made.finish()


def test_one_that_was_let_go_is_made_again(qtbot: QtBot, cels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = sorted(cels.glob("*.png"))
    made = Thumbnails()
    monkeypatch.setattr(module, "BUDGET_BYTES", 1)
    made.image(files[0])
    qtbot.waitUntil(lambda: made.kept == {files[0]})
    made.image(files[1])
    qtbot.waitUntil(lambda: made.kept == {files[1]})
    assert made.image(files[0]) is None
    qtbot.waitUntil(lambda: made.kept == {files[0]})
    made.finish()
