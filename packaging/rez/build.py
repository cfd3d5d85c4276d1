"""Fills the Rez package: the program and what it needs into `python`, the studio's folders into `studio`."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

STUDIO = ("styles", "presets", "shortcuts")


def main(words: list[str]) -> None:
    """Fill the folder that Rez names, if it installs; a build alone has nothing to make."""
    if "install" not in words:
        return
    source, target = Path(os.environ["REZ_BUILD_SOURCE_PATH"]), Path(os.environ["REZ_BUILD_INSTALL_PATH"])
    fill_studio(source, target)
    # Where this folder was copied away from the sources of Kagezou, a version or a file of it is named.
    program = os.environ.get("KAGEZOU_SOURCE", str(source.parents[1]))
    subprocess.run([sys.executable, "-m", "pip", "install", "--target", str(target / "python"), program], check=True)


def fill_studio(source: Path, target: Path) -> None:
    """Copy the studio's folders; those that there are none of are made."""
    for name in STUDIO:
        made = target / "studio" / name
        made.mkdir(parents=True, exist_ok=True)
        if (source / "studio" / name).is_dir():
            shutil.copytree(source / "studio" / name, made, dirs_exist_ok=True)


if __name__ == "__main__":
    main(sys.argv[1:])
