"""What is left out of a bundle's libraries: data of ICU in other languages, and Qt sorts as before with the rest."""

import shutil
import subprocess
import sys
from pathlib import Path

import PySide6
import pytest

import bundle_slimming

HEAD = b"\x20\x00\xda\x27\x14\x00\x00\x00\x00\x00\x02\x00CmnD".ljust(32, b"\0")
SORTED = """
import functools
from PySide6.QtCore import QCollator, QDateTime, QLocale, QTimeZone
for name in ("ja_JP", "en_US", "de_DE"):
    collator = QCollator(QLocale(name))
    collator.setNumericMode(True)
    words = ["b10", "b9", "あ", "イ", "亜", "Ä", "z", "a", "c012_A", "C012_B", "ウ"]
    print(sorted(words, key=functools.cmp_to_key(collator.compare)))
for name in ("ja_JP", "en_US"):
    moment = QDateTime.fromMSecsSinceEpoch(0, QTimeZone(b"Asia/Tokyo"))
    print(QLocale(name).toString(moment, QLocale.FormatType.LongFormat))
"""


@pytest.mark.parametrize(
    ("name", "kept"),
    [
        ("icudt73l/coll/ja.res", True),
        ("icudt73l/coll/root.res", True),
        ("icudt73l/coll/ucadata.icu", True),
        ("icudt73l/coll/zh.res", False),
        ("icudt73l/en_US.res", True),
        ("icudt73l/ja_JP_TRADITIONAL.res", True),
        ("icudt73l/vai_Latn_LR.res", False),
        ("icudt73l/de.res", False),
        ("icudt73l/zone/de_AT.res", False),
        ("icudt73l/zone/tzdbNames.res", True),
        ("icudt73l/zoneinfo64.res", True),
        ("icudt73l/lang/ja.res", False),
        ("icudt73l/brkitr/cjdict.dict", False),
        ("icudt73l/ibm-943_P15A-2003.cnv", False),
        ("icudt73l/cnvalias.icu", True),
    ],
)
def test_what_the_program_may_look_up_stays(name: str, *, kept: bool) -> None:
    assert bundle_slimming.is_ours(name) == kept


def test_a_package_is_what_it_was_made_of() -> None:
    items = {"icu/z.res": b"last" * 9, "icu/a.res": b"0123456789abcdef", "icu/B.icu": b"x"}
    package = bundle_slimming.icu_package(HEAD, items)
    head, found = bundle_slimming.icu_items(package)
    assert head == HEAD
    assert list(found) == ["icu/B.icu", "icu/a.res", "icu/z.res"], "as bytes, since it is searched by halves"
    assert {name: item[: len(items[name])] for name, item in found.items()} == items
    assert all(not item[len(items[name]) :].strip(b"\0") for name, item in found.items())
    assert all(package.index(item) % 16 == 0 for item in items.values())


def test_other_data_are_refused() -> None:
    with pytest.raises(ValueError, match="no data of ICU"):
        bundle_slimming.icu_items(b"\0" * 64)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="libraries of Linux")
@pytest.mark.skipif(shutil.which("cc") is None or shutil.which("strip") is None, reason="no compiler, or no binutils")
def test_qt_sorts_and_tells_the_time_with_what_is_left(tmp_path: Path) -> None:
    original = next((Path(PySide6.__path__[0]) / "Qt" / "lib").glob("libicudata.so.*"))
    inside = tmp_path / "_internal"
    inside.mkdir()
    (inside / "shadow.softness.png").write_bytes(b"no library")
    cut = Path(shutil.copy(original, inside))
    said: list[str] = []
    bundle_slimming.slimmed(tmp_path, said.append)
    assert said == []
    assert cut.stat().st_size < original.stat().st_size / 5
    assert sorted(path.name for path in inside.iterdir()) == [cut.name, "shadow.softness.png"]

    def told(**environment: str) -> str:
        words = [sys.executable, "-c", SORTED]
        environment = {"LC_ALL": "C.UTF-8", "PYTHONUTF8": "1", **environment}
        return subprocess.run(words, env=environment, capture_output=True, text=True, check=True).stdout

    with_it = told(LD_LIBRARY_PATH=str(inside), LD_DEBUG="files", LD_DEBUG_OUTPUT=str(tmp_path / "loaded"))
    assert with_it == told()
    assert any(str(cut) in path.read_text(errors="replace") for path in tmp_path.glob("loaded.*")), "it was the one"


def test_what_cannot_be_done_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "_internal").mkdir()
    monkeypatch.setattr(shutil, "which", lambda _: None)
    said: list[str] = []
    bundle_slimming.slimmed(tmp_path, said.append)
    assert len(said) == (2 if sys.platform.startswith("linux") else 0)
