"""How large a character's shadow is and where, frame by frame, as CSV: python measure_shadow.py CUT.kage NAME [OUT]."""

import sys
from pathlib import Path

import numpy as np

import kagezou

cut = kagezou.open(sys.argv[1])
name = sys.argv[2]
sys.stdout.write("frame,area_px,middle_x,middle_y,darkest\n")
for frame, shadow in cut.pictures(f"{name}_shadow", numbers="float32"):
    alpha = shadow[..., 3]  # (H, W), 0 to 1; colours are straight, so that they need no division
    area = float(alpha.sum())
    rows, columns = np.indices(alpha.shape)
    x, y = ((float((alpha * each).sum()) / area if area else 0.0) for each in (columns, rows))
    sys.stdout.write(f"{frame},{area:.1f},{x:.2f},{y:.2f},{alpha.max():.3f}\n")
    if len(sys.argv) > 3:  # the shadow multiplied on grey paper, as (H, W, 3) bytes
        multiplied = 0.8 * (1.0 - alpha[..., None] * (1.0 - shadow[..., :3]))
        np.save(Path(sys.argv[3]) / f"{name}_{frame:04d}.npy", np.round(multiplied * 255).astype(np.uint8))
