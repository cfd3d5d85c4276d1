"""The panel beside a Kagezou at work: nothing waits for it, it can be stopped, and what goes wrong is said."""

import os
import sys
import tempfile
from pathlib import Path

import pytest

from kagezou.io.project.file import load
from tests.export.after_effects.test_panel import panel, panel_at, saved, system
from tests.export.small_cuts import drawings

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")
__all__ = ["panel", "saved", "system"]


@pytest.fixture(autouse=True)
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of temporary files, empty and with a name of many scripts."""
    folder = tmp_path / "一時 🦊 it’s"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", None)
    return folder


LONG = """
    var cut = newComp('cut', 60); cut.put(file, 'A').selected = true;
"""


@pytest.mark.usefixtures("system")
def test_after_effects_does_not_wait(tmp_path: Path, saved: Path, temporary: Path) -> None:
    """The program waits for a file that is only there after the button has been pressed."""
    go = tmp_path / "go"
    panel = panel_at(tmp_path, saved, tmp_path / "kage zou", f"sleep 70 &\nwhile [ ! -e '{go}' ]; do sleep 0.05; done")
    run = panel(f"""
        {LONG}
        click(make);
        var isOn = (each) => panel.buttons[each].enabled;
        var look = () => String([isOn(make), isOn(cancel), panel.buttons[status].text]);
        var seen = look();
        click(bring);
        disk.writeFileSync({str(go)!r}, '');
        settle();
        asked.push(seen, look());
    """)
    assert run.tree["asked"] == ["false,true,プロジェクトを作成中...", "true,false,完了"]
    assert run.tree["alerts"] == ["前の処理がまだ終わっていません。"], "of the second button"
    assert load(saved).canvas.length_frames == 60
    assert list(temporary.iterdir()) == [], "no file is left"


def test_progress_is_shown_and_what_is_stopped_goes_on_the_next_time(tmp_path: Path, saved: Path) -> None:
    panel = panel_at(tmp_path, saved, tmp_path / "kage zou")
    run = panel("""
        var cut = newComp('cut', 400); cut.put(file, 'A').selected = true;
        press(make);
        callProgram('set', settings.saveTo, 'light.position=[5,-20,40]', '--frame', '1');
        callProgram('set', settings.saveTo, 'light.position=[300,-25,45]', '--frame', '400');
        click(bring);
        while (panel.buttons[bar].value === 0) { sleep(20); tick(); }
        asked.push(panel.buttons[status].text);
        click(cancel); settle();
        asked.push(panel.buttons[status].text, String(cut.all.length));
        press(bring);
        asked.push(String(cut.all.length));
    """)
    assert run.tree["alerts"] == []
    rendering, stopped, before, after = run.tree["asked"]
    assert rendering.startswith("影をレンダリング中... ")
    assert int(rendering.split()[-1]) >= 400
    assert stopped == "停止しました。次回は続きから始まります。"
    assert (before, after) == ("1", "4"), "shadow, light and ground"


@pytest.mark.usefixtures("system")
def test_names_of_any_script_go_over(tmp_path: Path) -> None:
    folder = tmp_path / "カット🎬 it’s “B” 表"
    drawings(folder, 3, "主役🦊_")
    saved = folder / "影🦊’.kage"
    panel = panel_at(tmp_path, saved, tmp_path / "影造🎬 ‘x’")
    first = str(folder / "主役🦊__0001.png")
    run = panel(f"""
        var cut = newComp('カット🎬', 4); cut.put({first!r}, '主役🦊').selected = true;
        press(make); press(bring);
    """)
    assert run.tree["alerts"] == []
    assert load(saved).layers[0].name == "主役🦊"
    assert run.layer("カット🎬", "主役🦊 shadow")
    assert all(call.isascii() or call.startswith("try") for call in run.tree["calls"])


@pytest.mark.usefixtures("system")
def test_a_program_that_is_not_there_is_said_at_once(tmp_path: Path, saved: Path, temporary: Path) -> None:
    run = panel_at(tmp_path, saved, tmp_path / "kage zou")(f"""
        {LONG} app.settings.kept.program = '/nowhere/影造'; press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.endswith("/nowhere/影造")
    assert "見つかりません" in said
    assert not [each for each in temporary.iterdir() if "progress" in each.name]


