"""Videos, decoded again: how many frames, how fast, and in which colours."""

import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.edits import set_background, set_canvas
from kagezou.document.model import Canvas, Document
from kagezou.errors import InputProblem, OutputProblem, UsageProblem
from kagezou.export import video as video_export
from kagezou.export.video import VideoRequest, VideoSummary, export_video, video_jobs
from kagezou.io.images import video
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import HEIGHT, WIDTH, cut, with_key, with_values

MEADOW = (60, 160, 90)


@pytest.fixture
def meadow(tmp_path: Path) -> Document:
    """A block over a plain background, 4 drawings on 6 frames; the last one holds."""
    write_rgba(tmp_path / "meadow.png", np.full((HEIGHT, WIDTH, 4), (*MEADOW, 255), np.uint8))
    document = set_background(cut(tmp_path, 4, length=6), tmp_path / "meadow.png")
    return with_values(document, layers__A__shadow__color="#C02010", layers__A__shadow__opacity=0.5)


def filmed(document: Document, path: Path, stop_after: int | None = None, **wishes: Any) -> VideoSummary:
    done = 0

    def progress(finished: int, _total: int) -> None:
        nonlocal done
        done = finished

    return export_video(
        document,
        VideoRequest(path, **wishes),
        open_headless_context,
        progress,
        lambda: stop_after is not None and done >= stop_after,
    )


def decoded(path: Path) -> tuple[list[NDArray[Any]], list[Fraction]]:
    """Return the frames as straight RGBA, by the matrix of BT.709, and their times in seconds."""
    with av.open(str(path)) as container:
        frames = list(container.decode(video=0))
    pixels = [
        frame.reformat(
            format="rgba", src_colorspace="ITU709", src_color_range="MPEG", dst_color_range="JPEG"
        ).to_ndarray()
        for frame in frames
    ]
    times = [frame.pts * frame.time_base for frame in frames if frame.pts is not None and frame.time_base is not None]
    return pixels, times


@pytest.mark.parametrize("suffix", [".mp4", ".mov"])
@pytest.mark.parametrize("rate", [Fraction(24000, 1001), Fraction(25)])
def test_a_video_has_the_frames_and_the_rate_of_the_cut(
    meadow: Document, tmp_path: Path, suffix: str, rate: Fraction
) -> None:
    document = set_canvas(meadow, Canvas(WIDTH, HEIGHT, rate, 6))
    done = filmed(document, tmp_path / f"a{suffix}")
    assert (done.frames, done.is_whole) == (6, True)
    _, times = decoded(done.path)
    assert times == [n / rate for n in range(6)]
    with av.open(str(done.path)) as container:
        stream = container.streams.video[0]
        assert stream.average_rate == rate
        context: Any = stream.codec_context
        assert (context.colorspace, context.color_primaries, context.color_trc, context.color_range) == (1, 1, 1, 1)


@pytest.mark.parametrize(("suffix", "tolerance"), [(".mp4", 4), (".mov", 1)])
def test_colours_are_those_of_the_picture(meadow: Document, tmp_path: Path, suffix: str, tolerance: int) -> None:
    frames, _ = decoded(filmed(meadow, tmp_path / f"a{suffix}").path)
    assert np.abs(frames[0][2:6, 2:6, :3].astype(int) - MEADOW).max() <= tolerance
    assert np.abs(frames[3][28:34, 21:24, :3].astype(int) - (200, 120, 40)).max() <= tolerance + 2
    assert np.abs(frames[3].astype(int) - frames[5]).max() <= 2
    assert np.abs(frames[0].astype(int) - frames[3]).max() > 50


def test_a_shadow_has_its_alpha_and_its_colour_everywhere(meadow: Document, tmp_path: Path) -> None:
    frames, _ = decoded(filmed(meadow, tmp_path / "a.mov", layer="A", frames=(2, 3)).path)
    assert len(frames) == 2
    assert np.abs(frames[0][..., :3].astype(int) - (0xC0, 0x20, 0x10)).max() <= 1
    alpha = frames[0][..., 3]
    assert alpha[0, 0] == 0
    assert abs(int(alpha.max()) - 128) <= 1


