"""How shadows, patches and reflections are laid from frame to frame, as layers of After Effects.

A layer there has one blend mode for the whole cut: what has both has two layers, each clear while the other is seen.
Footage is rendered at full opacity, see `at_full_opacity`; opacity is a property of its layer.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from kagezou.animation.track import Track
from kagezou.document.model import Document
from kagezou.export.after_effects import comp as ae
from kagezou.export.after_effects.channels import baked, channel_of
from kagezou.export.after_effects.mattes import at_full_opacity
from kagezou.scene.companions import contact_layer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import LayerScene, Scene, ShadowLook

_NEAR = 1e-9
_OVER = (":over", " normal")
"""What tag and name of a layer end in that is laid plainly over the one that multiplies."""

Way = tuple[float, bool]
"""An opacity, and whether what is under it is multiplied."""


@dataclass(frozen=True, slots=True)
class Laying:
    """A cut frame by frame: as it is, and at full opacity."""

    scenes: tuple[tuple[Scene, Scene], ...]
    rate: Fraction

    @classmethod
    def of(cls, document: Document) -> "Laying":
        """Look at every frame of a document."""
        full = at_full_opacity(document)
        frames = range(1, document.canvas.length_frames + 1)
        pairs = tuple((evaluate(document, frame), evaluate(full, frame)) for frame in frames)
        return cls(pairs, document.canvas.frame_rate)

    def layers(
        self, ways: tuple[Way | None, ...], track: Track, plain: ae.CompLayer, *, default: bool
    ) -> Iterator[ae.CompLayer]:
        """Yield a layer, or two where there are both blend modes, each with its opacity and blend mode.

        Parameters
        ----------
        ways
            That of each frame; None where nothing is seen whatever the opacity is.
        track
            The property that the opacity is of; the layer has its keys where they say the same as ``ways``.
        plain
            The layer without these.
        default
            Whether it multiplies where nothing is ever seen.
        """
        blends = {way[1] for way in ways if way is not None} or {default}
        is_tracks = all(
            way is None or abs(_number(track, frame) - way[0]) < _NEAR for frame, way in enumerate(ways, start=1)
        )
        if len(blends) == 1:
            opacity = (
                channel_of(track, 0, self.rate, 100.0) if is_tracks else self._baked(ways, multiply=next(iter(blends)))
            )
            yield replace(plain, blend=_mode(multiply=next(iter(blends))), opacity=opacity)
            return
        for multiply, (tag, name) in ((True, ("", "")), (False, _OVER)):
            own = replace(plain, tag=plain.tag + tag, name=plain.name + name, markers=plain.markers if multiply else ())
            yield replace(own, blend=_mode(multiply=multiply), opacity=self._baked(ways, multiply=multiply))

    def of_shadow(self, layer_id: str) -> tuple[Way | None, ...]:
        """Return how the shadow of a layer is laid on every frame."""
        return self._ways(partial(_shadow_look, layer_id=layer_id))

    def of_contact(self, layer_id: str) -> tuple[Way | None, ...]:
        """Return how the patches under a figure's feet are laid."""
        return self._ways(partial(_contact_look, layer_id=layer_id))

    def of_reflection(self, layer_id: str) -> tuple[Way | None, ...]:
        """Return how a figure's reflection is laid."""
        return self._ways(partial(_reflection_look, layer_id=layer_id))

    def of_set(self) -> tuple[Way | None, ...]:
        """Return how the shadow of the set is laid."""
        return self._ways(lambda scene: None if scene.set_shadow is None else scene.set_shadow.look)

    def _ways(self, look_of: Callable[[Scene], ShadowLook | None]) -> tuple[Way | None, ...]:
        return tuple(_way(look_of(scene), look_of(full)) for scene, full in self.scenes)

    def _baked(self, ways: tuple[Way | None, ...], *, multiply: bool) -> ae.Channel:
        """Return the opacity, in per cent, on frames that are laid in one way; none on others."""
        values: list[float] = []
        for way in ways:
            before = values[-1] if values else 0.0
            values.append(before if way is None else 100 * way[0] if way[1] == multiply else 0.0)
        return baked(lambda frame: values[frame - 1], len(values), self.rate)


def either(first: tuple[Way | None, ...], second: tuple[Way | None, ...]) -> tuple[Way | None, ...]:
    """Return the ways of one thing, and where it is not there of another."""
    return tuple(a or b for a, b in zip(first, second, strict=True))


def _way(look: ShadowLook | None, full: ShadowLook | None) -> Way | None:
    """Return how footage at full opacity is laid to be what it is; None where that has nothing to show."""
    if full is None or full.opacity <= 0:
        return None
    return (0.0, full.multiply) if look is None else (look.opacity / full.opacity, look.multiply)


def _mode(*, multiply: bool) -> str:
    return "MULTIPLY" if multiply else "NORMAL"


def _number(track: Track, frame: int) -> float:
    value = track.value_at(frame)
    assert isinstance(value, float | int)
    return float(value)


def _seen(scene: Scene, layer_id: str) -> LayerScene | None:
    return next((each for each in scene.layers if each.id == layer_id), None)


def _shadow_look(scene: Scene, layer_id: str) -> ShadowLook | None:
    layer = _seen(scene, layer_id)
    return None if layer is None or layer.cast is None else layer.look


def _contact_look(scene: Scene, layer_id: str) -> ShadowLook | None:
    layer = _seen(scene, layer_id)
    patches = None if layer is None else contact_layer(layer)
    return None if patches is None else patches.look


def _reflection_look(scene: Scene, layer_id: str) -> ShadowLook | None:
    layer = _seen(scene, layer_id)
    mirrored = None if layer is None else layer.reflection
    return None if mirrored is None else ShadowLook(mirrored.color, mirrored.opacity, multiply=False)
