"""The commands of the window: their table, their Qt actions, how they are found, and the keys that are theirs.

It may use `ui.system`, `ui.widgets` and the shortcut files.
It must never know what a command does: parts of the window say so by `Actions.on`.
"""
