"""A place on a Linux desktop, and small pictures for file managers."""

import configparser
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from kagezou.cli.desktop_files import DesktopFiles, quoted
from kagezou.io.images.reading import probe, read_cel
from kagezou.version import __version__
from tests.cli.projects import Shell

linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="elsewhere the installer does it")


@linux
def test_what_is_put_there_is_taken_away_again(shell: Shell, tmp_path: Path) -> None:
    share = tmp_path / "share"
    written = shell.ok("integrate", "--into", share, "--program", "/opt/kagezou/kagezou").split()
    files = {path for path in share.rglob("*") if path.is_file()}
    assert {Path(each) for each in written} == files
    assert len(files) == 14
    assert shell.ok("integrate", "--into", share, "--remove").split() == written
    assert not any(path.is_file() for path in share.rglob("*"))


def test_a_desktop_is_told_how_the_program_is_called(tmp_path: Path) -> None:
    DesktopFiles(tmp_path, ('/opt/my tools/kage"zou', "-m", "kagezou")).write()
    entry = configparser.ConfigParser(interpolation=None)
    entry.optionxform = str  # type: ignore[assignment,method-assign]
    entry.read(tmp_path / "applications" / "kagezou.desktop", encoding="utf-8")
    found = entry["Desktop Entry"]
    assert shlex.split(found["Exec"].replace("\\\\", "\\"))[0] == '/opt/my tools/kage"zou'
    assert found["Exec"].endswith(" -m kagezou %f")
    assert "[ja]" in (tmp_path / "applications" / "kagezou.desktop").read_text(encoding="utf-8")
    mime = ET.parse(tmp_path / "mime" / "packages" / "kagezou.xml").getroot()
    assert mime[0].attrib["type"] == found["MimeType"].rstrip(";")
    meta = ET.parse(tmp_path / "metainfo" / "org.kagezou.Kagezou.metainfo.xml").getroot()
    (release,) = meta.iter("release")
    assert release.attrib["version"] == __version__
    assert not [
        text for text in tmp_path.rglob("*.*") if b"@" in text.read_bytes() and text.suffix in (".desktop", ".xml")
    ]


@pytest.mark.parametrize(
    ("word", "said"),
    [("/usr/bin/kagezou", "/usr/bin/kagezou"), ("a b", '"a b"'), ("100%", "100%%"), ("$x", '"\\\\$x"')],
)
def test_words_are_quoted_as_desktop_entries_have_them(word: str, said: str) -> None:
    assert quoted(word) == said


@pytest.mark.parametrize("tool", ["desktop-file-validate", "appstreamcli"])
def test_the_files_are_as_their_specifications_have_them(tmp_path: Path, tool: str) -> None:
    if shutil.which(tool) is None:
        pytest.skip(f"{tool} is not here")
    DesktopFiles(tmp_path, ("/usr/bin/kagezou",)).write()
    entry = str(tmp_path / "applications" / "kagezou.desktop")
    meta = str(tmp_path / "metainfo" / "org.kagezou.Kagezou.metainfo.xml")
    words = [entry] if tool == "desktop-file-validate" else ["validate", "--no-net", meta]
    done = subprocess.run([tool, *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_project_has_a_small_picture(shell: Shell, project: Path) -> None:
    picture = project.with_suffix(".png")
    shell.ok("thumbnail", project, "-o", picture, "--size", "48")
    info = probe(picture)
    assert max(info.width_px, info.height_px) == 48
    pixels = read_cel(picture, white_is_clear=False).rgba
    assert (pixels[..., 3] == 255).all()
    assert len({tuple(each) for each in pixels.reshape(-1, 4)}) > 3
