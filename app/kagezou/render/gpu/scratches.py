"""Targets for what is drawn aside and then put where it belongs."""

from kagezou.render.gpu.targets import Target


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
