"""Sets in the window: the list of pieces, their commands, and importing set files.

It may use importing, tools, `ui.widgets` and `ui.system`.
It must never know how a piece is drawn on the picture.
"""
