"""Pictures made small for sheets of many: each pixel is the mean of those that it stands for."""

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images.reading import Steps


def shrunk(picture: Steps, most_px: int) -> NDArray[np.uint8]:
    """Return a picture, (H, W, C) 8 bit, with no side over ``most_px``; a smaller one stays as large as it is."""
    longest = max(picture.shape[:2])
    height, width = (max(round(side * min(most_px / longest, 1.0)), 1) for side in picture.shape[:2])
    rows, columns = (_means(whole, small) for whole, small in ((picture.shape[0], height), (picture.shape[1], width)))
    fewer = (rows @ picture.astype(np.float32).reshape(picture.shape[0], -1)).reshape(height, picture.shape[1], -1)
    return np.asarray(np.rint(columns @ fewer), np.uint8)


def _means(whole: int, small: int) -> NDArray[np.float32]:
    """Return the (small, whole) matrix of means over equal parts."""
    edges = np.linspace(0, whole, small + 1)
    starts, stops = edges[:-1, np.newaxis], edges[1:, np.newaxis]
    at = np.arange(whole)
    inside = np.clip(np.minimum(stops, at + 1) - np.maximum(starts, at), 0, None)
    return np.asarray(inside / inside.sum(axis=1, keepdims=True), np.float32)