@pytest.mark.parametrize("told", ["user", "all"])
def test_the_program_is_where_the_installer_says(tmp_path: Path, saved: Path, told: str) -> None:
    """A file as the installer writes it, with a mark of its encoding; one that names what is gone is passed over."""
    program = tmp_path / "影造 50%41"
    panel = panel_at(tmp_path, saved, program)
    for name, says in (("user", program if told == "user" else tmp_path / "gone"), ("all", program)):
        (tmp_path / name / "Kagezou").mkdir(parents=True)
        (tmp_path / name / "Kagezou" / "program.txt").write_bytes(f"\ufeff{says}\r\n".encode())
    run = panel(f"""
        {LONG}
        delete app.settings.kept.program;
        Folder.userData.fsName = {str(tmp_path / "user")!r}; Folder.appData.fsName = {str(tmp_path / "all")!r};
        press(make);
    """)
    assert run.tree["alerts"] == []
    assert load(saved).canvas.length_frames == 60


def test_without_an_installer_the_shell_finds_the_program(
    tmp_path: Path, saved: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "bin").mkdir()
    panel = panel_at(tmp_path, saved, tmp_path / "bin" / "kagezou")
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:{os.environ['PATH']}")
    run = panel(f"{LONG} delete app.settings.kept.program; press(make);")
    assert run.tree["alerts"] == []
    assert saved.is_file()


def test_why_it_failed_is_said(tmp_path: Path, saved: Path) -> None:
    panel = panel_at(tmp_path, saved, tmp_path / "kage zou")
    run = panel(f"""
        {LONG}
        press(make);
        disk.writeFileSync(settings.saveTo, 'no project');
        press(bring);
        asked.push(panel.buttons[status].text, String(panel.buttons[bring].enabled));
    """)
    (said,) = run.tree["alerts"]
    assert said.startswith("Kagezou が失敗しました:\n")
    assert saved.name in said
    assert run.tree["asked"] == ["", "true"]


def test_a_program_that_never_answers_is_given_up(tmp_path: Path, saved: Path) -> None:
    panel = panel_at(tmp_path, saved, tmp_path / "kage zou", "exit 0")
    run = panel(f"""
        {LONG}
        var shift = 0, real = Date; Date = class extends real {{ getTime() {{ return super.getTime() + shift; }} }};
        click(make); tick();
        asked.push(String(isWaiting()));
        shift = 61000; tick();
        asked.push(String(isWaiting()));
    """)
    assert run.tree["asked"] == ["true", "false"]
    assert "応答がありません" in run.tree["alerts"][0]


def test_a_composition_that_was_removed_meanwhile_is_said(tmp_path: Path, saved: Path) -> None:
    panel = panel_at(tmp_path, saved, tmp_path / "kage zou")
    run = panel(f"""
        {LONG}
        press(make); click(bring);
        Object.defineProperty(cut, 'name', {{ get() {{ throw new Error('Object is invalid'); }} }});
        settle();
        delete cut.name; cut.name = 'cut';
    """)
    assert run.tree["alerts"] == ["コンポジションがもうありません。"]


def test_the_window_is_opened_apart(tmp_path: Path, saved: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    run = panel_at(tmp_path, saved, tmp_path / "kage zou", f'cp "${{1#@}}" "{tmp_path}/words"; exit 0')(f"""
        {LONG} cut.comment = 'kagezou-project: ' + settings.saveTo; disk.writeFileSync(settings.saveTo, '');
        click(open);
        while (!disk.existsSync({str(tmp_path / "words")!r})) {{ sleep(20); }}
    """)
    assert run.tree["alerts"] == []
    assert saved.name in (tmp_path / "words").read_text(encoding="ascii")


@pytest.mark.parametrize(
    ("rate", "told"), [(12.5, "25/2"), (23.9759979248047, "24000/1001"), (29.9700012207031, "30000/1001"), (24, "24"),
                       (25.0000001, "25"), (14.985, "15000/1001"), (8.3333, "83333/10000"), (59.94, "60000/1001")]
)  # fmt: skip
def test_any_rate_stays(tmp_path: Path, saved: Path, rate: float, told: str) -> None:
    run = panel_at(tmp_path, saved, tmp_path / "kage zou")(f"""
        var cut = newComp('cut', 4);
        cut.frameRate = {rate}; cut.duration = 4 / {rate};
        cut.put(file, 'A').selected = true;
        press(make);
    """)
    assert run.tree["alerts"] == []
    assert str(load(saved).canvas.frame_rate) == told


def test_movies_are_refused_by_name(tmp_path: Path, saved: Path) -> None:
    for name in ("clip_0001.mov", "film.webm"):
        (tmp_path / name).write_bytes(b"")
    run = panel_at(tmp_path, saved, tmp_path / "kage zou")(f"""
        {LONG}
        ['clip_0001.mov', 'film.webm'].forEach((name) => {{
            var film = new FootageItem(new File({str(tmp_path)!r} + '/' + name), false);
            film.mainSource.isStill = false;
            var layer = cut.layers.add(film); layer.name = 'the ' + name; layer.selected = true;
        }});
        press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.splitlines()[1:] == ["the clip_0001.mov", "the film.webm"]
    assert not saved.exists()
