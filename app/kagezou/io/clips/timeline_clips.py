"""Keys and exposures as text, as they go through the clipboard from window to window.

Properties are named by the paths people write for them and drawings by their names, so that another cut can take them.
"""

from typing import Final

from kagezou.document.address import Address, path_of, resolve
from kagezou.document.exposure_edits import ExposureClip
from kagezou.document.key_edits import KeyClip
from kagezou.document.model import Document
from kagezou.document.properties import OF_LAYER
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.io.files.json_text import JsonRow, Reader, formatted, parse
from kagezou.io.project.fields import MAX_ROWS
from kagezou.io.project.paths import MAX_PATH_CHARACTERS
from kagezou.io.project.reading import read_key
from kagezou.io.project.writing import key_tree

_KEYS: Final = "kagezou-keys"
_DRAWINGS: Final = "kagezou-drawings"
_FIRST_CHARACTERS: Final = 64
_MAX_CHARACTERS: Final = 1 << 24
_MAX_FRAME: Final = 1_000_000


def dumps_keys(document: Document, clip: KeyClip) -> str:
    """Return copied keys of a document as text."""
    rows: dict[str, list[JsonRow]] = {}
    for address, key in clip.keys:
        rows.setdefault(path_of(document, address), []).append(JsonRow(key_tree(key)))
    return formatted({_KEYS: rows})


def holds_keys(text: str) -> bool:
    """Return whether a text was meant to hold copied keys, whether or not it can be read."""
    return _KEYS in text[:_FIRST_CHARACTERS]


def loads_keys(text: str, document: Document) -> KeyClip | None:
    """Return the copied keys that a text holds, for a document; None if it is no such text or none has a place there.

    Keys of a layer that the document has none of that name of get an address of their own, so that they can still be
    put onto another.
    """
    if not _may_be(text, _KEYS):
        return None
    found = []
    try:
        for path, keys in _content(text, _KEYS).members().items():
            address = _address_of(document, path)
            if address is not None:
                found += [(address, read_key(each, address.property)) for each in keys.items(MAX_ROWS)]
    except (ProjectProblem, UsageProblem):
        return None
    return KeyClip(min(key.frame for _, key in found), tuple(found)) if found else None


def dumps_drawings(clip: ExposureClip) -> str:
    """Return copied exposures as text."""
    entries = [JsonRow([frame, name]) for frame, name in clip.entries]
    return formatted({_DRAWINGS: {"length_frames": clip.length, "entries": entries}})


def loads_drawings(text: str) -> ExposureClip | None:
    """Return the copied exposures that a text holds; None if it is no such text."""
    if not _may_be(text, _DRAWINGS):
        return None
    entries: dict[int, str | None] = {}
    try:
        content = _content(text, _DRAWINGS).record(["length_frames", "entries"])
        length = content["length_frames"].whole(1, _MAX_FRAME)
        for entry in content["entries"].items(MAX_ROWS, least=1):
            frame, name = entry.items(2, least=2)
            entries[frame.whole(0, length - 1)] = None if name.value is None else name.text(MAX_PATH_CHARACTERS)
    except (ProjectProblem, UsageProblem):
        return None
    return ExposureClip(tuple(sorted(entries.items(), key=lambda entry: entry[0])), length)


def _may_be(text: str, kind: str) -> bool:
    """Whether a text may be of a kind; whatever else lies on the clipboard, however long, is not looked through."""
    return kind in text[:_FIRST_CHARACTERS] and len(text) <= _MAX_CHARACTERS


def _content(text: str, kind: str) -> Reader:
    return Reader(parse(text)).record([kind])[kind]


def _address_of(document: Document, path: str) -> Address | None:
    try:
        return resolve(document, path)
    except UsageProblem:
        if not path.startswith("layers."):
            return None
    name = max((name for name in OF_LAYER if path.endswith(f".{name}")), key=len, default=None)
    return None if name is None else Address(OF_LAYER[name], path.removesuffix(f".{name}"))
