"""What a technical animator would script with OpenCV: a program of its own, timed as a whole process.

Its words: the folder of drawings, the folder of frames, and the nine numbers of the map from the drawing to its shadow.
"""

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import cv2  # type: ignore[import-not-found,unused-ignore] # not one of our packages
import numpy as np

SIGMA_PX, OPACITY, GAIN, COLOR_BGR = 12.0, 0.6, 2.5066 * 12.0, (40, 16, 20)


def shadow(alpha: Any, canvas_from_art: Any) -> Any:
    """Return the alpha of a shadow, worked out within its box alone."""
    x, y, width, height = cv2.boundingRect(alpha)
    found = np.zeros_like(alpha)
    if not width:
        return found
    corners = np.array([[[x, y], [x + width, y], [x, y + height], [x + width, y + height]]], np.float64)
    seen = cv2.perspectiveTransform(corners, canvas_from_art)[0]
    margin, size = 3 * SIGMA_PX + 2, np.array(alpha.shape[::-1])
    low = np.clip(np.floor(seen.min(axis=0) - margin), 0, size).astype(int)
    high = np.clip(np.ceil(seen.max(axis=0) + margin), 0, size).astype(int)
    if (high <= low).any():
        return found
    shift = np.array([[1, 0, -low[0]], [0, 1, -low[1]], [0, 0, 1]], np.float64)
    warped = cv2.warpPerspective(alpha, shift @ canvas_from_art, tuple(map(int, high - low)))
    steep = np.clip((np.arange(256) / 255 - 0.5) * GAIN + 0.5, 0, 1) * 255 * OPACITY
    found[low[1] : high[1], low[0] : high[0]] = cv2.LUT(
        cv2.GaussianBlur(warped, (0, 0), SIGMA_PX), np.rint(steep).astype(np.uint8)
    )
    return found


def main() -> None:
    """Make all frames."""
    drawings, frames = Path(sys.argv[1]), Path(sys.argv[2])
    middles = np.array([[1, 0, 0.5], [0, 1, 0.5], [0, 0, 1]])
    moved = np.linalg.inv(middles) @ np.reshape(list(map(float, sys.argv[3:12])), (3, 3)) @ middles
    cv2.setNumThreads(1)

    def one(path: Path) -> None:
        picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        alpha = shadow(np.ascontiguousarray(picture[..., 3]), moved)
        planes = [np.full(alpha.shape, part, np.uint8) for part in COLOR_BGR]
        cv2.imwrite(str(frames / path.name), cv2.merge([*planes, alpha]), [cv2.IMWRITE_PNG_COMPRESSION, 1])

    with ThreadPoolExecutor() as pool:
        list(pool.map(one, sorted(drawings.glob("*.png"))))


if __name__ == "__main__":
    main()
