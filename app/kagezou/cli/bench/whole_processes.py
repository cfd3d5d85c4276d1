"""Programs timed from their start to their end: by the clock, by the processor, and by the memory they held.

Each is started by a small process of its own, as this module run: the system counts as a program's memory what the
process held that started it.
"""

import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Final

from kagezou.errors import OutputProblem
from kagezou.message import Message
from kagezou.own_process import module_words

_LIMIT_S: Final = 1800.0
_BYTES: Final = 1 if sys.platform == "darwin" else 1024
"""The unit in which a system tells the memory of a process."""


@dataclass(frozen=True, slots=True)
class Spent:
    """What a program and those it started took.

    Parameters
    ----------
    wall_s, cpu_s
        By the clock, and of all processors, s; the latter 0 where the system does not tell.
    peak_bytes
        The most memory that one of its processes held at a time; 0 where the system does not tell.
    """

    wall_s: float
    cpu_s: float
    peak_bytes: int


def taken(name: str, command: Sequence[str], limit_s: float = _LIMIT_S) -> Spent:
    """Run a program called ``name`` and return what it took.

    Raises
    ------
    OutputProblem
        It cannot be run, fails, or takes longer than ``limit_s``.
    """
    starting = (*module_words("kagezou.cli.bench.whole_processes"), repr(limit_s), *command)
    done = subprocess.run(starting, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode:
        last = (done.stderr.decode("utf-8", "replace").strip().splitlines() or ["?"])[-1]
        raise OutputProblem(Message("{name} cannot be timed: {error}", name=name, error=last))
    return Spent(**json.loads(done.stdout))


def _timed(limit_s: float, command: Sequence[str]) -> Spent:
    """Run a program; end this process with what it said last where it fails."""
    with tempfile.TemporaryFile() as said:
        started = time.perf_counter()
        try:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said)
        except OSError as error:
            sys.exit(str(error))
        patience = threading.Timer(limit_s, process.kill)
        patience.start()
        cpu_s, peak_bytes = _ended(process)
        wall_s = time.perf_counter() - started
        patience.cancel()
        if process.returncode:
            said.seek(0)
            sys.exit(said.read().decode("utf-8", "replace").strip() or f"it ended with {process.returncode}")
    return Spent(wall_s, cpu_s, peak_bytes)


def _ended(process: "subprocess.Popen[bytes]") -> tuple[float, int]:
    """Wait for a process; return its time of the processor, s, and its memory, bytes, with those it waited for."""
    if sys.platform == "win32":
        process.wait()
        return 0.0, 0
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return used.ru_utime + used.ru_stime, used.ru_maxrss * _BYTES


if __name__ == "__main__":
    sys.stdout.write(json.dumps(asdict(_timed(float(sys.argv[1]), sys.argv[2:]))))
