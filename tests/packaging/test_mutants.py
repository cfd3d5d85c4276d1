"""The script that damages files, on a few of each format; the long run is made by hand."""

import pytest

from dev_mutants import FORMATS, PICTURES, USD, outcomes, seeds

READ_HERE = [form for form in FORMATS if form not in USD]
"""A damaged USD file may take its process along."""


@pytest.mark.parametrize("form", READ_HERE)
def test_every_damaged_file_is_what_it_holds_or_a_sentence(form: str) -> None:
    found = outcomes(form, 60, 7)
    assert set(found) <= {"read", "refused"}
    assert found["refused"] > 5


@pytest.mark.parametrize("form", FORMATS)
def test_there_are_files_to_damage(form: str) -> None:
    if form in USD:
        pytest.importorskip("pxr")
    assert len(seeds(form)) > (form in PICTURES)
