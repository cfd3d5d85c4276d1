"""What is said about drawings that were brought onto the canvas but may not lie there as was meant."""

from kagezou.geometry.box import Box
from kagezou.importing.figures import Figure
from kagezou.importing.new_cels import NewCels
from kagezou.message import Message


def notes_on(name: str, character: NewCels, figure: Figure | None, canvas_box: Box) -> list[Message]:
    """Return what may look wrong with a character's drawings on a canvas, or with the figure found in them."""
    width, height = character.size_px
    notes = []
    if width > canvas_box.width or height > canvas_box.height:
        canvas = f"{canvas_box.width} × {canvas_box.height}"
        notes.append(
            Message(
                "{name}: its drawings of {width} × {height} px reach over the canvas of {canvas} px",
                name=name,
                width=width,
                height=height,
                canvas=canvas,
            )
        )
    if figure is None:
        notes.append(
            Message(
                "{name}: there is nothing solid in its drawings; the whole canvas was taken as the figure", name=name
            )
        )
    elif figure.is_cut_off:
        notes.append(
            Message(
                "{name}: the figure reaches the lower edge of its drawing, where the ground was put; "
                "if its feet are cut off, move the ground to where they would stand",
                name=name,
            )
        )
    return notes
