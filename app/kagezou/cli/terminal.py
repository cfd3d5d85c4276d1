"""What is said to whom: data on stdout, everything else on stderr; progress only where someone is watching."""

import json
import os
import shutil
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Final, TextIO

from kagezou.message import Message

PROGRAM: Final = "kagezou"
_REDRAW_S: Final = 0.1
_LINE_EACH_S: Final = 1.0
"""Where no one watches, progress is a line so often."""
_PACE_STEPS: Final = 24
"""The rate is that of so many steps: what was there before, and is only looked through, costs almost no time."""
_BAR: Final = 24

Json = str | int | float | bool | None | Sequence["Json"] | Mapping[str, "Json"]


def speak_plainly() -> None:
    """Let stdout and stderr escape what their encoding lacks, instead of failing in the middle of a sentence."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


@dataclass(frozen=True, slots=True)
class Voice:
    """How what is said reaches people.

    Parameters
    ----------
    is_quiet
        Notes and progress are left out.
    is_verbose
        Progress is said in lines where no one watches.
    log
        Where everything is written as well.
    heard
        Where notes are kept for a program.
    given
        Where JSON is kept that was given: a program gets one object, whatever happens later.
    """

    is_quiet: bool = False
    is_verbose: bool = False
    log: TextIO | None = None
    heard: list[str] | None = None
    given: list[str] | None = None


_voice: Final[ContextVar[Voice]] = ContextVar("voice", default=Voice())  # noqa: B039 - a frozen value


@contextmanager
def speaking(voice: Voice) -> Iterator[None]:
    """Speak in another way for a while."""
    before = _voice.set(voice)
    try:
        yield
    finally:
        _voice.reset(before)


def tell(sentence: str) -> None:
    """Say one line to the person, on stderr."""
    line = f"{PROGRAM}: {one_line(sentence)}\n"
    log = _voice.get().log
    if log is not None:
        log.write(line)
        log.flush()
    sys.stderr.write(line)
    sys.stderr.flush()


def note(sentence: Message) -> None:
    """Say one line that is no error, on stderr."""
    voice = _voice.get()
    if voice.heard is not None:
        voice.heard.append(str(sentence))
    if not voice.is_quiet:
        tell(f"note: {sentence}")
    elif voice.log is not None:
        voice.log.write(f"{PROGRAM}: note: {one_line(str(sentence))}\n")


def give(line: str) -> None:
    """Give one line of data, on stdout."""
    sys.stdout.write(f"{line}\n")


def give_json(value: Json, *, indent: int | None = None) -> None:
    """Give a value as JSON, on stdout; letters of any script as themselves where stdout can write them."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, indent=indent)
    try:
        text.encode(sys.stdout.encoding or "ascii")
    except (UnicodeEncodeError, LookupError):
        text = json.dumps(value, allow_nan=False, indent=indent)
    given = _voice.get().given
    if given is not None:
        given.append(text)
    give(text)


def one_line(text: str) -> str:
    """Return text as one printable line: names of files may hold line ends and terminal codes."""
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode("ascii") for sign in text)


def is_watched(stream: TextIO) -> bool:
    """Return whether a line that is redrawn makes sense there."""
    return stream.isatty() and os.environ.get("TERM") != "dumb"


class ProgressLine:
    """One line on stderr that counts frames, with their rate and the time left; nothing where no one is watching.

    It is made of ASCII signs and carriage returns alone, so that every terminal and encoding shows it. Use it as a
    context manager: it wipes itself when the work ends.

    Parameters
    ----------
    doing
        What is being done, such as ``rendering``.
    stream
        A terminal, or anything else.
    also
        What else is told of it, such as a file that another program reads.
    unit
        What is counted; None where only the share that is done is of interest.
    """

    def __init__(
        self,
        doing: str,
        stream: TextIO | None = None,
        also: Callable[[int, int], None] | None = None,
        unit: str | None = "frames",
    ) -> None:
        self._unit = unit
        self._also = also
        self._doing = doing
        self._stream = stream or sys.stderr
        self._is_shown = is_watched(self._stream) and not _voice.get().is_quiet
        self._lines_each_s = _LINE_EACH_S if _voice.get().is_verbose and not self._is_shown else None
        self._started = time.monotonic()
        self._pace: deque[tuple[float, int]] = deque(maxlen=_PACE_STEPS)
        self._drawn_at = 0.0
        self._length = 0

    def __enter__(self) -> "ProgressLine":
        return self

    def __exit__(self, *_: object) -> None:
        self.wipe()

    def wipe(self) -> None:
        """Take the line away, for something else to be said; it is back with the next step."""
        if self._length:
            self._stream.write("\r" + " " * self._length + "\r")
            self._stream.flush()
            self._length = 0

    def update(self, done: int, total: int) -> None:
        """Show that ``done`` of ``total`` frames are finished; drawn at most ten times a second."""
        if self._also is not None:
            self._also(done, total)
        now = time.monotonic()
        if not self._pace:
            self._pace.append((self._started, done - 1))
        began, before = self._pace[0]
        self._pace.append((now, done))
        pause = _REDRAW_S if self._lines_each_s is None else self._lines_each_s
        is_due = now - self._drawn_at >= pause or done >= total
        if not is_due or (not self._is_shown and self._lines_each_s is None):
            return
        self._drawn_at = now
        rate = (done - before) / (now - began) if now > began else 0.0
        text = progress_text(self._doing, done, total, rate, self._unit)
        if self._lines_each_s is not None:
            self._stream.write(f"{text}\n")
            self._stream.flush()
            return
        text = text[: max(shutil.get_terminal_size().columns - 1, 1)]
        self._stream.write("\r" + text.ljust(self._length))
        self._stream.flush()
        self._length = max(self._length, len(text))


def progress_text(doing: str, done: int, total: int, rate: float, unit: str | None = "frames") -> str:
    """Return one line of progress.

    Parameters
    ----------
    doing
        What is being done.
    done, total
        Steps finished and asked for.
    rate
        How many were made just now, a second.
    unit
        What a step is called; None for its share in percent.
    """
    filled = _BAR * done // max(total, 1)
    bar = "#" * filled + "-" * (_BAR - filled)
    left = clock_text((total - done) / rate) if rate > 0 else "?"
    count = f"{100 * done // max(total, 1)} %" if unit is None else f"{done}/{total}  {rate:.1f} {unit}/s"
    return f"{doing} [{bar}] {count}  {left} left"


def clock_text(seconds: float) -> str:
    """Return a duration as ``M:SS`` or ``H:MM:SS``."""
    whole = max(round(seconds), 0)
    hours, rest = divmod(whole, 3600)
    minutes, last = divmod(rest, 60)
    return f"{hours}:{minutes:02d}:{last:02d}" if hours else f"{minutes}:{last:02d}"
