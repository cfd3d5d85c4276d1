"""Frames, keys, curves and eases: how a value changes over a cut.

It may use the standard library and the geometry below it; everything is a frozen value or a pure function.
It must never know which property a curve belongs to, nor any document, file or window.

Time is counted in frames from 1; seconds exist only at the doors to other programs.
"""
