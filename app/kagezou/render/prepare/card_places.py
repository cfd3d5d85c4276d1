"""Where in the world a drawing stands on its card."""

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.card import receiver_of
from kagezou.geometry.ground import world_from_canvas_on
from kagezou.geometry.placement import around_placed, canvas_from_centred
from kagezou.geometry.vectors import Matrix
from kagezou.scene.scene import ShadowCast


def places_on_card(cast: ShadowCast, box: Box) -> Matrix | None:
    """Return world points (N, 3) around all of a card that holds a box of the drawing; None where it has no end.

    Parameters
    ----------
    box
        As the drawing lies before a placement moves it, canvas px.
    """
    seen = around_placed(box, canvas_from_centred(cast.placement))
    found: list[Matrix] = []
    for piece in cast.card.pieces:
        part = piece.part_of(seen)
        if len(part) == 0:
            continue
        lift = world_from_canvas_on(cast.camera, receiver_of(cast.camera, piece))
        if lift is None:
            return None
        places = lift @ np.column_stack([part, np.ones(len(part))]).T
        if not (places[3] > 1e-9 * np.abs(lift).max()).all():
            return None
        found.append((places[:3] / places[3]).T)
    return np.concatenate(found) if found else None
