"""The script that damages picture files, on a few of each format; the long run is made by hand."""

import pytest

from dev_mutants import FORMATS, outcomes, seeds


@pytest.mark.parametrize("form", FORMATS)
def test_every_damaged_file_is_a_picture_or_a_sentence(form: str) -> None:
    found = outcomes(form, 60, 7)
    assert set(found) <= {"read", "refused"}
    assert found["refused"] > 5
    assert len(seeds(form)) > 1
