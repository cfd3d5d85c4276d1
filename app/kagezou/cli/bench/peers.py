"""An export beside what other programs take for a plain shadow of the same drawings: whole processes, in turn."""

import importlib.util
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Final

import numpy as np

from kagezou.cli.bench.whole_processes import Spent, taken
from kagezou.document.address import resolve
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.geometry.vectors import Matrix
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.project.file import save
from kagezou.message import Message
from kagezou.own_process import program_words
from kagezou.scene.evaluate import evaluate

PAIRS: Final = 5
_SIGMA_PX: Final = 12.0
_OPACITY: Final = 0.6
_COLOR: Final = "141028"
_FFMPEG_SIGMA_PX: Final = 13.0
"""In three steps of its kind of blur this comes nearest to a Gaussian of 12 px."""

_GAIN: Final = 2.5066
"""How steep a Gaussian's blurred edge is made again, times its standard deviation: √(2π)."""


@dataclass(frozen=True, slots=True)
class Peer:
    """Another program.

    Parameters
    ----------
    name
        As it is shown.
    command
        What it is started with.
    """

    name: str
    command: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Compared:
    """Our time as a part of a peer's, medians of pairs; ``cpu`` is None where the system does not tell."""

    name: str
    wall: float
    cpu: float | None


def compared(drawings: Path, folder: Path, pairs: int = PAIRS) -> tuple[tuple[Compared, ...], tuple[str, ...]]:
    """Return how an export compares with each peer that is found here, and the names of those that are not.

    Parameters
    ----------
    drawings
        A folder of PNG drawings of one size, and of nothing else.
    folder
        Where projects and frames may be written.
    pairs
        How often each is timed, after once for nothing.

    Raises
    ------
    UsageProblem
        The drawings are not such.
    OutputProblem
        A program failed.
    """
    document = _plain(drawings)
    save(document, folder / "peers.kage")
    ours = Peer("kagezou", (*program_words(), "render", str(folder / "peers.kage"), "-o", str(folder / "ours")))
    found = {each.name: each for each in _peers(document, drawings, folder)}
    missing = tuple(name for name in ("ffmpeg", "OpenCV") if name not in found)
    return tuple(_against(ours, each, pairs) for each in found.values()), missing


def _plain(drawings: Path) -> Document:
    """Return a cut with one shadow, simplified alike everywhere, of figures on the ground line under the sun."""
    paths = sorted(path for path in drawings.iterdir() if not path.name.startswith("."))
    if not paths or any(path.suffix.lower() != ".png" for path in paths):
        raise UsageProblem(Message("to be compared with other programs, drawings have to be PNG files alone"))
    document = new_document([CharacterSource("Character", drawings)]).document
    values: dict[str, object] = {"stance": "line", "shadow.simplify": _SIGMA_PX, "shadow.distance": 0.0}
    values |= {"shadow.opacity": _OPACITY, "shadow.color": f"#{_COLOR}"}
    for name, value in values.items():
        document = set_constant(document, resolve(document, f"layers.Character.{name}"), value)
    return set_constant(document, resolve(document, "light.kind"), "sun")


def _peers(document: Document, drawings: Path, folder: Path) -> Iterator[Peer]:
    """Yield the peers that are installed, each with its way to make the same picture."""
    (layer,) = evaluate(document, 1).layers
    assert layer.cast is not None
    (cast, *_) = layer.cast.on(layer.cast.receivers[0], layer.cast.lights[0])
    canvas_from_art: Matrix = np.asarray(np.linalg.inv(cast.art_from_canvas))
    width, height = document.canvas.width_px, document.canvas.height_px
    (folder / "ffmpeg").mkdir(exist_ok=True)
    if (ffmpeg := shutil.which("ffmpeg")) is not None:
        graph = _graph(canvas_from_art, width, height)
        words = [ffmpeg, "-nostdin", "-v", "error", "-y", "-framerate", "24", "-pattern_type", "glob"]
        words += ["-i", f"{drawings}/*.png", "-f", "lavfi", "-i", f"color=0x{_COLOR}:s={width}x{height}:r=24"]
        words += ["-filter_complex", graph, "-map", "[o]", "-frames:v", str(document.canvas.length_frames)]
        words += ["-c:v", "png", "-pred", "none", "-compression_level", "1", str(folder / "ffmpeg" / "%04d.png")]
        yield Peer("ffmpeg", tuple(words))
    if importlib.util.find_spec("cv2") is not None:
        (folder / "opencv").mkdir(exist_ok=True)
        numbers = [repr(float(each)) for each in canvas_from_art.ravel()]
        script = str(Path(__file__).with_name("opencv_peer.py"))
        yield Peer("OpenCV", (sys.executable, script, str(drawings), str(folder / "opencv"), *numbers))


def _graph(canvas_from_art: Matrix, width: int, height: int) -> str:
    """Return a filter graph of ffmpeg: the alpha moved to where its shadow lies, blurred, its edge made steep again."""
    corners = canvas_from_art @ np.array([[0, width, 0, width], [0, 0, height, height], [1, 1, 1, 1]])
    places = (corners[:2] / corners[2]).T.ravel()
    names = (f"{axis}{number}" for number in range(4) for axis in "xy")
    where = ":".join(f"{name}={place:.4f}" for name, place in zip(names, places, strict=True))
    most, gain = 255 * _OPACITY, _GAIN * _SIGMA_PX
    return (
        f"[0]format=rgba,alphaextract,format=gray,perspective=sense=destination:{where},"
        f"gblur=sigma={_FFMPEG_SIGMA_PX}:steps=3,lut=y='clip((val/255-.5)*{gain:.2f}+.5,0,1)*{most:.0f}'[m];"
        "[1]format=rgba[k];[k][m]alphamerge=shortest=1[o]"
    )


def _against(ours: Peer, other: Peer, pairs: int) -> Compared:
    """Time two programs in turn, once for nothing."""
    both = [(_taken(ours), _taken(other)) for _ in range(pairs + 1)][1:]
    walls = [mine.wall_s / theirs.wall_s for mine, theirs in both]
    cpus = [mine.cpu_s / theirs.cpu_s for mine, theirs in both if theirs.cpu_s > 0]
    return Compared(other.name, median(walls), median(cpus) if cpus else None)


def _taken(peer: Peer) -> Spent:
    return taken(peer.name, peer.command)
