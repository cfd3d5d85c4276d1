"""Programs of a studio that are run after an export, each with the path of the manifest as its last word.

They are processes of their own: one that fails, crashes or hangs takes nothing of the export along.
"""

import json
import os
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Final

from kagezou.document.value_words import Json
from kagezou.errors import AfterExportFailed, UsageProblem
from kagezou.io.files.faults import cause_of
from kagezou.message import Message
from kagezou.own_process import module_words, script_words

if TYPE_CHECKING:  # a command is looked at before all that is handed to it is imported
    from kagezou.export.after.manifest import Handover

COMMAND_VARIABLE: Final = "KAGEZOU_AFTER_EXPORT"
MANIFEST_VARIABLE: Final = "KAGEZOU_MANIFEST"
ENTRY_POINTS: Final = "kagezou.after_export"
_POLL_S: Final = 0.1
_GRACE_S: Final = 3.0
_MOST_SAID: Final = 200


@dataclass(frozen=True, slots=True)
class Hook:
    """A program, by what people call it and by its words; ``is_ours`` where it runs in our Python, with our modules."""

    name: str
    words: tuple[str, ...]
    is_ours: bool = False


def hooks_of(command: str | None = None) -> tuple[Hook, ...]:
    """Return what runs after an export: a command, then the entry points of installed packages.

    Parameters
    ----------
    command
        A command as a shell takes it; None for that of ``KAGEZOU_AFTER_EXPORT``. Empty, either of them is for nothing
        at all.

    Raises
    ------
    UsageProblem
        The command cannot be split into words.
    """
    said = _said(command)
    if said is not None and not said.strip():
        return ()
    own = check_command(said)
    return (*((_hook(own),) if own else ()), *_of_packages())


def check_command(command: str | None) -> tuple[str, ...]:
    """Return the words of a command, before an export is begun that it would come after; as for `hooks_of`.

    Raises
    ------
    UsageProblem
        The command cannot be split into words.
    """
    return _words(_said(command) or "")


def _said(command: str | None) -> str | None:
    return os.environ.get(COMMAND_VARIABLE) if command is None else command


def hand_on(over: "Handover", hooks: Iterable[Hook], stopped: Callable[[], bool]) -> tuple[Message, ...]:
    """Run the hooks one after the other, all of them, and return what is to be said.

    An export that is not whole is not handed on, which is said.

    Parameters
    ----------
    stopped
        Asked ten times a second; once it is true, the hook that runs is ended and no other is begun.

    Raises
    ------
    AfterExportFailed
        One of them could not be run, failed or was stopped.
    OutputProblem
        A file that was made cannot be read any more, or there is no room for the manifest.
    """
    waiting = tuple(hooks)
    if not waiting:
        return ()
    if not over.is_whole:
        return (Message("not handed on to {hook}, as the export is not whole", hook=waiting[0].name),)
    notes: list[Message] = []
    failed: AfterExportFailed | None = None
    from kagezou.export.after.manifest import manifest_of

    with manifest_file(manifest_of(over)) as path:
        for hook in waiting:
            try:
                notes.append(_run(hook, path, stopped))
            except AfterExportFailed as problem:
                failed = failed or problem
                notes.append(problem.message)
    if failed is not None:
        raise AfterExportFailed(failed.message, tuple(each for each in notes if each != failed.message))
    return tuple(notes)


@contextmanager
def manifest_file(manifest: Mapping[str, Json]) -> Iterator[Path]:
    """Give the manifest as a file in a folder of its own, which goes when the block ends.

    Raises
    ------
    OutputProblem
        There is no room for it.
    """
    with tempfile.TemporaryDirectory(prefix="kagezou-export-", ignore_cleanup_errors=True) as folder:
        path = Path(folder) / "manifest.json"
        path.write_bytes(_json_bytes(manifest))
        yield path


def _json_bytes(manifest: Mapping[str, Json]) -> bytes:
    """Return UTF-8; where names of files hold bytes that are no text, ASCII, which Python reads back as such."""
    try:
        return json.dumps(manifest, ensure_ascii=False, indent=1).encode("utf-8")
    except UnicodeEncodeError:
        return json.dumps(manifest, indent=1).encode("ascii")


def _words(text: str) -> tuple[str, ...]:
    """Return the words of a command."""
    try:
        # On Windows a backslash parts folders.
        words = shlex.split(text, posix=os.name != "nt")
    except ValueError as error:
        raise UsageProblem(Message("the command {command!r} has no end: {cause}", command=text, cause=error)) from error
    return tuple(word.strip('"') for word in words) if os.name == "nt" else tuple(words)


