"""Paths of a project: what it may name on Linux and on Windows, and that names survive."""

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.errors import ProjectProblem
from kagezou.io.project import paths as project_paths
from kagezou.io.project.paths import local_path, refusal_of, stored_path
from tests.documents import FOLDER, paths

posix_only = pytest.mark.skipif(os.name == "nt", reason="these are names of POSIX file systems")


@posix_only
@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("/cuts/c012/A/1.png", "A/1.png"),
        ("/cuts/bg.png", "../bg.png"),
        ("/else/where.png", "../../else/where.png"),
        ("/cuts/c012/C:x.png", "./C:x.png"),
        ("/cuts/c012/\\\\x.png", "./\\\\x.png"),
        ("/cuts/c012/con.png", "con.png"),
        ("/cuts/c012/\u304c.png", "\u304c.png"),
        ("/cuts/c012/\u304b\u3099.png", "\u304b\u3099.png"),
    ],
)
def test_paths_are_kept_relative_with_their_very_characters(path: str, text: str) -> None:
    assert stored_path(Path(path), FOLDER) == text
    assert local_path(text, FOLDER) == Path(path)


@posix_only
@given(paths)
def test_every_file_of_this_computer_can_be_named(path: Path) -> None:
    assert local_path(stored_path(path, FOLDER), FOLDER) == path


@given(text=st.text(max_size=40), windows=st.booleans())
def test_any_text_is_refused_or_a_path_without_an_error(text: str, *, windows: bool) -> None:
    if not refusal_of(text, windows=windows):
        assert not text.startswith(("//", "\\\\"))


@pytest.mark.parametrize("windows", [True, False])
@pytest.mark.parametrize("text", ["//server/share/x", "\\\\server\\share", "/\\server/x", "\\\\?\\C:\\x", "a\0", ""])
def test_refused_everywhere(text: str, *, windows: bool) -> None:
    assert refusal_of(text, windows=windows)


@pytest.mark.parametrize(
    "text",
    ["C:x.png", "NUL", "con.png", "A/com1.txt", "a/COM¹", "lpt9 .x", "a/aux:b", "a/b.png:stream", "./C:/x", "C:/prn"],
)
def test_refused_on_windows(text: str) -> None:
    assert refusal_of(text, windows=True)


@pytest.mark.parametrize("text", ["C:/x.png", "D:\\cels\\1.png", "A/1.png", "../bg.png", "/x/y.png", "console.png"])
def test_allowed_on_windows(text: str) -> None:
    assert refusal_of(text, windows=True) is None


def test_a_drive_is_foreign_elsewhere() -> None:
    assert str(refusal_of("C:/x.png", windows=False)) == "it names a drive of another computer"


def test_a_path_has_an_end() -> None:
    assert str(refusal_of("a" * 5000, windows=False)) == "a path has 1 to 4096 characters"


def test_a_file_on_another_drive_is_absolute(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_way(*_: object) -> str:
        raise ValueError("path is on mount 'D:', start on mount 'C:'")

    monkeypatch.setattr(os.path, "relpath", no_way)
    assert stored_path(Path("/d/1.png"), FOLDER) == "/d/1.png"
    if os.name != "nt":
        with pytest.raises(ProjectProblem, match="network share"):
            stored_path(Path("//server/share/1.png"), FOLDER)
    monkeypatch.setattr(project_paths, "_ON_WINDOWS", True)
    with pytest.raises(ProjectProblem, match="device"):
        local_path("nul", FOLDER)
