"""A hand for measuring: a process of its own that moves the pointer by the X server's test extension."""

import ctypes
import ctypes.util
import os
import time
from collections.abc import Sequence
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection
from types import TracebackType
from typing import Any, Self

from kagezou.errors import UsageProblem
from kagezou.message import Message

Place = tuple[int, int]
"""A point of the screen, px."""

LEFT_BUTTON = 1


@dataclass(frozen=True, slots=True)
class Sent:
    """A move of the pointer: when the server had it (monotonic seconds), and where to."""

    at_s: float
    place: Place


class Hand:
    """Moves and presses as a hand does, at its own pace, however busy the window is.

    Raises
    ------
    UsageProblem
        There is no X server with the test extension.
    """

    def __init__(self) -> None:
        spawn = get_context("spawn")
        self._line, other = spawn.Pipe()
        self._process = spawn.Process(target=_serve, args=(other, os.environ.get("DISPLAY", "")), daemon=True)
        self._process.start()
        other.close()
        if not self._answer():
            self._process.join()
            raise UsageProblem(
                Message("the window can only be measured on an X server with its test extension (libX11, libXtst)")
            )

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._line.close()
        self._process.join()

    def go(self, places: Sequence[Place], every_s: float) -> None:
        """Begin to move through places, one every so many seconds."""
        self._line.send(("go", tuple(places), every_s))

    def press(self, *, down: bool) -> None:
        """Press or let go of the left button."""
        self._line.send(("press", down))

    @property
    def is_done(self) -> bool:
        """Whether what was begun last has ended; ask for ``sent`` then."""
        return self._line.poll()

    def sent(self) -> tuple[Sent, ...]:
        """Return the moves of what was begun last, when it has ended."""
        found = self._answer()
        return found if isinstance(found, tuple) else ()

    def _answer(self) -> object:
        try:
            answer: object = self._line.recv()
        except EOFError:
            return None
        return answer


def _serve(line: Connection, display: str) -> None:
    """Do what is asked until the line is closed; in the hand's own process."""
    server = _Server.open(display)
    line.send(server is not None)
    while server is not None:
        try:
            doing, *words = line.recv()
        except EOFError:
            return
        if doing == "press":
            server.press(down=words[0])
            line.send(())
        else:
            line.send(tuple(_moves(server, *words)))


def _moves(server: "_Server", places: Sequence[Place], every_s: float) -> list[Sent]:
    made, due = [], time.monotonic()
    for place in places:
        server.move(place)
        made.append(Sent(time.monotonic(), place))
        due += every_s
        time.sleep(max(due - time.monotonic(), 0.0))
    return made


@dataclass(frozen=True, slots=True)
class _Server:
    x: Any
    test: Any
    display: Any

    @classmethod
    def open(cls, name: str) -> "_Server | None":
        found = [ctypes.util.find_library(each) for each in ("X11", "Xtst")]
        if not name or None in found:
            return None
        x, test = (ctypes.CDLL(each) for each in found)
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XOpenDisplay.argtypes = [ctypes.c_char_p]
        x.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
        test.XTestFakeMotionEvent.argtypes = [ctypes.c_void_p, *[ctypes.c_int] * 3, ctypes.c_ulong]
        test.XTestFakeButtonEvent.argtypes = [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong]
        test.XTestQueryExtension.argtypes = [ctypes.c_void_p, *[ctypes.POINTER(ctypes.c_int)] * 4]
        display = x.XOpenDisplay(name.encode())
        numbers = [ctypes.byref(ctypes.c_int()) for _ in range(4)]
        if not display or not test.XTestQueryExtension(display, *numbers):
            return None
        return cls(x, test, display)

    def move(self, place: Place) -> None:
        self.test.XTestFakeMotionEvent(self.display, -1, *place, 0)
        self.x.XSync(self.display, 0)

    def press(self, *, down: bool) -> None:
        self.test.XTestFakeButtonEvent(self.display, LEFT_BUTTON, int(down), 0)
        self.x.XSync(self.display, 0)
