"""The driver is loaded beside other work."""

import os
import subprocess
import sys
import threading

import pytest

from kagezou.errors import GraphicsProblem
from kagezou.message import Message
from kagezou.render.gpu import context
from kagezou.render.gpu.context import GraphicsContext, loading_driver, open_headless_context
from kagezou.render.gpu.targets import Format, Target


def test_it_is_loaded_on_another_thread_while_this_one_draws(monkeypatch: pytest.MonkeyPatch) -> None:
    threads: list[threading.Thread] = []

    def open_it() -> GraphicsContext:
        threads.append(threading.current_thread())
        return open_headless_context()

    monkeypatch.setattr(context, "open_headless_context", open_it)
    with loading_driver(), open_headless_context() as opened:
        assert opened.info.is_enough
        target = Target(2, 2, Format.ALPHA16)
        target.clear()
        assert not target.read(target.box).any()
    assert len(threads) == 1
    assert threads != [threading.current_thread()]
    assert not threads[0].is_alive()


def test_where_there_is_none_nothing_is_said_before_it_is_wanted(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []

    def refused() -> GraphicsContext:
        asked.append(True)
        raise GraphicsProblem(Message("there is no OpenGL context to draw with"))

    monkeypatch.setattr(context, "open_headless_context", refused)
    with loading_driver():
        pass
    assert asked == [True]


def test_what_goes_wrong_within_ends_it_too() -> None:
    with pytest.raises(ZeroDivisionError), loading_driver():
        raise ZeroDivisionError
    assert not any(thread.name == "driver" for thread in threading.enumerate())


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="Mesa lets itself be told which version to have")
@pytest.mark.parametrize("version", ["2.1", "3.2"])
def test_an_opengl_that_is_too_old_is_one_sentence_with_what_is_needed(version: str) -> None:
    code = "from kagezou.render.gpu.context import open_headless_context as o\no()"
    mesa = {"MESA_GL_VERSION_OVERRIDE": version, "MESA_GLSL_VERSION_OVERRIDE": "120"}
    done = subprocess.run(
        [sys.executable, "-c", code], env={**os.environ, **mesa}, capture_output=True, text=True, check=False
    )
    if done.returncode == 0:
        pytest.skip("no Mesa draws here")
    assert "GraphicsProblem: " in done.stderr.splitlines()[-1]
    assert "3.3" in done.stderr.splitlines()[-1]
