"""Textures and framebuffers; nothing else makes any."""

from ctypes import c_uint, c_void_p
from enum import Enum
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import GraphicsProblem
from kagezou.geometry.box import Box
from kagezou.io.images.reading import Steps
from kagezou.message import Message
from kagezou.render.gpu.gl import GL, deleted, integer, made
from kagezou.render.prepare.uniforms import LAST_LEVEL

Component: TypeAlias = type[np.uint8] | type[np.uint16] | type[np.uint32] | type[np.float32]

_CHANNELS: dict[int, int] = {GL.GL_RG: 2, GL.GL_RGBA: 4, GL.GL_RGBA_INTEGER: 4}

_COMPONENTS: dict[int, Component] = {
    GL.GL_UNSIGNED_BYTE: np.uint8,
    GL.GL_UNSIGNED_SHORT: np.uint16,
    GL.GL_UNSIGNED_INT: np.uint32,
    GL.GL_FLOAT: np.float32,
}


class Format(Enum):
    """Internal format, pixel format and component type of a texture."""

    ALPHA8 = (GL.GL_R8, GL.GL_RED, GL.GL_UNSIGNED_BYTE)
    ALPHA16 = (GL.GL_R16, GL.GL_RED, GL.GL_UNSIGNED_SHORT)
    FLOAT = (GL.GL_R32F, GL.GL_RED, GL.GL_FLOAT)
    FLOAT2 = (GL.GL_RG32F, GL.GL_RG, GL.GL_FLOAT)
    FLOAT4 = (GL.GL_RGBA32F, GL.GL_RGBA, GL.GL_FLOAT)
    COUNT = (GL.GL_R32UI, GL.GL_RED_INTEGER, GL.GL_UNSIGNED_INT)
    COUNT4 = (GL.GL_RGBA32UI, GL.GL_RGBA_INTEGER, GL.GL_UNSIGNED_INT)
    RGBA8 = (GL.GL_RGBA8, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)
    RGBA16 = (GL.GL_RGBA16, GL.GL_RGBA, GL.GL_UNSIGNED_SHORT)

    @property
    def dtype(self) -> Component:
        """The numpy type of one component."""
        return _COMPONENTS[self.value[2]]

    @property
    def components(self) -> int:
        """How many components a pixel has."""
        return _CHANNELS.get(self.value[1], 1)


class Texture:
    """A 2-D texture whose first row is the top row of the picture."""

    def __init__(self, width_px: int, height_px: int, form: Format) -> None:
        limit = integer(GL.GL_MAX_TEXTURE_SIZE)
        if max(width_px, height_px) > limit:
            raise GraphicsProblem(
                Message(
                    "a picture of {width_px}x{height_px} px is over this graphics driver's {limit} px",
                    width_px=width_px,
                    height_px=height_px,
                    limit=limit,
                )
            )
        self.width_px = width_px
        self.height_px = height_px
        self.form = form
        self.has_mipmaps = False
        self.id = made(GL.glGenTextures)
        internal, pixels, component = form.value
        self.bind(0)
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, internal, width_px, height_px, 0, pixels, component, None)
        for name, value in (
            (GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST),
            (GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST),
            (GL.GL_TEXTURE_WRAP_S, GL.GL_CLAMP_TO_EDGE),
            (GL.GL_TEXTURE_WRAP_T, GL.GL_CLAMP_TO_EDGE),
            (GL.GL_TEXTURE_MAX_LEVEL, 0),
        ):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, name, value)

    @property
    def nbytes(self) -> int:
        """Memory of the finest level."""
        return self.width_px * self.height_px * self.form.components * np.dtype(self.form.dtype).itemsize

    def bind(self, unit: int) -> None:
        """Bind to a texture unit."""
        GL.glActiveTexture(GL.GL_TEXTURE0 + unit)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self.id)

    def upload(self, pixels: Steps | NDArray[np.float32], top: int = 0) -> None:
        """Fill the rows from ``top`` with C-contiguous pixels (H, W) or (H, W, 4) of the format's type."""
        _, order, component = self.form.value
        self.bind(0)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        start = c_void_p(pixels.ctypes.data)
        GL.glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, top, self.width_px, len(pixels), order, component, start)
        self.has_mipmaps = False

    def upload_part(self, pixels: Steps | NDArray[np.float32], box: Box) -> None:
        """Fill the texture with a box of its size out of C-contiguous pixels (H, W) or (H, W, 4)."""
        _, order, component = self.form.value
        self.bind(0)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        GL.glPixelStorei(GL.GL_UNPACK_ROW_LENGTH, pixels.shape[1])
        corner = pixels[box.top :, box.left :]
        start = c_void_p(corner.ctypes.data)
        GL.glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, 0, box.width, box.height, order, component, start)
        GL.glPixelStorei(GL.GL_UNPACK_ROW_LENGTH, 0)
        self.has_mipmaps = False

    def make_mipmaps(self) -> None:
        """Make the coarser levels, unless they are there."""
        if not self.has_mipmaps:
            self.bind(0)
            GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAX_LEVEL, LAST_LEVEL)
            GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST_MIPMAP_NEAREST)
            GL.glGenerateMipmap(GL.GL_TEXTURE_2D)
            self.has_mipmaps = True

    def set_linear(self, *, magnified: bool, minified: bool) -> None:
        """Choose smooth or blocky sampling."""
        self.bind(0)
        choices = ((GL.GL_TEXTURE_MAG_FILTER, magnified), (GL.GL_TEXTURE_MIN_FILTER, minified))
        for name, smooth in choices:
            GL.glTexParameteri(GL.GL_TEXTURE_2D, name, GL.GL_LINEAR if smooth else GL.GL_NEAREST)

    def close(self) -> None:
        """Give the memory back."""
        deleted(GL.glDeleteTextures, self.id)


