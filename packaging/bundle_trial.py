"""A bundle is tried beside the sources it was made of: what it lacks is not to be found out by whoever has it.

The doctor has to see the same packages; three frames of the demo, a hand-over, and every format that is written or read
have to be byte for byte as the sources make them; a batch has to run, and the window to come, on a screen of its own.
"""

import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from dev_display import private_display

_FRAMES: Final = "1,7,13"
_TRIED_S: Final = 300
_TERMINATED: Final = 143
_OF_SCREEN: Final = ("DISPLAY", "XDG_RUNTIME_DIR", "QT_QPA_PLATFORM", "LIBGL_ALWAYS_SOFTWARE")
_RENDER: Final = "render made/demo.kage --frames 1 -o"
_PIECE: Final = "mesh display=clay scale=1 --file"
_FORMATS: Final = (
    "set made/demo.kage canvas.length=2",
    *(f"{_RENDER} {name} --format {name} --composite" for name in ("tga", "tiff", "exr")),
    *(f"new back-{name}.kage --character A={name}/composite" for name in ("tga", "tiff", "exr")),
    f"{_RENDER} psd --layered",
    f"{_RENDER} layers --layered --format exr",
    f"{_RENDER} deep --depth 16 --receivers --united",
    *(
        f"export-scene made/demo.kage --for {program} -o to-{program}"
        for program in ("blender", "nuke", "natron", "fusion", "opentoonz", "oca")
    ),
    "timesheet made/demo.kage -o demo.xdts",
    "thumbnail made/demo.kage -o demo.png",
    "new sheet.kage --character Child=made/drawings --timesheet demo.xdts",
    f"piece sheet.kage add packed {_PIECE} draco.glb",
    "render sheet.kage --frames 1 -o packed --composite",
)
"""What both are told, each in a folder of its own."""
_OF_PARTS: Final = {
    "video": ("video made/demo.kage -o demo.mp4",),
    "usd": (f"piece sheet.kage add usd {_PIECE} cube.usda", "render sheet.kage --frames 1 -o usd --composite"),
    "gradients": (),
}
_SETS: Final = """
import json, struct, sys
from pathlib import Path
import DracoPy
import numpy as np
folder = Path(sys.argv[1])
(folder / "cube.usda").write_text('#usda 1.0\\n(upAxis = "Y")\\ndef Cube "cube" {\\n    double size = 90\\n}\\n')
corners = np.array([[0, 0, 0], [90, 0, 0], [0, 90, 0], [0, 0, 90]], np.float32)
packed = DracoPy.encode(corners, np.array([[0, 1, 2], [0, 2, 3]], np.uint32), preserve_order=True)
packed += bytes(-len(packed) % 4)
tree = {
    "asset": {"version": "2.0"},
    "extensionsUsed": ["KHR_draco_mesh_compression"], "extensionsRequired": ["KHR_draco_mesh_compression"],
    "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "buffers": [{"byteLength": len(packed)}], "bufferViews": [{"buffer": 0, "byteLength": len(packed)}],
    "accessors": [
        {"componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [90, 90, 90]},
        {"componentType": 5125, "count": 6, "type": "SCALAR"},
    ],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "extensions": {
        "KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}],
}
text = json.dumps(tree).encode()
text += b" " * (-len(text) % 4)
body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(packed), 0x004E4942) + packed
(folder / "draco.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
"""
"""Sets that only a part of the program reads: one packed by Draco, and one in USD."""


def say(sentence: str) -> None:
    """Print at once: child processes write to the same place."""
    sys.stdout.write(f"{sentence}\n")
    sys.stdout.flush()


