"""The menu of a bar: which drawing is exposed there, and the commands on drawings."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QMenu

from kagezou.document.model import Drawing
from kagezou.ui.timeline.timeline import Timeline

_A_MENU = 24
"""More drawings than that are shown in menus of their own."""


def open_drawing_menu(timeline: Timeline, fill: Callable[[QMenu], None], at: QPoint) -> None:
    """Open what can be done with the chosen exposures.

    Parameters
    ----------
    timeline
        Whose exposures they are.
    fill
        Fills in the commands.
    at
        Where, on the screen.
    """
    menu = QMenu(timeline)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    fill_drawing_menu(timeline, fill, menu)
    menu.popup(at)


def fill_drawing_menu(timeline: Timeline, fill: Callable[[QMenu], None], menu: QMenu) -> None:
    """Fill the menu of a bar."""
    layer = timeline.drawings.layer
    if layer is not None:
        replacing = menu.addMenu(QCoreApplication.translate("DrawingMenu", "Replace With"))
        _list(replacing, layer.cels.drawings, timeline.drawings.replace)
        inserting = menu.addMenu(QCoreApplication.translate("DrawingMenu", "Insert at the Playhead"))
        _list(inserting, layer.cels.drawings, timeline.drawings.insert)
        menu.addSeparator()
    fill(menu)


def _list(menu: QMenu, drawings: tuple[Drawing, ...], choose: Callable[[int], None]) -> None:
    for start in range(0, len(drawings), _A_MENU):
        part = drawings[start : start + _A_MENU]
        inner = menu if len(drawings) <= _A_MENU else menu.addMenu(f"{part[0].name} – {part[-1].name}")
        for number, drawing in enumerate(part, start):
            inner.addAction(drawing.name, partial(choose, number))
