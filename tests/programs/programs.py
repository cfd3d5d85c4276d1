"""Programs of other houses, where they are installed and asked for: ``KAGEZOU_WITH_PROGRAMS=1``."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ASKED_FOR = "KAGEZOU_WITH_PROGRAMS"


def needs(*programs: str) -> pytest.MarkDecorator:
    """Return the mark of a test that runs programs; it is left out where they are not there, or not asked for."""
    missing = [each for each in programs if shutil.which(each) is None]
    if missing:
        return pytest.mark.skip(reason=f"{', '.join(missing)}: not installed")
    return pytest.mark.skipif(not os.environ.get(ASKED_FOR), reason=f"runs {programs[0]} with {ASKED_FOR}=1")


def ran(home: Path, *words: str) -> str:
    """Run a program with settings of its own and return what it printed; what comes of it, the caller looks at."""
    for folder in (home, home / "run"):
        folder.mkdir(exist_ok=True)
        folder.chmod(0o700)
    own = {"HOME": str(home), "XDG_RUNTIME_DIR": str(home / "run"), "LIBGL_ALWAYS_SOFTWARE": "1"}
    done = subprocess.run(words, capture_output=True, text=True, timeout=600, check=False, env={**os.environ, **own})
    return done.stdout + done.stderr
