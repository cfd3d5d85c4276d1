"""Free memory is given back beside the window."""

import threading

import pytest
from pytestqt.qtbot import QtBot

from kagezou.ui.system import giving_back
from kagezou.ui.system.giving_back import GivingBack


def test_it_is_given_back_again_and_again_on_another_thread(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    threads: list[int] = []
    monkeypatch.setattr(giving_back, "EVERY_MS", 1)
    monkeypatch.setattr(giving_back, "give_back", lambda: threads.append(threading.get_ident()))
    giving = GivingBack()
    qtbot.waitUntil(lambda: len(threads) >= 2)
    giving.deleteLater()
    assert threading.get_ident() not in threads
