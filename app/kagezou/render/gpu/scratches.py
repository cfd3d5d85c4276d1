"""Targets for what is drawn aside and then put where it belongs."""

from typing import Final

from kagezou.render.gpu.targets import Format, Target

_STEP_PX: Final = 128
"""A target grows by at least so much: what is drawn into it often grows a little from frame to frame."""


class Scratches:
    """Targets by name, empty at first; whoever adds to one, rather than drawing over its own part, empties it again."""

    def __init__(self) -> None:
        self._kept: dict[str, Target] = {}

    def like(self, name: str, target: Target) -> Target:
        """Return the one of a name, as large as another target and of its format."""
        kept = self._kept.get(name)
        if kept is not None and (kept.box != target.box or kept.texture.form is not target.texture.form):
            kept.close()
            kept = None
        if kept is None:
            kept = self._kept[name] = Target(target.box.width, target.box.height, target.texture.form)
            kept.clear()
        return kept

    def close(self) -> None:
        """Give the memory back."""
        for target in self._kept.values():
            target.close()
        self._kept.clear()


class GrowingTarget:
    """A target that is as large as the largest asked for so far; what it holds is lost when it grows.

    Parameters
    ----------
    form
        Its format.
    """

    def __init__(self, form: Format) -> None:
        self._form = form
        self._target: Target | None = None

    @property
    def target(self) -> Target:
        """What was given last."""
        assert self._target is not None
        return self._target

    def holds(self, width_px: int, height_px: int) -> bool:
        """Return whether it need not grow for a size."""
        old = self._target
        return old is not None and old.box.width >= width_px and old.box.height >= height_px

    def at_least(self, width_px: int, height_px: int) -> Target:
        """Return it, with room for a size; what lies in it is what was left there, or unknown."""
        if not self.holds(width_px, height_px):
            width, height = (-(-max(side, 1) // _STEP_PX) * _STEP_PX for side in (width_px, height_px))
            if self._target is not None:
                width, height = max(width, self._target.box.width), max(height, self._target.box.height)
            self.close()
            self._target = Target(width, height, self._form)
        return self.target

    def close(self) -> None:
        """Give the memory back."""
        if self._target is not None:
            self._target.close()
            self._target = None
