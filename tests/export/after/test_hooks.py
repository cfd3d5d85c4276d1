"""Programs that run after an export, really run."""

import json
import os
import sys
import time
from pathlib import Path

import pytest

from kagezou.document.model import Document
from kagezou.errors import AfterExportFailed, UsageProblem
from kagezou.export.after.hooks import COMMAND_VARIABLE, Hook, hand_on, hooks_of
from kagezou.export.after.manifest import Handover
from kagezou.export.made_files import MadeFile
from tests.export.small_cuts import cut


def over(folder: Path, document: Document | None = None, *, is_whole: bool = True) -> Handover:
    """An export of one file."""
    file = folder / "made.png"
    file.write_bytes(b"pixels")
    return Handover("layers", document or cut(folder, 2), None, (MadeFile(file, "shadow"),), is_whole)


def script(folder: Path, text: str, name: str = "publish.py") -> Hook:
    path = folder / name
    path.write_text("import json, os, sys\n" + text)
    return Hook(name, (sys.executable, str(path)))


def never() -> bool:
    return False


def test_a_hook_gets_the_manifest_and_its_last_line_is_told(tmp_path: Path) -> None:
    hook = script(
        tmp_path,
        "found = json.load(open(sys.argv[-1], encoding='utf-8'))\n"
        "assert os.environ['KAGEZOU_MANIFEST'] == sys.argv[-1]\n"
        "print('some talk'); print('published', found['files'][0]['path']); print()\n",
    )
    (note,) = hand_on(over(tmp_path), [hook], never)
    assert str(note) == f"handed on to publish.py: published {tmp_path / 'made.png'}"


def test_a_hook_without_words_and_its_nested_exports(tmp_path: Path) -> None:
    hook = script(tmp_path, f"sys.exit(0 if os.environ[{COMMAND_VARIABLE!r}] == '' else 1)\n")
    assert [str(note) for note in hand_on(over(tmp_path), [hook], never)] == ["handed on to publish.py"]


def test_one_that_fails_is_told_and_the_others_run(tmp_path: Path) -> None:
    failing = script(tmp_path, "print('no such task'); sys.exit(3)\n", "a.py")
    raising = script(tmp_path, "raise ValueError('no shot')\n", "b.py")
    fine = script(tmp_path, "open(os.path.dirname(sys.argv[0]) + '/ran', 'w').close()\n", "c.py")
    with pytest.raises(AfterExportFailed) as found:
        hand_on(over(tmp_path), [failing, raising, fine], never)
    assert str(found.value) == "the export is whole, but a.py failed with code 3: no such task"
    assert [str(note) for note in found.value.notes] == [
        "the export is whole, but b.py failed with code 1: ValueError: no shot",
        "handed on to c.py",
    ]
    assert (tmp_path / "ran").exists()


def test_one_that_fails_without_a_word(tmp_path: Path) -> None:
    with pytest.raises(AfterExportFailed, match=r"^the export is whole, but publish\.py failed with code 4$"):
        hand_on(over(tmp_path), [script(tmp_path, "sys.exit(4)\n")], never)


def test_one_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(AfterExportFailed, match="nowhere cannot be run: "):
        hand_on(over(tmp_path), [Hook("nowhere", (str(tmp_path / "nowhere"),))], never)


@pytest.mark.skipif(os.name == "nt", reason="children are found by their process group")
def test_one_that_hangs_is_stopped_with_all_it_began(tmp_path: Path) -> None:
    hook = script(
        tmp_path,
        "import subprocess, time\n"
        "deaf = 'from signal import *; import time; signal(SIGTERM, SIG_IGN); print(1, flush=True); time.sleep(600)'\n"
        "child = subprocess.Popen([sys.executable, '-c', deaf], stdout=subprocess.PIPE)\n"
        "child.stdout.read(1)\n"
        "open(os.path.dirname(sys.argv[0]) + '/pid', 'w').write(str(child.pid))\n"
        "time.sleep(600)\n",
    )
    pid = tmp_path / "pid"
    with pytest.raises(AfterExportFailed, match=r"publish\.py was stopped; the export is whole"):
        hand_on(over(tmp_path), [hook, Hook("second", ("nothing",))], lambda: pid.exists() and bool(pid.read_text()))
    assert is_gone(int(pid.read_text()))


def is_gone(pid: int) -> bool:
    """Whether a process ends, or has ended and only waits for its parent."""
    while True:
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except FileNotFoundError:
            return True
        if state == "Z":
            return True
        time.sleep(0.01)


def test_what_is_not_whole_is_not_handed_on(tmp_path: Path) -> None:
    (note,) = hand_on(over(tmp_path, is_whole=False), [Hook("publish", ("nothing",))], never)
    assert str(note) == "not handed on to publish, as the export is not whole"
    assert hand_on(over(tmp_path), [], never) == ()


def test_where_commands_come_from(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(COMMAND_VARIABLE, raising=False)
    assert hooks_of() == ()
    monkeypatch.setenv(COMMAND_VARIABLE, "publish --show 'Ep 3'")
    assert hooks_of() == (Hook("publish", ("publish", "--show", "Ep 3")),)
    assert hooks_of("/bin/other") == (Hook("other", ("/bin/other",)),)
    assert hooks_of("tell.py x") == (Hook("tell.py", (sys.executable, "tell.py", "x")),)
    assert hooks_of("") == ()
    with pytest.raises(UsageProblem, match="has no end"):
        hooks_of("publish 'x")


def test_an_entry_point_of_a_package_is_called(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    about = tmp_path / "studio-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: studio\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[kagezou.after_export]\nto the studio = studio:take\n")
    (tmp_path / "studio.py").write_text(
        "def take(manifest):\n    print(manifest['export']['kind'], len(manifest['files']))\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delenv(COMMAND_VARIABLE, raising=False)
    (hook,) = hooks_of()
    assert [str(note) for note in hand_on(over(tmp_path), [hook], never)] == ["handed on to to the studio: layers 1"]
    monkeypatch.setenv(COMMAND_VARIABLE, "")
    assert hooks_of() == ()


@pytest.mark.skipif(sys.platform != "linux", reason="only there may names of files be no text")
def test_names_that_are_no_text_come_through(tmp_path: Path) -> None:
    odd = Path(os.fsdecode(os.fsencode(tmp_path) + b"/\xff\xfe.png"))
    odd.write_bytes(b"pixels")
    export = Handover("layers", cut(tmp_path, 1), None, (MadeFile(odd, "shadow"),), is_whole=True)
    said = "print(os.path.getsize(json.load(open(sys.argv[-1], encoding='utf-8'))['files'][0]['path']))\n"
    (note,) = hand_on(export, [script(tmp_path, said)], never)
    assert str(note).endswith(": 6")


def test_the_manifest_goes_when_the_hooks_are_over(tmp_path: Path) -> None:
    hook = script(tmp_path, "print(sys.argv[-1])\n")
    (note,) = hand_on(over(tmp_path), [hook], never)
    path = Path(json.loads(json.dumps(str(note).partition(": ")[2])))
    assert path.name == "manifest.json"
    assert not path.parent.exists()
