"""The window: what a person sees and touches, made of Qt widgets over one session.

It may use every room below it; it alone imports Qt, and its viewport, timeline, curves and panels stay apart.
It must never know how a shadow is computed or a file is written: it asks, shows, and says what went wrong.
"""
