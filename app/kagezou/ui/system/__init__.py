"""What every part of the window stands on: the session's bridge, settings, language, theme, icons, background work.

It may use the rooms below `ui`, and Qt.
It must never know any part of the window.
"""
