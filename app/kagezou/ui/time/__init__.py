"""Playback, the frame strip, and the commands that act on keys.

It may use `ui.widgets`, `ui.system` and the rooms below `ui`.
It must never know the timeline's or the curves' own pictures.
"""
