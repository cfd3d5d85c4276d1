"""Parts that are installed apart: their packages are those that the program's own list of extras names."""

import sys
import tomllib
from pathlib import Path

import pytest

from kagezou.extras import EXTRAS, IN_BUNDLE, VIDEO


@pytest.mark.parametrize("extra", EXTRAS, ids=lambda extra: extra.name)
def test_what_is_told_to_be_installed_is_what_the_extra_needs(extra: object) -> None:
    found = next(each for each in EXTRAS if each is extra)
    text = (Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8")
    needed = tomllib.loads(text)["project"]["optional-dependencies"][found.name]
    named = {each.split(";")[0].strip() for each in needed}
    assert set(found.packages) <= named
    assert {each.split(">")[0] for each in found.packages} == {each.split(">")[0] for each in named}


def test_a_bundle_tells_nobody_to_install_into_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert str(VIDEO.how) == "pip install 'av>=18,<21'"
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert VIDEO.how is IN_BUNDLE
