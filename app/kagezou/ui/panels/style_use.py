"""Styles on the layers of the window: one step of history, and what a person should know of it."""

from PySide6.QtCore import QCoreApplication

from kagezou.document.address import Address
from kagezou.document.frame_numbers import at_shown_number
from kagezou.document.style import Style
from kagezou.document.styling import Styled, notes_on, put_style
from kagezou.message import Message
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import named, translated

translate = QCoreApplication.translate


def put_on(bridge: Bridge, layer_ids: tuple[str, ...], style: Style, step: str, *, with_light: bool) -> str:
    """Put a style on layers as one step of a name, at the frame looked at; returns what there is to know of it."""
    styled = put_style(bridge.document, layer_ids, style, bridge.frame, with_light=with_light)
    bridge.session.edit(step, styled.document)
    return words_on(styled)


def words_on(styled: Styled) -> str:
    """Return how much a style changed, and on lines of their own what there is to know besides."""
    name = named(styled.style.name)
    asking = translate("StyleUse", "“With its light” in the Styles panel")
    notes = notes_on(styled, name, asking, _label)
    canvas = styled.document.canvas
    said = (_count(name, len(styled.changes)), *(at_shown_number(note, canvas) for note in notes))
    return "\n".join(map(translated, said))


def _count(name: str, count: int) -> Message:
    if count == 0:
        return Message("{style}: nothing looks otherwise than before", style=name)
    if count == 1:
        return Message("{style}: 1 property changed", style=name)
    return Message("{style}: {count} properties changed", style=name, count=count)


def _label(address: Address) -> str:
    return translated(address.property.label)
