"""Where a figure stands: feet in the outlines of drawings, and what they do over time.

It may use numpy and the geometry below it; everything is a frozen value or a pure function.
It must never know a document, a file or a window: outlines and numbers come in, feet and ground rows go out.
"""
