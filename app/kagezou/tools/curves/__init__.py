"""The curves of keyed properties as they are drawn over time, what of them is near a place, and the drags on them.

It may use the document, its edits and animation; places come in graph coordinates: frames across, ordinates up.
It must never know Qt, the plotting library or how anything looks.
"""
