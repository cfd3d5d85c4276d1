"""What a release is made with: notes from the changelog, terms of what is shipped, how a bundle calls itself."""

import json
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

import bundle_packing
import dev_third_party
import release_notes
from kagezou import own_process
from kagezou.version import __version__

ROOT = Path(__file__).resolve().parents[2]


def test_the_notes_of_a_release_are_its_part_of_the_changelog() -> None:
    text = (
        "# Changelog\n\n## Unreleased\n\n- new\n\n## 0.2.0 - 2026-12-01\n\n### Features\n\n- a\n\n## [0.2.0.1]\n\n- b\n"
    )
    assert release_notes.notes_of(text, "0.2.0") == "### Features\n\n- a\n"
    assert release_notes.notes_of(text, "0.2.0.1") == "- b\n"
    assert release_notes.notes_of(text, "0.3.0") is None


def test_a_tag_must_be_the_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert release_notes.version() == __version__
    assert release_notes.main([f"v{__version__}9"]) == 1
    assert "is not the version" in capsys.readouterr().err


def test_the_terms_of_everything_that_is_needed_are_named() -> None:
    shipped = {each.name: each for each in dev_third_party.parts()}
    for name in ("numpy", "pyside6-essentials", "openimageio", "pyopengl", "pyqtgraph", "kornia-rs", "zlib-ng", "isal"):
        assert shipped[name].terms not in ("", "see its licence file"), name
    assert "LGPL" in shipped["pyside6-essentials"].terms
    assert "pip" not in shipped
    made = json.loads(json.dumps(dev_third_party.sbom(tuple(shipped.values()), "1.2.3")))
    assert made["metadata"]["component"]["version"] == "1.2.3"
    assert len({each["bom-ref"] for each in made["components"]}) == len(shipped)


def test_the_page_of_terms_is_there_with_what_is_always_shipped() -> None:
    text = (ROOT / "THIRD_PARTY.md").read_text(encoding="utf-8")
    for name in ("numpy", "pyside6-essentials", "openimageio", "pyopengl", "pyqtgraph", "platformdirs", "psd-tools"):
        assert f"| {name} |" in text


