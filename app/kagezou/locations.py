"""Where shaders and resources lie, in a checkout, an installed wheel and a frozen bundle alike; and a studio's own."""

import os
import sys
from functools import cache
from pathlib import Path
from typing import Final

STYLE_FOLDERS: Final = "KAGEZOU_STYLES"
PRESET_FOLDERS: Final = "KAGEZOU_PRESETS"
SHORTCUT_FOLDERS: Final = "KAGEZOU_SHORTCUTS"
"""Variables of the environment that name the folders of a studio's own, parted as in ``PATH``."""


def shader_folder() -> Path:
    """Return the folder of the GLSL files."""
    return _bundled("shaders", checkout=("shaders",))


def resource_folder() -> Path:
    """Return the folder of icons, theme, translations and styles."""
    return _bundled("resources", checkout=("app", "resources"))


def manual_folder() -> Path:
    """Return the folder of the manual, a folder a language."""
    return _bundled("docs", checkout=("docs",))


def studio_folders(variable: str) -> tuple[Path, ...]:
    """Return the folders that a variable of the environment names, of which the first counts most."""
    named = (each.strip() for each in os.environ.get(variable, "").split(os.pathsep))
    return tuple(dict.fromkeys(Path(os.path.expanduser(each)) for each in named if each))  # noqa: PTH111 - as a shell


def own_style_folder() -> Path:
    """Return the folder of the user's own styles, beside which the other things of the user's lie."""
    import platformdirs

    return Path(platformdirs.user_config_path("kagezou", appauthor=False)) / "styles"


@cache
def _bundled(name: str, *, checkout: tuple[str, ...]) -> Path:
    package = Path(__file__).resolve().parent
    frozen = getattr(sys, "_MEIPASS", None)
    candidates = [
        *([Path(frozen, "kagezou", name)] if frozen else []),
        package / name,
        package.parents[1].joinpath(*checkout),
    ]
    for folder in candidates:
        if folder.is_dir():
            return folder
    looked = ", ".join(str(folder) for folder in candidates)
    raise FileNotFoundError(f"the installation is incomplete: no {name!r} folder at {looked}")
