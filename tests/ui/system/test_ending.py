"""Signals of the system reach the event loop; one that is to be ignored stays so."""

import os
import signal
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from kagezou.ui.system.ending import EndSignals

pytestmark = pytest.mark.skipif(os.name != "posix", reason="these signals are POSIX's")
NUMBERS = ("SIGINT", "SIGTERM", "SIGHUP")


@pytest.fixture
def untouched() -> Iterator[None]:
    """Let the signals do what they usually do, whatever started the tests, and put everything back as it was."""
    before = {name: signal.getsignal(getattr(signal, name)) for name in NUMBERS}
    for name in NUMBERS:
        signal.signal(getattr(signal, name), signal.SIG_DFL)
    yield
    signal.set_wakeup_fd(-1)
    for name, handler in before.items():
        signal.signal(getattr(signal, name), handler)


@pytest.mark.usefixtures("untouched")
@pytest.mark.parametrize("name", NUMBERS)
def test_a_signal_is_told_once_and_a_second_one_ends_at_once(qtbot: QtBot, name: str) -> None:
    number = getattr(signal, name)
    signals = EndSignals()
    signals.watch()
    with qtbot.waitSignal(signals.came) as told:
        os.kill(os.getpid(), number)
    assert told.args == [number]
    assert signal.getsignal(number) is signal.SIG_DFL
    signals.finish()


@pytest.mark.usefixtures("untouched")
def test_what_was_to_be_ignored_stays_ignored(qtbot: QtBot) -> None:
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    signals = EndSignals()
    signals.watch()
    assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    heard: list[int] = []
    signals.came.connect(heard.append)
    os.kill(os.getpid(), signal.SIGHUP)
    with qtbot.waitSignal(signals.came):
        os.kill(os.getpid(), signal.SIGTERM)
    assert heard == [signal.SIGTERM]
    signals.finish()
    assert signal.getsignal(signal.SIGINT) is signal.SIG_DFL
