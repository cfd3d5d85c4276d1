"""Where the whole story of a defect of ours goes, so that the person sees one line and can send the rest."""

import os
import platform
import sys
import time
import traceback
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from kagezou.version import __version__

DEBUG_VARIABLE: Final = "KAGEZOU_DEBUG"
_LARGEST_LOG: Final = 1 << 20


def log_path() -> Path:
    """Return the file that defects are written to."""
    import platformdirs

    return platformdirs.user_log_path("kagezou", appauthor=False) / "crash.log"


def noted_at(error: BaseException, arguments: Sequence[str]) -> str:
    """Write down a defect and return where that is, or why it could not be done."""
    story = "".join(traceback.format_exception(error))
    if os.environ.get(DEBUG_VARIABLE):
        sys.stderr.write(story)
    head = f"{time.strftime('%Y-%m-%d %H:%M:%S %z')} kagezou {__version__} Python {platform.python_version()} "
    head += f"{platform.platform()}\n{list(arguments)!r}\n"
    path = log_path()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists() and path.stat().st_size > _LARGEST_LOG:
            path.replace(path.with_name(path.name + ".1"))
        with path.open("a", encoding="utf-8", errors="backslashreplace") as log:
            log.write(f"{head}{story}\n")
    except OSError as refusal:
        return f"no log could be written at {path}: {refusal.strerror}; set {DEBUG_VARIABLE}=1 to see it all"
    return f"the details are in {path}"
