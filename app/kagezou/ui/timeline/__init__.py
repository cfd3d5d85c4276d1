"""The dope sheet: layers, exposures and keys over time.

It may use the tools of the timeline, `ui.widgets` and `ui.system`.
It must never know the curves, the picture or the panels.
"""
