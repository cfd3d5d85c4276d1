"""The words of a command line from a file."""

import json
from pathlib import Path

import pytest

from kagezou.cli.arguments_file import given_words
from tests.cli.projects import Shell, make_drawings


@pytest.mark.parametrize("ascii_only", [True, False])
def test_a_list_has_any_sign_in_any_word(shell: Shell, tmp_path: Path, *, ascii_only: bool) -> None:
    folder = tmp_path / '影 🦊 "a"\n% é'
    make_drawings(folder)
    project = tmp_path / "カット🎬.kage"
    words = ["new", str(project), "--character", f"主役🦊={folder}"]
    file = tmp_path / "words.json"
    file.write_text(json.dumps(words, ensure_ascii=ascii_only), encoding="utf-8")
    assert shell(f"@{file}") == 0, shell.said
    assert shell.json("info", project, "--json")["layers"][0]["name"] == "主役🦊"


def test_lines_are_words(shell: Shell, project: Path, tmp_path: Path) -> None:
    file = tmp_path / "words.txt"
    file.write_bytes(b"\xef\xbb\xbfget\r\n" + str(project).encode() + b"\r\n\r\nlight.kind\r\n")
    assert shell.json(f"@{file}") == "point"


def test_what_is_no_file_of_words_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("@a.kage").touch()
    Path("a.kage").write_text("no words")
    for words in ([], ["@"], ["render", "@x"], ["@a.kage"]):
        assert given_words(words) == words


@pytest.mark.parametrize(
    ("data", "code", "sentence"),
    [
        (None, 3, "it does not exist"),
        (b"\xff\xfe", 3, "are UTF-8"),
        (b'["info", 3]', 2, "not all of them are texts"),
        (b'["info"', 2, "no JSON list"),
        (b'["info\\u0000"]', 2, "a word has a zero in it"),
        (b"a" * ((1 << 20) + 1), 3, "too large"),
    ],
)
def test_what_cannot_be_read_is_one_sentence(
    shell: Shell, tmp_path: Path, data: bytes | None, code: int, sentence: str
) -> None:
    file = tmp_path / "words"
    if data is not None:
        file.write_bytes(data)
    assert sentence in shell.fails(code, f"@{file}")


def test_a_name_too_long_for_the_system_is_one_sentence(shell: Shell) -> None:
    assert shell.fails(3, "@" + "x" * 5000)
