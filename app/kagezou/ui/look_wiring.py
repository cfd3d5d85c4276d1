"""Who tells whom about looking closer: the views of the frame, and what is laid over the picture."""

from typing import TYPE_CHECKING

from PySide6.QtGui import QActionGroup

from kagezou.ui.viewport.picture_view import PictureView

if TYPE_CHECKING:
    from kagezou.ui.main_window import MainWindow


def connect_views(window: "MainWindow") -> None:
    """Connect the choice of what is looked at."""
    actions, viewport = window.actions_of, window.viewport
    group = QActionGroup(window)
    for view in PictureView:
        action = actions[f"view_{view.value}"]
        group.addAction(action)
        action.setChecked(view is viewport.view)

        def show(on: bool, chosen: PictureView = view) -> None:
            if on:
                viewport.show_view(chosen)

        actions.on_toggled(f"view_{view.value}", show)
