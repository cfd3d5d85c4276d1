"""Shader programs: read from files, joined by ``#include``, compiled, and fed uniforms by the document's words."""

import ctypes
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import GraphicsProblem
from kagezou.locations import shader_folder
from kagezou.render.gpu.gl import GL, log_of, set_source, status

_INCLUDE = re.compile(r'^#include "([\w.]+)"$', re.MULTILINE)

_FLOATS = ctypes.POINTER(ctypes.c_float)

Uniform = bool | int | float | Sequence[float] | NDArray[np.float64]
"""A (3, 3) matrix, (N, 4) vectors, a vector, a number or a switch."""


@cache
def shader_source(name: str) -> str:
    """Return a shader's text with its includes put in their places."""
    text = Path(shader_folder(), name).read_text(encoding="utf-8")
    return _INCLUDE.sub(lambda found: shader_source(found[1]), text)


class Program:
    """A linked pair of shaders.

    Parameters
    ----------
    vertex, fragment
        Names of files.
    switches
        Words that are defined for the preprocessor: a software rasteriser runs both sides of every branch, so what is
        known before drawing is decided when compiling.
    """

    def __init__(self, vertex: str, fragment: str, switches: Iterable[str] = ()) -> None:
        self._name = f"{vertex} + {fragment}"
        self._source = shader_source(vertex) + shader_source(fragment)
        self.id = int(GL.glCreateProgram())
        for name, kind in ((vertex, GL.GL_VERTEX_SHADER), (fragment, GL.GL_FRAGMENT_SHADER)):
            shader = _compiled(name, kind, switches)
            GL.glAttachShader(self.id, shader)
            GL.glDeleteShader(shader)
        GL.glLinkProgram(self.id)
        if not status(GL.glGetProgramiv, self.id, GL.GL_LINK_STATUS):
            raise GraphicsProblem(
                f"the graphics driver refuses {self._name}: {log_of(GL.glGetProgramInfoLog, self.id)}"
            )
        self._places: dict[str, int] = {}

    def use(self, uniforms: Mapping[str, Uniform]) -> None:
        """Draw with this program from now on, with these uniforms."""
        GL.glUseProgram(self.id)
        for name, value in uniforms.items():
            place = self._place(name)
            if place >= 0:
                self._set(place, value)

    def close(self) -> None:
        """Give the memory back."""
        GL.glDeleteProgram(self.id)

    def _place(self, name: str) -> int:
        place = self._places.get(name)
        if place is None:
            if not re.search(rf"\b{name}[;\[]", self._source):
                raise KeyError(f"{self._name} has no uniform {name}")
            # A driver may drop a uniform that does not matter; it is then at -1.
            place = self._places[name] = int(GL.glGetUniformLocation(self.id, name.encode()))
        return place

    def _set(self, place: int, value: Uniform) -> None:
        if isinstance(value, (bool, int)):
            GL.glUniform1i(place, int(value))
        elif isinstance(value, float):
            GL.glUniform1f(place, value)
        else:
            numbers = np.ascontiguousarray(value, dtype=np.float32)
            if numbers.shape == (3, 3):
                # Rows first, as numpy keeps them.
                GL.glUniformMatrix3fv(place, 1, 1, numbers.ctypes.data_as(_FLOATS))
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
    version, rest = shader_source(name).split("\n", 1)
    shader = int(GL.glCreateShader(kind))
    set_source(shader, "\n".join([version, *(f"#define {switch}" for switch in switches), rest]))
    GL.glCompileShader(shader)
    if not status(GL.glGetShaderiv, shader, GL.GL_COMPILE_STATUS):
        raise GraphicsProblem(f"the graphics driver refuses {name}: {log_of(GL.glGetShaderInfoLog, shader)}")
    return shader
