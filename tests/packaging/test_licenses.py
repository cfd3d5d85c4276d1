"""A bundle holds the texts without which it may not be passed on."""

import json
import re
import shutil
import sys
import sysconfig
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

import pytest

import bundle_licenses
import bundle_packing

ROOT = Path(__file__).resolve().parents[2]
OF_NO_WHEEL = {"pyopengl": "pyopengl.txt", "pyside6-essentials": "LGPL-3.0.txt", "shiboken6": "LGPL-3.0.txt"}
"""Packages that bring no text, and where it is instead."""


def shipped() -> list[Distribution]:
    """What the bundle takes along with all that is said of it, as far as it is installed here."""
    spec = (ROOT / "packaging" / "kagezou.spec").read_text(encoding="utf-8")
    found = []
    for name in re.findall(r'"([\w-]+)"', spec.partition("METADATA = (")[2].partition("\n)")[0]):
        try:
            found.append(distribution(name))
        except PackageNotFoundError:
            continue
    return found


def test_the_folder_holds_a_text_for_all_that_brings_none(tmp_path: Path) -> None:
    home = bundle_licenses.collected(Path(sys.executable), tmp_path / "licenses")
    assert (home / "kagezou.txt").read_bytes() == (ROOT / "LICENSE").read_bytes()
    assert "PYTHON SOFTWARE FOUNDATION LICENSE" in (home / "python.txt").read_text(encoding="utf-8")
    # The lesser licence is the greater one with permissions besides.
    assert "LESSER GENERAL PUBLIC LICENSE" in (home / "LGPL-3.0.txt").read_text(encoding="utf-8")
    assert (home / "GPL-3.0.txt").stat().st_size > 30_000
    assert "| numpy |" in (home / "THIRD_PARTY.md").read_text(encoding="utf-8")
    listed = json.loads((home / bundle_licenses.PARTS_LIST).read_text(encoding="utf-8"))
    assert listed["bomFormat"] == "CycloneDX"
    packages = shipped()
    assert len(packages) > 10
    for each in packages:
        name = each.metadata["Name"].lower().replace("_", "-")
        brings = any(re.search("licen|copying", str(file), re.IGNORECASE) for file in each.files or ())
        assert brings or (home / OF_NO_WHEEL[name]).is_file(), name


@pytest.mark.skipif(shutil.which("dpkg") is None, reason="dpkg is not installed, which knows whose a library is")
def test_the_system_s_libraries_bring_their_texts(tmp_path: Path) -> None:
    libraries, home = tmp_path / "libraries", tmp_path / "licenses"
    libraries.mkdir()
    home.mkdir()
    (libraries / "libc.so.6").touch()
    (libraries / "libnobody-knows.so.1").touch()
    said: list[str] = []
    bundle_licenses.add_texts_of_system(libraries, home, said.append)
    assert [path.name for path in home.iterdir()] == ["libc6.txt"]
    assert said == []


@pytest.mark.skipif(shutil.which("dpkg") is None, reason="dpkg is not installed, which knows whose a library is")
def test_a_package_without_its_text_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bundle_licenses, "_DOCUMENTS", tmp_path)
    (tmp_path / "libc.so.6").touch()
    said: list[str] = []
    bundle_licenses.add_texts_of_system(tmp_path, tmp_path, said.append)
    assert len(said) == 1
    assert "no text of libc6" in said[0]


def test_where_nothing_tells_whose_a_library_is_it_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("PATH", str(tmp_path))
    said: list[str] = []
    bundle_licenses.add_texts_of_system(tmp_path, tmp_path, said.append)
    assert len(said) == 1
    assert "dpkg" in said[0]


def test_a_python_without_its_text_makes_no_bundle(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sysconfig, "get_path", lambda _: str(tmp_path))
    monkeypatch.setattr(sys, "base_prefix", str(tmp_path))
    with pytest.raises(SystemExit, match=r"no LICENSE\.txt of Python"):
        bundle_licenses.collected(Path(sys.executable), tmp_path / "licenses")


@pytest.mark.skipif(sys.platform != "linux", reason="other systems pack with tools of their own")
def test_the_list_of_parts_lies_beside_what_is_packed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, out = tmp_path / "kagezou", tmp_path / "packed"
    bundle_licenses.collected(Path(sys.executable), folder / "_internal" / "licenses")
    out.mkdir()
    monkeypatch.setattr(shutil, "which", lambda _: None)
    names = [path.name for path in bundle_packing.packed(folder, out, "1.2")]
    assert [re.sub("linux-[^.]+", "SYSTEM", name) for name in names] == [
        "kagezou-1.2-SYSTEM.cdx.json", "kagezou-1.2-SYSTEM.tar.xz", "kagezou-1.2-SYSTEM.run",
    ]  # fmt: skip
    assert json.loads((out / names[0]).read_text(encoding="utf-8"))["components"]