def test_a_bundle_runs_modules_and_scripts_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a checkout calls by its Python, a bundle calls by itself."""
    assert own_process.module_words("kagezou.cli") == (sys.executable, "-m", "kagezou.cli")
    assert not own_process.ran_as_child(["--as-script", "x.py"])
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert own_process.program_words() == (sys.executable,)
    script = tmp_path / "hook.py"
    script.write_text(
        f"import sys\nfrom pathlib import Path\nPath({str(tmp_path / 'said')!r}).write_text(' '.join(sys.argv[1:]))\n"
    )
    monkeypatch.setattr(sys, "argv", ["kagezou"])
    _, *words = own_process.script_words(str(script))
    assert own_process.ran_as_child([*words, "one", "two"])
    assert (tmp_path / "said").read_text() == "one two"
    assert not own_process.ran_as_child(["--as-module", "http.server"])
    assert not own_process.ran_as_child(["--version"])


def test_the_spec_and_the_bundle_script_can_be_read() -> None:
    for name in ("kagezou.spec", "bundle.py", "bundle_packing.py", "bundle_trial.py"):
        compile((ROOT / "packaging" / name).read_text(encoding="utf-8"), name, "exec")
    said = subprocess.run(
        [sys.executable, ROOT / "packaging" / "bundle.py", "--help"], capture_output=True, text=True, check=True
    )
    assert "--with" in said.stdout


@pytest.mark.skipif(sys.platform == "win32", reason="a script for Linux")
@pytest.mark.skipif(shutil.which("xz") is None, reason="xz is not installed, without which it says so and ends")
def test_a_bundle_that_unpacks_itself_replaces_nothing_but_a_bundle(tmp_path: Path) -> None:
    bundle = tmp_path / "kagezou-1"
    (bundle / "_internal").mkdir(parents=True)
    (bundle / "kagezou").write_text("#!/bin/sh\necho made\n")
    (bundle / "kagezou").chmod(0o755)
    with tarfile.open(tmp_path / "a.tar.xz", "w:xz") as archive:
        archive.add(bundle, bundle.name)
    script = bundle_packing.self_unpacking(tmp_path / "a.tar.xz", tmp_path / "a.run", "1")

    def unpacked(home: Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(["sh", script, home], capture_output=True, text=True, check=False)

    home = tmp_path / "new" / "kagezou"
    for _ in range(2):
        done = unpacked(home)
        assert (done.returncode, done.stdout) == (0, f"{home / 'kagezou'}\n"), done.stderr
        assert sorted(path.name for path in home.iterdir()) == ["_internal", "kagezou"]
    (home / "mine.txt").write_text("precious")
    assert unpacked(home).returncode == 4
    assert (home / "mine.txt").read_text() == "precious"
    damaged = tmp_path / "b.run"
    damaged.write_bytes(script.read_bytes()[:-40])
    (home / "mine.txt").unlink()
    assert subprocess.run(["sh", damaged, home], capture_output=True, check=False).returncode != 0
    assert (home / "kagezou").is_file()
    assert [path.name for path in home.parent.iterdir()] == ["kagezou"]


@pytest.mark.skipif(sys.platform == "win32", reason="links stand for folders there only with rights of their own")
def test_a_disk_image_shows_where_the_application_is_to_be_dragged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "Kagezou.app" / "Contents").mkdir(parents=True)
    shown: list[str] = []

    def tool_of_a_mac(words: list[str], *, check: bool) -> None:
        assert check
        if words[0] == "ditto":
            shutil.copytree(words[1], words[2])
        else:
            assert words[:4] == ["hdiutil", "create", "-volname", "Kagezou"]
            shown.extend(sorted(path.name for path in Path(words[words.index("-srcfolder") + 1]).iterdir()))

    monkeypatch.setattr(subprocess, "run", tool_of_a_mac)
    bundle_packing.disk_image(tmp_path / "Kagezou.app", tmp_path / "kagezou.dmg")
    assert shown == ["Applications", "Kagezou.app"]


def test_the_installer_says_where_the_panel_looks_where_the_program_is() -> None:
    """``autoappdata`` of Inno Setup is what After Effects calls userData, and appData where it is for all users."""
    script = (ROOT / "packaging" / "windows" / "kagezou.iss").read_text(encoding="utf-8")
    panel = (ROOT / "app" / "resources" / "after_effects" / "Kagezou.jsx").read_text(encoding="utf-8")
    assert 'fsName + "/Kagezou/program.txt"' in panel
    assert "[Folder.userData, Folder.appData]" in panel
    assert r"Folder := ExpandConstant('{autoappdata}\Kagezou');" in script
    assert r"SaveStringsToUTF8File(Folder + '\program.txt', Lines, False)" in script
    assert r"Lines[0] := ExpandConstant('{app}\kagezou.exe');" in script
    assert r'Type: files; Name: "{autoappdata}\Kagezou\program.txt"' in script
    for language in ("en", "ja"):
        assert f"{language}.PanelProblem=%1" in script


def test_a_bundle_for_macs_lies_where_the_panel_looks() -> None:
    spec = (ROOT / "packaging" / "kagezou.spec").read_text(encoding="utf-8")
    panel = (ROOT / "app" / "resources" / "after_effects" / "Kagezou.jsx").read_text(encoding="utf-8")
    assert '"/Applications/Kagezou.app/Contents/MacOS/kagezou"' in panel
    assert 'name="Kagezou.app"' in spec
    assert 'program("kagezou", console=True)' in spec
    # A console program in a bundle of PyInstaller's has no windows unless this says so.
    assert '"LSBackgroundOnly": False' in spec
