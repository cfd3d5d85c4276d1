"""One writer at a time: others wait or are told, and who dies holds nothing."""

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from kagezou.errors import OutputProblem
from kagezou.io.files.exclusive import exclusive
from kagezou.io.project.open_elsewhere import lock_of_window, open_elsewhere

# Whoever holds the file adds one to the number in it, slowly enough for the others to come in between.
COUNTING = """
import sys, time
from pathlib import Path
from kagezou.io.files.exclusive import exclusive
path = Path(sys.argv[1])
for _ in range(int(sys.argv[2])):
    with exclusive(path, 600):
        number = int(path.read_text())
        time.sleep(0.001)
        path.write_text(str(number + 1))
"""


def start(program: str, *words: object) -> "subprocess.Popen[bytes]":
    return subprocess.Popen([sys.executable, "-c", program, *map(str, words)], stdout=subprocess.PIPE)


def test_of_many_writers_none_loses_what_another_did(tmp_path: Path) -> None:
    path = tmp_path / "number"
    path.write_text("0")
    writers = [start(COUNTING, path, 25) for _ in range(6)]
    for writer in writers:
        writer.communicate()
    assert [writer.returncode for writer in writers] == [0] * 6
    assert path.read_text() == "150"
    if sys.platform != "win32":
        assert list(tmp_path.iterdir()) == [path], "no lock file is left"


def test_who_waits_in_vain_is_told(tmp_path: Path) -> None:
    path = tmp_path / "walk.kage"
    with exclusive(path), pytest.raises(OutputProblem, match=r"walk\.kage: somebody else has been changing it"):  # noqa: SIM117
        with exclusive(path, wait_s=0):
            pass
    with exclusive(path, wait_s=0):
        pass


def test_who_dies_holds_nothing(tmp_path: Path) -> None:
    path = tmp_path / "walk.kage"
    program = "import sys, time\nfrom pathlib import Path\nfrom kagezou.io.files.exclusive import exclusive\n"
    program += "with exclusive(Path(sys.argv[1])):\n    print('held', flush=True)\n    time.sleep(600)\n"
    holder = start(program, path)
    assert holder.stdout is not None
    assert holder.stdout.readline().strip() == b"held"
    with pytest.raises(OutputProblem), exclusive(path, wait_s=0):
        pass
    holder.kill()
    holder.wait()
    holder.stdout.close()
    with exclusive(path, wait_s=60):
        pass


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_link_in_the_place_of_the_lock_is_not_followed(tmp_path: Path) -> None:
    other = tmp_path / "other"
    (tmp_path / ".walk.kage.edit").symlink_to(other)
    with pytest.raises(OutputProblem), exclusive(tmp_path / "walk.kage", wait_s=0):
        pass
    assert not other.exists()


def test_a_folder_that_takes_no_file_is_said(tmp_path: Path) -> None:
    with pytest.raises(OutputProblem), exclusive(tmp_path / "nowhere" / "walk.kage", wait_s=0):
        pass


@pytest.mark.parametrize("text", ["1\nkagezou\nelsewhere\n", "not a number\nkagezou\nelsewhere\n", ""])
def test_a_window_on_another_computer_is_told_of(tmp_path: Path, text: str) -> None:
    path = tmp_path / "walk.kage"
    assert open_elsewhere(path) is None
    lock_of_window(path).write_text(text, encoding="utf-8")
    assert open_elsewhere(path) is not None


def test_a_window_that_died_here_has_nothing_open(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("socket.gethostname", lambda: "here")
    path = tmp_path / "walk.kage"
    gone = start("pass")
    gone.communicate()
    lock_of_window(path).write_text(f"{gone.pid}\nkagezou\nhere\n", encoding="utf-8")
    assert open_elsewhere(path) is None
    lock_of_window(path).write_text(f"{os.getpid()}\nkagezou\nhere\n", encoding="utf-8")
    assert "open in a window on here" in str(open_elsewhere(path))


@pytest.mark.parametrize("is_left", [True, False])
def test_a_lock_of_another_user_is_told_from_a_folder_that_takes_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, is_left: bool
) -> None:
    path = tmp_path / "walk.kage"
    if is_left:
        path.with_name(".walk.kage.edit").touch()

    def refused(*_: object, **__: object) -> int:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(os, "open", refused)
    said = r"another user changes it, or left \.walk\.kage\.edit" if is_left else "cannot be written: permission denied"
    with pytest.raises(OutputProblem, match=rf"walk\.kage: {said}"), exclusive(path):
        pass
