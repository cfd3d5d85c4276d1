"""Texts of Qt's own dialogs that some of Qt's catalogues lack: listed here, they are translated in ours.

Ours are asked first, so that a file dialog is of one language whole.
"""

from typing import Final


def translate(context: str, text: str) -> tuple[str, str]:
    """Mark a text of Qt's for the translators."""
    return context, text


OF_QT: Final = (
    translate("QFileDialog", "&Look in:"),
    translate("QFileDialog", "Files of &type:"),
    translate("QFileSystemModel", "%1 KiB"),
    translate("QFileSystemModel", "%1 MiB"),
    translate("QFileSystemModel", "%1 GiB"),
    translate("QFileSystemModel", "%1 TiB"),
    translate("QAbstractFileIconProvider", "Drive"),
    translate("QAbstractFileIconProvider", "File"),
    translate("QAbstractFileIconProvider", "%1 File"),
    translate("QAbstractFileIconProvider", "File Folder"),
    translate("QAbstractFileIconProvider", "Folder"),
    translate("QAbstractFileIconProvider", "Alias"),
    translate("QAbstractFileIconProvider", "Shortcut"),
    translate("QAbstractFileIconProvider", "Unknown"),
    translate("QColorDialog", "Pick Screen Color"),
    translate("QColorDialog", "&Pick Screen Color"),
)
"""Context and text, as Qt has them."""
