"""Widgets that know no document: fields, sliders, buttons, docks, the message bar.

It may use Qt and `ui.system`.
It must never know a session, a layer or a file.
"""
