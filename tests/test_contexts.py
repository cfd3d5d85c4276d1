"""Whether a window could be seen: displays that the environment names, and that are there."""

import socket
import sys
from pathlib import Path

import pytest

from kagezou.contexts import avoid_dead_compositor, has_display

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="X11 and Wayland are of Linux")


@pytest.fixture
def nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    """An environment without a display, and with an empty folder for sockets."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    return monkeypatch


def platform_named(nothing: pytest.MonkeyPatch) -> str | None:
    import os

    avoid_dead_compositor()
    named = os.environ.get("QT_QPA_PLATFORM")
    nothing.delenv("QT_QPA_PLATFORM", raising=False)
    return named


def test_without_any_there_is_none(nothing: pytest.MonkeyPatch) -> None:
    assert not has_display()
    assert platform_named(nothing) is None


@pytest.mark.parametrize("is_file", [False, True])
def test_a_compositor_that_is_named_and_gone_is_none(
    nothing: pytest.MonkeyPatch, tmp_path: Path, *, is_file: bool
) -> None:
    nothing.setenv("WAYLAND_DISPLAY", "wayland-7")
    if is_file:
        (tmp_path / "wayland-7").write_bytes(b"")
    assert not has_display()
    nothing.setenv("DISPLAY", ":7")
    assert has_display()
    assert platform_named(nothing) == "xcb"


def test_a_compositor_that_answers_is_used(nothing: pytest.MonkeyPatch, tmp_path: Path) -> None:
    place = tmp_path / "wayland-0"
    with socket.socket(socket.AF_UNIX) as door:
        nothing.chdir(tmp_path)  # a path of a socket may have 107 characters
        door.bind(place.name)
        door.listen()
        nothing.setenv("WAYLAND_DISPLAY", str(place))
        assert has_display()
        nothing.setenv("DISPLAY", ":7")
        assert platform_named(nothing) is None


def test_what_a_person_chose_stays(nothing: pytest.MonkeyPatch) -> None:
    nothing.setenv("WAYLAND_DISPLAY", "wayland-7")
    nothing.setenv("DISPLAY", ":7")
    nothing.setenv("QT_QPA_PLATFORM", "wayland")
    assert platform_named(nothing) == "wayland"


def test_a_socket_without_a_folder_is_none(nothing: pytest.MonkeyPatch) -> None:
    nothing.delenv("XDG_RUNTIME_DIR")
    nothing.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert not has_display()
