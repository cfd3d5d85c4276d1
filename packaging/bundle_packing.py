"""The files that a bundle's folder is packed into, each as its system wants it."""

import hashlib
import lzma
import os
import platform
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from bundle_licenses import PARTS_LIST

LIBRARIES: Final = (
    "libstdc++6", "libegl1", "libgl1", "libgl1-mesa-dri", "libglib2.0-0t64 | libglib2.0-0", "libdbus-1-3",
    "libfontconfig1", "libxkbcommon-x11-0", "libxcb-cursor0", "libxcb-icccm4", "libxcb-keysyms1", "libxcb-shape0",
    "libwayland-cursor0", "libwayland-egl1",
)  # fmt: skip
"""What a Debian system brings for Qt and OpenGL."""
_HOME: Final = "opt/kagezou"
_UNPACKING: Final = """\
#!/bin/sh
# Kagezou {version}: unpacks itself into the folder that is named (else ~/.local/opt/kagezou), and says what to start.
set -e
home="${{1:-$HOME/.local/opt/kagezou}}"
case "$home" in -h|--help) sed -n 2p "$0"; exit 0;; esac
# Only a bundle is replaced: a folder that holds anything besides is somebody's.
if [ -e "$home" ] && [ "$(LC_ALL=C ls -A "$home" | tr '\\n' ' ')" != "_internal kagezou " ]; then
    echo "$home: there is something else; name a new folder" >&2
    exit 4
fi
if ! command -v xz >/dev/null; then
    echo "to unpack it takes xz, which is not here (in Debian the package xz-utils)" >&2
    exit 6
fi
mkdir -p "$(dirname "$home")"
part="$(mktemp -d "$home.XXXXXX")"
trap 'rm -rf "$part"' EXIT
tail -n +{first_line} "$0" | tar -xJ -C "$part" --strip-components=1
test -x "$part/kagezou"
chmod 755 "$part"
rm -rf "$home"
mv "$part" "$home"
echo "$home/kagezou"
exit 0
"""


_COPYRIGHT: Final = f"""\
Kagezou is under the Apache License 2.0 (/usr/share/common-licenses/Apache-2.0).

What else is in the package, and under which terms, is told in /{_HOME}/_internal/licenses/THIRD_PARTY.md; the texts of
these licences lie beside it, and in the folders /{_HOME}/_internal/*.dist-info.
"""


_OF_CODE: Final = [{"id": lzma.FILTER_X86}] if platform.machine() == "x86_64" else []
_PACKING: Final = [*_OF_CODE, {"id": lzma.FILTER_LZMA2, "preset": 9}]
"""Addresses in machine code are told from where they stand before they are packed."""


def packed(folder: Path, out: Path, version: str) -> Iterator[Path]:
    """Pack a bundle for the system this runs on, and yield the files as they are made."""
    name = f"kagezou-{version}-{_system()}"
    yield Path(shutil.copy(folder / "_internal" / "licenses" / PARTS_LIST, out / f"{name}.cdx.json"))
    if sys.platform == "win32":
        yield Path(shutil.make_archive(str(out / name), "zip", folder.parent, folder.name))
    elif sys.platform == "darwin":
        yield disk_image(folder.parent / "Kagezou.app", out / f"{name}.dmg")
    else:
        archive = out / f"{name}.tar.xz"
        _tar(folder, archive, name)
        yield archive
        yield self_unpacking(archive, out / f"{name}.run", version)
        if shutil.which("dpkg-deb"):
            yield _deb(folder, out, version)


def disk_image(application: Path, target: Path) -> Path:
    """Make a disk image for Macs of an application, beside the folder that it is to be dragged into."""
    with tempfile.TemporaryDirectory() as scratch:
        # It keeps what the signature is over, as other ways to copy do not.
        subprocess.run(["ditto", str(application), str(Path(scratch) / application.name)], check=True)
        Path(scratch, "Applications").symlink_to("/Applications")
        words = ["hdiutil", "create", "-volname", application.stem, "-srcfolder", scratch, "-ov", str(target)]
        subprocess.run(words, check=True)
    return target


def _system() -> str:
    system = {"win32": "windows", "darwin": "macos"}.get(sys.platform, "linux")
    return f"{system}-{os.uname().machine if hasattr(os, 'uname') else 'x86_64'}"


def _tar(folder: Path, archive: Path, name: str) -> None:
    """Pack a folder so that the same folder gives the same bytes."""

    def plain(entry: tarfile.TarInfo) -> tarfile.TarInfo:
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mtime = 0
        return entry

    with lzma.open(archive, "wb", filters=_PACKING) as stream, tarfile.open(fileobj=stream, mode="w") as target:
        for path in (folder, *sorted(folder.rglob("*"))):
            target.add(path, Path(name) / path.relative_to(folder), recursive=False, filter=plain)


def self_unpacking(archive: Path, target: Path, version: str) -> Path:
    """Make a script of an archive that unpacks itself; an earlier bundle is replaced, nothing else ever is."""
    head = _UNPACKING.format(version=version, first_line=_UNPACKING.count("\n") + 1)
    with target.open("wb") as stream:
        stream.write(head.encode())
        with archive.open("rb") as source:
            shutil.copyfileobj(source, stream)
    target.chmod(0o755)
    return target


def _deb(folder: Path, out: Path, version: str) -> Path:
    """Make a package for Debian and Ubuntu: the folder in /opt, the program on the path, a place on the desktop."""
    root = out / "deb-root"
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(folder, root / _HOME, symlinks=True)
    (root / "usr" / "bin").mkdir(parents=True)
    (root / "usr" / "bin" / "kagezou").symlink_to(f"/{_HOME}/kagezou")
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    words = [
        str(folder / "kagezou"),
        "integrate",
        "--into",
        str(root / "usr" / "share"),
        "--program",
        "/usr/bin/kagezou",
    ]
    subprocess.run(words, check=True, env=environment)
    (root / "usr" / "share" / "doc" / "kagezou").mkdir(parents=True)
    (root / "usr" / "share" / "doc" / "kagezou" / "copyright").write_text(_COPYRIGHT, encoding="utf-8")
    control = root / "DEBIAN"
    control.mkdir()
    size_kb = sum(path.stat().st_size for path in root.rglob("*") if path.is_file() and not path.is_symlink()) // 1024
    machine = subprocess.run(
        ["dpkg", "--print-architecture"], capture_output=True, text=True, check=True
    ).stdout.strip()
    (control / "control").write_text(
        f"Package: kagezou\nVersion: {version}\nArchitecture: {machine}\nSection: graphics\nPriority: optional\n"
        f"Installed-Size: {size_kb}\nMaintainer: Kagezou <kagezou@localhost>\nDepends: {', '.join(LIBRARIES)}\n"
        "Description: cast-shadow layers for 2D animation\n"
        " Kagezou stands transparent drawings of characters on a ground, puts a light beside them, and gives back\n"
        " their cast shadows as layers for compositing.\n",
        encoding="utf-8",
    )
    sums = (
        f"{hashlib.md5(path.read_bytes()).hexdigest()}  {path.relative_to(root).as_posix()}\n"
        for path in sorted(root.rglob("*"))
        if path.is_file() and not path.is_symlink() and control not in path.parents
    )
    (control / "md5sums").write_text("".join(sums), encoding="utf-8")
    target = out / f"kagezou_{version}_{machine}.deb"
    subprocess.run(["dpkg-deb", "--root-owner-group", "-Zxz", "-z9", "--build", str(root), str(target)], check=True)
    shutil.rmtree(root)
    return target
