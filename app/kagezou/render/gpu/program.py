"""Shader programs: read from files, joined by ``#include``, compiled, and fed uniforms by the document's words."""

import ctypes
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from weakref import WeakSet

import numpy as np

from kagezou.errors import GraphicsProblem
from kagezou.locations import shader_folder
from kagezou.message import Message
from kagezou.render.gpu.gl import GL, log_of, set_source, status
from kagezou.render.prepare.uniforms import Uniform

_INCLUDE = re.compile(r'^#include "([\w./]+)"$')
_DECLARED = re.compile(r"\b(\w+)[;\[]")
_ENDS = ("#else", "#elif", "#endif")
_PLACE_IN_LOG = re.compile(r"\b(\d+)([:(])(\d+)")
"""File number and line as drivers write them: ``0:12(5)``, ``0(12)``, ``ERROR: 0:12``."""

_FLOATS = ctypes.POINTER(ctypes.c_float)


@dataclass(frozen=True, slots=True)
class ShaderSource:
    """A shader's text with its includes in their places.

    Attributes
    ----------
    text
        GLSL; ``#line`` directives number each line as in its own file, and the files as in ``files``.
    files
        Their names in the folder of shaders, the shader's own first.
    """

    text: str
    files: tuple[str, ...]

    def named(self, log: str) -> str:
        """Return a driver's log with names of files in the place of their numbers."""

        def place(found: re.Match[str]) -> str:
            number = int(found[1])
            return f"{self.files[number]}{found[2]}{found[3]}" if number < len(self.files) else found[0]

        return _PLACE_IN_LOG.sub(place, log)


@cache
def shader_source(name: str) -> ShaderSource:
    """Return the shader in a file, e.g. ``passes/cast.frag``, with its includes put in their places."""
    files: list[str] = []
    text = "\n".join(_lines_of(name, files))
    return ShaderSource(f"{text}\n", tuple(files))


@cache
def names_in(name: str) -> frozenset[str]:
    """Return what a shader in a file declares, and more: every word before the end of a statement or an index."""
    return frozenset(_DECLARED.findall(shader_source(name).text))


def _lines_of(name: str, files: list[str]) -> Iterator[str]:
    """Yield the lines of a file and of what it includes, and add their names to ``files``."""
    own = len(files)
    files.append(name)
    lines = Path(shader_folder(), name).read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        found = _INCLUDE.match(line)
        if found is not None:
            yield f"#line 1 {len(files)}"
            yield from _lines_of(found[1], files)
        else:
            yield line
        # A directive that a condition leaves out does not count, so that lines are counted anew where conditions end.
        if found is not None or line.startswith(_ENDS):
            yield f"#line {number + 1} {own}"


_waiting: WeakSet["Program"] = WeakSet()
"""Programs that nothing has been drawn with."""


def compile_all() -> None:
    """Compile every program that nothing has been drawn with yet; GraphicsProblem if the driver refuses one."""
    for program in tuple(_waiting):
        _ = program.id


