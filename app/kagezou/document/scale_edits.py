"""Scaling keys in time and value about a fixed place, as a frame around them is pulled."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Key, components_of, rebuilt
from kagezou.document.address import Address
from kagezou.document.key_edits import Refs, replaced_keys
from kagezou.document.model import Document
from kagezou.document.property import Kind


@dataclass(frozen=True, slots=True)
class Scaling:
    """What lies at ``about`` stays, everything else goes ``factor`` times as far from it."""

    about: float = 0.0
    factor: float = 1.0

    def of(self, number: float) -> float:
        """Return where a number goes."""
        return self.about + (number - self.about) * self.factor


UNSCALED: Final = Scaling()
ByComponent = Mapping[tuple[Address, int], Scaling]
"""How the numbers of properties are scaled, in their own units; those that are missing stay."""

NO_SCALING: Final[ByComponent] = MappingProxyType({})


def scale_keys(
    document: Document, refs: Refs, time: Scaling = UNSCALED, values: ByComponent = NO_SCALING
) -> tuple[Document, Refs]:
    """Scale keys in time, in value or both; the speeds of their eases follow.

    Keys land on whole frames, in their old order and each on one of its own; a factor below 0 counts as 0 in time and
    turns values over. Other keys that lie where these come to lie are replaced by them.
    """
    frames = sorted({ref.frame for ref in refs})
    places = dict(zip(frames, landed(frames, time), strict=True))
    span = frames[-1] - frames[0] if frames else 0
    slower = (places[frames[-1]] - places[frames[0]]) / span if span else 1.0

    def scaled(address: Address, key: Key) -> Key:
        moved = _scaled_values(address, key, values, slower)
        return replace(moved, frame=places[key.frame])

    return replaced_keys(document, refs, scaled)


def landed(frames: Sequence[int], time: Scaling) -> list[int]:
    """Return the whole frames on which ordered frames land: in their order, no two on one, none before 1."""
    if not frames:
        return []
    factor = max(time.factor, 0.0)
    if frames[0] < time.about:
        factor = min(factor, max((time.about - 1) / (time.about - frames[0]), 0.0))
    wanted = [round(time.about + (frame - time.about) * factor) for frame in frames]
    first_right = next((index for index, frame in enumerate(frames) if frame >= time.about), len(frames))
    # From the fixed place outward, each at least one frame beyond the one before.
    for index in range(first_right + 1, len(frames)):
        wanted[index] = max(wanted[index], wanted[index - 1] + 1)
    for index in range(min(first_right, len(frames) - 1) - 1, -1, -1):
        wanted[index] = min(wanted[index], wanted[index + 1] - 1)
    away = max(1 - wanted[0], 0)
    return [frame + away for frame in wanted]


def _scaled_values(address: Address, key: Key, values: ByComponent, slower: float) -> Key:
    parts = components_of(key.value)
    if parts is None:
        return key
    scalings = [values.get((address, index), UNSCALED) for index in range(len(parts))]
    prop = address.property
    low, high = (0.0, 255.0) if prop.kind is Kind.COLOR else (prop.low, prop.high)
    numbers = tuple(
        part if scaling is UNSCALED else min(max(scaling.of(part), low), high)
        for part, scaling in zip(parts, scalings, strict=True)
    )
    speeds = [scaling.factor / slower for scaling in scalings]
    return replace(
        key,
        value=key.value if numbers == parts else rebuilt(key.value, numbers),
        ease_in=_quicker(key.ease_in, speeds),
        ease_out=_quicker(key.ease_out, speeds),
    )


def _quicker(eases: tuple[Ease, ...], factors: Sequence[float]) -> tuple[Ease, ...]:
    return tuple(
        ease if ease == EASY or factor == 1 else replace(ease, speed=ease.speed * factor)
        for ease, factor in zip(eases, factors, strict=False)
    )
