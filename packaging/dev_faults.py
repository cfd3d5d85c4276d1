"""Fails each system call on a folder in which the program works, one at a time, and looks at what is there then.

    python packaging/dev_faults.py [--every N] [TASK …]

A task is a whole process that writes: a project saved, frames of a format, a hand-off, a job, a keepsake. It is run
once as it is; then, for each call on its folder that opens, writes, synchronises, renames, links, closes or reads, once
more with that call failing, by strace. Each run must end in one sentence, with every file as it was or was to become,
or in success with all files as they were to become. Needs Linux and strace.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

import numpy as np

SOUND: Final = frozenset({"refused", "made", "another call"})
"""How a run may end; "another call" is one that failed outside of the folder, as calls of threads change places."""

_PYTHON: Final = (sys.executable, "-P")
"""Without the folder it works in, in which Python would look for modules."""

_HANG_S: Final = 120
_LEDGER: Final = ".kagezou-frames.jsonl"
_FAULTS: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType({
    "openat": ("EACCES", "ENOSPC", "EIO", "EDQUOT"),
    "read": ("EIO",),
    "write": ("ENOSPC", "EIO", "EDQUOT"),
    "pwrite64": ("ENOSPC", "EIO", "EDQUOT"),
    "writev": ("ENOSPC", "EIO", "EDQUOT"),
    "fsync": ("EIO", "ENOSPC", "EDQUOT"),
    "close": ("EIO", "ENOSPC", "EDQUOT"),
    "rename": ("EACCES", "EIO", "ENOSPC", "EDQUOT"),
    "link": ("EACCES", "EIO", "ENOSPC", "EDQUOT"),
    "mkdir": ("EACCES", "EIO", "ENOSPC", "EDQUOT"),
})  # fmt: skip
_CALL: Final = re.compile(r"(?P<pid>\d+) +(?P<name>\w+)\(")
_KEEP: Final = """
import sys
from pathlib import Path
from kagezou.errors import Problem
from kagezou.io.project.file import load
from kagezou.io.project.recovery_file import RecoveredWork, keep
try:
    document = load(Path("walk.kage"))
    keep(Path("kept/walk.keepsake"), RecoveredWork(document, sys.argv[1], None, 1, 1))
except Problem as problem:
    print(f"kagezou: {problem}", file=sys.stderr)
    sys.exit(problem.exit_code)
