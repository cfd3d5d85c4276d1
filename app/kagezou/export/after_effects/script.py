"""The script: what is to be built as a literal, and behind it the builder, which is the same for every cut."""

import json
from collections.abc import Iterable
from dataclasses import asdict
from typing import Final

from kagezou.export.after_effects.comp import HandOff
from kagezou.locations import resource_folder

_FOLDER: Final = "after_effects/builder"
_PARTS: Final = (
    "words",
    "progress",
    "memory",
    "items",
    "states",
    "keys",
    "effects",
    "markers",
    "place",
    "survey",
    "footage",
    "controls",
    "layers",
    "guides",
    "comps",
    "precomps",
    "guards",
    "summary",
    "plan",
    "parts",
    "order",
    "run",
)
"""Names of files, each of which may use those before it while it is read, and all of them while it runs."""
_HEAD: Final = """\
/* Made by Kagezou. File > Scripts > Run Script File... builds the composition, or brings it up to date.
   It needs After Effects CC 2018 or newer, in any language, and everything that lies beside it. */
(function () {
    var HAND_OFF = """


def script_of(hand_off: HandOff) -> str:
    """Return the text of the ``.jsx``, ASCII only.

    Everything that comes from people lies in one JSON literal whose every sign beyond ASCII, and every one that could
    end a line or a string, is escaped; none of it is ever run.
    """
    literal = json.dumps(asdict(hand_off, dict_factory=_without_nothing), ensure_ascii=True, allow_nan=False, indent=1)
    return built_of(literal)


def built_of(literal: str) -> str:
    """Return the script that builds what a literal says."""
    folder = resource_folder() / _FOLDER
    parts = ((folder / f"{name}.jsx").read_text(encoding="ascii") for name in _PARTS)
    return "\n".join((f"{_HEAD}{literal};\n", *parts, "}());\n"))


def _without_nothing(fields: Iterable[tuple[str, object]]) -> dict[str, object]:
    """Return a record without what is None, which the builder takes for what it does not find."""
    return {name: value for name, value in fields if value is not None}