def test_the_shadow_of_a_layer_that_receives_others_has_each_frame_once(meadow: Document, tmp_path: Path) -> None:
    receiving = with_values(meadow, layers__A__receives=True)
    jobs = video_jobs(receiving, VideoRequest(tmp_path / "a.mov", layer="A"))
    assert [target.frame for job in jobs for target in job.targets] == [1, 2, 3, 4, 5, 6]


def test_what_has_no_alpha_lies_on_white(meadow: Document, tmp_path: Path) -> None:
    frames, _ = decoded(filmed(meadow, tmp_path / "a.mp4", layer="A", frames=(1,)).path)
    assert frames[0][0, 0].tolist() == [255, 255, 255, 255]
    assert np.abs(frames[0][0, -1].astype(int) - 255).max() <= 1


def test_odd_sides_get_a_row_more(tmp_path: Path) -> None:
    document = set_canvas(cut(tmp_path, 1), Canvas(WIDTH - 1, HEIGHT - 1, Fraction(24), 1))
    for suffix, size in ((".mp4", (WIDTH, HEIGHT)), (".mov", (WIDTH - 1, HEIGHT - 1))):
        frames, _ = decoded(filmed(document, tmp_path / f"a{suffix}").path)
        assert frames[0].shape[1::-1] == size


def test_a_picture_that_holds_is_drawn_once_and_one_that_comes_again_in_its_place(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path, 1, length=6), "layers.A.visible", 1, value=True)
    document = with_key(with_key(document, "layers.A.visible", 3, value=False), "layers.A.visible", 5, value=True)
    jobs = video_jobs(document, VideoRequest(tmp_path / "a.mov"))
    assert [[target.frame for target in job.targets] for job in jobs] == [[1, 2], [3, 4], [5, 6]]
    frames, _ = decoded(filmed(document, tmp_path / "a.mov").path)
    assert [bool(frame[..., 3].any()) for frame in frames] == [True, True, False, False, True, True]


def test_a_stopped_video_is_not_there_and_the_old_one_still_is(meadow: Document, tmp_path: Path) -> None:
    folder = tmp_path / "videos"
    folder.mkdir()
    # With more different pictures than are drawn ahead, so that there is something left to stop.
    long = replace(meadow, canvas=replace(meadow.canvas, length_frames=200))
    for frame, opacity in ((1, 0.1), (200, 0.9)):
        long = with_key(long, "layers.A.shadow.opacity", frame, opacity)
    assert not filmed(long, folder / "a.mp4", stop_after=2).is_whole
    assert list(folder.iterdir()) == []
    (folder / "a.mp4").write_bytes(b"old")
    meadow.layers[0].cels.drawings[2].path.write_bytes(b"\x89PNG\r\n\x1a\nbroken")
    with pytest.raises(InputProblem, match="a_0003"):
        filmed(meadow, folder / "a.mp4")
    assert (folder / "a.mp4").read_bytes() == b"old"
    assert len(list(folder.iterdir())) == 1


def test_a_video_that_reads_back_short_is_refused(
    meadow: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(video_export, "frames_in", lambda path: video.frames_in(path) - 1)
    with pytest.raises(OutputProblem, match="other frames"):
        filmed(meadow, tmp_path / "a.mov")
    assert not (tmp_path / "a.mov").exists()


def test_what_cannot_be_made_is_one_sentence(meadow: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(UsageProblem, match=r"ends in \.mp4 or \.mov"):
        filmed(meadow, tmp_path / "a.avi")
    with pytest.raises(UsageProblem, match="no layer 'B'"):
        filmed(meadow, tmp_path / "a.mov", layer="B")
    with pytest.raises(UsageProblem, match="frame 7 is not in the cut"):
        filmed(meadow, tmp_path / "a.mov", frames=(7,))
    with pytest.raises(OutputProblem, match="its folder does not exist"):
        filmed(meadow, tmp_path / "nowhere" / "a.mov")
    monkeypatch.setattr(video, "find_spec", lambda _name: None)
    with pytest.raises(UsageProblem, match="pip install 'av>="):
        filmed(meadow, tmp_path / "a.mov")


def test_nothing_of_it_is_imported_until_it_is_used() -> None:
    import subprocess

    code = (
        "import sys, kagezou.export.video, kagezou.export.frames, kagezou.io.images.layered;"
        "print([name for name in ('av', 'psd_tools') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
