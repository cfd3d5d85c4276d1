"""The composition that After Effects is to build: plain values in its own units, nothing of After Effects itself."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ChannelKey:
    """A key of one number.

    Parameters
    ----------
    time
        Seconds from the start of the composition.
    value
        In the units of the property: per cent, px, degrees.
    into, out
        "HOLD", "LINEAR" or "BEZIER", before and after the key.
    ease_in, ease_out
        (speed in units a second, influence in per cent) of bezier sides.
    """

    time: float
    value: float
    into: str
    out: str
    ease_in: tuple[float, float] = (0.0, 100 / 3)
    ease_out: tuple[float, float] = (0.0, 100 / 3)


@dataclass(frozen=True, slots=True)
class Channel:
    """One number over time: ``value`` where there are no keys."""

    value: float
    keys: tuple[ChannelKey, ...] = ()


@dataclass(frozen=True, slots=True)
class PairKey:
    """A key of two numbers that are one property, as `ChannelKey`, with an ease for each of them."""

    time: float
    value: tuple[float, float]
    into: str
    out: str
    ease_in: tuple[tuple[float, float], ...] = ()
    ease_out: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Pair:
    """Two numbers over time: ``value`` where there are no keys."""

    value: tuple[float, float]
    keys: tuple[PairKey, ...] = ()


@dataclass(frozen=True, slots=True)
class Transform:
    """How a layer lies in the composition.

    Parameters
    ----------
    anchor
        In px of the footage; it has no eases, which After Effects has none a dimension of.
    x, y
        The position, px of the composition, in dimensions of their own.
    scale
        In per cent.
    rotation
        In degrees, clockwise.
    """

    anchor: Pair
    x: Channel
    y: Channel
    scale: Pair
    rotation: Channel


@dataclass(frozen=True, slots=True)
class Rising:
    """How a shadow moves while the control of the height is at so many px.

    Parameters
    ----------
    contact
        Where the figure touches the ground, px of the composition, about which the shadow shrinks.
    raised
        Where the shadow of that place falls when it is held ``step_px`` higher.
    step_px
        A part of the figure's height.
    tall_px
        The height of the figure.
    shrink
        Which part of its size the shadow loses at that height.
    """

    contact: Pair
    raised: Pair
    step_px: float
    tall_px: float
    shrink: float


@dataclass(frozen=True, slots=True)
class Driven:
    """What of a layer the controls drive.

    Parameters
    ----------
    has_look
        Whether opacity, colour and softness do.
    rising
        How the height moves it, None where it does not.
    gone_px
        The height at which nothing is left of it, 0 where there is none.
    """

    has_look: bool = True
    rising: Rising | None = None
    gone_px: float = 0.0


@dataclass(frozen=True, slots=True)
class Footage:
    """Pictures on disk.

    Parameters
    ----------
    tag
        By which a second run finds the item again, whatever it is called by then.
    name
        What the item is called.
    path
        The first file, from the script's folder, with forward slashes; absolute where there is no way from there.
    count
        How many numbered files follow one another; 1 for a still.
    alpha
        "STRAIGHT" or "PREMULTIPLIED", where there is alpha.
    folder
        The folder of the project panel it goes into.
    absolute
        Where footage that was left in its place lay; empty for what is in the script's folder.
    label
        The number of its label's colour; 0 for After Effects' own choice.
    """

    tag: str
    name: str
    path: str
    count: int
    alpha: str
    folder: str
    absolute: str = ""
    label: int = 0


@dataclass(frozen=True, slots=True)
class CompMarker:
    """A marker: seconds, words."""

    time: float
    comment: str
    duration: float = 0.0


@dataclass(frozen=True, slots=True)
class CompLayer:
    """A layer of footage, or of a composition.

    Parameters
    ----------
    footage
        The tag of its footage; ``comp:`` and the tag of a composition that comes before its own.
    blend
        "NORMAL", "MULTIPLY" or "LIGHTEN".
    opacity
        In per cent.
    remap
        (seconds, picture from 0) of held pictures; empty where every frame has a picture of its own. None for an empty
        cel.
    inverted
        Whether its colours are turned over, black for white.
    alpha_shown
        Whether it is an opaque picture of its alpha, white on black.
    colors
        (seconds, red, green and blue from 0 to 1) from when on it has a colour, and its brightness as its alpha; empty
        where it is what its footage is.
    transform
        How it lies; None where it lies centred on whole pixels.
    label
        As of `Footage`.
    driven
        What the controls drive of it, None for nothing.
    """

    tag: str
    name: str
    footage: str
    blend: str
    opacity: Channel
    remap: tuple[tuple[float, int | None], ...] = ()
    markers: tuple[CompMarker, ...] = ()
    inverted: bool = False
    alpha_shown: bool = False
    colors: tuple[tuple[float, tuple[float, ...]], ...] = ()
    transform: Transform | None = None
    label: int = 0
    driven: Driven | None = None


@dataclass(frozen=True, slots=True)
class Null:
    """A guide: a place on the canvas over time, a turn, and sliders."""

    tag: str
    name: str
    x: Channel
    y: Channel
    rotation: Channel
    sliders: tuple[tuple[str, Channel], ...] = ()


@dataclass(frozen=True, slots=True)
class Comp:
    """A composition; layers and nulls from the bottom up.

    Parameters
    ----------
    white
        Whether a white solid lies under everything.
    """

    tag: str
    name: str
    layers: tuple[CompLayer, ...]
    nulls: tuple[Null, ...] = ()
    markers: tuple[CompMarker, ...] = ()
    white: bool = False


@dataclass(frozen=True, slots=True)
class HandOff:
    """Everything the script needs.

    Parameters
    ----------
    project
        Tells the hand-offs of several cuts in one project apart.
    frame_rate, frames
        As a number; ``frames`` is the length.
    first_frame
        What the first frame is called.
    work_area
        Start and length in seconds.
    controls
        Whether a null has sliders that drive all shadows.
    """

    project: str
    name: str
    width: int
    height: int
    frame_rate: float
    frames: int
    duration: float
    first_frame: int
    work_area: tuple[float, float]
    footage: tuple[Footage, ...]
    comps: tuple[Comp, ...]
    controls: bool = False
