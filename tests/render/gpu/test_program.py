"""Shaders as files: joined by includes, and a driver's error names the file and the line that a person must open."""

from collections.abc import Iterator
from pathlib import Path
from weakref import WeakSet

import numpy as np
import pytest

from kagezou.errors import GraphicsProblem
from kagezou.locations import shader_folder
from kagezou.render.gpu import program
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.gpu.program import Program, compile_all, names_in, shader_source
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.prepare.uniforms import Uniform

VERTEX = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n"
FRAGMENT = """#version 330 core
#ifdef TINTED
#include "common/tint.glsl"
#endif
out vec4 color;
void main() {
    color = vec4(%s);
}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of shaders of the test's own, and a context to compile them in."""
    (tmp_path / "common").mkdir()
    (tmp_path / "whole.vert").write_text(VERTEX, encoding="utf-8")
    monkeypatch.setattr(program, "shader_folder", lambda: tmp_path)
    shader_source.cache_clear()
    names_in.cache_clear()
    with open_headless_context():
        yield tmp_path
    shader_source.cache_clear()
    names_in.cache_clear()


def refusal(fragment: str, switches: tuple[str, ...] = ()) -> str:
    with pytest.raises(GraphicsProblem) as problem:
        Program("whole.vert", fragment, switches).use({})
    return str(problem.value)


def test_an_error_after_an_include_names_its_own_line(folder: Path) -> None:
    (folder / "common" / "tint.glsl").write_text("vec4 tint = vec4(1.0);\n" + "\n" * 40, encoding="utf-8")
    (folder / "broken.frag").write_text(FRAGMENT % "missing", encoding="utf-8")
    for switches in ((), ("TINTED",), ("TINTED", "MORE", "YET_MORE")):
        assert "broken.frag:7" in refusal("broken.frag", switches)


def test_an_error_within_an_include_names_the_included_file(folder: Path) -> None:
    (folder / "common" / "tint.glsl").write_text("\n\nfloat tint() { return missing; }\n", encoding="utf-8")
    (folder / "good.frag").write_text(FRAGMENT % "1.0", encoding="utf-8")
    assert "common/tint.glsl:3" in refusal("good.frag", ("TINTED",))


def test_includes_of_includes_are_numbered_apart(folder: Path) -> None:
    (folder / "common" / "tint.glsl").write_text('#include "common/hue.glsl"\nfloat tint = hue();\n', encoding="utf-8")
    (folder / "common" / "hue.glsl").write_text("float hue() { return 1.0; }\n", encoding="utf-8")
    (folder / "nested.frag").write_text(FRAGMENT % "1.0", encoding="utf-8")
    source = shader_source("nested.frag")
    assert source.files == ("nested.frag", "common/tint.glsl", "common/hue.glsl")
    assert (
        source.named("0:1(2): error, 2(7) : error, 9:9") == "nested.frag:1(2): error, common/hue.glsl(7) : error, 9:9"
    )


def test_every_include_of_the_program_is_there() -> None:
    for path in shader_folder().rglob("*"):
        if path.is_file():
            assert shader_source(path.relative_to(shader_folder()).as_posix()).text


def test_each_draw_has_the_uniforms_that_it_was_given_last(folder: Path) -> None:
    corners = (
        "#version 330 core\nlayout(location = 0) in vec2 a_place;\nvoid main() { gl_Position = vec4(%s, 0.0, 1.0); }\n"
    )
    (folder / "box.vert").write_text(corners % "a_place * 2.0 - 1.0", encoding="utf-8")
    shown = "#version 330 core\nuniform float u_part;\nuniform vec2 u_pair;\nout float part;\n%s\n"
    (folder / "part.frag").write_text(shown % "void main() { part = u_part + u_pair.x; }", encoding="utf-8")
    target, boxes, drawn = Target(1, 1, Format.ALPHA16), Boxes(), Program("box.vert", "part.frag")
    pairs: list[tuple[float, Uniform]] = [
        (0.25, (0.0, 0.0)),
        (0.25, (0.5, 0.0)),
        (0.25, np.array([0.125, 0.0])),
        (0.5, (0.5, 0.0)),
        (0.5, (0.5, 0.0)),
    ]
    found = []
    for part, pair in pairs:
        target.clear()
        target.bind(target.box)
        drawn.use({"u_part": part, "u_pair": pair})
        boxes.draw_one(target.box)
        found.append(int(target.read(target.box)[0, 0]) / 65535)
    assert found == pytest.approx([0.25, 0.75, 0.375, 1.0, 1.0], abs=1e-4)


def test_a_program_is_compiled_when_it_is_first_used_or_when_all_are(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Programs that other tests have left are of other folders.
    monkeypatch.setattr(program, "_waiting", WeakSet())
    (folder / "common" / "tint.glsl").write_text("float tint = 1.0;\n", encoding="utf-8")
    (folder / "good.frag").write_text(FRAGMENT % "1.0", encoding="utf-8")
    (folder / "bad.frag").write_text(FRAGMENT % "missing", encoding="utf-8")
    good, bad = Program("whole.vert", "good.frag"), Program("whole.vert", "bad.frag")
    good.use({})
    with pytest.raises(GraphicsProblem, match=r"bad\.frag"):
        compile_all()
    Program("whole.vert", "bad.frag").close()
    compile_all()
    for program_of_both in (good, bad):
        program_of_both.close()


def test_a_uniform_that_is_not_there_is_told(folder: Path) -> None:
    (folder / "common" / "tint.glsl").write_text("uniform float u_tint;\n", encoding="utf-8")
    (folder / "good.frag").write_text(FRAGMENT % "1.0", encoding="utf-8")
    made = Program("whole.vert", "good.frag", ("TINTED",))
    made.use({"u_tint": 1.0})
    with pytest.raises(KeyError, match="u_hue"):
        made.use({"u_hue": 1.0})
    made.close()
