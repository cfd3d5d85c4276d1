"""What a drag says beside the pointer, and what a frame says about the figure looked at."""

from kagezou.document.address import value_of
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty, Kind
from kagezou.message import Message
from kagezou.scene.lift import lift_at
from kagezou.tools.handle import Handle


def readout(handle: Handle, before: Document, after: Document, frame: int) -> tuple[Message, ...]:
    """Return the values a handle edits and how far they have come, such as ``X 412 (+18)`` and ``Y 203 (-4)``.

    Parameters
    ----------
    handle
        The handle in the hand.
    before, after
        The document at the press and now.
    frame
        The frame looked at.
    """
    parts: list[Message] = []
    for address in handle.addresses:
        prop = address.property
        names = _names(prop)
        old = _numbers(value_of(before, address, frame), handle.index)
        new = _numbers(value_of(after, address, frame), handle.index)
        parts.extend(
            Message(
                "{name} {value}{unit} ({change}{unit})",
                name=name,
                value=_short(b),
                change=_signed(b - a),
                unit=_degree(prop),
            )
            for name, a, b in zip(names, old, new, strict=False)
        )
    return tuple(parts)


def values(handle: Handle, document: Document, frame: int) -> tuple[Message, ...]:
    """Return the values a handle edits, such as ``X 412`` and ``Y 203``."""
    return tuple(
        Message("{name} {value}{unit}", name=name, value=_short(number), unit=_degree(address.property))
        for address in handle.addresses
        for name, number in zip(
            _names(address.property), _numbers(value_of(document, address, frame), handle.index), strict=False
        )
    )


def height_words(document: Document, layer_id: str, frame: int) -> Message | None:
    """Return how high over the ground the figure of a layer is at a frame, such as ``Height 52 px``.

    None on the ground, and where the figure does not stand on feet.
    """
    layer = document.layer(layer_id)
    figure = layer if layer.joins is None else document.layer(layer.joins)
    lift = lift_at(document, figure, frame)
    height = 0 if lift is None else round(lift.height_px)
    return Message("Height {value} px", value=height) if height > 0 else None


def _names(prop: AnyProperty) -> tuple[Message | str, ...]:
    if prop.kind is Kind.NUMBER:
        return (prop.label,)
    return ("X", "Y", "Z")


def _numbers(value: object, index: int | None) -> tuple[float, ...]:
    """Return the numbers of a value, or of one point of a list; none where the point is gone."""
    if isinstance(value, tuple) and index is not None:
        return _numbers(value[index], None) if index < len(value) else ()
    if isinstance(value, tuple):
        return tuple(part for part in value if isinstance(part, float))
    return (value,) if isinstance(value, float) else ()


def _degree(prop: AnyProperty) -> str:
    return "°" if prop.unit == "°" else ""


def _short(number: float) -> str:
    """Return a number to a tenth, without a needless ``.0`` or ``-0``."""
    rounded = round(number, 1) + 0.0
    return f"{rounded:.0f}" if rounded == round(rounded) else f"{rounded:.1f}"


def _signed(number: float) -> str:
    text = _short(number)
    return text if text.startswith("-") else f"+{text}"
