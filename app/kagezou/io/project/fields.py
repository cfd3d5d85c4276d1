"""The keys of the project file: the one table that the reader obeys and the description of the format is made from."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from kagezou.document.layer_marks import LABELS
from kagezou.document.review import MAX_ANSWERS, MAX_TEXT_CHARACTERS
from kagezou.document.set_pieces import MAX_PIECES
from kagezou.document.slate import MAX_FIRST_FRAME, MAX_WORD_CHARACTERS


@dataclass(frozen=True, slots=True)
class Field:
    """One key of an object in the file.

    Parameters
    ----------
    kind, meaning
        What the description of the format says.
    optional
        Whether the key may be missing.
    """

    kind: str
    meaning: str
    optional: bool = False


Fields = Mapping[str, Field]

MAX_LAYERS: Final = 1000
MAX_ROWS: Final = 1_000_000
"""The most drawings, exposures and keys of a project together."""

MAX_NAME_CHARACTERS: Final = 200
MAX_SHEET_CHARACTERS: Final = 1 << 20

PROJECT: Final[Fields] = MappingProxyType({
    "format": Field('"kagezou-project"', "Tells the file from other JSON."),
    "version": Field("whole number", "The format version; a program refuses a newer one than it knows."),
    "app_version": Field("text", "The program that wrote the file; only ever shown."),
    "canvas": Field("object", "Size and time of the cut."),
    "background": Field("path, [path, part], object or null",
                        "The picture under everything, or pictures and when each is seen."),
    "tracks": Field("object", "Property name → track, for the properties of the scene."),
    "layers": Field(f"list of at most {MAX_LAYERS} objects", "The character layers from bottom to top."),
    "work_area": Field("[first, last]", "The frames that are played and worked on, both included.", optional=True),
    "markers": Field("list of [frame, comment, duration]", "Named places in time; frames go up.", optional=True),
    "notes": Field("list of objects", "What is said about properties.", optional=True),
    "set": Field(f"list of at most {MAX_PIECES} objects", "The set pieces; missing where there are none.",
                 optional=True),
    "vanishing": Field("list of four [[x, y], [x, y]]",
                       "Edges of the floor in the background picture by which the camera was matched, canvas px: two "
                       "that run one way, and two square to them.", optional=True),
    "vanishing_fov": Field("number", "The field of view in degrees that is kept while these edges tell none.",
                           optional=True),
    "linked": Field("list of names", "The layer properties that are the same for all layers; missing where there are "
                    "none. Every layer has them in its own tracks too.", optional=True),
    "brought_light": Field("object", "The light that a style brought; missing where none did.", optional=True),
    "timesheet": Field(f"text of at most {MAX_SHEET_CHARACTERS} characters",
                       "The timesheet that timed the cut, as JSON text: keeps dialogue, camera work and marks for the "
                       "sheet that is written.", optional=True),
    "slate": Field("object", "What the cut is called; missing where nothing is said.", optional=True),
})  # fmt: skip

SLATE: Final[Fields] = MappingProxyType({
    "name": Field(f"text of at most {MAX_WORD_CHARACTERS} characters", "Of the production or the episode.",
                  optional=True),
    "scene": Field(f"text of at most {MAX_WORD_CHARACTERS} characters", "The scene's number.", optional=True),
    "cut": Field(f"text of at most {MAX_WORD_CHARACTERS} characters", "The cut's number.", optional=True),
})  # fmt: skip

BROUGHT_LIGHT: Final[Fields] = MappingProxyType({
    "tracks": Field("object", "What the style set: property name → track, for properties of the scene."),
    "before": Field("object", "What was there, for as many of these as had been set."),
})  # fmt: skip

BACKGROUND: Final[Fields] = MappingProxyType({
    "drawings": Field("list of [name, path] and [name, path, part]", "The pictures."),
    "exposures": Field("list of [frame, index]", "As a layer's."),
})  # fmt: skip

CANVAS: Final[Fields] = MappingProxyType({
    "width_px": Field("whole number, 1 to 16384", "Width."),
    "height_px": Field("whole number, 1 to 16384", "Height."),
    "frame_rate": Field('text such as "24" or "24000/1001"', "Frames a second, exact; at most 1000."),
    "length_frames": Field("whole number, 1 to 1000000", "The last frame of the cut; the first one is 1."),
    "first_frame": Field(f"whole number, 0 to {MAX_FIRST_FRAME}",
                         "The number that people read for the first frame, 1 where it is missing; all frames in this "
                         "file count from 1.", optional=True),
})  # fmt: skip

LAYER: Final[Fields] = MappingProxyType({
    "id": Field("text", "Unique and unchanging; never shown."),
    "name": Field("text", "Unique; part of property paths and of the names of rendered files."),
    "figure": Field("[left, top, right, bottom]", "Whole canvas px, half-open: the opaque part of the first drawing."),
    "drawings": Field("list of [name, path] and [name, path, part]",
                      "The cels; each lies centred on the canvas, pixel for pixel, unless its layer moves it."),
    "exposures": Field("list of [frame, index]",
                       "From this frame on that drawing is seen, counted from 0, or none for null; frames go up."),
    "tracks": Field("object", "Property name → track, for the properties of the layer."),
    "joins": Field("text", "The id of the layer of whose figure this one is a part.", optional=True),
    "paper": Field("white or border",
                   "Which white is clear where drawings have no alpha: all that is pure white, which is usual, or what "
                   "is connected with the border of its picture.", optional=True),
    "locked": Field("true", "Whether it is not to be changed by hand; missing where it may be.", optional=True),
    "solo": Field("true", "Whether the window shows it alone; missing where it does not.", optional=True),
    "label": Field(f"one of {', '.join(LABELS)}", "The colour of its label; missing where it has none.", optional=True),
    "sizes": Field("list of [index, width, height]",
                   "Pictures whose size is known, px: from this drawing on all have it, until the next row.",
                   optional=True),
    "feet": Field("list of [index, box, [[track, x, y], …]]",
                  "Drawings in which feet were looked for: the opaque part, [left, top, right, bottom] in whole px of "
                  "the picture, or null; and the feet that were found: which one, and its lowest point in px of the "
                  "picture.", optional=True),
    "pins": Field("list of [index, track, verdict, place, row]",
                  'What a person said about a foot of a drawing: "planted", "lifted", "none" or null; [x, y] in px of '
                  "the picture or null; and the row of the ground below it, px of the picture, or null.",
                  optional=True),
})  # fmt: skip

PIECE: Final[Fields] = MappingProxyType({
    "id": Field("text", "Unique and unchanging; never shown."),
    "name": Field("text", "Unique in the set; part of property paths."),
    "tracks": Field("object", "Property name → track, for the properties of the piece."),
    "source": Field("path", "The file of an imported set.", optional=True),
})  # fmt: skip

TRACK: Final[Fields] = MappingProxyType({
    "constant": Field("value", "The value from before there were keys; kept, not seen.", optional=True),
    "keys": Field("list of objects", "At least one; frames go up."),
})  # fmt: skip

KEY: Final[Fields] = MappingProxyType({
    "frame": Field("whole number, 1 to 1000000", "Where the value is reached."),
    "value": Field("value", "As the property wants it."),
    "interpolation": Field('"hold", "linear" or "bezier"', "How it goes on toward the next key; "
                           "switches and choices only hold."),
    "ease_in": Field("list of [speed, influence]",
                     "One a component, for a bezier before the key: units per frame, and a part of the time "
                     "between the keys, 0 to 1.", optional=True),
    "ease_out": Field("list of [speed, influence]", "The same for a bezier after the key.", optional=True),
})  # fmt: skip

NOTE: Final[Fields] = MappingProxyType({
    "frame": Field("whole number, 1 to 1000000", "What frame it is about."),
    "layer": Field("text or null", "The id of the layer whose property it is about, null for one of the scene."),
    "property": Field("text", "The property's name."),
    "text": Field(f"text of at most {MAX_TEXT_CHARACTERS} characters", "What is said."),
    "author": Field("text", "Who says it, may be empty."),
    "answers": Field("list of [author, text]", f"What was said to it, at most {MAX_ANSWERS}, the latest last.",
                     optional=True),
    "done": Field("true or false", "Whether it is ticked off.", optional=True),
})  # fmt: skip
