"""A flame graph is written by py-spy, and it is said where that is not installed."""

import shutil
import sys
from pathlib import Path

import pytest

from kagezou.cli.bench import flame_graph
from kagezou.errors import OutputProblem, UsageProblem
from tests.export.small_cuts import cut


def test_where_it_is_not_installed_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _name: None)
    with pytest.raises(UsageProblem, match="pip install py-spy"):
        flame_graph.write_flame_graph(cut(tmp_path), tmp_path / "graph.svg")


@pytest.mark.skipif(sys.platform == "win32", reason="a script stands for the program")
@pytest.mark.parametrize("works", ["well", ""])
def test_what_it_writes_is_put_in_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, works: str) -> None:
    stand_in = tmp_path / "py-spy"
    script = "pathlib.Path(sys.argv[3]).write_text(' '.join(sys.argv))" if works else "sys.exit('not permitted')"
    stand_in.write_text(f"#!{sys.executable}\nimport pathlib, sys\n{script}\n")
    stand_in.chmod(0o755)
    monkeypatch.setattr(shutil, "which", lambda _name: str(stand_in))
    if works:
        flame_graph.write_flame_graph(cut(tmp_path), tmp_path / "graph.svg")
        assert " -- " in (tmp_path / "graph.svg").read_text()
        assert "render" in (tmp_path / "graph.svg").read_text()
    else:
        with pytest.raises(OutputProblem, match="not permitted"):
            flame_graph.write_flame_graph(cut(tmp_path), tmp_path / "graph.svg")
        assert not (tmp_path / "graph.svg").exists()
