"""The front door: help, versions, wrong words, exit codes, streams."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from kagezou.cli.main import VERBS
from kagezou.version import __version__
from tests.cli.projects import Shell


def python(*arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    kept = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run(
        [sys.executable, *map(str, arguments)],
        capture_output=True,
        encoding="utf-8",
        check=False,
        env={**kept, **environment},
    )


def kagezou(*arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    return python("-m", "kagezou", *arguments, **environment)


@pytest.mark.parametrize("word", ["--help", "-h", "help"])
def test_help_names_every_command(shell: Shell, word: str) -> None:
    text = shell.ok(word)
    assert all(f"\n  {verb} " in text for verb in VERBS)
    assert "exit codes" in text


@pytest.mark.parametrize("verb", VERBS)
def test_each_command_has_help_with_examples(shell: Shell, verb: str) -> None:
    text = shell.ok(verb, "--help")
    assert text.startswith(f"usage: kagezou {verb}")
    assert f"examples:\n  kagezou {verb}" in text


def test_the_version(shell: Shell) -> None:
    assert shell.ok("--version") == f"kagezou {__version__}\n"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["rendr"], "did you mean render"),
        (["walk.kag"], "a project ends in .kage"),
        (["render", "p.kage", "-o", "x", "--formt", "png"], "did you mean --format"),
        (["render", "p.kage"], "-o/--output"),
        (["render", "p.kage", "-o", "x", "--workers", "0"], "1 or more"),
        (["render", "p.kage", "-o", "x", "--workers", "1000"], "1 to 64"),
        (["render", "p.kage", "-o", "x", "--frames", "5-1"], "5-1"),
        (["render", "p.kage", "-o", "x", "--format", "tga", "--depth", "16"], "tga"),
        (["get", "p.kage"], "PATH"),
        (["set"], "required: PROJECT.kage ("),
        (["info", ""], "empty"),
        (["--louder"], "neither a command nor a project"),
    ],
)
def test_wrong_words_are_one_line(shell: Shell, words: list[str], sentence: str) -> None:
    assert sentence in shell.fails(2, *words)


@pytest.mark.parametrize(
    "words",
    [
        ["layers.Hero.tilt=3", "ground.roll=2", "--frame", "1"],
        ["--frame", "1", "layers.Hero.tilt=3", "ground.roll=2"],
        ["layers.Hero.tilt=3", "--frame", "1", "ground.roll=2"],
        ["layers.Hero.tilt=3", "--frame", "1", "--", "ground.roll=2"],
    ],
)
def test_options_stand_before_between_and_behind_other_words(shell: Shell, project: Path, words: list[str]) -> None:
    shell.ok("set", project, *words)
    found = [shell.json("get", project, path) for path in ("layers.Hero.tilt", "ground.roll")]
    assert [[(key["frame"], key["value"]) for key in keys] for keys in found] == [[(1, 3)], [(1, 2)]]


@pytest.mark.parametrize("words", [[], ["p.kage"], ["SHEET.XDTS"]])
def test_without_a_display_there_is_no_window(shell: Shell, words: list[str]) -> None:
    assert "no display" in shell.fails(6, *words)


def test_a_desktop_without_a_console_gets_the_window_or_silence() -> None:
    code = "import os, sys\nfor name in ('DISPLAY', 'WAYLAND_DISPLAY'): os.environ.pop(name, None)\n"
    code += "from kagezou.__main__ import window; sys.stdout = sys.stderr = None; sys.exit(window(['p.kage', 'x']))"
    done = python("-c", code)
    assert (done.returncode, done.stdout, done.stderr) == (6, "", "")


def test_the_command_line_imports_neither_qt_nor_anything_heavy() -> None:
    code = "import sys; from kagezou.__main__ import main; main(['--version']); main(['render', '--help'])\n"
    code += "print(sorted({name.split('.')[0] for name in sys.modules} & set(sys.argv[1:])))"
    done = python("-c", code, "PySide6", "shiboken6", "pyqtgraph", "numpy", "OpenGL", "OpenImageIO")
    assert done.stdout.endswith("[]\n")


def test_a_render_never_imports_qt_nor_what_it_does_not_use(project: Path) -> None:
    code = "import sys; from kagezou.__main__ import main; code = main(sys.argv[1:])\n"
    unused = {"PySide6", "shiboken6", "numpy.ma", "socket", "difflib"}
    unused |= {f"kagezou.geometry.sets.{name}" for name in ("bodies", "shapes", "regions", "unfolding")}
    unused |= {f"kagezou.render.{name}" for name in ("sets", "mirrors", "passes.picture", "passes.sheets")}
    unused |= {f"kagezou.export.{name}" for name in ("layered", "guides", "after.manifest", "exporters.layered_frames")}
    code += f"assert not {unused} & set(sys.modules), {unused} & set(sys.modules); sys.exit(code)"
    done = python("-c", code, "render", project, "-o", project.parent / "out")
    assert (done.returncode, done.stderr) == (0, "")


def test_a_window_comes_without_what_is_only_for_exports() -> None:
    later = (
        "kagezou.ui.export.dialog",
        "kagezou.export.after_effects",
        "kagezou.export.exchange",
        "importlib.metadata",
    )
    code = f"import sys, kagezou.ui.application; print([each for each in {later} if each in sys.modules])"
    assert python("-c", code).stdout == "[]\n"


def test_nothing_is_said_when_all_is_well(project: Path) -> None:
    done = kagezou("render", project, "-o", project.parent / "out", "--composite")
    out = project.parent / "out"
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{out / 'Hero_shadow'}\n{out / 'composite'}\n"


def test_a_reader_that_goes_away_ends_it_silently(project: Path) -> None:
    command = f'"{sys.executable}" -m kagezou info --properties "{project}" --json; echo $? >&2'
    shell = subprocess.run(["/bin/bash", "-c", f"({command}) | true"], capture_output=True, text=True, check=False)
    assert shell.stderr in ("141\n", "0\n")  # 0 where the output was taken before the reader went


def test_a_pipe_whose_reader_is_gone_is_141(project: Path) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        done = subprocess.run(
            [sys.executable, "-m", "kagezou", "info", str(project)], stdout=pipe, stderr=subprocess.PIPE, check=False
        )
    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is always full")
def test_an_output_that_is_full_is_told(project: Path) -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "kagezou", "info", str(project)], stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert done.returncode == 5
    assert done.stderr == b"kagezou: the output cannot be written: no space left on the disk\n"


@pytest.mark.parametrize("encoding", ["cp932", "ascii", "utf-8"])
def test_any_encoding_of_the_terminal_will_do(project: Path, encoding: str) -> None:
    odd = project.with_name("影😀\u202e.kage")
    project.rename(odd)
    for words in (("info", odd), ("get", odd, "layers.🎈.tilt"), ("info", odd, "--properties", "--json")):
        done = subprocess.run(
            [sys.executable, "-m", "kagezou", *map(str, words)],
            capture_output=True,
            check=False,
            env={**os.environ, "PYTHONIOENCODING": encoding, "PYTHONUTF8": "0"},
        )
        assert done.returncode == (2 if words[0] == "get" else 0)
        assert b"Traceback" not in done.stderr


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such variable")
def test_a_system_without_a_language_takes_any_name(project: Path) -> None:
    odd, out = project.with_name("影 絵.kage"), project.with_name("出力")
    project.rename(odd)
    plain = {name: value for name, value in os.environ.items() if name[:3] != "LC_" and name[:6] != "PYTHON"}
    kept = {name: os.environ[name] for name in ("PYTHONPATH",) if name in os.environ}
    done = subprocess.run(
        [sys.executable, "-m", "kagezou", "render", str(odd), "-o", str(out)],
        capture_output=True,
        check=False,
        env={**plain, **kept, "LC_ALL": "C"},
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert len(list((out / "Hero_shadow").iterdir())) == 3
    assert done.stdout.decode("utf-8").strip() == str(out / "Hero_shadow")


def test_names_with_terminal_codes_and_line_ends_are_one_plain_line(shell: Shell, tmp_path: Path) -> None:
    said = shell.fails(7, "info", tmp_path / "a\n\x1b[31mb.kage")
    assert "\\n\\x1b[31mb.kage" in said


def failing(error: BaseException) -> str:
    return f"""
