"""A screen of its own for the tests, so that nobody's desktop decides their outcome."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from dev_system import SetupProblem

SCREEN = "1920x1200x24"  # width x height in px, x bits per pixel


@contextmanager
def private_display() -> Iterator[dict[str, str]]:
    """Yield the environment for a process that draws: on Linux, of a virtual screen that ends with the block."""
    if sys.platform != "linux":
        yield dict(os.environ)
        return
    with tempfile.TemporaryDirectory(prefix="kagezou-run-") as runtime:
        # Qt warns about a runtime folder that others could read, and warnings fail our tests.
        Path(runtime).chmod(0o700)
        with _virtual_screen(Path(runtime) / "xvfb.log") as display:
            environment = {key: value for key, value in os.environ.items() if key != "WAYLAND_DISPLAY"}
            yield {
                **environment,
                "DISPLAY": display,
                "XDG_RUNTIME_DIR": runtime,
                "QT_QPA_PLATFORM": "xcb",
                "LIBGL_ALWAYS_SOFTWARE": "1",
            }


@contextmanager
def _virtual_screen(log: Path) -> Iterator[str]:
    number_out, number_in = os.pipe()
    # -displayfd: the server itself picks a free number. -noreset: it outlives its last client.
    command = ["Xvfb", "-displayfd", str(number_in), "-screen", "0", SCREEN, "-nolisten", "tcp", "-noreset"]
    with log.open("wb") as messages, os.fdopen(number_out, encoding="ascii") as answer:
        try:
            # Its own session, so that Ctrl-C reaches the tests first and they still have a screen to close.
            server = subprocess.Popen(
                command, pass_fds=[number_in], stdout=messages, stderr=messages, start_new_session=True
            )
        except OSError as problem:
            raise SetupProblem(f"The virtual screen Xvfb cannot be started: {problem}.") from problem
        finally:
            os.close(number_in)
        try:
            number = answer.readline().strip()  # ends empty when the server dies: ours was the other copy
            if not number:
                last = log.read_text(encoding="utf-8", errors="replace").strip().splitlines()[-1:]
                raise SetupProblem(f"The virtual screen Xvfb did not start: {' '.join(last) or 'it said nothing'}")
            yield f":{number}"
        finally:
            server.terminate()
            try:
                server.wait(timeout=5)
            except subprocess.TimeoutExpired:
                server.kill()
                server.wait()
