"""The pictures of a scene on disk: each different one of a layer once, or one for every frame."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.document.model import Canvas
from kagezou.export.exchange.drawn import DrawnLayer, Who
from kagezou.export.exchange.stack import Stack, StackLayer
from kagezou.export.made_files import PICTURE, MadeFile
from kagezou.export.names import digits_for, safe_names
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import input_problem, output_problem
from kagezou.io.files.folders import entries_to_write
from kagezou.io.files.small_files import remove_file
from kagezou.io.images.writing import encode_rgba_png
from kagezou.message import Message

# Signs that mean something to some program within the name of a sequence.
_PATTERN_SIGNS: Final = re.compile(r"[#%$@&{}\[\]()`'~;!^=+,]")


def ordered(frames: Iterable[tuple[Who, ...]]) -> tuple[Who, ...]:
    """Return the layers of all frames in one order, each frame's as it has them; what comes later is fitted in."""
    known: list[Who] = []
    for layers in dict.fromkeys(frames):
        for index, who in enumerate(layers):
            if who not in known:
                above = next((known.index(each) for each in layers[index + 1 :] if each in known), len(known))
                known.insert(above, who)
    return tuple(known)


def labels_of(layers: Iterable[Who]) -> dict[Who, str]:
    """Return for each layer the name of its folder and files, which no program takes for a pattern."""
    unlike: dict[Who, str] = {}
    for who in layers:
        free = _PATTERN_SIGNS.sub("_", who.name)
        while free in unlike.values():
            free += "_"
        unlike[who] = free
    safe = safe_names(unlike.values())
    return {who: safe[name] for who, name in unlike.items()}


@dataclass(frozen=True, slots=True)
class _Shown:
    """A layer on a frame: the number of its picture, None for none, and how it is laid."""

    picture: int | None
    opacity: float
    multiply: bool
    is_filled: bool

    @property
    def seen_opacity(self) -> float:
        """The opacity, 0 where nothing is seen."""
        return 0.0 if self.picture is None else self.opacity


_NOTHING: Final = _Shown(None, 1.0, multiply=False, is_filled=False)


