"""After Effects' compositing, as much of it as hand-offs use: straight, rounded after every step."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.io.images.reading import probe, read_cel
from tests.export.after_effects.extendscript import Run, pair_at, place_at, property_of, value_at
from tests.export.after_effects.sampling import resampled, with_control

Pixels = NDArray[np.uint8] | NDArray[np.uint16]

# What Shift Channels may take a channel from, by number; hue, lightness and saturation are not asked for.
SOURCES = {1: 3, 2: 0, 3: 1, 4: 2}
FULL_ON = 9
# What is full in projects of 8 and of 16 bit a channel.
EIGHT, SIXTEEN = 255, 32768


def composed(run: Run, comp: str, frame: int, full: int = EIGHT) -> Pixels:
    """Return what a composition shows on a frame, counted from 1: (H, W, 4), straight, clear where nothing lies."""
    return _composed(run, run.item(comp, "CompItem"), frame, full)


def _composed(run: Run, item: dict[str, Any], frame: int, full: int) -> Pixels:
    shown = _stored(np.zeros((item["height"], item["width"], 4)), full)
    time = (frame - 1) / item["frameRate"]
    for layer in reversed(item["layers"]):
        if layer["enabled"] and layer["inPoint"] - 1e-6 <= time < layer["outPoint"] - 1e-6:
            shown = _laid(run, layer, shown, frame, item["frameRate"], full)
    return shown


def _stored(unit: NDArray[np.float64], full: int) -> Pixels:
    steps = np.rint(unit * full)
    return steps.astype(np.uint8) if full == EIGHT else steps.astype(np.uint16)


def _laid(run: Run, layer: dict[str, Any], under: Pixels, frame: int, rate: float, full: int) -> Pixels:
    time = (frame - 1) / rate
    pixels = _source(run, layer, frame, rate, full)
    for effect in layer["groups"]["ADBE Effect Parade"]["children"].values():
        pixels = _with_effect(effect, pixels, time, full)
    pixels = _moved(layer, pixels, under.shape[:2], time, full)
    opacity = value_at(property_of(layer, "ADBE Transform Group", "ADBE Opacity"), time) / 100
    over, below = pixels / full, under / full
    alpha, covered = over[..., 3:] * opacity, below[..., 3:]
    blended = {
        "NORMAL": over[..., :3],
        "MULTIPLY": over[..., :3] * below[..., :3],
        "LIGHTEN": np.maximum(over[..., :3], below[..., :3]),
    }[layer["blend"]]
    whole = alpha + covered * (1 - alpha)
    light = alpha * (1 - covered) * over[..., :3] + alpha * covered * blended + (1 - alpha) * covered * below[..., :3]
    color = light / np.where(whole > 0, whole, 1)
    return _stored(np.concatenate([color, whole], -1), full)


def _moved(layer: dict[str, Any], pixels: Pixels, shape: tuple[int, ...], time: float, full: int) -> Pixels:
    """Return a layer's pixels where they lie in its composition."""
    transform = ("ADBE Transform Group",)
    anchor = pair_at(property_of(layer, *transform, "ADBE Anchor Point"), time)
    scale = np.array(pair_at(property_of(layer, *transform, "ADBE Scale"), time)) / 100
    turn = np.deg2rad(value_at(property_of(layer, *transform, "ADBE Rotate Z"), time))
    linear = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) * scale
    return _stored(resampled(pixels / full, shape, linear, anchor, place_at(layer, time)), full)


def _source(run: Run, layer: dict[str, Any], frame: int, rate: float, full: int) -> Pixels:
    (found,) = [each for each in run.tree["items"] if each["id"] == layer["source_id"]]
    picture = frame - 1
    if layer["remap"]:
        picture = int(value_at(property_of(layer, "ADBE Time Remapping"), (frame - 1) / rate) * rate)
    if found["kind"] == "CompItem":
        return _composed(run, found, picture + 1, full)
    if found["kind"] == "SolidItem":
        return _stored(np.ones((found["height"], found["width"], 4)), full)
    first = Path(found["file"])
    path = first
    if found["frames"] > 1:
        stem, _, number = first.stem.rpartition("_")
        path = first.with_name(f"{stem}_{int(number) + picture:0{len(number)}d}{first.suffix}")
    # A background whose alpha is 0 everywhere would be seen; footage has the alpha that it has.
    rgba = read_cel(path, white_is_clear=probe(path).has_alpha).rgba
    assert full == SIXTEEN or rgba.dtype == np.uint8
    return _stored(rgba / np.iinfo(rgba.dtype).max, full)


def _with_effect(effect: dict[str, Any], pixels: Pixels, time: float, full: int) -> Pixels:
    parts = effect["children"]
    if effect["matchName"] == "ADBE Shift Channels":
        sources = [parts[f"ADBE Shift Channels-000{number}"]["value"] for number in (2, 3, 4, 1)]
        most = np.full(pixels.shape[:2], full, pixels.dtype)
        return np.stack([most if each == FULL_ON else pixels[..., SOURCES[each]] for each in sources], -1)
    if effect["matchName"] != "ADBE Fill":
        return _stored(with_control(effect, pixels / full, time), full)
    color = parts["ADBE Fill-0002"]
    held = [key for key in color["keys"] if key["time"] <= time + 1e-9]
    assert all(key["out"] == "HOLD" for key in color["keys"])
    filled = pixels.copy()
    filled[..., :3] = np.rint(np.array((held[-1] if held else color)["value"][:3]) * full)
    return filled
