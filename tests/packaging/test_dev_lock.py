"""The lock: every package that the project asks for, exactly, with hashes; and systems that are too old for it."""

import importlib
import re
import tomllib
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
_PINNED = re.compile(r"^([A-Za-z0-9][\w.-]*)==([^\s;]+)", re.MULTILINE)


@pytest.fixture
def lock(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return importlib.import_module("dev_lock")


def name_of(requirement: str) -> str:
    found = re.match(r"[A-Za-z0-9][\w.-]*", requirement)
    assert found is not None
    return re.sub(r"[-_.]+", "-", found[0]).lower()


@pytest.mark.parametrize("extra", ["", "dev"])
def test_everything_that_is_asked_for_is_locked_with_hashes(lock: ModuleType, extra: str) -> None:
    text = lock.lock_file(ROOT, extra).read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    asked = {name_of(each) for each in project["dependencies"]} | {"hatchling", "editables"}
    if extra:
        optional = project["optional-dependencies"]
        asked |= {name_of(each) for group in optional.values() for each in group} - {"kagezou"}
    assert asked <= {found[1] for found in _PINNED.finditer(text)}
    entries = re.split(r"\n(?=[A-Za-z0-9])", text)
    assert all("--hash=sha256:" in entry for entry in entries if _PINNED.match(entry))
    assert "://" not in text.replace("https://docs", ""), "no package comes from an address"


def test_both_locks_have_one_version_of_each_package(lock: ModuleType) -> None:
    alone, everything = (
        {(found[1], found[2]) for found in _PINNED.finditer(lock.lock_file(ROOT, extra).read_text(encoding="utf-8"))}
        for extra in ("", "dev")
    )
    assert alone <= everything


@pytest.mark.parametrize(
    ("platform", "glibc", "macos", "reason"),
    [
        ("linux", "2.28", "", "glibc 2.28"),
        ("linux", "2.36", "", ""),
        ("linux", "", "", ""),
        ("darwin", "", "13.6", "macOS 13.6"),
        ("darwin", "", "15.1", ""),
        ("win32", "", "", ""),
    ],
)
def test_a_system_that_is_too_old_says_so(
    lock: ModuleType, monkeypatch: pytest.MonkeyPatch, platform: str, glibc: str, macos: str, reason: str
) -> None:
    monkeypatch.setattr(lock.sys, "platform", platform)
    monkeypatch.setattr(lock.platform, "libc_ver", lambda: ("glibc", glibc))
    monkeypatch.setattr(lock.platform, "mac_ver", lambda: (macos, ("", "", ""), ""))
    said = lock.reason_not_to_lock()
    assert reason in said
    assert bool(said) is bool(reason)
