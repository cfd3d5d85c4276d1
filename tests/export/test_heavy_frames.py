"""Frames that take minutes: they can be stopped within, and nothing half drawn is left."""

from pathlib import Path

import pytest

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.export.frames import export_frames
from kagezou.export.request import ExportRequest, Summary
from kagezou.export.video import VideoRequest, export_video
from kagezou.render.gpu.context import open_headless_context
from kagezou.scene import heavy_sets
from tests.export.small_cuts import cut


@pytest.fixture
def room(tmp_path: Path) -> Document:
    """One frame with some flights of steps."""
    document = cut(tmp_path, count=1)
    for number in range(4):
        document = add_piece(document, f"steps {number}", "steps", {"count": 6, "position": (10.0 + 12 * number, 38.0)})
    return document


class Patience:
    """Asks to stop when it was asked so often whether to."""

    def __init__(self, most: int) -> None:
        self.asked, self.most = 0, most

    def is_over(self) -> bool:
        self.asked += 1
        return self.asked > self.most


def exported(document: Document, folder: Path, patience: Patience) -> Summary:
    request = ExportRequest(folder, workers=1)
    return export_frames(document, request, open_headless_context, lambda _done, _all: None, patience.is_over)


@pytest.mark.parametrize("most", [5, 60])
def test_a_frame_that_takes_minutes_can_be_stopped_within(
    room: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, most: int
) -> None:
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 0)
    patience = Patience(most)
    stopped = exported(room, tmp_path / "out", patience)
    assert patience.asked == most + 1, "nothing goes on after that"
    assert (stopped.written, stopped.cancelled, stopped.is_whole) == (0, True, False)
    assert not list((tmp_path / "out").rglob("*.png"))
    assert exported(room, tmp_path / "out", Patience(10**6)).is_whole


def test_any_other_frame_reaches_its_file(room: Document, tmp_path: Path) -> None:
    patience = Patience(1)
    stopped = exported(room, tmp_path / "out", patience)
    assert (stopped.written, stopped.is_whole) == (1, True)
    assert patience.asked <= 2


def test_a_video_can_be_stopped_within_a_frame(room: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("av", reason="the packages for video are not installed")
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 0)
    request = VideoRequest(tmp_path / "a.mov", workers=1)
    done = export_video(room, request, open_headless_context, lambda _done, _all: None, Patience(20).is_over)
    assert not done.is_whole
    assert not (tmp_path / "a.mov").exists()
