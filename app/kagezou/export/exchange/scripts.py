"""Python scripts that other programs run: a builder, the same for every cut, and what is to be built."""

import json
from typing import Any, Final

from kagezou.locations import resource_folder

_MARK: Final = 'json.loads("null")'


def filled_in(builder: str, cut: dict[str, Any]) -> str:
    """Return the text of a script, ASCII only: what comes from people is JSON within a string, and never run.

    Parameters
    ----------
    builder
        The name of its file among the resources.
    cut
        What it is to build, as JSON has it.
    """
    text = (resource_folder() / "exchange" / builder).read_text(encoding="ascii")
    before, mark, after = text.partition(_MARK)
    assert mark, "the builder has a place for what is to be built"
    literal = repr(json.dumps(cut, ensure_ascii=True, allow_nan=False, indent=1))
    lines = literal.replace("\\n", "\\n\\\n")
    return f"{before}json.loads({lines}){after}"
