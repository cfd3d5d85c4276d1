"""The properties of waves and of the gaps in them: lines of the one table, see ``properties``."""

from dataclasses import dataclass

from kagezou.document.property import AnyProperty, Kind, Property, Scope
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class WaveLines:
    """The properties of one set of waves (spec 4).

    ``sideways``, ``depth``, ``sideways_shear`` and ``depth_shear`` are A00, A11, A10 and A01 of the paper's matrix,
    each a part of the amplitude.
    """

    amplitude: Property[float]
    wavelength: Property[float]
    direction: Property[float]
    velocity: Property[float]
    sideways: Property[float]
    depth: Property[float]
    sideways_shear: Property[float]
    depth_shear: Property[float]

    @property
    def all(self) -> tuple[AnyProperty, ...]:
        """All of them, in the order in which people read them."""
        motion = (self.amplitude, self.wavelength, self.direction, self.velocity)
        return (*motion, self.sideways, self.depth, self.sideways_shear, self.depth_shear)


def wave_lines(number: int, wavelength_px: float, direction_deg: float, velocity_px: float) -> WaveLines:
    """Return the properties of the set of waves of a number, and what they are where nothing was ever set."""
    path = f"shadow.wave{number}"
    return WaveLines(
        Property(
            f"{path}.amplitude", Kind.NUMBER, Scope.LAYER, 0.0,
            Message("Wave {number} amplitude", number=number),
            Message("How far the waves move the shadow; 0 is no wave."),
            unit="px", low=0.0, high=500.0, slides=(0.0, 60.0),
        ),
        Property(
            f"{path}.wavelength", Kind.NUMBER, Scope.LAYER, wavelength_px,
            Message("Wave {number} length", number=number),
            Message("From crest to crest on the ground."),
            unit="px", low=4.0, high=10000.0, slides=(10.0, 300.0),
        ),
        Property(
            f"{path}.direction", Kind.NUMBER, Scope.LAYER, direction_deg,
            Message("Wave {number} direction", number=number),
            Message("Where the crests go on the ground; 0 is to the right, 90 toward the viewer."),
            unit="°", low=-36000.0, high=36000.0,
        ),
        Property(
            f"{path}.velocity", Kind.NUMBER, Scope.LAYER, velocity_px,
            Message("Wave {number} speed", number=number),
            Message("How far the crests go in a frame."),
            unit="px", low=-1000.0, high=1000.0, slides=(-20.0, 20.0),
        ),
        *_elements(number),
    )  # fmt: skip


def _elements(number: int) -> tuple[Property[float], ...]:
    """Return ``sideways``, ``depth`` and the shears of a set of waves."""
    path = f"shadow.wave{number}"
    return (
        _element(
            f"{path}.sideways", 1.0,
            Message("Wave {number} sideways", number=number),
            Message("How much of the amplitude moves the shadow sideways: long streaks over 1, none at 0."),
        ),
        _element(
            f"{path}.depth", 1.0,
            Message("Wave {number} in depth", number=number),
            Message("How much of the amplitude moves the shadow toward the viewer and back; small is calm water."),
        ),
        _element(
            f"{path}.sideways_shear", 0.0,
            Message("Wave {number} sideways shear", number=number),
            Message("How much of the movement in depth is a movement sideways as well: streaks lean."),
        ),
        _element(
            f"{path}.depth_shear", 0.0,
            Message("Wave {number} depth shear", number=number),
            Message("How much of the movement sideways is a movement in depth as well: streaks rise to one side."),
        ),
    )  # fmt: skip


SLITS = Property(
    "shadow.slits", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Slits"),
    Message("How much of the length of a crest of wave 1 is open, in long gaps without shadow; 0 has none."),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
SLIT_SPACING = Property(
    "shadow.slit_spacing", Kind.NUMBER, Scope.LAYER, 0.0,
    Message("Slit spacing"),
    Message("From one row of gaps to the next on the ground; 0 is the length of wave 1."),
    unit="px", low=0.0, high=10000.0, slides=(0.0, 300.0),
)  # fmt: skip
SLIT_GROWTH = Property(
    "shadow.slit_growth", Kind.NUMBER, Scope.LAYER, 0.03,
    Message("Slit growth"),
    Message("How much wider the gaps get with every px of distance from the feet."),
    low=0.0, high=1.0, slides=(0.0, 0.2),
)  # fmt: skip


def _element(name: str, default: float, label: Message, text: Message) -> Property[float]:
    """Return the property of an element of the matrix."""
    return Property(name, Kind.NUMBER, Scope.LAYER, default, label, text, low=-100.0, high=100.0, slides=(-2.0, 2.0))
