"""What a place of the graph means for the curve there: handles, speeds and new keys."""

from kagezou.animation.curve import EaseHandle, ease_toward
from kagezou.animation.ease import Ease
from kagezou.animation.track import components_of, rebuilt
from kagezou.document.address import track_of, value_of
from kagezou.document.ease_edits import set_handle
from kagezou.document.edits import set_key
from kagezou.document.model import Document
from kagezou.tools.curves.picture import CurvePicture, HandleMark, KeyMark


def with_handle(
    document: Document, picture: CurvePicture, mark: HandleMark, place: tuple[float, float], *, joined: bool
) -> Document:
    """Pull a handle to a place; ``joined`` pulls the one on the other side of the key along."""
    track = track_of(document, picture.curve.address)
    index = next(i for i, key in enumerate(track.keys) if key.frame == mark.key.frame)
    # A handle that is pulled over its own key stands upright there.
    beside = min(place[0], mark.key.frame - 1e-6) if mark.is_before else max(place[0], mark.key.frame + 1e-6)
    wanted = EaseHandle(beside, picture.fitting.from_graph(place[1]))
    ease = ease_toward(track, index, picture.curve.component, wanted)
    return set_handle(document, mark.key.ref, picture.curve.component, ease, before=mark.is_before, joined=joined)


def with_speed(document: Document, picture: CurvePicture, mark: KeyMark, ordinate: float) -> Document:
    """Let a curve go through a key at the speed of an ordinate."""
    key = track_of(document, picture.curve.address).key_at(int(mark.frame))
    component = picture.curve.component
    eases = key.ease_out if key is not None else ()
    influence = eases[component].influence if component < len(eases) else Ease().influence
    ease = Ease(picture.fitting.from_graph(ordinate), influence)
    return set_handle(document, mark.ref, component, ease, before=False, joined=True)


def with_key(document: Document, picture: CurvePicture, frame: int, level: float | None) -> Document:
    """Set a key on a frame, with the value of an ordinate where there is one, else with what is there."""
    address, component = picture.curve.address, picture.curve.component
    value = value_of(document, address, frame)
    parts = list(components_of(value) or ())
    if level is not None and component < len(parts):
        parts[component] = min(max(picture.fitting.from_graph(level), address.property.low), address.property.high)
    return set_key(document, address, frame, rebuilt(value, tuple(parts)))
