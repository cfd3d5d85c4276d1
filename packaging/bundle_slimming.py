"""What libraries carry and nobody looks up: names of functions, and words of ICU in languages other than ours.

On Linux, with the tools that PyInstaller needs as well (binutils) and a C compiler; without them it stays as it is.
"""

import re
import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Final

_LIBRARY: Final = re.compile(r"\.so(\.\d+)*$")
_SYMBOL: Final = re.compile(r"^(?P<address>[0-9a-f]+) [RD] (?P<name>icudt\d+_dat)$", re.MULTILINE)
_WHOLE_FOLDERS: Final = re.compile(r"(brkitr|curr|lang|rbnf|region|translit|unit)/|.*\.cnv$")
"""Where lines break, names of money, languages, regions and units, spelt numbers, scripts in each other's letters, and
code pages: Qt has tables of its own for these, or the program does not ask it."""
_OF_A_LANGUAGE: Final = re.compile(r"((coll|zone)/)?(?P<language>[a-z]{2,3})(_\w+)?\.res$")
_OURS: Final = frozenset({"en", "ja"})
_SOURCE: Final = """\
    .section .rodata
    .balign 16
    .globl {symbol}
    .type {symbol}, %object
    .size {symbol}, {size}
{symbol}:
    .incbin "data"
    .section .note.GNU-stack, "", %progbits
"""
Say = Callable[[str], None]


def slimmed(folder: Path, say: Say) -> None:
    """Make the libraries of a bundle smaller; what cannot be done is said.

    Raises
    ------
    subprocess.CalledProcessError
        A tool refuses.
    ValueError
        Data of ICU are built in another way.
    """
    if not sys.platform.startswith("linux"):
        return
    strip, compiler = shutil.which("strip"), shutil.which("cc")
    found = (path for path in (folder / "_internal").rglob("*.so*") if _LIBRARY.search(path.name))
    libraries = [path for path in found if path.is_file() and not path.is_symlink()]
    if compiler is None:
        say("the data of ICU stay whole: that takes a C compiler (cc)")
    else:
        for path in libraries:
            if path.name.startswith("libicudata.so."):
                _with_our_languages(path, compiler)
    if strip is None:
        say("libraries keep the names of their functions: that takes strip (binutils)")
    else:
        for path in libraries:
            _strip(path, strip)


def _strip(library: Path, strip: str) -> None:
    """Take the names out where the library can still be loaded: what auditwheel has patched sometimes cannot."""
    slim = library.with_name(f"{library.name}.slim")
    try:
        subprocess.run([strip, "--strip-unneeded", "-o", str(slim), str(library)], check=True, capture_output=True)
        if _is_aligned(slim):
            slim.replace(library)
    finally:
        slim.unlink(missing_ok=True)


def _is_aligned(library: Path) -> bool:
    """Return whether each part that is loaded lies in the file as it lies in a page of memory, as a loader wants it."""
    words = ["readelf", "-lW", str(library)]
    said = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    parts = re.findall(r"^ +LOAD +(0x\w+) +(0x\w+)", said, re.MULTILINE)
    return bool(parts) and all(int(offset, 16) % 4096 == int(address, 16) % 4096 for offset, address in parts)


def _with_our_languages(library: Path, compiler: str) -> None:
    """Put a library of ICU's data in the place of one, with the languages of the program alone."""
    words = ["nm", "-D", "--defined-only", str(library)]
    found = _SYMBOL.search(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    if found is None:
        raise ValueError(f"{library}: it has no data of ICU")
    # It has one part that is read, from its beginning, so that addresses are places in the file; what follows the data
    # would go to the last item.
    data = library.read_bytes()[int(found["address"], 16) :]
    head, items = icu_items(data)
    kept = icu_package(head, {name: item for name, item in items.items() if is_ours(name)})
    with tempfile.TemporaryDirectory() as scratch:
        Path(scratch, "data").write_bytes(kept)
        Path(scratch, "data.S").write_text(_SOURCE.format(symbol=found["name"], size=len(kept)), encoding="ascii")
        made = ["-shared", "-nostdlib", f"-Wl,-soname,{library.name}", "-o", str(library.resolve()), "data.S"]
        library.unlink()
        subprocess.run([compiler, *made], check=True, cwd=scratch)


def is_ours(name: str) -> bool:
    """Return whether an item of ICU's data is one that a program in our languages may look up.

    Parameters
    ----------
    name
        As ``icudt73l/coll/ja.res``.
    """
    _, _, inside = name.partition("/")
    if _WHOLE_FOLDERS.match(inside):
        return False
    found = _OF_A_LANGUAGE.match(inside)
    return found is None or found["language"] in _OURS


def icu_items(data: bytes) -> tuple[bytes, dict[str, bytes]]:
    """Return the head and the items, by name, of a package of ICU data ("CmnD", ICU's ``ucmndata.h``).

    Raises
    ------
    ValueError
        It is none, or one with another order of bytes than this machine's.
    """
    head_size, *magic = struct.unpack_from("=HBB", data)
    if magic != [0xDA, 0x27] or data[12:16] != b"CmnD":
        raise ValueError("these are no data of ICU")
    table = memoryview(data)[head_size:]
    (count,) = struct.unpack_from("=I", table)
    places = [struct.unpack_from("=II", table, 4 + 8 * index) for index in range(count)]
    ends = [*(start for _, start in places[1:]), len(table)]
    items = {
        _text_at(data, head_size + at): bytes(table[start:end]) for (at, start), end in zip(places, ends, strict=True)
    }
    return data[:head_size], items


def _text_at(data: bytes, place: int) -> str:
    return data[place : data.index(b"\0", place)].decode("ascii")


def icu_package(head: bytes, items: Mapping[str, bytes]) -> bytes:
    """Return a package of ICU data: a table in the order of names, the names, and items, each from a 16th byte on."""
    names = sorted(items, key=lambda name: name.encode("ascii"))
    texts = [name.encode("ascii") + b"\0" for name in names]
    sizes = [_padded(len(items[name])) for name in names]
    name_at = list(_summed(4 + 8 * len(names), map(len, texts)))
    item_at = list(_summed(_padded(len(head) + name_at[-1]) - len(head), sizes))
    table = struct.pack("=I", len(names)) + b"".join(map(struct.Struct("=II").pack, name_at[:-1], item_at[:-1]))
    text = (head + table + b"".join(texts)).ljust(len(head) + item_at[0], b"\0")
    return text + b"".join(items[name].ljust(size, b"\0") for name, size in zip(names, sizes, strict=True))


def _padded(size: int) -> int:
    return -(-size // 16) * 16


def _summed(start: int, sizes: Iterator[int] | list[int]) -> Iterator[int]:
    yield start
    for size in sizes:
        start += size
        yield start
