"""Mesa's OpenGL for Windows machines without a graphics driver, fetched into build/mesa before a bundle is made.

``python packaging/bundle_mesa.py --sha256 HEX [--url URL] [--out DIR]`` fetches one archive, holds it against its hash,
and takes its two 64-bit libraries; what is there from the same archive stays. Where anything is wrong it says so
in one sentence, and DIR is as it was. Archives in 7z are unpacked by 7-Zip, which has to be on the path.
"""

import argparse
import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request
import zipfile
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
URL: Final = "https://github.com/pal1000/mesa-dist-win/releases/download/26.2.4/mesa3d-26.2.4-release-msvc.7z"
LIBRARIES: Final = ("opengl32.dll", "libgallium_wgl.dll")
_FOLDER: Final = "x64"
"""Where the archive has what 64-bit programs load."""
_STAMP: Final = "archive.sha256"
_MOST_BYTES: Final = 512 << 20
_SILENT_S: Final = 60
_CHUNK: Final = 1 << 20
_SEVEN_ZIP: Final = ("7z", "7zz", "7zr", "7za")


class MesaProblem(Exception):
    """Why there is no Mesa, in one sentence."""


def main(arguments: list[str] | None = None) -> int:
    """Fetch it; return 0, or 1 after one sentence on stderr."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--sha256", required=True, help="what the archive's SHA-256 has to be, in 64 hexadecimal digits"
    )
    parser.add_argument("--url", default=URL, help="where the archive is (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "mesa", help="the folder that is made")
    options = parser.parse_args(arguments)
    try:
        fetch(options.url, options.sha256.lower(), options.out)
    except (MesaProblem, OSError) as problem:
        sys.stderr.write(f"{problem}\n")
        return 1
    return 0


def fetch(url: str, sha256: str, out: Path) -> None:
    """Make a folder of Mesa's libraries, whole or not at all.

    Raises
    ------
    MesaProblem
        The archive cannot be had, is another one than was asked for, or has no such libraries.
    OSError
        The folder cannot be written.
    """
    if re.fullmatch(r"[0-9a-f]{64}", sha256) is None:
        raise MesaProblem(f"{sha256!r} is no SHA-256: give the 64 hexadecimal digits of {url} as --sha256")
    if _is_there(out, sha256):
        return
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}-") as scratch:
        archive, made, old = (Path(scratch) / name for name in (url.rpartition("/")[2] or "archive", "made", "old"))
        found = _download(url, archive)
        if found != sha256:
            raise MesaProblem(f"{url}: the file's SHA-256 is {found}, not {sha256}, so it is not used")
        made.mkdir()
        _unpack(archive, made, url)
        (made / _STAMP).write_text(f"{sha256}\n", encoding="ascii")
        if out.exists():
            out.rename(old)
        made.rename(out)


def _is_there(out: Path, sha256: str) -> bool:
    stamp = out / _STAMP
    whole = stamp.is_file() and all((out / name).is_file() for name in LIBRARIES)
    return whole and stamp.read_text(encoding="ascii").strip() == sha256


def _download(url: str, archive: Path) -> str:
    """Write what lies at an address into a file, and return its SHA-256."""
    digest, size = hashlib.sha256(), 0
    try:
        with urllib.request.urlopen(url, timeout=_SILENT_S) as source, archive.open("wb") as stream:
            while chunk := source.read(_CHUNK):
                size += len(chunk)
                if size > _MOST_BYTES:
                    raise MesaProblem(f"{url}: it is larger than {_MOST_BYTES >> 20} MB, so it cannot be what is meant")
                digest.update(chunk)
                stream.write(chunk)
    except (urllib.error.URLError, TimeoutError, ConnectionError, ValueError) as problem:
        raise MesaProblem(f"{url}: it cannot be fetched: {getattr(problem, 'reason', problem)}") from problem
    return digest.hexdigest()


def _unpack(archive: Path, folder: Path, url: str) -> None:
    """Take the libraries out of an archive."""
    inside = [f"{_FOLDER}/{name}" for name in LIBRARIES]
    if zipfile.is_zipfile(archive):
        with zipfile.ZipFile(archive) as source:
            for name in set(inside) & set(source.namelist()):
                with source.open(name) as part, (folder / Path(name).name).open("wb") as stream:
                    shutil.copyfileobj(part, stream)
    else:
        tool = next(filter(None, map(shutil.which, _SEVEN_ZIP)), None)
        if tool is None:
            raise MesaProblem(f"{url}: to unpack it takes 7-Zip on the path (one of {', '.join(_SEVEN_ZIP)})")
        words = [tool, "e", "-y", f"-o{folder}", str(archive), *inside]
        done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
        if done.returncode != 0:
            said = next((line for line in done.stderr.splitlines() if line.strip()), f"it ended with {done.returncode}")
            raise MesaProblem(f"{url}: 7-Zip cannot unpack it: {said}")
    lacking = [each for each in inside if not (folder / Path(each).name).is_file()]
    if lacking:
        raise MesaProblem(f"{url}: there is no {' and no '.join(lacking)} in it")


if __name__ == "__main__":
    sys.exit(main())