def _hook(words: tuple[str, ...]) -> Hook:
    """Return what runs a command; a script of Python is run by this Python, as Windows starts none by itself."""
    return Hook(Path(words[0]).name, (*script_words(words[0]), *words[1:]) if words[0].endswith(".py") else words)


def _of_packages() -> Iterator[Hook]:
    """Yield the entry points, each called in a process of its own."""
    if not _is_any_installed():
        return
    from importlib.metadata import entry_points

    module = "kagezou.export.after.entry_point"
    for each in sorted(entry_points(group=ENTRY_POINTS), key=lambda found: found.name):
        yield Hook(each.name, (*module_words(module), each.value), is_ours=True)


def _is_any_installed() -> bool:
    """Return whether a package may have such entry points, without what reads them, which is imported slowly.

    Where Python finds modules in anything but a folder, there may be one.
    """
    group = f"[{ENTRY_POINTS}]".encode()
    for place in map(Path, filter(None, sys.path)):
        if place.is_file():
            return True
        with suppress(OSError), os.scandir(place) as found:
            if any(
                each.name.endswith((".dist-info", ".egg-info")) and group in _named_by(Path(each.path))
                for each in found
            ):
                return True
    return False


def _named_by(package: Path) -> bytes:
    """Return the entry points of an installed package as it writes them; nothing where it has none."""
    with suppress(OSError):
        return (package / "entry_points.txt").read_bytes()
    return b""


def _run(hook: Hook, manifest: Path, stopped: Callable[[], bool]) -> Message:
    """Run a hook to its end and return what it said last."""
    with tempfile.TemporaryFile() as said:
        code = _ended(hook, manifest, said, stopped)
        last = _last_line(said)
    if code is None:
        raise AfterExportFailed(Message("{hook} was stopped; the export is whole", hook=hook.name))
    if code:
        words = Message("{hook} failed with code {code}", hook=hook.name, code=code)
        if last:
            words = Message("{hook} failed with code {code}: {said}", hook=hook.name, code=code, said=last)
        raise AfterExportFailed(Message("the export is whole, but {what}", what=words))
    return Message("handed on to {hook}: {said}", hook=hook.name, said=last) if last else _handed_on(hook)


def _handed_on(hook: Hook) -> Message:
    return Message("handed on to {hook}", hook=hook.name)


def _ended(hook: Hook, manifest: Path, said: IO[bytes], stopped: Callable[[], bool]) -> int | None:
    """Return the exit code of a hook; None where it was stopped."""
    try:
        process = subprocess.Popen(
            [*hook.words, str(manifest)],
            stdin=subprocess.DEVNULL,
            stdout=said,
            stderr=subprocess.STDOUT,
            env=_surroundings(hook, manifest),
            # Ctrl-C in a terminal is for us; whoever is to be ended is ended by us, with all it began.
            start_new_session=os.name != "nt",
        )
    except (OSError, ValueError) as error:
        cause = cause_of(error) if isinstance(error, OSError) else str(error)
        words = Message("{hook} cannot be run: {cause}", hook=hook.name, cause=cause)
        raise AfterExportFailed(Message("the export is whole, but {what}", what=words)) from error
    try:
        while True:
            with suppress(subprocess.TimeoutExpired):
                return process.wait(_POLL_S)
            if stopped():
                return None
    finally:
        if process.poll() is None:
            _end(process)


def _end(process: "subprocess.Popen[bytes]") -> None:
    """End a process and what it began: asked first, then without asking."""
    if os.name == "nt":
        subprocess.run(["taskkill", "/F", "/T", "/PID", str(process.pid)], capture_output=True, check=False)
        process.wait()
        return
    import signal

    for sign, patience_s in ((signal.SIGTERM, _GRACE_S), (signal.SIGKILL, None)):
        # The second also reaches what the process began, and what does not listen.
        with suppress(ProcessLookupError):
            os.killpg(process.pid, sign)
        with suppress(subprocess.TimeoutExpired):
            process.wait(patience_s)


def _surroundings(hook: Hook, manifest: Path) -> dict[str, str]:
    """Return the variables of a hook: an export that it makes itself has no hooks."""
    variables = os.environ | {COMMAND_VARIABLE: "", MANIFEST_VARIABLE: str(manifest)}
    if hook.is_ours:
        # Another Python would find modules there that are not for it.
        variables["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    return variables


def _last_line(said: IO[bytes]) -> str:
    said.seek(0, os.SEEK_END)
    said.seek(max(said.tell() - 4 * _MOST_SAID, 0))
    lines = [line.strip() for line in said.read().decode("utf-8", errors="replace").splitlines()]
    return next((line[:_MOST_SAID] for line in reversed(lines) if line), "")
