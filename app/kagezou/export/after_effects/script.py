"""The script: what is to be built as a literal, and behind it the builder, which is the same for every cut."""

import json
from collections.abc import Iterable
from dataclasses import asdict
from typing import Final

from kagezou.export.after_effects.comp import HandOff
from kagezou.locations import resource_folder

_BUILDER: Final = "after_effects/build.jsx"
_MARK: Final = "/*HAND_OFF*/ null"


def script_of(hand_off: HandOff) -> str:
    """Return the text of the ``.jsx``, ASCII only.

    Everything that comes from people lies in one JSON literal whose every sign beyond ASCII, and every one that could
    end a line or a string, is escaped; none of it is ever run.
    """
    literal = json.dumps(asdict(hand_off, dict_factory=_without_nothing), ensure_ascii=True, allow_nan=False, indent=1)
    builder = (resource_folder() / _BUILDER).read_text(encoding="ascii")
    before, mark, after = builder.partition(_MARK)
    assert mark, "the builder has a place for what is to be built"
    return before + literal + after


def _without_nothing(fields: Iterable[tuple[str, object]]) -> dict[str, object]:
    """Return a record without what is None, which the builder takes for what it does not find."""
    return {name: value for name, value in fields if value is not None}
