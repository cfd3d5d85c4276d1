"""The picture that fills the viewport now: kept from before, or drawn as finely as there is time for."""

from time import perf_counter

from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from kagezou.document.scaling import usable_divisor
from kagezou.io.images.reading import Steps
from kagezou.render.gpu.presenter import WindowView
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.finished_frames import FinishedFrames
from kagezou.ui.viewport.frame_painter import FramePainter
from kagezou.ui.viewport.picture_view import PictureView, behind, line_px
from kagezou.ui.viewport.reading import Reading
from kagezou.ui.viewport.resolution import Pace
from kagezou.ui.viewport.viewpoint import Viewpoint


class Showing:
    """Finds the session's frame as it fills the viewport.

    Parameters
    ----------
    bridge, viewpoint
        The session, and how the canvas is looked at.
    reading
        What brings drawings into memory.
    """

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint, reading: Reading) -> None:
        self._bridge, self._viewpoint, self._reading = bridge, viewpoint, reading
        self._image_of: tuple[object, ...] = ()
        self.pace, self.finished = Pace(), FinishedFrames()
        self.backdrop, self.view = Backdrop.BACKGROUND, PictureView.COMPOSITE
        self.image: QImage | None = None
        self.is_current = False
        self.took_s = 0.0

    def draw_into(self, frame_painter: FramePainter, view: WindowView, *, moving: bool) -> None:
        """Draw the frame if need be, and place it in the framebuffer of a view."""
        if self.draw(frame_painter, moving=moving):
            self.pace.took(frame_painter.divisor, frame_painter.took_s)
        frame_painter.present(view)

    def find(self, frame_painter: FramePainter, view: WindowView, *, moving: bool) -> None:
        """Make ``image`` the frame in a view without a framebuffer, kept from before or drawn now."""
        began_s, frame, document = perf_counter(), self._bridge.frame, self._bridge.shown
        resting = self.pace.next(moving=False).divisor
        look = (document, self.backdrop, self.view, view, resting)
        kept = self.finished.picture(look, frame)
        if kept is not None:
            self.image, self._image_of, self.is_current, self.took_s = kept, (), True, 0.0
            return
        is_new = self.draw(frame_painter, moving=moving)
        made_of = (view, frame_painter.divisor, frame_painter.pictures_drawn)
        if self._image_of == made_of:
            return
        pixels = frame_painter.present(view)
        assert pixels is not None
        self.image, self._image_of = _image_of(pixels, self._viewpoint.device_ratio), made_of
        self.took_s = perf_counter() - began_s
        if is_new:
            self.pace.took(frame_painter.divisor, self.took_s)
        # What is dragged is never seen again, and a file that cannot be read may be mended.
        is_done = self.is_current and not frame_painter.broken and not self._bridge.session.is_in_gesture
        if is_done and frame_painter.divisor == usable_divisor(document.canvas, resting):
            self.finished.keep(look, frame, self.image, document.canvas.length_frames)

    def draw(self, frame_painter: FramePainter, *, moving: bool) -> bool:
        """Draw the frame unless it is the one drawn last or its drawings are still on their way; false then."""
        document, view = self._bridge.shown, self.view
        self.is_current = self._reading.has_drawings_of(document, self._bridge.frame)
        if not self.is_current and frame_painter.pictures_drawn:
            return False
        backdrop = behind(view, self.backdrop, has_background=document.background is not None)
        line = line_px(view, self._viewpoint.view.zoom)
        return frame_painter.draw(document, self._bridge.frame, backdrop, view, line, self.pace.next(moving=moving))


def window_view(widget: QWidget, viewpoint: Viewpoint) -> WindowView:
    """Return how the picture lies in a widget, which has no framebuffer."""
    ratio = widget.devicePixelRatioF()
    view, surround = viewpoint.view, viewpoint.surround
    x, y = view.origin_view_px
    return WindowView(
        framebuffer=None,
        # Halves go up, as Qt makes its framebuffer.
        width_px=max(int(widget.width() * ratio + 0.5), 1),
        height_px=max(int(widget.height() * ratio + 0.5), 1),
        zoom=view.zoom * ratio,
        # On whole device pixels, so that at 100 % nothing is blurred by half a pixel.
        origin_px=(float(round(x * ratio)), float(round(y * ratio))),
        surround=(surround.redF(), surround.greenF(), surround.blueF()),
    )


def _image_of(pixels: Steps, ratio: float) -> QImage:
    """Return pixels (H, W, 4), blue, green, red, opaque, as a picture that keeps them alive."""
    height, width = pixels.shape[:2]
    image = QImage(pixels.data, width, height, width * 4, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    return image
