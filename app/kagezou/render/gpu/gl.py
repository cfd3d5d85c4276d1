"""The one door to OpenGL: PyOpenGL's raw functions of version 3.3, and what Python needs around them.

PyOpenGL's friendly layer takes a tenth of a second to import and more time per call than the driver does; the raw
functions are plain ctypes. They are built when they are imported, so ``GL`` is ``Any`` here, on purpose and once.
"""

import ctypes
import importlib
import os
import sys
from collections.abc import Iterable
from ctypes import byref, c_char, c_char_p, c_int, c_uint, c_void_p
from functools import partial
from types import SimpleNamespace
from typing import Any, Final

import OpenGL

from kagezou.errors import GraphicsProblem
from kagezou.message import Message

if sys.platform.startswith("linux"):
    # One dispatch table (libglvnd) serves EGL contexts of our own and GLX or EGL contexts of a window alike.
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
# A glGetError after every call would cost more than the calls; errors are asked for once a picture (check).
OpenGL.ERROR_CHECKING = False
OpenGL.ERROR_LOGGING = False

_Simple: Final[type] = c_int.__mro__[1]
"""What every number of ctypes is."""

_VERSIONS: Final = ("1_0", "1_1", "1_2", "1_3", "1_4", "1_5", "2_0", "2_1", "3_0", "3_1", "3_2", "3_3")


_QUICK: Final = (
    "glActiveTexture", "glBindBuffer", "glBindFramebuffer", "glBindTexture", "glBindVertexArray", "glBlendEquation",
    "glBlendFunc", "glBufferData", "glClearColor", "glDisable", "glEnable", "glPixelStorei", "glScissor",
    "glTexParameteri", "glUniform1f", "glUniform1i", "glUniform2f", "glUniform3f", "glUniform4f", "glUniform4fv",
    "glUniformMatrix3fv", "glUseProgram", "glViewport",
)  # fmt: skip
"""What only notes something down and returns at once."""


def _everything() -> SimpleNamespace:
    modules = (importlib.import_module(f"OpenGL.raw.GL.VERSION.GL_{version}") for version in _VERSIONS)
    named = {name: value for module in modules for name, value in vars(module).items() if name[:2] in ("gl", "GL")}
    # PyOpenGL's constants are numbers with a name; ctypes takes plain ones faster.
    return SimpleNamespace(**{n: int(v) if isinstance(v, int) else v for n, v in named.items()})


def _hold_on_to_python(names: Iterable[str]) -> None:
    """Have functions called without letting other threads of Python go on meanwhile, from their first call on.

    To let them and to wait for one's turn again takes many times as long as these do. Nor are their arguments looked at
    by PyOpenGL, which makes arrays of what is a plain pointer here.
    """
    for name in names:
        setattr(GL, name, partial(_first_call, name, getattr(GL, name)))


def _first_call(name: str, original: Any, *arguments: Any) -> Any:
    # It is found out where the function is only when there is a context.
    found = original.load() if hasattr(original, "load") else original
    plain = [each if issubclass(each, _Simple) else c_void_p for each in found.argtypes]
    quick = ctypes.PYFUNCTYPE(found.restype, *plain)(ctypes.cast(found, c_void_p).value or 0)
    setattr(GL, name, quick)
    return quick(*arguments)


GL: Any = _everything()
if sys.platform.startswith("linux"):
    _hold_on_to_python(_QUICK)

_NAMES = {
    0x0500: "invalid enum",
    0x0501: "invalid value",
    0x0502: "invalid operation",
    0x0505: "out of memory",
    0x0506: "invalid framebuffer operation",
}


def check(doing: str) -> None:
    """Raise GraphicsProblem if OpenGL has noted an error since the last check.

    Parameters
    ----------
    doing
        What was being done, as it stands in the sentence.
    """
    error = int(GL.glGetError())
    if error:
        while GL.glGetError():
            pass
        raise GraphicsProblem(
            Message(
                "the graphics driver failed while {doing}: {error}", doing=doing, error=_NAMES.get(error, hex(error))
            )
        )


def made(make: Any) -> int:
    """Return the name of one new object, made by a function such as ``GL.glGenTextures``."""
    name = c_uint()
    make(1, byref(name))
    return name.value


def deleted(delete: Any, name: int) -> None:
    """Delete one object by a function such as ``GL.glDeleteTextures``."""
    delete(1, byref(c_uint(name)))


def integer(what: int) -> int:
    """Return a number of the context, such as ``GL.GL_MAX_TEXTURE_SIZE``."""
    value = c_int()
    GL.glGetIntegerv(what, byref(value))
    return value.value


def text(what: int) -> str | None:
    """Return a text of the context, such as ``GL.GL_VENDOR``; None without a context."""
    words = ctypes.cast(GL.glGetString(what), c_char_p).value
    return None if words is None else words.decode("utf-8", "replace")


def status(get: Any, name: int, what: int) -> int:
    """Return a number of a shader or program, by a function such as ``GL.glGetShaderiv``."""
    value = c_int()
    get(name, what, byref(value))
    return value.value


def log_of(get: Any, name: int, limit: int = 2000) -> str:
    """Return what the driver says of a shader or program, by a function such as ``GL.glGetShaderInfoLog``."""
    words = (c_char * limit)()
    get(name, limit, None, words)
    return " ".join(words.value.decode("utf-8", "replace").split())[:500]


def set_source(shader: int, source: str) -> None:
    """Give a shader its text."""
    words = ctypes.create_string_buffer(source.encode("utf-8"))
    GL.glShaderSource(shader, 1, byref(ctypes.cast(words, ctypes.POINTER(c_char))), None)
