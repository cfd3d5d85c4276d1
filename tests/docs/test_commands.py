"""Every command that README and manual name is run, page by page, in the order in which a reader types it."""

import re
import runpy
import shutil
from pathlib import Path

import numpy as np
import pytest

from dev_page_commands import PROGRAM, ROOT, PageCommand, commands, pages
from kagezou.cli.demo.figure import drawn
from kagezou.cli.demo.pose import FRAMES, pose_at
from kagezou.cli.main import VERBS
from kagezou.io.images.writing import write_rgba
from tests.docs.typing_shell import NOT_RUN, help_of, reason_not_to_run, run, typed

ENGLISH = [page for page in pages() if page.parent.name != "ja"]
SMALLER, POSES, SHORT = 16, 6, 8
DRAWS = "kagezou demo"
FOUND = {
    "walk.kage": ("Hero",),
    "duo.kage": ("A", "B"),
    "show.kage": ("A",),
    "master.kage": ("A",),
    "ep03/c001.kage": ("A",),
}
"""Projects that a page takes for granted which does not begin with the demo, and their characters."""


CHAPTERS = [(ROOT / "docs" / "en" / "gallery.md", number) for number in range(11)]
"""The gallery's chapters have nothing to do with each other, and are tests of their own."""
STRETCHES = [*((page, None) for page in ENGLISH if page.stem != "gallery"), *CHAPTERS]


def commands_of(page: Path, chapter: int | None = None) -> list[PageCommand]:
    text = page.read_text(encoding="utf-8")
    return list(commands(text if chapter is None else re.split(r"^## ", text, flags=re.MULTILINE)[chapter]))


@pytest.fixture(scope="session")
def world(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the pages' commands begin with, sixteen times smaller and of six different drawings."""
    folder = tmp_path_factory.mktemp("world")
    demo = folder / "kagezou-demo"
    drawings = demo / "drawings"
    drawings.mkdir(parents=True)
    poses = [drawn(pose_at(1 + number * FRAMES // POSES), 1000, 1000)[::SMALLER, ::SMALLER] for number in range(POSES)]
    for number, pixels in enumerate(poses, start=1):
        write_rgba(folder / f"{number}.png", np.ascontiguousarray(pixels))
    for frame in range(1, FRAMES + 1):
        shutil.copy(folder / f"{(frame - 1) * POSES // FRAMES + 1}.png", drawings / f"child_{frame:04d}.png")
    write_rgba(demo / "meadow.png", np.full((*poses[0].shape[:2], 4), 255, np.uint8))
    for place in ("hero", "cels/A", "ep03/cuts/c001/A"):
        (folder / place).mkdir(parents=True)
        for number in range(1, POSES + 1):
            shutil.copy(folder / f"{number}.png", folder / place / f"walk_{number:04d}.png")
    return folder


@pytest.fixture(scope="session")
def known() -> dict[tuple[str, ...], bytes]:
    """Projects that were made already, by the words behind their names."""
    return {}


@pytest.fixture
def folder(
    request: pytest.FixtureRequest,
    world: Path,
    known: dict[tuple[str, ...], bytes],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> Path:
    """A folder of one page, without a display."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "KAGEZOU_DEBUG"):
        monkeypatch.delenv(name, raising=False)
    shutil.copytree(world, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    found = [each.text for each in commands_of(request.getfixturevalue("page"))]
    if not any(text.startswith(DRAWS) for text in found):
        for name, characters in FOUND.items():
            if any(name.split("/")[-1] in text or "ep03/*.kage" in text for text in found):
                words = [word for each in characters for word in ("--character", f"{each}=hero")]
                assert run(["new", name, *words], known) == 0
    return tmp_path


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("page", "chapter"), STRETCHES, ids=lambda part: part.stem if isinstance(part, Path) else str(part or "")
)
def test_every_command_of_a_page_does_what_it_says(
    page: Path, chapter: int | None, known: dict[tuple[str, ...], bytes], capsys: pytest.CaptureFixture[str]
) -> None:
    for command in commands_of(page, chapter):
        if command.words[0] != PROGRAM or command.is_form or reason_not_to_run(command.text):
            continue
        code = run(typed(command.words[1:], Path.cwd()), known)
        assert code == 0, f"{command.text}\n{capsys.readouterr().err}"


@pytest.mark.parametrize("page", pages(), ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_what_is_not_run_is_a_form_of_a_command_or_has_a_reason(page: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for command in commands_of(page):
        if reason_not_to_run(command.text):
            continue
        assert command.words[0] == PROGRAM, f"say in NOT_RUN why it is not run: {command.text}"
        if command.is_form and len(command.words) > 1 and command.words[1] in VERBS:
            listed = help_of(command.words[1])
            for option in (word.split("=")[0] for word in command.words[2:] if word.startswith("-")):
                assert option in listed.replace(",", " ").split() or f"[{option}" in listed, command.text
    capsys.readouterr()


@pytest.mark.parametrize("page", [ROOT / "docs" / "en" / "how-python.md"], ids=["how-python"])
def test_the_first_script_runs(page: Path, folder: Path) -> None:
    text = page.read_text(encoding="utf-8")
    (script,) = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    for path in sorted((folder / "kagezou-demo" / "drawings").iterdir())[SHORT:]:
        path.unlink()
    (folder / "first.py").write_text(script, encoding="utf-8")
    runpy.run_path(str(folder / "first.py"))
    assert len(list((folder / "python_shadows" / "Child_shadow").glob("*.png"))) == SHORT


def test_both_languages_type_the_same() -> None:
    """Only the names of styles, and pages that English alone has, may differ."""
    for page in (ROOT / "docs" / "en").glob("*.md"):
        other = page.parent.parent / "ja" / page.name
        texts = [
            [each.text.split('"')[0] for each in commands_of(one) if not each.is_form and each.words[0] == PROGRAM]
            for one in (page, other)
        ]
        assert set(texts[0]) == set(texts[1]), page.name


def test_every_reason_is_of_a_command_that_is_there() -> None:
    everything = [each.text for page in pages() for each in commands_of(page)]
    assert [each for each in NOT_RUN if not any(text.startswith(each) for text in everything)] == []


def test_every_chapter_of_the_gallery_is_run() -> None:
    text = (ROOT / "docs" / "en" / "gallery.md").read_text(encoding="utf-8")
    assert len(re.split(r"^## ", text, flags=re.MULTILINE)) == len(CHAPTERS)


def test_commands_are_found_in_their_order() -> None:
    text = (
        "Say `kagezou new a.kage` first:\n\n```sh\nkagezou set a.kage light.kind=sun  # a sun\n```\n\n![It](x.webp)\n\n"
        "```python\nkagezou.open()\n```\n\n    kagezou demo      makes it\n\nand `kagezou\nfeet a.kage`.\n"
    )
    found = list(commands(text))
    assert [each.words[1] for each in found] == ["new", "set", "demo", "feet"]
    assert [each.pictures for each in found] == [(), ("x.webp",), (), ()]
    assert found[1].words[-1] == "light.kind=sun"
    assert not any(each.is_form for each in found)
    forms = "`kagezou new P.kage --size WxH` `kagezou render` `kagezou retake P.kage NAME=DIR ...` `kagezou new --psd`"
    assert all(each.is_form for each in commands(forms))
