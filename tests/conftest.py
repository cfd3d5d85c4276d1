"""What every tier of tests shares."""

from collections.abc import Iterator
from pathlib import Path

import hypothesis
import numpy as np
import pytest

SAMPLES = Path(__file__).resolve().parents[1].parent / "shared" / "samples"

# A busy machine is slow now and then; that says nothing about the program.
hypothesis.settings.register_profile("kagezou", deadline=None)
hypothesis.settings.load_profile("kagezou")


@pytest.fixture(autouse=True)
def _numeric_errors_raise() -> Iterator[None]:
    """A division by zero or an overflow in numpy is a defect, not a warning to scroll past."""
    with np.errstate(all="raise", under="ignore"):
        yield


@pytest.fixture(scope="session")
def samples() -> Path:
    """The folder of real character animation that lies beside the project on some machines."""
    if not SAMPLES.is_dir():
        pytest.skip(f"no real sample animation beside the project ({SAMPLES.name} folder is absent)")
    return SAMPLES
