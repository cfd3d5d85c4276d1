"""Drags in the timeline: of keys and of drawings, along time.

It may use the document, its edits and animation; places come in px across, with the px that a frame measures.
It must never know Qt, rows of the window or how anything looks.
"""
