"""How the program looks: neutral greys (red = green = blue), because a tinted surround shifts how colours are seen.

Colour is kept for state: yellow is selected or keyed here, blue is changed from the default, orange is a warning.
"""

from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication, QStyleFactory

from kagezou.locations import resource_folder

CHROME = QColor("#2b2b2b")
WELL = QColor("#1e1e1e")
RAISED = QColor("#3a3a3a")
HOVERED = QColor("#454545")
LINE = QColor("#1a1a1a")
CHOSEN = QColor("#565656")
TEXT = QColor("#d0d0d0")
BRIGHT = QColor("#f0f0f0")
DIM = QColor("#a0a0a0")
"""Said more quietly, and still 4.5 to 1 on every ground it stands on but that of a chosen row."""
OFF = QColor("#6a6a6a")
"""What cannot be used now; nothing else is that faint."""
SURROUND = QColor("#484848")

SELECTED = QColor("#f0e442")
CHANGED = QColor("#56b4e9")
WARNING = QColor("#e69f00")
ERROR = QColor("#d55e00")

_JAPANESE_FONTS = ("Hiragino Sans", "Yu Gothic UI", "Meiryo", "Noto Sans CJK JP", "Noto Sans JP", "IPAGothic")
"""Named behind the system's own font so that names written in kanji get Japanese glyphs whatever the language."""


def apply(application: QApplication) -> None:
    """Give the application its style, palette, font and style sheet."""
    application.setStyle(QStyleFactory.create("Fusion"))
    application.setPalette(palette())
    font = QFont(application.font())
    font.setFamilies([font.family(), *_JAPANESE_FONTS])
    application.setFont(font)
    folder = resource_folder()
    sheet = (folder / "theme" / "kagezou.qss").read_text(encoding="utf-8")
    application.setStyleSheet(sheet.replace("@icons", (folder / "icons").as_posix()))


def palette() -> QPalette:
    """Return the dark palette; Qt derives nothing from the desktop's own colours."""
    made = QPalette(RAISED, CHROME)
    roles = {
        QPalette.ColorRole.Window: CHROME,
        QPalette.ColorRole.WindowText: TEXT,
        QPalette.ColorRole.Base: WELL,
        QPalette.ColorRole.AlternateBase: QColor("#232323"),
        QPalette.ColorRole.Text: TEXT,
        QPalette.ColorRole.Button: RAISED,
        QPalette.ColorRole.ButtonText: TEXT,
        QPalette.ColorRole.BrightText: BRIGHT,
        QPalette.ColorRole.Highlight: CHOSEN,
        QPalette.ColorRole.HighlightedText: BRIGHT,
        QPalette.ColorRole.ToolTipBase: QColor("#101010"),
        QPalette.ColorRole.ToolTipText: TEXT,
        QPalette.ColorRole.PlaceholderText: DIM,
        QPalette.ColorRole.Link: CHANGED,
        QPalette.ColorRole.Accent: CHOSEN,
    }
    for role, color in roles.items():
        made.setColor(role, color)
    for role in (QPalette.ColorRole.WindowText, QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText):
        made.setColor(QPalette.ColorGroup.Disabled, role, OFF)
    return made
