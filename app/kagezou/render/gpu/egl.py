"""A core OpenGL 3.3 context without a display, through libEGL (Linux)."""

import ctypes
from ctypes import POINTER, c_char_p, c_int, c_uint, c_void_p
from types import TracebackType
from typing import TYPE_CHECKING, Self

from kagezou.errors import GraphicsProblem
from kagezou.message import Message

if TYPE_CHECKING:  # a context is opened beside the import of all that is done with it
    from kagezou.render.gpu.info import GraphicsInfo

_OPENGL_API = 0x30A2
_EXTENSIONS = 0x3055
_SURFACELESS_MESA = 0x31DD
_DEVICE_EXT = 0x313F
_CONTEXT = (0x3098, 3, 0x30FB, 3, 0x30FD, 0x00000001, 0x3038)
"""Major 3, minor 3, core profile."""
_MAX_DEVICES = 16


def _library() -> ctypes.CDLL:
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError as error:
        raise GraphicsProblem(
            Message("OpenGL without a display needs libEGL (Debian package libegl1): {error}", error=error)
        ) from error
    egl.eglGetProcAddress.restype = c_void_p
    egl.eglGetProcAddress.argtypes = [c_char_p]
    egl.eglGetDisplay.restype = c_void_p
    egl.eglGetDisplay.argtypes = [c_void_p]
    egl.eglInitialize.argtypes = [c_void_p, POINTER(c_int), POINTER(c_int)]
    egl.eglQueryString.restype = c_char_p
    egl.eglQueryString.argtypes = [c_void_p, c_int]
    egl.eglCreateContext.restype = c_void_p
    egl.eglCreateContext.argtypes = [c_void_p, c_void_p, c_void_p, POINTER(c_int)]
    egl.eglMakeCurrent.argtypes = [c_void_p, c_void_p, c_void_p, c_void_p]
    egl.eglDestroyContext.argtypes = [c_void_p, c_void_p]
    egl.eglBindAPI.argtypes = [c_uint]
    return egl


class EglContext:
    """A context of our own, current on the thread that entered it; use it as a context manager."""

    def __init__(self) -> None:
        self._egl = _library()
        self._display, self._context = self._first_working()

    def __enter__(self) -> Self:
        """Make the context current."""
        self.make_current()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Release and destroy the context."""
        self.close()

    @property
    def info(self) -> "GraphicsInfo":
        """What draws; the context must be current."""
        from kagezou.render.gpu.info import read_info

        return read_info()

    def make_current(self) -> None:
        """Make the context current on the calling thread; one that is closed is left alone."""
        if self._context is not None and not self._egl.eglMakeCurrent(self._display, None, None, self._context):
            raise GraphicsProblem(
                Message("the OpenGL context cannot be used on this thread (EGL error {self})", self=self._error())
            )

    def close(self) -> None:
        """Destroy the context; a second call does nothing."""
        if self._context is not None:
            self._egl.eglMakeCurrent(self._display, None, None, None)
            self._egl.eglDestroyContext(self._display, self._context)
            self._context = None

    def _first_working(self) -> tuple[int, int | None]:
        """Return the first display that gives a 3.3 core context: surfaceless, then each device, then the default."""
        for display in self._displays():
            if not display or not self._egl.eglInitialize(display, None, None):
                continue
            extensions = self._egl.eglQueryString(display, _EXTENSIONS) or b""
            if b"EGL_KHR_surfaceless_context" not in extensions or not self._egl.eglBindAPI(_OPENGL_API):
                continue
            attributes = (c_int * len(_CONTEXT))(*_CONTEXT)
            context = self._egl.eglCreateContext(display, None, None, attributes)
            if context:
                return display, context
        raise GraphicsProblem(
            Message(
                "OpenGL 3.3 is not available without a display: "
                "on Debian and Ubuntu install libegl1 libgl1 libgl1-mesa-dri"
            )
        )

    def _displays(self) -> list[int | None]:
        platform_display = self._egl.eglGetProcAddress(b"eglGetPlatformDisplayEXT")
        if not platform_display:
            return [self._egl.eglGetDisplay(None)]
        get = ctypes.CFUNCTYPE(c_void_p, c_uint, c_void_p, POINTER(c_int))(platform_display)
        devices = (get(_DEVICE_EXT, device, None) for device in self._devices())
        return [get(_SURFACELESS_MESA, None, None), *devices, self._egl.eglGetDisplay(None)]

    def _devices(self) -> list[int | None]:
        query = self._egl.eglGetProcAddress(b"eglQueryDevicesEXT")
        if not query:
            return []
        found = (c_void_p * _MAX_DEVICES)()
        count = c_int()
        if not ctypes.CFUNCTYPE(c_uint, c_int, c_void_p, POINTER(c_int))(query)(_MAX_DEVICES, found, count):
            return []
        return [found[index] for index in range(count.value)]

    def _error(self) -> str:
        return hex(self._egl.eglGetError())
