"""Exporting, as the window shows it: the dialog, its presets and options, and the progress.

It may use the export room, `ui.widgets` and `ui.system`.
It must never know how a frame is drawn or written.
"""
