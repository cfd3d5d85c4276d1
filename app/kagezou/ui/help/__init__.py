"""Help within the program: the manual and where it is opened, and the guided first cut.

It may use the document, `ui.widgets` and `ui.system`.
It must never know the panels that it explains: the window says which page is about what.
"""
