"""A cut as layers on each other over time: what the scene of every other program is written from."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

from kagezou.message import Message

Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class StackLayer:
    """One layer; its pictures are as large as the canvas, straight sRGB.

    Parameters
    ----------
    name
        What it is called, in any script.
    label
        The name of its folder, and the first part of its files'.
    multiply
        Whether it multiplies what is under it; else it lies over it.
    pictures
        For each frame the number of its picture, from 1; 0 where nothing is seen.
    opacities
        For each frame, 0 to 1; beside the alpha of the picture.
    """

    name: str
    label: str
    multiply: bool
    pictures: tuple[int, ...]
    opacities: tuple[float, ...]

    @property
    def seen_opacities(self) -> tuple[float, ...]:
        """For each frame the opacity, 0 where nothing is seen."""
        return tuple(
            opacity if picture else 0.0 for picture, opacity in zip(self.pictures, self.opacities, strict=True)
        )


@dataclass(frozen=True, slots=True)
class Stack:
    """Everything a scene is made of.

    Parameters
    ----------
    name
        What the cut is called.
    width_px, height_px, frame_rate
        As of the canvas.
    first_frame
        The number that the first frame bears.
    length_frames
        How many frames there are.
    layers
        From the bottom.
    digits
        How many the number of each file has.
    depth
        Bits a channel, 8 or 16.
    every_frame
        Whether there is a file for every frame, which bears its number, instead of one for every picture.
    is_filled
        Whether the lowest layer fills the whole canvas on every frame.
    separator
        What stands before the number of a file.
    folder
        The folder of the pictures, beside the scene.
    """

    name: str
    width_px: int
    height_px: int
    frame_rate: Fraction
    first_frame: int
    length_frames: int
    layers: tuple[StackLayer, ...]
    digits: int = 4
    depth: int = 8
    every_frame: bool = False
    is_filled: bool = True
    separator: str = "_"
    folder: str = "layers"

    @property
    def last_frame(self) -> int:
        """The number that the last frame bears."""
        return self.first_frame + self.length_frames - 1

    def file(self, label: str, number: int) -> str:
        """Return where a picture lies, from the scene's folder, with forward slashes."""
        return self.pattern(label, f"{number:0{self.digits}d}")

    def pattern(self, label: str, digits: str) -> str:
        """Return where the pictures of a layer lie, with ``digits`` in the place of the number."""
        return f"{self.folder}/{label}/{label}{self.separator}{digits}.png"


@dataclass(frozen=True, slots=True)
class SceneText:
    """A scene as text.

    Parameters
    ----------
    text
        Written as UTF-8.
    notes
        What the program cannot say as it is here, one sentence each.
    """

    text: str
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True, slots=True)
class SceneTarget:
    """A program that scenes are written for.

    Parameters
    ----------
    suffix
        Of the scene's file.
    pictures
        The name of the pictures' folder: one of its own, so that scenes of several programs in one folder stay whole.
    write
        Makes the scene of a stack.
    every_frame
        Whether it wants a file for every frame.
    separator
        What stands before the number of a file.
    is_module
        Whether it imports the scene as Python does, so that its name has letters, digits and ``_`` alone.
    """

    suffix: str
    pictures: str
    write: Callable[[Stack], SceneText]
    every_frame: bool = False
    separator: str = "_"
    is_module: bool = False


def held(values: Iterable[Value], first: int = 1) -> Iterator[tuple[int, Value]]:
    """Yield when another value begins, and it; the first of them is that of frame ``first``."""
    last: list[Value] = []
    for frame, value in enumerate(values, start=first):
        if last != [value]:
            last = [value]
            yield frame, value
