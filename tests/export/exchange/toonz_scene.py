"""As much of OpenToonz as its scenes use: its streams, strictly, and what its effects do, as its source has it."""

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.export.exchange.cuts import pixels_of

Pixels = NDArray[np.float64]
_TOKEN = re.compile(
    r'\s*(?:<(/?)([A-Za-z0-9][\w.-]*)((?:\s+\w+=(?:"[^"]*"|\'[^\']*\'))*)\s*(/?)>|("(?:\\.|[^"\\])*"|[^\s<>"]+))'
)
_ATTRIBUTE = re.compile(r"(\w+)=(?:\"([^\"]*)\"|'([^']*)')")


@dataclass
class Tag:
    """A tag: its attributes, and what stands in it in order, tags and words."""

    name: str
    attributes: dict[str, str]
    inside: list["Tag | str"] = field(default_factory=list)

    def find(self, path: str) -> "Tag":
        """Return the first tag on a way of names."""
        found = self
        for name in path.split("/"):
            found = next(each for each in found.tags if each.name == name)
        return found

    @property
    def tags(self) -> list["Tag"]:
        return [each for each in self.inside if isinstance(each, Tag)]

    @property
    def words(self) -> list[str]:
        return [each for each in self.inside if isinstance(each, str)]


def scene_in(text: str) -> Tag:
    """Return the root; AssertionError where the stream would stop."""
    root = Tag("", {})
    stack, end = [root], 0
    for found in _TOKEN.finditer(text):
        assert not text[end : found.start()].strip(), text[end : found.start()]
        end = found.end()
        closing, name, attributes, empty, word = found.groups()
        if word is not None:
            stack[-1].inside.append(re.sub(r"\\(.)", r"\1", word[1:-1]) if word.startswith('"') else word)
        elif closing:
            assert stack.pop().name == name
        else:
            given = {key: one or other for key, one, other in _ATTRIBUTE.findall(attributes)}
            stack[-1].inside.append(Tag(name, given))
            if not empty:
                stack.append(stack[-1].tags[-1])
    assert len(stack) == 1
    assert not text[end:].strip()
    (only,) = root.tags
    return only


class Scene:
    """A scene, and the folder that it lies in."""

    def __init__(self, root: Tag, folder: Path) -> None:
        self.root, self.folder = root, folder
        self.objects: dict[str, Tag] = {}
        self._note(root)
        self.columns = root.find("xsheet/columns").tags

    def _note(self, tag: Tag) -> None:
        """Keep objects by their numbers; what is named only must have been written before."""
        number = tag.attributes.get("id", "")
        if number.isdecimal():
            known = self.objects.setdefault(number, tag)
            assert known.name == tag.name
            assert (known is tag) == bool(tag.inside), "written once, in full"
        for each in tag.tags:
            self._note(each)

    def shown(self, row: int) -> Pixels:
        """Return what is rendered on a row, (H, W, 4), multiplied by alpha."""
        (node,) = self.root.find("xsheet/fxnodes/terminal").tags
        made = self._effect(self.objects[node.tags[0].attributes["id"]], row)
        assert made is not None
        return made

    def _effect(self, effect: Tag, row: int) -> Pixels | None:
        if effect.name == "Toonz_columnFx":
            return self._column(next(each for each in self.columns if effect in each.find("fx").tags), row)
        ports = {port.name: self.objects[port.tags[0].attributes["id"]] for port in effect.find("ports").tags}
        upper = self._effect(ports["Fore"], row)
        under = self._effect(ports["Back"], row) if "Back" in ports else None
        assert effect.find("params/clipping_mask").words == ["0", "0"]
        if upper is None:
            return under
        opacity = _at(effect.find("params/opacity"), row)
        under = np.zeros_like(upper) if under is None else under
        over = upper * opacity + under * (1 - upper[..., 3:] * opacity)
        if effect.name == "STD_inoOverFx":
            return over
        assert effect.name == "STD_inoMultiplyFx"
        return _multiplied(under, upper, opacity, over)

    def _column(self, column: Tag, row: int) -> Pixels | None:
        assert column.find("status").words == ["0"], "seen by the camera"
        for cell in column.find("cells").tags:
            first, rows, number, grows = cell.words
            if int(first) <= row < int(first) + int(rows):
                assert grows == "0"
                level = self.objects[cell.tags[0].attributes["id"]]
                path = level.find("path").words[0]
                assert path.startswith("$scenefolder/")
                stored = pixels_of(self.folder / path.removeprefix("$scenefolder/").replace("..", f".{number}."))
                # Its reader of PNG multiplies by alpha.
                return np.concatenate([stored[..., :3] * stored[..., 3:], stored[..., 3:]], -1)
        return None


def _at(param: Tag, row: int) -> float:
    keys = [(float(at), float(value)) for at, value in (key.words for key in param.tags[1:] for key in key.tags)]
    held = [value for at, value in keys if at <= row]
    return held[-1] if held else float(param.find("default").words[0])


def _multiplied(under: Pixels, upper: Pixels, opacity: float, over: Pixels) -> Pixels:
    """Return what `igs::color::multiply` makes."""
    dn_a, up_a = under[..., 3:], upper[..., 3:]
    both = (dn_a > 0) & (up_a > 0)
    dn, up = (each[..., :3] / np.where(alpha > 0, alpha, 1) for each, alpha in ((under, dn_a), (upper, up_a)))
    least, most = np.minimum(dn_a, up_a), np.where(both, np.maximum(dn_a, up_a), 1)
    blend = dn * up * least / most
    blend += np.where(up_a < dn_a, dn * (dn_a - up_a) / most, 0) + np.where(dn_a < up_a, up * (up_a - dn_a) / most, 0)
    blend *= up_a + dn_a * (1 - up_a)
    mixed = under[..., :3] * (1 - opacity) + blend * opacity
    color = np.where(both, mixed, np.where(up_a > 0, upper[..., :3] * opacity, under[..., :3]))
    return np.concatenate([color, over[..., 3:]], -1)