import sys
from kagezou import __main__
from kagezou.cli.verbs import info
def fail(options, entry_points):
    raise {error!r}
info.run = fail
sys.exit(__main__.main(["info", "p.kage"]))
"""


def test_a_defect_is_one_line_and_a_log(tmp_path: Path) -> None:
    code = failing(ZeroDivisionError("two\nlines"))
    done = python("-c", code, XDG_STATE_HOME=str(tmp_path), HOME=str(tmp_path), LOCALAPPDATA=str(tmp_path))
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1
    assert "ZeroDivisionError: two (" in done.stderr
    (log,) = tmp_path.rglob("crash-*.txt")
    assert "called with: " in log.read_text(encoding="utf-8")
    assert "Traceback" in log.read_text(encoding="utf-8")
    assert str(log) in done.stderr


def test_a_defect_shows_its_story_to_those_who_ask(tmp_path: Path) -> None:
    code = failing(KeyError("x"))
    done = python("-c", code, KAGEZOU_DEBUG="1", XDG_STATE_HOME="/proc/nowhere", HOME=str(tmp_path))
    assert "Traceback" in done.stderr
    assert "no report could be written" in done.stderr


def test_too_little_memory_is_told() -> None:
    done = python("-c", failing(MemoryError()))
    assert (done.returncode, done.stderr) == (1, "kagezou: there is not enough memory for this\n")
