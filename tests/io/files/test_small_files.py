"""Small files: read whole or refused in one sentence, in every language, and removed."""

from pathlib import Path

import pytest

from kagezou.errors import InputProblem, OutputProblem, ProjectProblem
from kagezou.io.files.small_files import remove_file, small_text
from kagezou.message import Message

TOO_LARGE = Message("it is too large for one")


def test_a_text_is_read_up_to_its_last_byte(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_text("影!", encoding="utf-8")
    assert small_text(path, 4, TOO_LARGE) == "影!"
    with pytest.raises(ProjectProblem) as caught:
        small_text(path, 3, TOO_LARGE)
    assert caught.value.message == TOO_LARGE


def test_what_is_not_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_bytes(b"\xff")
    with pytest.raises(ProjectProblem, match="it is not UTF-8 text"):
        small_text(path, 10, TOO_LARGE)


def test_why_the_system_refuses_is_said_in_words_that_are_translated(tmp_path: Path) -> None:
    with pytest.raises(InputProblem) as caught:
        small_text(tmp_path / "none.json", 10, TOO_LARGE)
    assert caught.value.message.values["cause"] == Message("it does not exist")
    with pytest.raises(OutputProblem) as refused:
        remove_file(tmp_path / ("x" * 300))
    assert refused.value.message.values["cause"] == Message("its name is too long")


def test_a_file_is_removed_once_and_again(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_text("{}")
    remove_file(path)
    assert not path.exists()
    remove_file(path)
