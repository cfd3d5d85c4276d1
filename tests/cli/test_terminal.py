import io

import pytest

from kagezou.cli.terminal import ProgressLine, clock_text, progress_text


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("seconds", "text"), [(0.2, "0:00"), (59.6, "1:00"), (65, "1:05"), (3599, "59:59"), (3661, "1:01:01"), (-1, "0:00")]
)
def test_durations(seconds: float, text: str) -> None:
    assert clock_text(seconds) == text


def test_a_line_of_progress() -> None:
    text = progress_text("rendering", 12, 48, 6.0)
    assert text == "rendering [######------------------] 12/48  6.0 frames/s  0:06 left"
    assert "?" in progress_text("rendering", 0, 48, 0.0)
    assert text.isascii()


def test_frames_that_were_there_before_do_not_count_for_the_rate() -> None:
    terminal = Terminal()
    with ProgressLine("rendering", terminal) as line:
        line.update(91, 100)
        line.update(100, 100)
    assert "100/100" in terminal.getvalue()


def test_the_line_wipes_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    terminal = Terminal()
    with ProgressLine("drawing", terminal) as line:
        line.update(1, 2)
    shown, wiped = terminal.getvalue().split("\r")[1:3]
    assert shown.startswith("drawing [")
    assert wiped == " " * len(shown)
    assert "\x1b" not in terminal.getvalue()
    assert "\n" not in terminal.getvalue()


@pytest.mark.parametrize("stream", [io.StringIO(), Terminal()])
def test_where_no_one_is_watching_nothing_is_drawn(monkeypatch: pytest.MonkeyPatch, stream: io.StringIO) -> None:
    monkeypatch.setenv("TERM", "dumb")
    with ProgressLine("drawing", stream) as line:
        line.update(1, 1)
    assert stream.getvalue() == ""


def test_it_is_not_redrawn_for_every_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    terminal = Terminal()
    with ProgressLine("drawing", terminal) as line:
        for done in range(1, 1001):
            line.update(done, 2000)
    assert terminal.getvalue().count("drawing") < 50
