"""Pixels as bytes: packing, signatures of formats, colour, and the values that a layered picture is made of.

It may use numpy, isal, zlib-ng and the geometry's boxes.
It must never know where a file lies or which document asked.
"""
