"""The one door to PyOpenGL, opened with the settings that make it fast and usable without a display.

PyOpenGL is untyped and builds its functions when it is imported; ``GL`` is therefore ``Any`` here, on purpose and once.
"""

import importlib
import os
import sys
from typing import Any

import OpenGL

from kagezou.errors import GraphicsProblem

if sys.platform.startswith("linux"):
    # One dispatch table (libglvnd) serves EGL contexts of our own and GLX or EGL contexts of a window alike.
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
# A glGetError after every call would cost more than the calls; errors are asked for once a picture (check).
OpenGL.ERROR_CHECKING = False
OpenGL.ERROR_LOGGING = False

GL: Any = importlib.import_module("OpenGL.GL")
# PyOpenGL's own form of this one call asks which context is current, of EGL alone, and fails in a GLX window.
GL.glVertexAttribPointer = importlib.import_module("OpenGL.raw.GL.VERSION.GL_2_0").glVertexAttribPointer

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
        raise GraphicsProblem(f"the graphics driver failed while {doing}: {_NAMES.get(error, hex(error))}")
