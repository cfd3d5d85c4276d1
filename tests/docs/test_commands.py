"""Every command that README and manual name is run, page by page, in the order in which a reader types it."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from dev_page_commands import PROGRAM, ROOT, PageCommand, commands, pages
from kagezou.__main__ import main
from kagezou.cli.demo.figure import drawn
from kagezou.cli.demo.pose import FRAMES, pose_at
from kagezou.cli.main import VERBS
from kagezou.io.images.writing import write_rgba
from tests.docs.typing_shell import NOT_RUN, reason_not_to_run, typed

ENGLISH = [page for page in pages() if page.parent.name != "ja"]
SMALLER, POSES = 8, 6


def commands_of(page: Path) -> list[PageCommand]:
    return list(commands(page.read_text(encoding="utf-8")))


@pytest.fixture(scope="session")
def world(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the pages' commands begin with, eight times smaller and of six different drawings."""
    folder = tmp_path_factory.mktemp("world")
    drawings = folder / "kagezou-demo" / "drawings"
    drawings.mkdir(parents=True)
    poses = [drawn(pose_at(1 + number * FRAMES // POSES), 1000, 1000)[::SMALLER, ::SMALLER] for number in range(POSES)]
    for number, pixels in enumerate(poses, start=1):
        write_rgba(folder / f"{number}.png", np.ascontiguousarray(pixels))
    for frame in range(1, FRAMES + 1):
        shutil.copy(folder / f"{(frame - 1) * POSES // FRAMES + 1}.png", drawings / f"child_{frame:04d}.png")
    write_rgba(folder / "kagezou-demo" / "meadow.png", np.full((125, 125, 4), 255, np.uint8))
    return folder


@pytest.fixture
def folder(world: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of one page, without a display."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "KAGEZOU_DEBUG"):
        monkeypatch.delenv(name, raising=False)
    shutil.copytree(world / "kagezou-demo", tmp_path / "kagezou-demo")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("page", ENGLISH, ids=lambda page: page.stem)
def test_every_command_of_a_page_does_what_it_says(page: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for command in commands_of(page):
        if command.words[0] != PROGRAM or command.is_form or reason_not_to_run(command.text):
            continue
        code = main(typed(command.words[1:], Path.cwd()))
        assert code == 0, f"{command.text}\n{capsys.readouterr().err}"


@pytest.mark.parametrize("page", pages(), ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_what_is_not_run_is_a_form_of_a_command_or_has_a_reason(
    page: Path, capsys: pytest.CaptureFixture[str], helps: Callable[[str], str]
) -> None:
    for command in commands_of(page):
        if reason_not_to_run(command.text):
            continue
        assert command.words[0] == PROGRAM, f"say in NOT_RUN why it is not run: {command.text}"
        if command.is_form and len(command.words) > 1 and command.words[1] in VERBS:
            known = helps(command.words[1])
            for option in (word.split("=")[0] for word in command.words[2:] if word.startswith("-")):
                assert option in known.replace(",", " ").split() or f"[{option}" in known, command.text
    capsys.readouterr()


@pytest.fixture(scope="session")
def helps() -> Callable[[str], str]:
    from tests.docs.typing_shell import help_of

    return help_of


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
    assert os.sep  # the folder of a page is a real one
