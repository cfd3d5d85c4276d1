"""What a light looks at when a depth map is made: a frame around the card, as narrow as it can be."""

from dataclasses import dataclass

import numpy as np

from kagezou.errors import GraphicsProblem
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.message import Message
from kagezou.render.prepare.uniforms import Uniform


@dataclass(frozen=True, slots=True, eq=False)
class LightView:
    """The light's own axes and the window its map shows.

    Parameters
    ----------
    light
        Homogeneous, world px.
    axes
        (3, 3), rows: across, up, away from the light.
    centre, half
        The window in light space: for a lamp in parts of the distance, for the sun in px.
    near, far
        The distances kept, px.
    """

    light: Vector4
    axes: Matrix
    centre: Matrix
    half: Matrix
    near: float
    far: float

    @staticmethod
    def around(light: Vector4, points: Matrix) -> "LightView":
        """Return the view that holds world points (N, 3).

        Raises
        ------
        GraphicsProblem
            If the points lie around the lamp, not before it: one map cannot hold them.
        """
        position = np.array(light[:3])
        away = points.mean(axis=0) - position if light[3] else -position
        away = away / np.linalg.norm(away)
        helper = np.array([1.0, 0.0, 0.0]) if abs(away[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
        across = np.cross(helper, away)
        across /= np.linalg.norm(across)
        axes = np.array([across, np.cross(away, across), away])
        seen = (points - position * light[3]) @ axes.T
        if light[3] and seen[:, 2].min() <= 1e-6:
            raise GraphicsProblem(
                Message("the lamp stands within the card: its depth map cannot hold what lies around it")
            )
        flat = seen[:, :2] / seen[:, 2:] if light[3] else seen[:, :2]
        low, high = flat.min(axis=0), flat.max(axis=0)
        reach = float(np.ptp(seen[:, 2])) + 1.0
        return LightView(
            light=light,
            axes=axes,
            centre=(low + high) / 2,
            half=(high - low) / 2 * 1.001 + 1e-9,
            near=float(seen[:, 2].min()) - 0.01 * reach,
            far=float(seen[:, 2].max()) + 0.01 * reach,
        )

    def seen(self, points: Matrix) -> Matrix:
        """Return world points (N, 3) in light space (N, 3)."""
        return np.asarray((points - np.array(self.light[:3]) * self.light[3]) @ self.axes.T)

    def light_from_world(self) -> Matrix:
        """Return the (3, 4) map from homogeneous world points to light space."""
        return np.column_stack([self.axes, -self.axes @ np.array(self.light[:3]) * self.light[3]])

    def uniforms(self) -> dict[str, Uniform]:
        """Return what both depth shaders want."""
        return {
            "u_window": (*map(float, self.centre), *map(float, self.half)),
            "u_is_lamp": self.light[3] != 0,
            "u_range": (self.near, self.far),
        }
