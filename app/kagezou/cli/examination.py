"""What the doctor looks at besides the graphics card."""

import ctypes
import ctypes.util
import importlib.metadata
import importlib.util
import locale
import platform
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final

from kagezou.cli.terminal import Json
from kagezou.errors import Problem
from kagezou.io.files.processors import processors
from kagezou.io.files.small_files import folder_problems
from kagezou.locations import PRESET_FOLDERS, SHORTCUT_FOLDERS, STYLE_FOLDERS, studio_folders
from kagezou.version import __version__

_PACKAGES: Final = (
    "numpy", "PyOpenGL", "OpenImageIO", "isal", "kornia-rs", "zlib-ng", "mapbox-earcut", "pillow", "platformdirs",
    "PySide6-Essentials", "shiboken6", "pyqtgraph", "psd-tools", "scipy", "aggdraw", "av", "usd-core", "DracoPy",
)  # fmt: skip
_RENDER_LIBRARIES: Final = {"libEGL.so.1": "libegl1", "libGL.so.1": "libgl1"}
_WINDOW_LIBRARIES: Final = {
    "libglib-2.0.so.0": "libglib2.0-0",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
    "libwayland-egl.so.1": "libwayland-egl1",
}
"""What Qt's wheels expect of a Linux system, and the Debian package that has it."""

_STUDIO: Final = (STYLE_FOLDERS, PRESET_FOLDERS, SHORTCUT_FOLDERS)
_RENAMED_FOR_64_BIT_TIME: Final = {"libglib2.0-0": "libglib2.0-0t64"}
_LITTLE_SPACE_BYTES: Final = 1 << 30
_GLIBC_OF_QT_6_10: Final = (2, 34)
_MACOS_OF_QT_6_12: Final = (14,)
"""The oldest systems that the wheels of these and later versions can be installed on."""