"""
_WARM: Final = """
import os
import sys
from kagezou.__main__ import main
os.chdir(sys.argv[1])
assert main(sys.argv[3:]) == 0
os.chdir(sys.argv[2])
print("ready", flush=True)
sys.stdin.readline()
sys.exit(main(sys.argv[3:]))
"""
"""Does it once in another folder, so that all modules and drivers are loaded when it is watched. Calls are counted for
each thread, and the first ones of a worker would be those with which the first thread starts Python."""

_ONE_FRAME: Final = ("-o", "out", "--frames", "1", "--workers", "1")


@dataclass(frozen=True)
class Task:
    """What is done: the words of the command once to have something old there, and the words that are tried.

    ``is_threaded`` says that other threads write.
    """

    before: tuple[str, ...]
    tried: tuple[str, ...]
    is_threaded: bool = False


def _rendering(*words: str) -> Task:
    render = ("-m", "kagezou", "render", "walk.kage", *_ONE_FRAME, *words)
    return Task(render, (*render[:3], "bright.kage", *render[4:]), is_threaded=True)


TASKS: Final[Mapping[str, Task]] = MappingProxyType({
    "save": Task((), ("-m", "kagezou", "set", "walk.kage", "light.azimuth=33")),
    "keepsake": Task(("-c", _KEEP, "old"), ("-c", _KEEP, "new")),
    "farm": Task(
        ("-m", "kagezou", "farm", "walk.kage", "--program", "kagezou"),
        ("-m", "kagezou", "farm", "walk.kage", "--program", "kagezou", "--chunk", "3"),
    ),
    "png": _rendering(),
    "tga": _rendering("--format", "tga"),
    "tiff": _rendering("--format", "tiff"),
    "exr": _rendering("--format", "exr"),
    "psd": _rendering("--layered"),
    "after effects": Task(
        ("-m", "kagezou", "export-ae", "walk.kage", "-o", "out", "--workers", "1", "--name", "walk"),
        ("-m", "kagezou", "export-ae", "bright.kage", "-o", "out", "--workers", "1", "--name", "walk"),
        is_threaded=True,
    ),
})  # fmt: skip


def made_before(task: Task, folder: Path) -> None:
    """Fill a folder with two projects of one character, and with what the task finds there."""
    from kagezou.io.images.writing import write_rgba

    (folder / "hero").mkdir(parents=True)
    (folder / "kept").mkdir(mode=0o700)
    for number in (1, 2):
        pixels = np.zeros((48, 64, 4), np.uint8)
        pixels[12:40, 18 + 4 * number : 30 + 4 * number] = (200, 120, 40, 255)
        write_rgba(folder / "hero" / f"walk_{number:04d}.png", pixels)
    for name in ("walk", "bright"):
        _called(folder, ("-m", "kagezou", "new", f"{name}.kage", "--character", "Hero=hero"))
    _called(folder, ("-m", "kagezou", "set", "bright.kage", "layers.Hero.shadow.color=#3050A0", "light.azimuth=20"))
    if task.before:
        _called(folder, task.before)


def _called(folder: Path, words: Sequence[str]) -> None:
    done = subprocess.run([*_PYTHON, *words], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr)


@dataclass(frozen=True)
class Place:
    """A folder that is as it was before whenever it is asked for, always at the same path."""

    before: Path
    work: Path
    other: Path

    def fresh(self) -> Path:
        """Return it as it was."""
        shutil.rmtree(self.work, ignore_errors=True)
        shutil.copytree(self.before, self.work)
        return self.work


def files_of(folder: Path) -> dict[str, bytes]:
    """Return the files of a folder; the ledger may say more or less of them."""
    found = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != _LEDGER)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


def calls_on(log: str, folder: Path) -> Iterator[tuple[str, int]]:
    """Yield each call that touched a folder: its name, and the how manieth of it its thread made."""
    count: Counter[tuple[str, str]] = Counter()
    for line in log.splitlines():
        if (found := _CALL.match(line)) is None:
            continue
        count[found["pid"], found["name"]] += 1
        if is_on(line, folder):
            yield found["name"], count[found["pid"], found["name"]]


def is_on(line: str, folder: Path) -> bool:
    """Return whether a call has to do with a folder; that the program works there is no reason."""
    return str(folder) in line.replace(f"AT_FDCWD<{folder}>", "")


def _traced(place: Place, task: Task, *asked: str) -> tuple[int | None, str, str]:
    """Do a task under strace; return its exit code (None: it hung), what it said, and the log."""
    folder, log = place.fresh(), place.work.with_suffix(".log")
    watch = ["strace", "-f", "-y", "-qq", *asked, "-o", str(log)]
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment["XDG_STATE_HOME"] = str(place.work.with_name("state"))
    command = [*watch, *_PYTHON, *task.tried]
    if task.is_threaded:
        shutil.copytree(place.before, place.other, dirs_exist_ok=True)
        command = [*_PYTHON, "-c", _WARM, str(place.other), str(folder), *task.tried[2:]]
    pipe = subprocess.PIPE
    with subprocess.Popen(
        command, cwd=folder, stdin=pipe, stdout=pipe, stderr=pipe, text=True, env=environment
    ) as process:
        watcher = _watcher(process, watch) if task.is_threaded else None
        try:
            _, said = process.communicate("\n", timeout=_HANG_S)
        except subprocess.TimeoutExpired:
            process.kill()
            return None, "", ""
        finally:
            if watcher is not None:
                watcher.wait()
    return process.returncode, said, log.read_text(encoding="utf-8", errors="replace")


def _watcher(process: "subprocess.Popen[str]", watch: Sequence[str]) -> "subprocess.Popen[bytes]":
    """Watch a process from when it is ready, and return once it is watched."""
    assert process.stdout is not None
    while process.stdout.readline().strip() != "ready":
        if process.poll() is not None:
            raise RuntimeError("it ended before it was watched")
    watcher = subprocess.Popen([*watch, "-p", str(process.pid)])
    status = Path(f"/proc/{process.pid}/status")
    while "TracerPid:\t0\n" in status.read_text(encoding="ascii"):
        if watcher.poll() is not None:
            raise RuntimeError("it cannot be watched")
        time.sleep(0.005)
    return watcher


def ending(
    code: int | None, said: str, there: Mapping[str, bytes], old: Mapping[str, bytes], new: Mapping[str, bytes]
) -> str:
    """Return how a run ended, in a word or two; `SOUND` are good ones."""
    if code is None:
        return "HANG"
    if "Traceback" in said or code < 0 or code == 1:
        return "CRASH"
    if code == 0:
        return "made" if there == new else "FALSE SUCCESS"
    lines = [line for line in said.splitlines() if not line.startswith("kagezou: note: ")]
    if len(lines) != 1 or not lines[0].startswith("kagezou: "):
        return "NOT ONE SENTENCE"
    if any(".part" in name for name in there):
        return "LEFT OVER"
    is_whole = all(content in (old.get(name), new.get(name)) for name, content in there.items())
    return "refused" if is_whole and set(old) <= set(there) else "TORN"


def swept(name: str, *, every: int = 1, calls: Sequence[str] = tuple(_FAULTS)) -> Counter[str]:
    """Return how the runs of a task ended, with every call on its folder failing once.

    Parameters
    ----------
    name
        A key of `TASKS`.
    every
        Only each so manieth of them is tried.
    calls
        Which kinds of calls fail.
    """
    task, found = TASKS[name], Counter[str]()
    with tempfile.TemporaryDirectory() as scratch:
        place = Place(*(Path(scratch) / each for each in ("before", "work", "other")))
        made_before(task, place.before)
        old = files_of(place.before)
        code, said, log = _traced(place, task, "-e", f"trace={','.join(calls)}")
        if code != 0:
            raise RuntimeError(said)
        new = files_of(place.work)
        points: dict[str, set[int]] = defaultdict(set)
        for call, number in calls_on(log, place.work):
            points[call].add(number)
        tries = [(call, number, fault) for call in calls for number in sorted(points[call]) for fault in _FAULTS[call]]
        for call, number, fault in tries[::every]:
            asked = ("-e", f"trace={call}", "-e", f"inject={call}:error={fault}:when={number}")
            code, said, log = _traced(place, task, *asked)
            hit = [line for line in log.splitlines() if "(INJECTED)" in line]
            came = ending(code, said, files_of(place.work), old, new)
            if not hit or not all(is_on(line, place.work) for line in hit):
                came = "another call"
            if came not in SOUND:
                print(f"{name}: {came} at {call} {number} {fault}, exit code {code}\n{said}\n{hit}", flush=True)
            found[came] += 1
    return found


def main(words: list[str]) -> int:
    """Sweep tasks and print the counts."""
    if shutil.which("strace") is None:
        print("strace is not installed", file=sys.stderr)
        return 2
    every, bad = 1, 0
    if words[:1] == ["--every"]:
        every, words = int(words[1]), words[2:]
    for name in words or TASKS:
        found = swept(name, every=every)
        print(name, dict(found), flush=True)
        bad += sum(number for came, number in found.items() if came not in SOUND)
    return min(bad, 1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
