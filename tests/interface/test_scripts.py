"""The scripts of the manual: quoted as they stand, short, and run."""

import json
import os
import re
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import numpy as np
import pytest

import kagezou
from kagezou.export.after.hooks import COMMAND_VARIABLE
from kagezou.interface.cut import Cut
from kagezou.locations import manual_folder

SCRIPTS = manual_folder() / "scripts"
_QUOTED = re.compile(r"`docs/scripts/(\w+\.py)`[^`]*```python\n(.*?)```", re.DOTALL)


def run(script: str, *words: object, **variables: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPTS / script), *map(str, words)]
    paths = os.pathsep.join(path for path in sys.path if path)
    env = {**os.environ, "PYTHONPATH": paths, "PYTHONIOENCODING": "utf-8", COMMAND_VARIABLE: "", **variables}
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False, env=env)


@pytest.mark.parametrize("language", ["en", "ja"])
def test_scripts_are_quoted_as_they_stand_and_short(language: str) -> None:
    quoted: dict[str, str] = {}
    for page in ("python", "pipeline"):
        quoted |= dict(_QUOTED.findall((manual_folder() / language / f"{page}.md").read_text(encoding="utf-8")))
    assert quoted == {path.name: path.read_text(encoding="utf-8") for path in SCRIPTS.glob("*.py")}
    assert {name: len(text.splitlines()) for name, text in quoted.items() if len(text.splitlines()) > 30} == {}


def test_a_cut_from_a_folder_to_after_effects(drawings: Path, tmp_path: Path) -> None:
    done = run("to_after_effects.py", drawings, tmp_path / "out")
    assert (done.returncode, done.stdout) == (0, f"{tmp_path / 'out' / 'to_ae' / 'hero.jsx'}\n"), done.stderr
    assert kagezou.open(tmp_path / "out" / "hero.kage").value("layers.hero.shadow.opacity") == 0.6
    assert "hero: 3 drawings" in done.stderr


def test_the_same_light_for_many_projects(cut: Cut, drawings: Path, tmp_path: Path) -> None:
    cut.with_values({"light.kind": "sun", "ground.roll": 4}).save()
    others = [tmp_path / "a.kage", tmp_path / "b.kage"]
    for path in others:
        kagezou.new({"B": drawings}).save(path)
    done = run("same_light.py", cut.path, others[0], tmp_path / "no.kage", others[1], cut.path)
    assert done.returncode == 7
    assert done.stdout.splitlines() == [*(f"{path}: lit anew" for path in others), f"{cut.path}: as it was"]
    assert "no.kage" in done.stderr
    assert [kagezou.open(path).value("light.kind") for path in others] == ["sun", "sun"]


def test_a_shadow_is_measured_and_laid_on_paper(cut: Cut, tmp_path: Path) -> None:
    done = run("measure_shadow.py", cut.path, "Hero", tmp_path)
    assert done.returncode == 0, done.stderr
    head, *lines = done.stdout.splitlines()
    assert head == "frame,area_px,middle_x,middle_y,darkest"
    rows = [[float(each) for each in line.split(",")] for line in lines]
    for row, (frame, pixels) in zip(rows, cut.pictures("Hero_shadow", numbers="float32"), strict=True):
        assert row[:2] == [frame, pytest.approx(float(pixels[..., 3].sum()), abs=0.06)]
    assert rows[0][2] < rows[2][2]  # the figure goes to the right
    laid = np.load(tmp_path / "Hero_0001.npy")
    assert laid.shape == (48, 64, 3)
    assert laid.max() == 204
    assert laid.min() < 204


@contextmanager
def kitsu() -> Iterator[tuple[str, list[tuple[str, Any]]]]:
    """Stand in for a server of Kitsu: give its address, and what was sent to it."""
    sent: list[tuple[str, Any]] = []
    entries = {
        "projects": {"id": "p", "name": "Show"},
        "shots/all": {"id": "s", "name": "012"},
        "task-types": {"id": "y"},
        "tasks": {"id": "t"},
        "task-status": {"id": "w"},
    }

    class Server(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            url = urlsplit(self.path)
            sent.append((url.path, parse_qs(url.query)))
            found = next((each for name, each in entries.items() if url.path.endswith(f"data/{name}")), {"id": "q"})
            self.answer([found])

        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["Content-Length"]))
            is_json = self.headers["Content-Type"] == "application/json"
            sent.append((self.path, json.loads(body) if is_json else body))
            self.answer({"id": "made"})

        def answer(self, value: object) -> None:
            data = json.dumps(value).encode()
            self.send_response(200)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, *_: object) -> None:
            pass

    server = HTTPServer(("127.0.0.1", 0), Server)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/api", sent
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


@pytest.mark.skipif(find_spec("gazu") is None, reason="gazu, the client of Kitsu, is not installed")
def test_a_composite_is_published_to_kitsu(cut: Cut, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    named = cut.with_values({"canvas.name": "Show", "canvas.scene": "3", "canvas.cut": "012"}).save()
    with kitsu() as (host, sent):
        monkeypatch.setenv("KITSU_HOST", host)
        monkeypatch.setenv("KITSU_TOKEN", "secret")
        command = f"'{SCRIPTS / 'publish_to_kitsu.py'}'"
        came = named.export(kagezou.Frames(tmp_path / "out", composite=True), after=command)
    first = next(each.path for each in came.files if each.kind == "composite")
    assert came.notes == (f"handed on to publish_to_kitsu.py: published {first}",)
    asked = {path.rpartition("/data/")[2]: words for path, words in sent if "/data/" in path}
    assert asked["projects"] == {"name": ["Show"]}
    assert asked["shots/all"]["name"] == ["012"]
    assert asked["tasks"] == {"name": ["main"], "task_type_id": ["y"], "entity_id": ["s"]}
    posted = {path.partition("/api")[2]: body for path, body in sent if "/data/" not in path}
    assert "6 files" in posted["/actions/tasks/t/comment"]["comment"]
    assert first.read_bytes() in posted["/pictures/preview-files/made"]
