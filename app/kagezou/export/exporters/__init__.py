"""The kinds of export, one module each, and the table that window and command line take them from.

It may use everything of the export room.
It must never know who asked, nor how the choices are shown.
"""