def versions() -> dict[str, Json]:
    """Return the program's version and those of what it is built on; None for what is not installed."""
    found: dict[str, Json] = {"kagezou": __version__, "Python": platform.python_version()}
    for package in _PACKAGES:
        try:
            found[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            found[package] = None
    return found


def system() -> dict[str, Json]:
    """Return what runs the program."""
    return {
        "system": platform.platform(),
        "machine": platform.machine(),
        "processors": processors(),
        "memory_mb": _memory_mb(),
    }


def window(*, has_display: bool) -> dict[str, Json]:
    """Return what the window needs, without importing Qt: a library it lacks would end the program."""
    plugins = _platform_plugins()
    return {
        "display": has_display,
        "qt_platforms": [*plugins],
        "missing_libraries": _missing(_WINDOW_LIBRARIES) if platform.system() == "Linux" else [],
    }


def formats() -> dict[str, Json]:
    """Write and read a small picture in each format; yes where it comes back, else the reason."""
    found: dict[str, Json] = {}
    with tempfile.TemporaryDirectory(prefix="kagezou-") as folder:
        for suffix in (".png", ".tga", ".tif", ".exr"):
            found[suffix.removeprefix(".")] = _round_trip(Path(folder, f"probe{suffix}"))
    return found


def folders() -> dict[str, Json]:
    """Return for each folder the program writes to whether it can, and the free space."""
    import platformdirs

    places = {
        "temporary": Path(tempfile.gettempdir()),
        "settings": platformdirs.user_config_path("kagezou", appauthor=False),
        "state": platformdirs.user_state_path("kagezou", appauthor=False),
        "log": platformdirs.user_log_path("kagezou", appauthor=False),
        "present": Path.cwd(),
    }
    return {name: _about_folder(path) for name, path in places.items()}


def text() -> dict[str, Json]:
    """Return how text and names of files are coded."""
    return {
        "locale": locale.setlocale(locale.LC_CTYPE),
        "file_names": sys.getfilesystemencoding(),
        "output": getattr(sys.stdout, "encoding", None),
        "utf8_mode": bool(sys.flags.utf8_mode),
    }


def crashes() -> dict[str, Json]:
    """Return the newest report of a crash; None where there is none."""
    from kagezou.io.files.crash_reports import left_by_dead, report_folder, reports_in
    from kagezou.io.files.faults import shown

    left_by_dead()
    found = reports_in(report_folder())
    return {"newest report": shown(found[0]) if found else None, "reports": len(found)}


def studio() -> dict[str, Json]:
    """Return the folders of a studio's own and what runs after an export; None for what nobody named."""
    from kagezou.export.after.hooks import hooks_of
    from kagezou.io.files.faults import shown

    named = {variable: [shown(folder) for folder in studio_folders(variable)] for variable in _STUDIO}
    try:
        after = ", ".join(hook.name for hook in hooks_of())
    except Problem as problem:
        after = f"it cannot be used: {problem}"
    return {
        **{variable: ", ".join(folders) or None for variable, folders in named.items()},
        "after export": after or None,
    }


def advice(report: Mapping[str, Json], *, can_render: bool) -> Iterator[str]:
    """Yield what is missing, one sentence each, with the command that brings it where it is known."""
    graphics, about_window = report["graphics"], report["window"]
    assert isinstance(graphics, dict)
    assert isinstance(about_window, dict)
    packages: list[str] = []
    if not can_render:
        yield f"OpenGL cannot be used: {graphics.get('problem')}"
        if platform.system() == "Linux":
            packages += [_RENDER_LIBRARIES[str(name)] for name in _missing(_RENDER_LIBRARIES)] or ["libgl1-mesa-dri"]
    lacking = about_window["missing_libraries"]
    assert isinstance(lacking, list)
    if lacking:
        yield f"the window cannot be opened without {', '.join(map(str, lacking))}; rendering can do without"
        packages += [_debian_name(_WINDOW_LIBRARIES[str(name)]) for name in lacking]
    if not about_window["qt_platforms"]:
        yield "the window cannot be opened: PySide6-Essentials is not installed; rendering can do without"
        yield from _fitting_qt()
    if packages and _is_debian():
        yield f"install them: sudo apt-get install --no-install-recommends {' '.join(dict.fromkeys(packages))}"
    yield from (
        str(problem) for name in _STUDIO for folder in studio_folders(name) for problem in folder_problems(folder, name)
    )
    for part in ("formats", "folders", "studio"):
        found = report[part]
        assert isinstance(found, dict)
        yield from (f"{name}: {value}" for name, value in found.items() if isinstance(value, str) and "cannot" in value)


def _fitting_qt() -> Iterator[str]:
    """Yield which version of Qt's wheels this system is new enough for, where it is not so for the newest."""
    library, number = platform.libc_ver()
    mac = platform.mac_ver()[0]
    if library == "glibc" and _numbers(number) < _GLIBC_OF_QT_6_10:
        yield f"with glibc {number} its newest version is 6.9.3: pip install PySide6-Essentials==6.9.3"
    elif mac and _numbers(mac) < _MACOS_OF_QT_6_12:
        yield f"on macOS {mac} its newest version is 6.11.3: pip install PySide6-Essentials==6.11.3"


def _numbers(text: str) -> tuple[int, ...]:
    return tuple(int(each) for each in text.split(".") if each.isdecimal())


def _memory_mb() -> int | None:
    from kagezou.io.files.memory import whole_memory

    whole = whole_memory()
    return None if whole is None else whole >> 20


def _platform_plugins() -> tuple[str, ...]:
    """Return the names of Qt's window system plugins; none where Qt is not installed."""
    spec = importlib.util.find_spec("PySide6")
    roots = [Path(root) for root in (spec.submodule_search_locations or [])] if spec else []
    found = [
        path.stem.removeprefix("lib").removeprefix("q")
        for root in roots
        for folder in (root / "Qt" / "plugins" / "platforms", root / "plugins" / "platforms")
        if folder.is_dir()
        for path in folder.iterdir()
        if path.suffix in {".so", ".dll", ".dylib"}
    ]
    return tuple(sorted(found))


def _missing(libraries: Mapping[str, str]) -> list[Json]:
    missing: list[Json] = []
    for name in libraries:
        try:
            ctypes.CDLL(name)
        except OSError:
            missing.append(name)
    return missing


def _round_trip(path: Path) -> Json:
    import numpy as np

    from kagezou.io.images.reading import read_matte
    from kagezou.io.images.writing import write_rgba

    pixels = np.zeros((4, 4, 4), np.uint8)
    pixels[1:3, 1:3] = (32, 64, 128, 255)
    try:
        write_rgba(path, pixels)
        box = read_matte(path).box
    except Problem as problem:
        return f"it cannot be used: {problem}"
    return True if box is not None and (box.width, box.height) == (2, 2) else "it cannot be used: it reads back wrong"


def _about_folder(path: Path) -> str:
    """Return what can be done in a folder, which need not exist yet."""
    nearest = next((folder for folder in (path, *path.parents) if folder.is_dir()), path)
    try:
        with tempfile.TemporaryFile(dir=nearest) as probe:
            probe.write(b"kagezou")
        free = shutil.disk_usage(nearest).free
    except OSError as error:
        return f"{path} cannot be written to: {error.strerror}"
    little = " (little)" if free < _LITTLE_SPACE_BYTES else ""
    return f"{path}, {free >> 20} MB free{little}"


def _release() -> dict[str, str]:
    try:
        return platform.freedesktop_os_release()
    except OSError:
        return {}


def _is_debian() -> bool:
    release = _release()
    return "debian" in {release.get("ID"), *release.get("ID_LIKE", "").split()}


def _debian_name(package: str) -> str:
    """Return the name a package has in this release: 64-bit time renamed some."""
    release = _release()
    number = release.get("VERSION_ID", "0")
    first_renamed = 24.04 if release.get("ID") == "ubuntu" else 13.0
    is_new = number.replace(".", "", 1).isdigit() and float(number) >= first_renamed
    return _RENAMED_FOR_64_BIT_TIME.get(package, package) if is_new else package
