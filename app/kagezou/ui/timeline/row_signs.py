"""What a row is called, and what stands beside it: a layer's label, that it is locked or alone, missing drawings."""

from typing import Final

from PySide6.QtCore import QCoreApplication, QRect, QRectF
from PySide6.QtGui import QColor, QPainter

from kagezou.document.alike_names import folded
from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.document.model import Document
from kagezou.ui.system.icons import icon
from kagezou.ui.system.words import translated
from kagezou.ui.timeline.rows import RowKind, TimelineRow

SIGN_PX: Final = 16
_LABEL_PX: Final = 4


def paint_label(painter: QPainter, marks: LayerMarks, row: QRectF) -> None:
    """Paint the colour of a layer at the left edge of its row."""
    if marks.label in LABELS:
        painter.fillRect(QRectF(row.left(), row.top(), _LABEL_PX, row.height() - 1), QColor(LABELS[marks.label]))


def paint_signs(painter: QPainter, marks: LayerMarks, *, is_missing: bool, right: float, row: QRectF) -> float:
    """Paint the signs of a layer from the right; return how wide they are, px."""
    signs = (("warning", is_missing), ("lock", marks.is_locked), ("solo", marks.is_solo))
    shown = [name for name, is_shown in signs if is_shown]
    for number, name in enumerate(shown):
        left = round(right - SIGN_PX * (number + 1))
        icon(name).paint(painter, QRect(left, round(row.center().y()) - SIGN_PX // 2, SIGN_PX - 2, SIGN_PX))
    return float(SIGN_PX * len(shown))


def row_name(document: Document, row: TimelineRow) -> str:
    """Return what a row is called; no group of rows is called as another one, whatever the case of its letters."""
    translate = QCoreApplication.translate
    scene = translate("RowNames", "Scene")
    if row.kind is RowKind.SCENE:
        return translate("RowNames", "Scene (light, ground)") if _is_taken(document, scene) else scene
    if row.layer_id is not None and row.kind is RowKind.LAYER:
        return document.layer(row.layer_id).name
    if row.piece_id is not None and row.kind is RowKind.PIECE:
        name = document.piece(row.piece_id).name
        is_taken = _is_taken(document, name) or folded(name) == folded(scene)
        return translate("RowNames", "%1 (set)").replace("%1", name) if is_taken else name
    if row.kind is RowKind.FEET:
        return translate("RowNames", "Feet")
    return translated(row.addresses[0].property.label)


def _is_taken(document: Document, name: str) -> bool:
    """Whether a layer bears a name."""
    return any(folded(layer.name) == folded(name) for layer in document.layers)
