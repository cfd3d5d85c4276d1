"""video and layered frames as a person or a farm calls them."""

import signal
from pathlib import Path

import av
import pytest
from psd_tools import PSDImage

from kagezou.export import video as video_export
from kagezou.io.images.video import VideoWriter
from tests.cli.projects import Shell


def test_video_writes_one_file_and_names_it(shell: Shell, project: Path, tmp_path: Path) -> None:
    assert shell.ok("video", project, "-o", tmp_path / "a.mp4") == f"{tmp_path / 'a.mp4'}\n"
    report = shell.json("video", project, "-o", tmp_path / "a.mov", "--layer", "Hero", "--frames", "2-3", "--json")
    assert report["file"] == str(tmp_path / "a.mov")
    assert report["frames"] == 2
    for name, count, pixels in (("a.mp4", 3, "yuv420p"), ("a.mov", 2, "yuva444p12le")):
        with av.open(str(tmp_path / name)) as container:
            assert container.streams.video[0].codec_context.pix_fmt == pixels
            assert len(list(container.decode(video=0))) == count


def test_a_video_refuses_in_one_sentence(shell: Shell, project: Path, tmp_path: Path) -> None:
    assert shell.fails(2, "video", project, "-o", tmp_path / "a.gif").endswith("a video ends in .mp4 or .mov")
    assert "did you mean 'Hero'?" in shell.fails(2, "video", project, "-o", tmp_path / "a.mov", "--layer", "Herro")
    assert "folder does not exist" in shell.fails(4, "video", project, "-o", tmp_path / "no" / "a.mov")


def test_ctrl_c_leaves_no_half_video(
    shell: Shell, project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = VideoWriter.add
    signals = iter([signal.SIGINT])

    def interrupted(writer: VideoWriter, frame: object) -> None:
        real(writer, frame)
        for number in signals:
            signal.raise_signal(number)

    monkeypatch.setattr(VideoWriter, "add", interrupted)
    monkeypatch.setattr(video_export, "window_for", lambda *_: 1)
    (tmp_path / "out").mkdir()
    assert shell.fails(130, "video", project, "-o", tmp_path / "out" / "a.mov") == "stopped; the video is not written"
    assert list((tmp_path / "out").iterdir()) == []


def test_layered_frames_are_documents_unless_told_otherwise(shell: Shell, project: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out" / "layered"
    assert shell.ok("render", project, "-o", tmp_path / "out", "--layered") == f"{folder}\n"
    shell.ok("render", project, "-o", tmp_path / "out", "--layered", "--format", "exr", "--frames", "1")
    names = [f"layered_000{number}.{suffix}" for number, suffix in ((1, "exr"), (1, "psd"), (2, "psd"), (3, "psd"))]
    assert sorted(path.name for path in folder.iterdir()) == names
    assert [layer.name for layer in PSDImage.open(folder / names[1])] == ["Hero_shadow", "Hero"]
    assert PSDImage.open(folder / names[1]).depth == 8
    shell.ok("render", project, "-o", tmp_path / "out", "--layered", "--depth", "16", "--frames", "1")
    assert PSDImage.open(folder / names[1]).depth == 16
    assert "needs layered frames" in shell.fails(2, "render", project, "-o", tmp_path / "out", "--format", "psd")