class Program:
    """A linked pair of shaders, compiled when something is first drawn with it: most pictures need few of them.

    Parameters
    ----------
    vertex, fragment
        Names of files.
    switches
        Words that are defined for the preprocessor: a software rasteriser runs both sides of every branch, so what is
        known before drawing is decided when compiling.
    """

    def __init__(self, vertex: str, fragment: str, switches: Iterable[str] = ()) -> None:
        self._files = (vertex, fragment)
        self._switches = tuple(switches)
        self._id: int | None = None
        self._places: dict[str, int] = {}
        self._values: dict[int, Uniform | None] = {}
        _waiting.add(self)

    @property
    def id(self) -> int:
        """Its name in OpenGL; GraphicsProblem if it has to be compiled and the driver refuses that."""
        if self._id is None:
            _waiting.discard(self)
            self._id = self._linked()
        return self._id

    def use(self, uniforms: Mapping[str, Uniform]) -> None:
        """Draw with this program from now on, with these uniforms."""
        GL.glUseProgram(self.id)
        for name, value in uniforms.items():
            place = self._place(name)
            if place >= 0 and not self._has(place, value):
                self._set(place, value)

    def close(self) -> None:
        """Give the memory back."""
        _waiting.discard(self)
        if self._id is not None:
            GL.glDeleteProgram(self._id)

    @property
    def _name(self) -> str:
        return " + ".join(self._files)

    def _linked(self) -> int:
        vertex, fragment = self._files
        program = int(GL.glCreateProgram())
        for name, kind in ((vertex, GL.GL_VERTEX_SHADER), (fragment, GL.GL_FRAGMENT_SHADER)):
            shader = _compiled(name, kind, self._switches)
            GL.glAttachShader(program, shader)
            GL.glDeleteShader(shader)
        GL.glLinkProgram(program)
        if not status(GL.glGetProgramiv, program, GL.GL_LINK_STATUS):
            raise GraphicsProblem(
                Message(
                    "the graphics driver refuses {name}: {glgetprograminfolog}",
                    name=self._name,
                    glgetprograminfolog=log_of(GL.glGetProgramInfoLog, program),
                )
            )
        return program

    def _place(self, name: str) -> int:
        place = self._places.get(name)
        if place is None:
            if not any(name in names_in(each) for each in self._files):
                raise KeyError(f"{self._name} has no uniform {name}")
            # A driver may drop a uniform that does not matter; it is then at -1.
            place = self._places[name] = int(GL.glGetUniformLocation(self.id, name.encode()))
        return place

    def _has(self, place: int, value: Uniform) -> bool:
        """Return whether a uniform has a value already; the program keeps them, and to compare arrays costs as much."""
        known = None if isinstance(value, np.ndarray) else value
        is_same = known is not None and self._values.get(place) == known
        self._values[place] = known
        return is_same

    def _set(self, place: int, value: Uniform) -> None:
        if isinstance(value, (bool, int)):
            GL.glUniform1i(place, int(value))
        elif isinstance(value, float):
            GL.glUniform1f(place, value)
        else:
            numbers = np.ascontiguousarray(value, dtype=np.float32)
            if numbers.shape[-2:] == (3, 3):
                # Rows first, as numpy keeps them.
                GL.glUniformMatrix3fv(place, numbers.size // 9, 1, numbers.ctypes.data_as(_FLOATS))
            elif numbers.ndim == 2:
                GL.glUniform4fv(place, len(numbers), numbers.ctypes.data_as(_FLOATS))
            else:
                (GL.glUniform2f, GL.glUniform3f, GL.glUniform4f)[len(numbers) - 2](place, *numbers.tolist())


class Variants:
    """The same pair of shaders, compiled once for each set of switches that is asked for."""

    def __init__(self, vertex: str, fragment: str) -> None:
        self._files = (vertex, fragment)
        self._made: dict[frozenset[str], Program] = {}

    def __getitem__(self, switches: frozenset[str]) -> Program:
        """Return the program with these switches."""
        program = self._made.get(switches)
        if program is None:
            program = self._made[switches] = Program(*self._files, sorted(switches))
        return program

    def close(self) -> None:
        """Give the memory back."""
        for program in self._made.values():
            program.close()
        self._made.clear()


def _compiled(name: str, kind: int, switches: Iterable[str]) -> int:
    source = shader_source(name)
    version, rest = source.text.split("\n", 1)
    shader = int(GL.glCreateShader(kind))
    # The version must stand first; what is defined after it must not shift the numbers of the lines.
    set_source(shader, "\n".join([version, *(f"#define {switch}" for switch in switches), "#line 2 0", rest]))
    GL.glCompileShader(shader)
    if not status(GL.glGetShaderiv, shader, GL.GL_COMPILE_STATUS):
        log = source.named(log_of(GL.glGetShaderInfoLog, shader))
        raise GraphicsProblem(Message("the graphics driver refuses {name}: {log}", name=name, log=log))
    return shader