@dataclass(slots=True)
class Gathered:
    """What was drawn so far.

    Parameters
    ----------
    folder
        Where the scene will lie.
    name, depth, every_frame, separator
        As of `Stack`.
    canvas
        That of the document.
    frames
        The frames of the document that are handed over, one after the other.
    layers
        From the bottom.
    pictures
        The name of the pictures' folder.
    """

    folder: Path
    name: str
    depth: int
    canvas: Canvas
    frames: tuple[int, ...]
    every_frame: bool
    layers: tuple[Who, ...]
    pictures: str
    separator: str = "_"
    _shown: dict[tuple[Who, int], _Shown] = field(default_factory=dict)
    _numbers: dict[Who, dict[str, int]] = field(default_factory=dict)
    _paths: dict[tuple[Who, int], Path] = field(default_factory=dict)
    _labels: dict[Who, str] = field(init=False)

    def __post_init__(self) -> None:
        self._labels = labels_of(self.layers)

    @property
    def files(self) -> int:
        """How many pictures there are."""
        return len(self._paths)

    @property
    def digits(self) -> int:
        """How many the number of each file has."""
        return digits_for(max(self._number(self.frames[-1]), len(self.frames)))

    def take(self, frames: tuple[int, ...], drawn: tuple[DrawnLayer, ...]) -> None:
        """Take in what was drawn for some frames, and write what is new of it.

        Raises
        ------
        DiskFullProblem, OutputProblem
            A picture cannot be written.
        """
        for layer in drawn:
            picture = self._picture(layer, frames[0])
            shown = _Shown(picture, layer.opacity, layer.multiply, layer.is_filled)
            self._shown.update({(layer.who, frame): shown for frame in frames})
            if layer.png is not None and picture is not None:
                path = self._path(layer.who, picture)
                _make(path.parent)
                write_bytes(path, layer.png)
                self._paths[layer.who, picture] = path

    def laid_out(self) -> Iterator[None]:
        """Write what every frame has of its own, a frame a step; nothing where each picture is there once.

        Raises
        ------
        DiskFullProblem, OutputProblem
            A picture cannot be written.
        """
        if not self.every_frame:
            return
        clear = encode_rgba_png(np.zeros((self.canvas.height_px, self.canvas.width_px, 4), f"u{self.depth // 8}"))
        for frame in self.frames:
            for who in self._seen:
                number = self._number(frame)
                if (who, number) in self._paths:
                    continue
                shown = self._shown.get((who, frame))
                data = _bytes_of(self._paths[who, shown.picture]) if shown and shown.picture is not None else clear
                path = self._path(who, number)
                _make(path.parent)
                write_bytes(path, data)
                self._paths[who, number] = path
            yield

    def made(self) -> Iterator[MadeFile]:
        """Yield the pictures that are there; where every frame has one, with its frame of the document."""
        for (who, number), path in self._paths.items():
            frames = (number - self.canvas.first_frame + 1,) if self.every_frame else ()
            yield MadeFile(path, PICTURE, self._labels[who], frames=frames)

    def remove_others(self) -> None:
        """Remove numbered pictures of an earlier, longer export from the folders: some programs take them all."""
        there = set(self._paths.values())
        for label in self._labels.values():
            folder = self.folder / self.pictures / label
            numbered = re.compile(re.escape(label) + r"[_.][0-9]+\.png")
            for path in entries_to_write(folder):
                if numbered.fullmatch(path.name) and path not in there:
                    remove_file(path)

    def stack(self) -> tuple[Stack, tuple[Message, ...]]:
        """Return the layers that are ever seen, and what is to be said about them."""
        seen = self._seen
        stack = Stack(
            name=self.name,
            width_px=self.canvas.width_px,
            height_px=self.canvas.height_px,
            frame_rate=self.canvas.frame_rate,
            first_frame=self._number(self.frames[0]),
            length_frames=len(self.frames),
            layers=tuple(layer for who in seen for layer in self._layers_of(who)),
            digits=self.digits,
            depth=self.depth,
            every_frame=self.every_frame,
            separator=self.separator,
            folder=self.pictures,
            is_filled=bool(seen) and all(each.is_filled for each in self._over_time(seen[0])),
        )
        return stack, tuple(self._notes(seen))

    @property
    def _seen(self) -> list[Who]:
        """The layers that are seen on any frame."""
        return [who for who in self.layers if self._numbers.get(who)]

    def _layers_of(self, who: Who) -> Iterator[StackLayer]:
        """Yield a layer; where it multiplies on some frames and lies plainly on others two, each seen on its own."""
        shown = self._over_time(who)
        numbers = {picture: place for place, picture in enumerate(self._numbers[who].values(), start=1)}
        ways = sorted({each.multiply for each in shown if each.picture is not None}, reverse=True)
        for way in ways:
            own = [each if each.multiply == way else _NOTHING for each in shown]
            pictures = tuple(0 if each.picture is None else numbers[each.picture] for each in own)
            opacities = _opacities(shown) if len(ways) == 1 else tuple(each.seen_opacity for each in own)
            name = who.name if way == ways[0] else f"{who.name}_normal"
            yield StackLayer(name, self._labels[who], way, pictures, opacities)

    def _notes(self, seen: list[Who]) -> Iterator[Message]:
        for who in seen:
            label = self._labels[who]
            if label != who.name:
                yield Message("the layer {name!r} lies in the folder {folder!r}", name=who.name, folder=label)

    def _over_time(self, who: Who) -> tuple[_Shown, ...]:
        return tuple(self._shown.get((who, frame), _NOTHING) for frame in self.frames)

    def _picture(self, layer: DrawnLayer, frame: int) -> int | None:
        """Return the number of a picture; where every frame has one, that of the first that shows it."""
        if not layer.key:
            return None
        numbers = self._numbers.setdefault(layer.who, {})
        return numbers.setdefault(layer.key, self._number(frame) if self.every_frame else len(numbers) + 1)

    def _number(self, frame: int) -> int:
        return frame + self.canvas.first_frame - 1

    def _path(self, who: Who, number: int) -> Path:
        label = self._labels[who]
        return self.folder / self.pictures / label / f"{label}{self.separator}{number:0{self.digits}d}.png"


def _opacities(shown: tuple[_Shown, ...]) -> tuple[float, ...]:
    """Return the opacity on each frame; while nothing is seen that of the last one before, else of the first."""
    last = next(each.opacity for each in shown if each.picture is not None)
    opacities = []
    for each in shown:
        last = last if each.picture is None else each.opacity
        opacities.append(last)
    return tuple(opacities)


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error


def _bytes_of(path: Path) -> bytes:
    """Return a picture that was written before; InputProblem where the system refuses."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise input_problem(path, error) from error
