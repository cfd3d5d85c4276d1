"""How the machines of a farm call the program, as far as this machine can tell."""

import shutil
import sys
from pathlib import Path
from typing import Final

from kagezou.own_process import is_bundle

USUAL: Final = "kagezou"
"""The name under which an installed program is found."""


def program_here() -> str:
    """Return the program's name where this machine finds it by that; else its path here, if it has one."""
    if shutil.which(USUAL) is not None:
        return USUAL
    own = Path(sys.executable)
    if not is_bundle():
        own = own.with_name(USUAL + own.suffix)
    return str(own) if own.is_file() else USUAL
