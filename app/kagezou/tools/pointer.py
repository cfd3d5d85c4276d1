"""Where the hand is and which keys it holds."""

from dataclasses import dataclass

from kagezou.geometry.vectors import Point2
from kagezou.tools.view import CanvasView


@dataclass(frozen=True, slots=True)
class Modifiers:
    """What the held keys ask of a drag; :meth:`of_keys` holds the program's one convention.

    Parameters
    ----------
    constrain
        Keep to one axis, to steps of 15°, or to a piece's proportions.
    fine
        Move at a tenth of the pointer's speed.
    symmetric
        Move the counterpart the opposite way, where there is one.
    snap
        Be drawn to places that mean something.
    """

    constrain: bool = False
    fine: bool = False
    symmetric: bool = False
    snap: bool = True

    @classmethod
    def of_keys(cls, *, shift: bool = False, alt: bool = False, ctrl: bool = False) -> "Modifiers":
        """Return what keys mean: Shift constrains, Alt is symmetric, both together are fine, Ctrl lets go of snaps."""
        return cls(constrain=shift and not alt, fine=shift and alt, symmetric=alt and not shift, snap=not ctrl)


@dataclass(frozen=True, slots=True)
class Pointer:
    """One report of mouse, pen or finger: the same place in view px (logical) and in canvas px, and the keys."""

    view_px: Point2
    canvas_px: Point2
    modifiers: Modifiers = Modifiers()

    @classmethod
    def seen_at(cls, view: CanvasView, view_px: Point2, modifiers: Modifiers | None = None) -> "Pointer":
        """Return the pointer at a place of the view."""
        return cls(view_px, view.canvas_from_view(view_px), modifiers or Modifiers())
