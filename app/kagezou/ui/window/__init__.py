"""The window itself: its bars, menus, panels and status, composed here and nowhere else.

It may use every other part of the window.
It must never know how any of them works.
"""
