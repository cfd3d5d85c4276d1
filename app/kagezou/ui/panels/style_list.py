"""The styles: the present drawing in every look there is; resting on one shows it, a click puts it on the character."""

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QIcon, QImage, QPixmap, QShowEvent
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QListWidgetItem, QVBoxLayout, QWidget

from kagezou.document.style import style_of
from kagezou.document.styling import put_style
from kagezou.errors import Problem
from kagezou.io.clips.style_files import StyleFile, path_of_style, save_style, styles_there
from kagezou.io.files.small_files import remove_file
from kagezou.ui.panels.style_name import StyleName
from kagezou.ui.panels.style_pictures import StylePictures, Wanted
from kagezou.ui.panels.style_use import put_on
from kagezou.ui.panels.style_view import StyleView
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.words import named, translated
from kagezou.ui.widgets.tool_button import tool_button

_PAUSE_MS = 500
"""Pictures are drawn anew when the hand has rested this long."""

_LIGHT_FLAG = "styles_bring_light"

_SIGN_OF_STUDIO = "◇ "
"""Before the name of a style of the studio's; there is no room for a word."""


class StyleList(QWidget):
    """The panel: pictures over a small footer.

    Parameters
    ----------
    bridge
        The session.
    settings
        Where the user's own styles are kept, and whether styles bring their light.
    """

    failed = Signal(str)
    noted = Signal(str)
    """What there is to know of a style that was put on."""

    def __init__(self, bridge: Bridge, settings: Settings) -> None:
        super().__init__()
        self._bridge = bridge
        self._settings = settings
        self._folder = settings.style_folder
        self._files: tuple[StyleFile, ...] = ()
        self._is_seen = True
        self.pictures = StylePictures()
        self.pictures.made.connect(self._show_picture)
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_PAUSE_MS)
        self._rest.timeout.connect(self._ask)
        self.light = self._made_light()
        self.list = StyleView()
        self.list.setAccessibleName(self.tr("Styles"))
        self.list.currentRowChanged.connect(lambda _: self._show_choice())
        self.list.picked.connect(self.apply)
        self.list.looked_at.connect(self._look_at)
        self.list.looked_away.connect(lambda: bridge.look_at(None))
        self._lay_out()
        for signal in (bridge.document_changed, bridge.frame_settled, bridge.selection_changed):
            signal.connect(self._wait_for_rest)
        self.reload()

    @property
    def brings_light(self) -> bool:
        """Whether a style that is put on brings its own light."""
        return self.light.isChecked()

    def come(self, seen: bool) -> None:
        """Take note whether the dock is at the front; docks behind others count as shown with Qt, but not as seen."""
        self._is_seen = seen
        self._wait_for_rest()

    def reload(self) -> None:
        """Read the styles again."""
        self._files, problems = styles_there(self._folder)
        for problem in problems:
            self.failed.emit(translated(problem))
        self.list.look_away()
        self.list.clear()
        blank = QPixmap(self.list.iconSize())
        blank.fill(Qt.GlobalColor.transparent)
        for each in self._files:
            item = QListWidgetItem(
                _SIGN_OF_STUDIO + named(each.style.name) if each.is_studio else named(each.style.name)
            )
            item.setData(Qt.ItemDataRole.AccessibleTextRole, self._words(each))
            item.setToolTip(self._hint(each))
            item.setSizeHint(self.list.gridSize())
            item.setIcon(QIcon(blank))
            self.list.addItem(item)
        self._show_choice()
        self._rest.start()

    def apply(self, index: int) -> None:
        """Put a style on the chosen layers, as one step."""
        if not self._bridge.layer_ids or not 0 <= index < len(self._files):
            return
        style = self._files[index].style
        step = self.tr("Style: %1").replace("%1", named(style.name))
        self.noted.emit(put_on(self._bridge, self._bridge.layer_ids, style, step, with_light=self.brings_light))

    def save(self, name: str, *, with_scene: bool = False) -> None:
        """Keep the look of the layer worked on under a name, perhaps with light, ground and set-up."""
        layer_id = self._bridge.layer_id
        if layer_id is None:
            return
        try:
            look = style_of(self._bridge.document, layer_id, self._bridge.frame, name, with_scene=with_scene)
            if path_of_style(self._folder, look).exists():
                self.noted.emit(
                    self.tr("The style %1 took the place of the one before").replace("%1", named(look.name))
                )
            save_style(self._folder, look)
        except Problem as problem:
            self.failed.emit(translated(problem))
        self.reload()

    def remove_current(self) -> None:
        """Take the chosen style away, if it is the user's own."""
        index = self.list.currentRow()
        if 0 <= index < len(self._files) and self._files[index].is_own:
            try:
                remove_file(self._files[index].path)
            except Problem as problem:
                self.failed.emit(translated(problem))
            self.reload()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._rest.start()

    def _hint(self, file: StyleFile) -> str:
        lines = [named(file.style.name)]
        if file.style.scene:
            lines.append(self.tr("Has a light of its own"))
        if file.is_studio:
            of_studio = self.tr("Of the studio: %1").replace("%1", str(file.path.parent))
            lines.append(_SIGN_OF_STUDIO + of_studio)
        return "\n".join(lines)

    def _words(self, file: StyleFile) -> str:
        """Return what is said of a style where its picture is not seen."""
        name = named(file.style.name)
        return self.tr("%1 (studio)").replace("%1", name) if file.is_studio else name

    def _made_light(self) -> QCheckBox:
        made = QCheckBox(self.tr("With its light"))
        made.setToolTip(
            self.tr("Where a style has a light of its own, take it along. Light is for all characters, so choose all.")
        )
        made.setChecked(self._settings.flag(_LIGHT_FLAG, default=False))
        made.toggled.connect(self._bring_light)
        return made

    def _bring_light(self, brings: bool) -> None:
        self._settings.set_flag(_LIGHT_FLAG, on=brings)
        self._wait_for_rest()

    def _lay_out(self) -> None:
        footer = QWidget()
        footer.setObjectName("panel_footer")
        footer.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        row = QHBoxLayout(footer)
        row.setContentsMargins(4, 2, 4, 2)
        row.addWidget(tool_button("add", self.tr("Keep this look as a style of your own"), self.ask_name))
        row.addWidget(self.light)
        row.addStretch(1)
        self._remove = tool_button("remove", self.tr("Remove your style"), self.remove_current)
        row.addWidget(self._remove)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.list, 1)
        column.addWidget(footer)

    def _look_at(self, index: int) -> None:
        """Show the picture as it would be in a style, as long as nothing is done."""
        if self._bridge.layer_ids and not self._bridge.session.is_in_gesture:
            styled = put_style(
                self._bridge.document,
                self._bridge.layer_ids,
                self._files[index].style,
                self._bridge.frame,
                with_light=self.brings_light,
            )
            self._bridge.look_at(styled.document)

    def ask_name(self) -> None:
        """Ask by which name the look of the layer worked on is kept."""
        if self._bridge.layer_id is not None:
            question = StyleName(self)
            question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            question.given.connect(lambda name, with_scene: self.save(name, with_scene=with_scene))
            question.open()

    def _show_choice(self) -> None:
        index = self.list.currentRow()
        self._remove.setEnabled(0 <= index < len(self._files) and self._files[index].is_own)

    def _wait_for_rest(self) -> None:
        # Seven more pictures at once would take the processor from the one under the hand.
        self.pictures.pause()
        self._rest.start()

    def _ask(self) -> None:
        if self._bridge.layer_ids and self._is_seen and self.isVisible():
            styles = tuple(each.style for each in self._files)
            wanted = Wanted(
                self._bridge.document, self._bridge.layer_ids, self._bridge.frame, styles, self.brings_light
            )
            self.pictures.ask(wanted)

    def _show_picture(self, index: int, image: QImage) -> None:
        item = self.list.item(index)
        if item is not None:
            item.setIcon(QIcon(QPixmap.fromImage(image)))
