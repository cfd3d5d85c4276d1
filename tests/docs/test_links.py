"""Links and pictures of everything that is read: each leads somewhere, no picture is heavy, and none lies unused."""

import re
from pathlib import Path

import pytest

from dev_page_commands import ROOT, pages
from kagezou.ui.panels.filter_pictures import EXAMPLES, picture_of

PICTURES = ROOT / "docs" / "pictures"
READ = (*pages(), ROOT / "CHANGELOG.md", ROOT / "THIRD_PARTY.md", ROOT / "app" / "README.md")
MOVING = PICTURES / "window" / "moving.webp"
MOST_BYTES, MOST_MOVING_BYTES, MOST_TOGETHER_BYTES = 120_000, 1_000_000, 1_500_000


def prose(path: Path) -> str:
    """Return the text of a page without what is quoted as code."""
    return re.sub(r"^```.*?^```|`[^`\n]*`", "", path.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def links(path: Path) -> list[str]:
    return [target for target in re.findall(r"\]\(([^)\s]+)\)", prose(path)) if "://" not in target]


def anchors(path: Path) -> set[str]:
    """Return the names of the headings of a page, as websites that show Markdown make them."""
    heads = re.findall(r"^#+ (.+)$", prose(path), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).strip().replace(" ", "-") for head in heads}


@pytest.mark.parametrize("path", READ, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_every_link_leads_to_a_file_and_a_heading(path: Path) -> None:
    for target in links(path):
        name, _, anchor = target.partition("#")
        led_to = path if not name else (path.parent / name).resolve()
        assert led_to.exists(), target
        assert not anchor or anchor in anchors(led_to), target


def test_headings_become_names() -> None:
    assert "a-first-shadow" in anchors(ROOT / "README.md")
    assert anchors(ROOT / "docs" / "ja" / "index.md") >= {"やりたいことから", "影をつくる"}


def test_every_picture_is_shown_somewhere() -> None:
    shown = {(path.parent / target).resolve() for path in READ for target in links(path)}
    shown |= {picture_of(name) for name in EXAMPLES}
    assert [path for path in PICTURES.rglob("*") if path.is_file() and path not in shown] == []


def test_each_language_shows_its_own_window() -> None:
    for language, other in (("en", "ja"), ("ja", "en")):
        for page in (ROOT / "docs" / language).glob("*.md"):
            assert f"window/{other}/" not in page.read_text(encoding="utf-8"), page.name


def test_pictures_are_light() -> None:
    sizes = {path: path.stat().st_size for path in PICTURES.rglob("*") if path.is_file()}
    assert sizes.pop(MOVING) <= MOST_MOVING_BYTES
    assert [path for path, size in sizes.items() if size > MOST_BYTES] == []
    assert sum(sizes.values()) <= MOST_TOGETHER_BYTES


def test_the_readme_is_short_and_has_the_two_commands() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert text.count("\n") <= 150
    assert re.findall(r"^    (python3 .*)$", text, re.MULTILINE) == [
        "python3 packaging/dev.py demo",
        "python3 packaging/dev.py test",
    ]
    gate = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    assert "python3 packaging/dev.py test" in gate
