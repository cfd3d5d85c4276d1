"""The hand on the frame around the selected keys: inside it moves them, its edges and corners scale them."""

from PySide6.QtCore import QCoreApplication

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, move_keys
from kagezou.document.model import Document
from kagezou.document.scale_edits import UNSCALED, Scaling, scale_keys
from kagezou.ui.curves.key_box import BoxGrip, KeyBox
from kagezou.ui.curves.picture import CurvePicture


class BoxController:
    """One drag of the frame.

    Parameters
    ----------
    box, part
        The frame as it was, and what was taken hold of.
    pictures
        The curves as they were.
    start
        Where, in graph coordinates.
    """

    def __init__(
        self, box: KeyBox, part: BoxGrip, pictures: tuple[CurvePicture, ...], start: tuple[float, float]
    ) -> None:
        self._box, self.part, self._start = box, part, start
        self._pictures = tuple(picture for picture in pictures if any(mark.is_chosen for mark in picture.keys))
        chosen = (mark.ref for picture in self._pictures for mark in picture.keys if mark.is_chosen)
        self._refs: Refs = frozenset(chosen)
        self.said = ""

    @property
    def name(self) -> str:
        """What the step of history is called."""
        words = {
            (False, False): QCoreApplication.translate("BoxController", "Move keys"),
            (True, False): QCoreApplication.translate("BoxController", "Stretch keys"),
            (False, True): QCoreApplication.translate("BoxController", "Scale keys in value"),
            (True, True): QCoreApplication.translate("BoxController", "Scale keys"),
        }
        return words[bool(self.part.across), bool(self.part.up)]

    def dragged(
        self, document: Document, place: tuple[float, float], *, about_centre: bool, one_axis: bool
    ) -> tuple[Document, Refs]:
        """Return the document with the keys where the pointer pulls them.

        Parameters
        ----------
        document
            As it was when the drag began.
        place
            Where the pointer is, in graph coordinates.
        about_centre
            Whether the middle of the frame stays instead of the opposite edge.
        one_axis
            Whether a move goes only the way along which it goes farther, and a corner scales both ways alike.
        """
        away = place[0] - self._start[0], place[1] - self._start[1]
        if self.part.is_inside:
            return self._moved(document, away, one_axis=one_axis)
        along, up = self._scalings(away, about_centre=about_centre)
        if one_axis and self.part.across and self.part.up:
            factor = max(along.factor, up.factor, key=lambda each: abs(each - 1))
            along, up = Scaling(along.about, factor), Scaling(up.about, factor)
        shown = []
        if self.part.across:
            shown.append(QCoreApplication.translate("BoxController", "time × %1").replace("%1", f"{along.factor:.2f}"))
        if self.part.up:
            shown.append(QCoreApplication.translate("BoxController", "value × %1").replace("%1", f"{up.factor:.2f}"))
        self.said = "    ".join(shown)
        return scale_keys(document, self._refs, along, self._in_own_units(up))

    def _scalings(self, away: tuple[float, float], *, about_centre: bool) -> tuple[Scaling, Scaling]:
        edge = self._box.edge_of(self.part)
        fixed = self._box.edge_of(BoxGrip(0, 0) if about_centre else BoxGrip(-self.part.across, -self.part.up))
        sides = (self.part.across, self.part.up)
        scalings = []
        for side, at, about, more in zip(sides, edge, fixed, away, strict=True):
            reach = at - about
            scalings.append(Scaling(about, (reach + more) / reach) if side and reach else UNSCALED)
        along, up = scalings
        return (Scaling(along.about, max(along.factor, 0.0)) if self.part.across else UNSCALED), up

    def _in_own_units(self, up: Scaling) -> dict[tuple[Address, int], Scaling]:
        """Return the scaling of ordinates as scalings of each curve's own values."""
        if up is UNSCALED:
            return {}
        return {
            (picture.curve.address, picture.curve.component): Scaling(picture.fitting.from_graph(up.about), up.factor)
            for picture in self._pictures
        }

    def _moved(self, document: Document, away: tuple[float, float], *, one_axis: bool) -> tuple[Document, Refs]:
        frames, ordinates = round(away[0]), away[1]
        if one_axis:
            across_px, up_px = abs(away[0] * self._box.frame_px), abs(away[1] * self._box.unit_px)
            frames, ordinates = (frames, 0.0) if across_px >= up_px else (0, ordinates)
        amounts: dict[Address, tuple[float, ...]] = {}
        for picture in self._pictures:
            before = amounts.get(picture.curve.address, ())
            padding = (0.0,) * (picture.curve.component - len(before))
            amounts[picture.curve.address] = (*before, *padding, ordinates / picture.fitting.factor)
        factors = {picture.fitting.factor for picture in self._pictures}
        value = f"{ordinates / next(iter(factors)):+.4g}" if len(factors) == 1 else ""
        moved = QCoreApplication.translate("BoxController", "%1 frames").replace("%1", f"{frames:+d}")
        self.said = f"{moved}    {value}".strip()
        return move_keys(document, self._refs, frames, amounts)
