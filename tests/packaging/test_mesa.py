"""Mesa for Windows: fetched from a server of the test's own, held against its hash, whole or not at all."""

import hashlib
import http.server
import shutil
import subprocess
import threading
import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

import bundle_mesa

ROOT = Path(__file__).resolve().parents[2]
SEVEN_ZIP = next(filter(None, map(shutil.which, ("7z", "7zz", "7za"))), None)


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Says nothing on stderr."""

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - the name is the library's
        """Say nothing."""


@pytest.fixture
def served(tmp_path: Path) -> Iterator[tuple[Path, str]]:
    """A folder, and the address at which it is served on this machine."""
    folder = tmp_path / "served"
    folder.mkdir()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield folder, f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    thread.join()
    server.server_close()


def archive(
    path: Path, *, names: tuple[str, ...] = ("x64/opengl32.dll", "x64/libgallium_wgl.dll", "x86/opengl32.dll")
) -> str:
    """Write an archive whose files hold their own names, and return its hash."""
    with zipfile.ZipFile(path, "w") as made:
        for name in names:
            made.writestr(name, name)
    return hashlib.sha256(path.read_bytes()).hexdigest()


def content(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in folder.iterdir()}


def test_the_two_libraries_come_and_stay(served: tuple[Path, str], tmp_path: Path) -> None:
    folder, address = served
    digest = archive(folder / "mesa.zip")
    out = tmp_path / "build" / "mesa"
    assert bundle_mesa.main(["--url", f"{address}/mesa.zip", "--sha256", digest.upper(), "--out", str(out)]) == 0
    there = {
        "opengl32.dll": "x64/opengl32.dll",
        "libgallium_wgl.dll": "x64/libgallium_wgl.dll",
        "archive.sha256": f"{digest}\n",
    }
    assert content(out) == there
    (folder / "mesa.zip").unlink()
    assert bundle_mesa.main(["--url", f"{address}/mesa.zip", "--sha256", digest, "--out", str(out)]) == 0
    assert content(out) == there, "nothing is fetched twice"
    assert [path.name for path in out.parent.iterdir()] == ["mesa"]


def test_another_archive_takes_the_place_of_the_one_before(tmp_path: Path) -> None:
    out = tmp_path / "mesa"
    out.mkdir()
    (out / "opengl32.dll").write_text("of an earlier time")
    digest = archive(tmp_path / "mesa.zip")
    assert bundle_mesa.main(["--url", (tmp_path / "mesa.zip").as_uri(), "--sha256", digest, "--out", str(out)]) == 0
    assert content(out)["opengl32.dll"] == "x64/opengl32.dll"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mesa", "mesa.zip"]


@pytest.mark.parametrize(
    ("made", "digest", "said"),
    [
        (("x64/opengl32.dll", "x64/libgallium_wgl.dll"), "0" * 64, "not 0000"),
        (("x64/opengl32.dll", "libgallium_wgl.dll"), None, "there is no x64/libgallium_wgl.dll in it"),
        (("opengl32.dll",), None, "there is no x64/opengl32.dll and no x64/libgallium_wgl.dll in it"),
        (("x64/opengl32.dll", "x64/libgallium_wgl.dll"), "", "is no SHA-256"),
        (None, "0" * 64, "it cannot be fetched: "),
    ],
)
def test_what_is_wrong_is_one_sentence_and_what_was_there_stays(
    served: tuple[Path, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    made: tuple[str, ...] | None,
    digest: str | None,
    said: str,
) -> None:
    folder, address = served
    real = "" if made is None else archive(folder / "mesa.zip", names=made)
    out = tmp_path / "build" / "mesa"
    out.mkdir(parents=True)
    (out / "opengl32.dll").write_text("old")
    words = ["--url", f"{address}/mesa.zip", "--sha256", real if digest is None else digest, "--out", str(out)]
    assert bundle_mesa.main(words) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line
    assert f"{address}/mesa.zip" in line
    assert content(out) == {"opengl32.dll": "old"}
    assert [path.name for path in out.parent.iterdir()] == ["mesa"]


def test_nobody_there_is_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    gone = (tmp_path / "gone.7z").as_uri()
    assert bundle_mesa.main(["--url", gone, "--sha256", "0" * 64, "--out", str(tmp_path / "mesa")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"{gone}: it cannot be fetched: ")
    assert list(tmp_path.iterdir()) == []


def test_an_archive_that_7_zip_has_to_unpack(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without 7-Zip it is asked for; with it (where it is installed) what it cannot unpack is said."""
    broken = tmp_path / "mesa.7z"
    broken.write_bytes(b"7z\xbc\xaf\x27\x1c broken")
    words = ["--url", broken.as_uri(), "--sha256", hashlib.sha256(broken.read_bytes()).hexdigest(), "--out"]
    with monkeypatch.context() as without:
        without.setattr(shutil, "which", lambda _: None)
        assert bundle_mesa.main([*words, str(tmp_path / "mesa")]) == 1
    assert "takes 7-Zip on the path" in capsys.readouterr().err
    if SEVEN_ZIP is not None:
        assert bundle_mesa.main([*words, str(tmp_path / "mesa")]) == 1
        assert "7-Zip cannot unpack it: " in capsys.readouterr().err


@pytest.mark.skipif(SEVEN_ZIP is None, reason="7-Zip is not installed")
def test_an_archive_in_7z(tmp_path: Path) -> None:
    assert SEVEN_ZIP is not None
    (tmp_path / "x64").mkdir()
    for name in bundle_mesa.LIBRARIES:
        (tmp_path / "x64" / name).write_text(name)
    subprocess.run([SEVEN_ZIP, "a", "mesa.7z", "x64"], cwd=tmp_path, check=True, capture_output=True)
    made = tmp_path / "mesa.7z"
    digest = hashlib.sha256(made.read_bytes()).hexdigest()
    assert bundle_mesa.main(["--url", made.as_uri(), "--sha256", digest, "--out", str(tmp_path / "mesa")]) == 0
    assert set(content(tmp_path / "mesa")) == {*bundle_mesa.LIBRARIES, "archive.sha256"}


def test_release_bundle_and_installer_name_the_same_files() -> None:
    release = (ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
    assert release.index("packaging/bundle_mesa.py --sha256") < release.index("packaging/bundle.py")
    script = (ROOT / "packaging" / "windows" / "kagezou.iss").read_text(encoding="utf-8")
    for name in bundle_mesa.LIBRARIES:
        assert rf'Source: "{{#Folder}}\mesa\{name}"; DestDir: "{{app}}"; Tasks: software' in script