def try_out(folder: Path, python: Path, work: Path, parts: list[str]) -> None:
    """Raise SystemExit with one sentence where the bundle does not do what the sources do."""
    program = folder / ("kagezou.exe" if os.name == "nt" else "kagezou")
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    # A bundle finds what it needs in itself: no Python of the machine may help.
    bare = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "VIRTUAL_ENV"))}
    _try_doctor(program, python, work, bare)
    _run([program, "demo", "made"], work, bare)
    project = next(work.glob("made/*.kage"))
    for words, out in (([program], "bundle"), ([python, "-m", "kagezou"], "sources")):
        _run([*words, "render", project, "-o", work / out, "--composite", "--frames", _FRAMES], work, bare)
        _run([*words, "export-ae", project, "-o", work / f"{out}-ae"], work, bare)
    for made in ("bundle", "bundle-ae"):
        theirs = made.replace("bundle", "sources")
        if _content(work / made) != _content(work / theirs):
            raise SystemExit(f"the bundle makes other files than the sources: {work / made} and {work / theirs}")
    _try_formats(program, python, work, bare, parts)
    _run([program, "auto", work / "made", "-o", work / "auto", "--style", "Natural"], work, bare)
    _try_window(program, project, work, bare)


def _try_doctor(program: Path, python: Path, work: Path, environment: dict[str, str]) -> None:
    """See that what is installed where the bundle was made is in it."""
    told = [json.loads(_run([*words, "doctor", "--json"], work, environment)) for words in _both(program, python)]
    theirs, ours = (each["versions"] for each in told)
    lacking = [name for name, version in ours.items() if theirs[name] != version]
    if lacking:
        raise SystemExit(f"the bundle lacks what the sources have, or does not know it: {', '.join(lacking)}")


def _both(program: Path, python: Path) -> tuple[list[object], list[object]]:
    return [program], [python, "-m", "kagezou"]


def _try_formats(program: Path, python: Path, work: Path, environment: dict[str, str], parts: list[str]) -> None:
    """Write and read back every format by the bundle and by the sources, and compare all files."""
    _run([python, "-c", _SETS, work], work, environment)
    steps = [each.split() for each in (*_FORMATS, *(step for part in parts for step in _OF_PARTS[part]))]
    made = []
    for number, words in enumerate(_both(program, python)):
        place = work / f"formats-{number}"
        place.mkdir()
        shutil.copytree(work / "made", place / "made")
        for name in ("draco.glb", "cube.usda"):
            shutil.copy(work / name, place)
        for step in steps:
            _run([*words, *step], place, environment)
        made.append(_content(place))
    theirs, ours = made
    wrong = sorted(name for name in {*theirs, *ours} if theirs.get(name) != ours.get(name))
    if wrong:
        raise SystemExit(f"the bundle makes other files than the sources: {', '.join(wrong)}")
    say(f"{len(steps)} commands about formats: {len(ours)} files as the sources make them")


def _try_window(program: Path, project: Path, work: Path, environment: dict[str, str]) -> None:
    """Open the window with a project on a screen of its own, wait until it is there, and end it as a desktop does."""
    if not sys.platform.startswith("linux") or shutil.which("xwininfo") is None:
        say("the window was not tried: that takes Linux and xwininfo (x11-utils)")
        return
    with private_display() as screen:
        shown: dict[str, str] = {**environment, **{name: word for name, word in screen.items() if name in _OF_SCREEN}}
        began = time.monotonic()
        with subprocess.Popen([program, project], cwd=work, env=shown, stderr=subprocess.PIPE, text=True) as window:
            while project.stem not in _titles(shown):
                if window.poll() is not None or time.monotonic() - began > _TRIED_S:
                    window.kill()
                    raise SystemExit(f"the bundle shows no window: {window.communicate()[1].strip()}")
                time.sleep(0.05)
            say(f"the window is there after {time.monotonic() - began:.1f} s")
            window.terminate()
            code = window.wait(_TRIED_S)
    if code != _TERMINATED:
        raise SystemExit(f"the bundle's window ended with {code}, not {_TERMINATED}")


def _titles(environment: dict[str, str]) -> str:
    words = ["xwininfo", "-root", "-tree"]
    return subprocess.run(words, env=environment, capture_output=True, text=True, check=False).stdout


def _run(words: Sequence[object], work: Path, environment: dict[str, str]) -> str:
    done = subprocess.run(
        list(map(str, words)), cwd=work, env=environment, capture_output=True, text=True, check=False, timeout=_TRIED_S
    )
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, words))} ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def _content(folder: Path) -> dict[str, bytes]:
    """Return what an export made, but for what knows when it was made."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and not path.name.startswith("."))
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files if path.suffix != ".jsx"}
