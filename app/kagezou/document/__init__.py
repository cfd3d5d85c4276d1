"""The document: layers, light, ground and their properties over time, and the edits that make a new one of an old one.

It may use animation and geometry; every value is frozen, every edit a pure function ``(document, …) -> document``.
It must never know files' contents, pixels, windows, history or the frame someone is looking at.
"""
