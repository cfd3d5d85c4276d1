"""Retakes: other drawings for a layer, matched with those it had, so that what was set stays where it makes sense.

`prints` says what a drawing looks like, `matching` which old drawing is which new one, `timing` when the new ones are
exposed and where keys go, `pins` what stays of what a person said about feet, and `retake` does all of it.
It may use the other modules of `importing`.
It must never change a document but as a whole: `retaken` returns the new one, with all that is to be said of it.
"""
