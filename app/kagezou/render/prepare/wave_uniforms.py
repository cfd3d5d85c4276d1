"""The numbers of waves as ``common/waves.glsl`` wants them."""

from math import pi

import numpy as np

from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.filters import Water

_MAX_RIPPLES = 2


def wave_uniforms(water: Water, receiver_from_place: Matrix, anchor_px: float) -> dict[str, Uniform]:
    """Return the ripples of a receiver, told in coordinates of its own.

    Parameters
    ----------
    water
        In u and v of the receiver.
    receiver_from_place
        Affine (2, 3), from the coordinates in which places are moved.
    anchor_px
        The distance in those at which the waves have their full strength.
    """
    turn, shift = receiver_from_place[:, :2], receiver_from_place[:, 2]
    ripples, matrices = np.zeros((_MAX_RIPPLES, 4)), np.zeros((_MAX_RIPPLES, 4))
    for index, ripple in enumerate(water.ripples):
        k = np.array(ripple.k)
        phase = (ripple.phase + float(k @ shift)) % (2 * pi)
        ripples[index] = (*(k @ turn), phase, ripple.wave.amplitude_px)
        matrices[index] = ripple.wave.matrix
    return {
        "u_ripple_count": len(water.ripples),
        "u_ripples": ripples,
        "u_ripple_matrices": matrices,
        "u_heave": np.asarray(np.linalg.inv(turn)).ravel(),
        "u_anchor_px": anchor_px,
    }
