"""How a layer looks in the list: eye, thumbnail, name, and what it holds."""

from PySide6.QtCore import QObject, QRect, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen
from PySide6.QtWidgets import QStyleOptionViewItem, QWidget

from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.ui.panels.layer_model import Role
from kagezou.ui.system.icons import icon
from kagezou.ui.system.theme import BRIGHT, DIM, HOVERED, TEXT, WELL
from kagezou.ui.widgets.eye_delegate import EYE_WIDTH, EyeDelegate, Index

_THUMBNAIL = 40
_GAP = 8
_INDENT = 18
_LABEL_PX = 4
_SIGN_PX = 18


class LayerDelegate(EyeDelegate):
    """Paints rows and takes clicks on the eye."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(Role.IS_VISIBLE, parent)

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        two_lines = 2 * option.fontMetrics.height() + 8
        return QSize(160, max(_THUMBNAIL + 10, two_lines))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        area = QRect(option.rect)
        painter.save()
        chosen, visible = self.paint_start(painter, option, index)
        frame = QRect(
            area.left() + EYE_WIDTH + _indent(index), area.center().y() - _THUMBNAIL // 2, _THUMBNAIL, _THUMBNAIL
        )
        if _indent(index):
            _paint_elbow(painter, frame)
        _paint_thumbnail(painter, frame, index.data(Role.THUMBNAIL), faded=not visible)
        _paint_marks(painter, area, frame, index)
        tone, quiet = (BRIGHT if chosen else TEXT) if visible else DIM, TEXT if chosen else DIM
        self._paint_words(painter, option, index, name_tone=tone, quiet=quiet)
        painter.restore()

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        editor = super().createEditor(parent, option, index)
        editor.setAccessibleName(self.tr("Layer name"))
        return editor

    def updateEditorGeometry(self, editor: QWidget, option: QStyleOptionViewItem, index: Index) -> None:
        area = _words_area(QRect(option.rect), _indent(index))
        height = editor.sizeHint().height()
        editor.setGeometry(area.left() - 4, area.center().y() - height // 2, area.width() + 2, height)

    def _paint_words(
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index, *, name_tone: QColor, quiet: QColor
    ) -> None:
        area = _words_area(QRect(option.rect), _indent(index))
        area.setRight(area.right() - _SIGN_PX * len(_signs(index)))
        metrics = painter.fontMetrics()
        middle = area.center().y()
        name = metrics.elidedText(str(index.data()), Qt.TextElideMode.ElideMiddle, area.width())
        painter.setPen(name_tone)
        painter.drawText(area.left(), middle - 2, name)
        painter.setPen(quiet)
        summary = metrics.elidedText(str(index.data(Role.SUMMARY)), Qt.TextElideMode.ElideRight, area.width())
        painter.drawText(area.left(), middle + metrics.ascent() + 2, summary)


def _indent(index: Index) -> int:
    """Return how far a row is set in: a part of a figure stands behind an elbow."""
    return _INDENT if index.data(Role.IS_PART) else 0


def _words_area(area: QRect, indent: int) -> QRect:
    return area.adjusted(EYE_WIDTH + indent + _THUMBNAIL + _GAP, 0, -6, 0)


def _signs(index: Index) -> list[str]:
    """Return the signs that stand at the right end of a row, from the right."""
    marks = index.data(Role.MARKS)
    if not isinstance(marks, LayerMarks):
        return []
    return [*(["lock"] if marks.is_locked else []), *(["solo"] if marks.is_solo else [])]


def _paint_marks(painter: QPainter, area: QRect, frame: QRect, index: Index) -> None:
    """Paint the label's colour at the left edge, the signs at the right one, and a warning where drawings miss."""
    marks = index.data(Role.MARKS)
    if isinstance(marks, LayerMarks) and marks.label in LABELS:
        painter.fillRect(QRect(area.left(), area.top(), _LABEL_PX, area.height() - 1), QColor(LABELS[marks.label]))
    for number, sign in enumerate(_signs(index)):
        left = area.right() - _SIGN_PX * (number + 1) - 2
        icon(sign).paint(painter, QRect(left, area.center().y() - _SIGN_PX // 2, _SIGN_PX - 3, _SIGN_PX))
    if index.data(Role.IS_MISSING):
        corner = QRect(frame.right() - 15, frame.bottom() - 15, 16, 16)
        painter.fillRect(corner, QColor(0, 0, 0, 170))
        icon("warning").paint(painter, corner.adjusted(1, 1, -1, -1))


def _paint_elbow(painter: QPainter, frame: QRect) -> None:
    """Paint the line that leads from a figure to its part."""
    painter.setPen(QPen(DIM, 1.5))
    x, y = frame.left() - _INDENT // 2, frame.center().y()
    painter.drawLine(x, frame.top(), x, y)
    painter.drawLine(x, y, frame.left() - 3, y)


def _paint_thumbnail(painter: QPainter, frame: QRect, image: QImage | None, *, faded: bool) -> None:
    painter.fillRect(frame, HOVERED)
    painter.setPen(QPen(WELL, 1))
    painter.drawRect(frame.adjusted(0, 0, -1, -1))
    if image is None or image.isNull():
        return
    size = image.size().scaled(frame.size() - QSize(4, 4), Qt.AspectRatioMode.KeepAspectRatio)
    place = QRect(frame.topLeft(), size)
    place.moveCenter(frame.center())
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.setOpacity(0.35 if faded else 1.0)
    painter.drawImage(place, image)
    painter.setOpacity(1.0)
