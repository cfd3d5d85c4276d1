"""Videos: H.264 in MP4 to look at, and ProRes 4444 in QuickTime with alpha; PyAV is imported when one is written.

RGB becomes Y′CbCr by the matrix of BT.709, in the range of video, and the file says so: without that programs guess,
and colours shift.
"""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import OutputProblem, UsageProblem
from kagezou.extras import VIDEO
from kagezou.io.files.faults import output_problem, shown
from kagezou.message import Message

Pixels = NDArray[Any]
MISSING: Final = Message("video needs PyAV, which is not installed: {how}", how=VIDEO.how)
_BT709: Final = 1
_VIDEO_RANGE: Final = 1
_WHITE: Final = 255


@dataclass(frozen=True, slots=True)
class _Coding:
    """How a kind of video is coded."""

    codec: str
    container: str
    pixel_format: str
    options: dict[str, str]
    container_options: dict[str, str]


class VideoKind(Enum):
    """What can be written, by its suffix."""

    MP4 = ".mp4"
    MOV = ".mov"

    @property
    def has_alpha(self) -> bool:
        """Whether alpha is kept; else pictures are laid on white."""
        return self is VideoKind.MOV


_CODINGS: Final = {
    VideoKind.MP4: _Coding("libx264", "mp4", "yuv420p", {"crf": "16", "preset": "medium"}, {"movflags": "+faststart"}),
    VideoKind.MOV: _Coding(
        "prores_ks", "mov", "yuva444p10le", {"profile": "4444", "alpha_bits": "16", "vendor": "apl0"}, {}
    ),
}


def is_there() -> bool:
    """Return whether videos can be written here, without importing what writes them."""
    return find_spec(VIDEO.module) is not None


def kind_of(path: Path) -> VideoKind:
    """Return the kind of video that a path's suffix asks for.

    Raises
    ------
    UsageProblem
        The suffix is no video's, or what writes videos is not installed.
    """
    suffix = path.suffix.lower()
    if suffix not in [kind.value for kind in VideoKind]:
        raise UsageProblem(Message("{path}: a video ends in .mp4 or .mov", path=shown(path)))
    if not is_there():
        raise UsageProblem(MISSING)
    return VideoKind(suffix)


def converted(rgba: Pixels, kind: VideoKind) -> Any:
    """Return straight sRGB (H, W, 4) ``uint8`` as a frame that a `VideoWriter` of that kind takes; on any thread."""
    from av import VideoFrame

    if kind.has_alpha:
        frame = VideoFrame.from_ndarray(np.ascontiguousarray(rgba), format="rgba")
    else:
        frame = VideoFrame.from_ndarray(_even(_on_white(rgba)), format="rgb24")
    made = frame.reformat(
        format=_CODINGS[kind].pixel_format,
        src_colorspace="ITU709",
        dst_colorspace="ITU709",
        src_color_range="JPEG",
        dst_color_range="MPEG",
    )
    made.colorspace = _BT709
    made.color_range = _VIDEO_RANGE
    return made


class VideoWriter:
    """A video being written; use it as a context manager, which finishes the file.

    Parameters
    ----------
    path
        Where to write.
    shown_as
        The file's name in messages.
    size_px
        Width and height of the pictures; H.264 adds a column or a row to an odd one.
    rate
        Frames a second, exact.
    kind
        How it is coded.

    Raises
    ------
    DiskFullProblem, OutputProblem
        It cannot be written.
    """

    def __init__(self, path: Path, shown_as: Path, size_px: tuple[int, int], rate: Fraction, kind: VideoKind) -> None:
        import av

        self._failure = av.FFmpegError
        self._shown_as = shown_as
        coding = _CODINGS[kind]
        self._rate = rate
        self._count = 0
        try:
            self._container = av.open(str(path), "w", format=coding.container, options=coding.container_options)
            stream: Any = self._container.add_stream(coding.codec, rate=rate, options=coding.options)
            stream.width, stream.height = (side if kind.has_alpha else side + side % 2 for side in size_px)
            stream.pix_fmt = coding.pixel_format
            context = stream.codec_context
            context.time_base = 1 / rate
            context.colorspace = context.color_primaries = context.color_trc = _BT709
            context.color_range = _VIDEO_RANGE
            self._stream = stream
        except (av.FFmpegError, ValueError) as error:
            raise self._problem(error) from error

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None:
            self._encode(None)
        try:
            self._container.close()
        except self._failure as failed:
            if kind is None:
                raise self._problem(failed) from failed

    def add(self, frame: Any) -> None:
        """Append a frame made by `converted`.

        Raises
        ------
        DiskFullProblem, OutputProblem
            It cannot be written.
        """
        frame.pts, frame.time_base = self._count, 1 / self._rate
        self._count += 1
        self._encode(frame)

    def _encode(self, frame: Any) -> None:
        try:
            self._container.mux(self._stream.encode(frame))
        except self._failure as error:
            raise self._problem(error) from error

    def _problem(self, error: Exception) -> OutputProblem:
        if isinstance(error, OSError):
            return output_problem(self._shown_as, error)
        return output_problem(self._shown_as, Message("cannot be written: {error}", error=error))


def frames_in(path: Path) -> int:
    """Return how many frames a video holds; 0 for one that cannot be opened."""
    import av

    try:
        with av.open(str(path)) as container:
            return sum(packet.size > 0 for packet in container.demux(video=0))
    except av.FFmpegError:
        return 0


def _on_white(rgba: Pixels) -> Pixels:
    """Return straight (H, W, 4) laid on white, (H, W, 3)."""
    alpha = rgba[..., 3:].astype(np.uint16)
    if int(alpha.min()) == _WHITE:
        return np.ascontiguousarray(rgba[..., :3])
    mixed: Pixels = (rgba[..., :3] * alpha + _WHITE * (_WHITE - alpha) + _WHITE // 2) // _WHITE
    return mixed.astype(np.uint8)


def _even(rgb: Pixels) -> Pixels:
    """Return (H, W, 3) with the last column and row again where their number is odd."""
    height, width = rgb.shape[:2]
    if height % 2 == 0 and width % 2 == 0:
        return rgb
    return np.pad(rgb, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