class Target:
    """A texture that can be drawn into. Framebuffer row 0 is the top row of the picture, so nothing is flipped."""

    def __init__(self, width_px: int, height_px: int, form: Format) -> None:
        self.texture = Texture(width_px, height_px, form)
        self.id = made(GL.glGenFramebuffers)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self.id)
        GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, self.texture.id, 0)
        if GL.glCheckFramebufferStatus(GL.GL_FRAMEBUFFER) != GL.GL_FRAMEBUFFER_COMPLETE:
            raise GraphicsProblem(
                Message(
                    "the graphics driver cannot draw a picture of {width_px}x{height_px} px ({form})",
                    width_px=width_px,
                    height_px=height_px,
                    form=form.name,
                )
            )

    @property
    def box(self) -> Box:
        """The whole target."""
        return Box(0, 0, self.texture.width_px, self.texture.height_px)

    @property
    def size_px(self) -> tuple[float, float]:
        """Width and height as a uniform."""
        return (float(self.texture.width_px), float(self.texture.height_px))

    def bind(self, scissor: Box | None = None) -> None:
        """Draw into this target from now on, within ``scissor``, with no blending, depth test or culling left over."""
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self.id)
        GL.glViewport(0, 0, self.texture.width_px, self.texture.height_px)
        for state in (GL.GL_BLEND, GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST, GL.GL_DITHER):
            GL.glDisable(state)
        GL.glBlendEquation(GL.GL_FUNC_ADD)
        GL.glColorMask(True, True, True, True)  # noqa: FBT003 - the call's own order
        box = scissor or self.box
        GL.glEnable(GL.GL_SCISSOR_TEST)
        GL.glScissor(box.left, box.top, box.width, box.height)

    def clear(self, box: Box | None = None) -> None:
        """Make a box, or everything, transparent black."""
        self.bind(box)
        GL.glClearColor(0.0, 0.0, 0.0, 0.0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)

    def read(self, box: Box) -> Steps:
        """Return the pixels of a box, (h, w) or (h, w, 4), top row first."""
        _, order, component = self.texture.form.value
        count = self.texture.form.components
        shape = (box.height, box.width) if count == 1 else (box.height, box.width, count)
        pixels: Steps = np.empty(shape, np.uint8) if self.texture.form.dtype is np.uint8 else np.empty(shape, np.uint16)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self.id)
        GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
        GL.glReadPixels(box.left, box.top, box.width, box.height, order, component, c_void_p(pixels.ctypes.data))
        return pixels

    def read_for_screen(self) -> Steps:
        """Return all pixels, (H, W, 4) 8 bit, in the order in which screens keep them: blue, green, red, alpha."""
        pixels = np.empty((self.texture.height_px, self.texture.width_px, 4), np.uint8)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self.id)
        GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
        start = c_void_p(pixels.ctypes.data)
        GL.glReadPixels(0, 0, *pixels.shape[1::-1], GL.GL_BGRA, GL.GL_UNSIGNED_BYTE, start)
        return pixels

    def read_floats(self, box: Box) -> NDArray[np.float32]:
        """Return a box as floats, (h, w) or with two or four components (h, w, 2) or (h, w, 4), top row first."""
        count = self.texture.form.components
        pixels = np.empty((box.height, box.width) if count == 1 else (box.height, box.width, count), np.float32)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self.id)
        GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
        start = c_void_p(pixels.ctypes.data)
        GL.glReadPixels(box.left, box.top, box.width, box.height, self.texture.form.value[1], GL.GL_FLOAT, start)
        return pixels

    def texture_alone(self) -> Texture:
        """Give up drawing and return what was drawn."""
        deleted(GL.glDeleteFramebuffers, self.id)
        return self.texture

    def close(self) -> None:
        """Give the memory back."""
        self.texture_alone().close()


