"""Cuts as scenes of other programs: layers as pictures, and one file of text that lays them on each other.

It may use everything of the export room but the exporters.
It must never know who asked, nor how the choices are shown.
"""
