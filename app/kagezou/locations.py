"""Where the shaders and resources lie, in a checkout, an installed wheel and a frozen bundle alike."""

import sys
from functools import cache
from pathlib import Path


def shader_folder() -> Path:
    """Return the folder of the GLSL files."""
    return _bundled("shaders", checkout=("shaders",))


def resource_folder() -> Path:
    """Return the folder of icons, theme, translations and styles."""
    return _bundled("resources", checkout=("app", "resources"))


def manual_folder() -> Path:
    """Return the folder of the manual, a folder a language."""
    return _bundled("docs", checkout=("docs",))


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