class DeepTarget(Target):
    """A target in which the nearest counts, of numbers (COUNT) or floats; it starts with zero, infinitely far away."""

    def __init__(self, width_px: int, height_px: int, form: Format) -> None:
        super().__init__(width_px, height_px, form)
        self._depth = made(GL.glGenRenderbuffers)
        GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, self._depth)
        GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT32F, width_px, height_px)
        GL.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER, self._depth)

    def begin(self) -> None:
        """Draw from now on, starting with nothing."""
        self.bind()
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glDepthFunc(GL.GL_LESS)
        GL.glDepthMask(True)  # noqa: FBT003 - the call's own order
        GL.glClearDepth(1.0)
        GL.glClear(GL.GL_DEPTH_BUFFER_BIT)
        if self.texture.form is Format.COUNT:
            GL.glClearBufferuiv(GL.GL_COLOR, 0, (c_uint * 4)())
        else:
            GL.glClearColor(0.0, 0.0, 0.0, 0.0)
            GL.glClear(GL.GL_COLOR_BUFFER_BIT)

    def texture_alone(self) -> Texture:
        """Give up drawing and return what was drawn."""
        deleted(GL.glDeleteRenderbuffers, self._depth)
        return super().texture_alone()


class DepthTarget:
    """A square depth buffer that can be read as a texture: 32 bit, compared as less."""

    def __init__(self, side_px: int) -> None:
        self._side = side_px
        self._texture = made(GL.glGenTextures)
        self.bind_texture(0)
        GL.glTexImage2D(
            GL.GL_TEXTURE_2D, 0, GL.GL_DEPTH_COMPONENT32F, side_px, side_px, 0, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT, None
        )
        for name in (GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, name, GL.GL_NEAREST)
        self._framebuffer = made(GL.glGenFramebuffers)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self._framebuffer)
        GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_TEXTURE_2D, self._texture, 0)
        GL.glDrawBuffer(GL.GL_NONE)
        GL.glReadBuffer(GL.GL_NONE)

    def bind_texture(self, unit: int) -> None:
        """Bind the depths to a texture unit."""
        GL.glActiveTexture(GL.GL_TEXTURE0 + unit)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self._texture)

    def begin(self) -> None:
        """Draw depths from now on, starting from the farthest."""
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self._framebuffer)
        GL.glViewport(0, 0, self._side, self._side)
        for state in (GL.GL_BLEND, GL.GL_SCISSOR_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST):
            GL.glDisable(state)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glDepthFunc(GL.GL_LESS)
        GL.glDepthMask(True)  # noqa: FBT003 - the call's own order
        GL.glClearDepth(1.0)
        GL.glClear(GL.GL_DEPTH_BUFFER_BIT)

    def close(self) -> None:
        """Give the memory back."""
        deleted(GL.glDeleteFramebuffers, self._framebuffer)
        deleted(GL.glDeleteTextures, self._texture)
