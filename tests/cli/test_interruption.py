import os
import signal
import sys

import pytest

from kagezou.cli.interruption import Interrupted, stopping_at_once, stopping_gently

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_the_first_signal_asks_and_the_second_ends(number: signal.Signals, code: int) -> None:
    with stopping_gently() as interruption:
        assert not interruption.is_asked
        assert interruption.exit_code == 0
        os.kill(os.getpid(), number)
        assert interruption.is_set()
        assert interruption.exit_code == code
        with pytest.raises(Interrupted) as stopped:
            os.kill(os.getpid(), number)
    assert stopped.value.exit_code == code


def test_elsewhere_the_first_signal_ends() -> None:
    with stopping_at_once(), pytest.raises(Interrupted) as stopped:
        os.kill(os.getpid(), signal.SIGTERM)
    assert stopped.value.exit_code == 143


def test_afterwards_signals_are_handled_as_before() -> None:
    before = signal.getsignal(signal.SIGINT)
    with stopping_at_once(), stopping_gently():
        assert signal.getsignal(signal.SIGINT) != before
    assert signal.getsignal(signal.SIGINT) == before
