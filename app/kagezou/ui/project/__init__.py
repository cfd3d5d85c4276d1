"""The open project: opening, importing, saving, autosave, recovery, and the first page.

It may use importing, the files' room, `ui.widgets` and `ui.system`.
It must never know the timeline, the picture or the panels.
"""
