"""Draws the pictures under the commands of the manual's pages by these commands, with what the demo draws.

::

    .venv/bin/python packaging/dev_made_pictures.py [PAGE ...]

A picture ``../pictures/made/NAME.webp`` of an English page shows what the last ``kagezou render`` or ``kagezou sheet``
above it writes: composites beside each other, or the sheet. So a page cannot show what its commands do not make.
"""

import shlex
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Final

from PIL import Image

from dev_page_commands import PROGRAM, ROOT, PageCommand, commands
from kagezou.cli.demo.scenery import painted
from kagezou.cli.demo.stage import SIZE_PX, make_drawings
from kagezou.io.images.writing import write_rgba

FOLDER: Final = "../pictures/made/"
_HEIGHT_PX: Final = 420
_WIDEST_PX: Final = 1400
_GAP_PX: Final = 8
_QUALITY: Final = 84


def make_world(folder: Path) -> None:
    """Draw into a folder what the pages' commands begin with: ``kagezou-demo`` with its drawings and its meadow."""
    demo = folder / "kagezou-demo"
    make_drawings(demo / "drawings", 2, lambda *_: None)
    write_rgba(demo / "meadow.png", painted(SIZE_PX, SIZE_PX))


def make(page: Path, world: Path) -> None:
    """Run the commands of a page as far as its last picture, and draw its pictures."""
    listed = [each for each in commands(page.read_text(encoding="utf-8")) if not each.is_form]
    wanted = [any(name.startswith(FOLDER) for name in each.pictures) for each in listed]
    if not any(wanted):
        return
    last: PageCommand | None = None
    for command in listed[: len(wanted) - wanted[::-1].index(True)]:
        if command.words[0] != PROGRAM or command.words[1] == "demo":
            continue
        _run(command, world)
        if command.words[1] in ("render", "sheet"):
            last = command
        for name in command.pictures:
            if name.startswith(FOLDER) and last is not None:
                _draw(_made_by(last, world), page.parent / name)


def _run(command: PageCommand, world: Path) -> None:
    sys.stdout.write(f"  {command.text}\n")
    sys.stdout.flush()
    words = [sys.executable, "-m", "kagezou", *command.words[1:]]
    done = subprocess.run(words, cwd=world, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{shlex.join(command.words)}: code {done.returncode}\n{done.stderr}")


def _made_by(command: PageCommand, world: Path) -> list[Path]:
    out = world / command.words[command.words.index("-o") + 1]
    return [out] if out.is_file() else sorted((out / "composite").glob("*.png"))


def _draw(paths: list[Path], target: Path) -> None:
    pictures = [Image.open(path).convert("RGBA") for path in paths]
    for each in pictures:
        each.thumbnail((_WIDEST_PX, _HEIGHT_PX), Image.Resampling.LANCZOS)
    width = sum(each.width for each in pictures) + _GAP_PX * (len(pictures) - 1)
    beside = Image.new("RGB", (width, max(each.height for each in pictures)), "white")
    left = 0
    for each in pictures:
        beside.paste(each, (left, 0), each)
        left += each.width + _GAP_PX
    target = target.resolve()
    target.parent.mkdir(parents=True, exist_ok=True)
    beside.save(target, quality=_QUALITY, method=6)
    sys.stdout.write(f"{target}  {target.stat().st_size // 1000} kB\n")


def main(names: list[str]) -> None:
    """Draw the pictures of the pages that are named, or of all."""
    folder = ROOT / "docs" / "en"
    with tempfile.TemporaryDirectory() as made:
        drawn = Path(made) / "drawn"
        make_world(drawn)
        for page in [folder / f"{name}.md" for name in names] or sorted(folder.glob("*.md")):
            world = Path(made) / page.stem
            world.mkdir()
            (world / "kagezou-demo").symlink_to(drawn / "kagezou-demo")
            make(page, world)


if __name__ == "__main__":
    main(sys.argv[1:])
