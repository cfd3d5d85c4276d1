"""What the doctor looks at."""

import re
import tomllib
from pathlib import Path

from kagezou.cli.examination import versions

ROOT = Path(__file__).parents[2]


def test_every_package_and_those_of_all_extras_are_named() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = [each for name, wanted in project["optional-dependencies"].items() if name != "dev" for each in wanted]
    named = {re.split(r"[<>=;\[ ]", each)[0] for each in (*project["dependencies"], *extras)}
    assert named <= set(versions())
