"""``kagezou doctor``: what this machine has, and in words what it lacks."""

import json
import os
import subprocess
from argparse import SUPPRESS, Namespace
from typing import Final

from kagezou.cli.arguments import Parser
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give, give_json, one_line
from kagezou.errors import GraphicsProblem
from kagezou.own_process import program_words

DESCRIPTION = """\
Say what this machine has and what it lacks: versions, OpenGL, picture formats, folders, what is a studio's own,
encodings, crashes. Ends with 0 where shadows can be rendered, else with 6."""
EXAMPLES = """\
  kagezou doctor
  kagezou doctor --json
"""
PROBE: Final = "--probe-graphics"
PROBE_LIMIT_S: Final = 120.0
"""A machine without a graphics card that does much else compiles all shaders in half a minute; a driver that hangs is
told from it by waiting longer than that."""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("--json", action="store_true", help="print one object")
    parser.add_argument(PROBE, dest="probe", action="store_true", help=SUPPRESS)


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Look at everything and report."""
    from kagezou.cli import examination

    if options.probe:
        return _probe(entry_points)
    graphics = _graphics()
    report: dict[str, Json] = {
        "versions": examination.versions(),
        "system": examination.system(),
        "graphics": graphics,
        "window": examination.window(has_display=entry_points.has_display),
        "formats": examination.formats(),
        "folders": examination.folders(),
        "studio": examination.studio(),
        "text": examination.text(),
        "crashes": examination.crashes(),
    }
    can_render = "renderer" in graphics
    missing = [*examination.advice(report, can_render=can_render)]
    if options.json:
        give_json({**report, "missing": missing, "can_render": can_render}, indent=2)
    else:
        for line in _lines(report):
            give(one_line(line))
        for sentence in missing or ["nothing is missing"]:
            give(one_line(sentence))
        give("this machine can render" if can_render else "this machine cannot render")
    return 0 if can_render else GraphicsProblem.exit_code


def _lines(report: dict[str, Json]) -> list[str]:
    lines: list[str] = []
    for title, part in report.items():
        assert isinstance(part, dict)
        lines.append(f"{title}:")
        lines += [f"  {name:<20} {_shown(value)}" for name, value in part.items()]
    return lines


def _shown(value: Json) -> str:
    match value:
        case True:
            return "yes"
        case False:
            return "no"
        case None:
            return "-"
        case str():
            return value
        case list():
            return ", ".join(map(str, value)) or "-"
        case _:
            return str(value)


def _probe(entry_points: EntryPoints) -> int:
    """Open a context, set up everything that draws, and print what draws: what the parent may not survive itself."""
    from kagezou.io.images.cel_cache import CelCache
    from kagezou.render.gpu.program import compile_all
    from kagezou.render.renderer import Renderer

    with entry_points.open_context() as context:
        info = context.info
        renderer = Renderer(CelCache(0))
        compile_all()
        renderer.close()
    give_json(
        {
            "vendor": info.vendor,
            "renderer": info.renderer,
            "version": info.version,
            "max_texture_px": info.max_texture_px,
            "software": info.is_software,
        }
    )
    return 0


def _graphics() -> dict[str, Json]:
    """Return what the probe in a child process says, or why it says nothing: a driver may crash or hang."""
    try:
        done = subprocess.run(
            [*program_words(), "doctor", PROBE],
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            timeout=PROBE_LIMIT_S,
            check=False,
            env={**os.environ, "PYTHONUTF8": "1"},
        )
    except subprocess.TimeoutExpired:
        return {"problem": f"the graphics driver did not answer within {PROBE_LIMIT_S:.0f} s"}
    except OSError as error:
        return {"problem": f"the probe could not be started: {error.strerror}"}
    if done.returncode == 0:
        found: dict[str, Json] = json.loads(done.stdout)
        return found
    if done.returncode < 0:
        return {"problem": f"the graphics driver crashed (signal {-done.returncode})"}
    said = done.stderr.strip().splitlines() or [f"the probe ended with code {done.returncode}"]
    return {"problem": said[-1].removeprefix("kagezou: ")}
