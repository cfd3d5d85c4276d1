"""What is written down of the system at every start, quickly."""

import os
import platform
import subprocess
import sys
from types import SimpleNamespace

import pytest

from kagezou.io.files import this_system
from kagezou.io.files.this_system import system_words


@pytest.mark.skipif(sys.platform == "win32", reason="the system of others")
def test_it_is_what_python_finds_out_more_slowly() -> None:
    words = system_words()
    assert words.startswith(f"{platform.system()} {platform.release()}")
    assert words.endswith(platform.machine())
    assert all(each in words for each in platform.libc_ver())


def test_a_c_library_that_does_not_tell_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    system = SimpleNamespace(sysname="Darwin", release="24.1.0", machine="arm64")
    monkeypatch.setattr(os, "uname", lambda: system, raising=False)
    monkeypatch.setattr(os, "confstr_names", {}, raising=False)
    monkeypatch.setattr(this_system, "sys", SimpleNamespace(platform="darwin"))
    assert system_words() == "Darwin 24.1.0, arm64"


def test_windows_tells_its_build(monkeypatch: pytest.MonkeyPatch) -> None:
    version = SimpleNamespace(major=10, minor=0, build=26100)
    monkeypatch.setattr(this_system, "sys", SimpleNamespace(platform="win32", getwindowsversion=lambda: version))
    monkeypatch.setenv("PROCESSOR_ARCHITECTURE", "AMD64")
    assert system_words() == "Windows 10.0.26100, AMD64"


_RUNS_NOTHING = """
import sys
started = []
kinds = ("subprocess.Popen", "os.exec", "os.posix_spawn", "os.system")
sys.addaudithook(lambda name, _: started.append(name) if name in kinds else None)
from kagezou.__main__ import main
main(["--version"])
main(["info", "nothing.kage"])
assert not started, started
"""


def test_no_program_is_run_for_it() -> None:
    done = subprocess.run([sys.executable, "-c", _RUNS_NOTHING], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "nothing.kage" in done.stderr
