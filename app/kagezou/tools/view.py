"""How the canvas is seen in the viewport: magnified and moved, nothing else."""

from dataclasses import dataclass, replace

from kagezou.geometry.vectors import Point2

MIN_ZOOM = 0.05
MAX_ZOOM = 64.0


@dataclass(frozen=True, slots=True)
class CanvasView:
    """A magnification and a place.

    Parameters
    ----------
    zoom
        Logical view px for one canvas px, kept within ``MIN_ZOOM`` to ``MAX_ZOOM`` by every method here.
    origin_view_px
        Where the canvas's top left corner is seen, logical px from the viewport's top left.
    """

    zoom: float = 1.0
    origin_view_px: Point2 = (0.0, 0.0)

    @classmethod
    def fitted(cls, canvas_size: Point2, view_size: Point2, margin_px: float = 24.0) -> "CanvasView":
        """Return the view that shows the whole canvas, centred, with ``margin_px`` view px around it."""
        room = (max(view_size[0] - 2 * margin_px, 1.0), max(view_size[1] - 2 * margin_px, 1.0))
        zoom = _limited(min(room[0] / canvas_size[0], room[1] / canvas_size[1]))
        left, top = ((view - zoom * canvas) / 2 for view, canvas in zip(view_size, canvas_size, strict=True))
        return cls(zoom, (left, top))

    def view_from_canvas(self, canvas_px: Point2) -> Point2:
        """Return where a canvas point is seen, view px."""
        return (
            self.origin_view_px[0] + self.zoom * canvas_px[0],
            self.origin_view_px[1] + self.zoom * canvas_px[1],
        )

    def canvas_from_view(self, view_px: Point2) -> Point2:
        """Return the canvas point seen at a place of the view, canvas px."""
        return (
            (view_px[0] - self.origin_view_px[0]) / self.zoom,
            (view_px[1] - self.origin_view_px[1]) / self.zoom,
        )

    def canvas_length(self, view_length_px: float) -> float:
        """Return the canvas px that look ``view_length_px`` long."""
        return view_length_px / self.zoom

    def zoomed_at(self, pointer_view_px: Point2, factor: float) -> "CanvasView":
        """Return the view magnified ``factor`` times; the canvas point under the pointer stays there."""
        zoom = _limited(self.zoom * factor)
        kept = self.canvas_from_view(pointer_view_px)
        origin = (pointer_view_px[0] - zoom * kept[0], pointer_view_px[1] - zoom * kept[1])
        return CanvasView(zoom, origin)

    def panned(self, dx: float, dy: float) -> "CanvasView":
        """Return the view with its picture moved by view px."""
        return replace(self, origin_view_px=(self.origin_view_px[0] + dx, self.origin_view_px[1] + dy))


def _limited(zoom: float) -> float:
    return min(max(zoom, MIN_ZOOM), MAX_ZOOM)
