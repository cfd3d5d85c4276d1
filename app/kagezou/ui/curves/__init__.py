"""The curve editor: values and speeds of keyed properties over time, and what leads say about them.

It may use pyqtgraph, the tools of curves, `ui.widgets` and `ui.system`.
It must never know the timeline, the picture or the panels.
"""
