"""What draws: the strings and limits of the current OpenGL context."""

from dataclasses import dataclass

from kagezou.errors import GraphicsProblem
from kagezou.message import Message
from kagezou.render.gpu.gl import GL, integer, text

NEEDED = (3, 3)
_SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "swiftshader", "gdi generic")


@dataclass(frozen=True, slots=True)
class GraphicsInfo:
    """The driver's own words, and what follows from them."""

    vendor: str
    renderer: str
    version: str
    major: int
    minor: int
    max_texture_px: int

    @property
    def is_software(self) -> bool:
        """Whether the processor draws, not a graphics card."""
        return any(word in self.renderer.lower() for word in _SOFTWARE)

    @property
    def is_enough(self) -> bool:
        """Whether the version suffices: OpenGL 3.3."""
        return (self.major, self.minor) >= NEEDED


def read_info() -> GraphicsInfo:
    """Return what the current context is; GraphicsProblem if none is current or it is too old."""
    vendor, renderer, version = (text(what) for what in (GL.GL_VENDOR, GL.GL_RENDERER, GL.GL_VERSION))
    if vendor is None or renderer is None or version is None:
        raise GraphicsProblem(Message("there is no OpenGL context to draw with"))
    numbers = version.split()[0].split(".")
    major, minor = (int(part) if part.isdigit() else 0 for part in (*numbers, "0")[:2])
    info = GraphicsInfo(vendor, renderer, version, major, minor, integer(GL.GL_MAX_TEXTURE_SIZE))
    if not info.is_enough:
        raise GraphicsProblem(
            Message(
                "the graphics driver offers OpenGL {version} ({renderer}); Kagezou needs 3.3: update the driver",
                version=version,
                renderer=renderer,
            )
        )
    return info
