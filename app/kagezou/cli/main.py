"""From the words of a command line to an exit code."""

import importlib
import io
import os
import sys
from argparse import Namespace
from collections.abc import Sequence
from contextlib import nullcontext, redirect_stdout
from dataclasses import replace
from typing import Final, Protocol

from kagezou.cli import crash_log
from kagezou.cli.arguments import Parser, did_you_mean
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import Interrupted, stopping_at_once
from kagezou.cli.manner import Manner, failure, manner_of
from kagezou.cli.progress_file import ProgressFile, taken_out
from kagezou.cli.terminal import PROGRAM, Voice, give, give_json, speaking, tell
from kagezou.errors import OutputProblem, Problem, UsageProblem
from kagezou.message import Message

VERBS: Final = {
    "new": "make a project of character drawings",
    "set": "set properties, for the whole cut or by keys",
    "get": "print the value of a property",
    "info": "say what is in a project, and what is missing",
    "inspect": "say what any file is understood to be, and what of it is not used",
    "retake": "give layers other drawings, and say what became of keys and feet",
    "relink": "find drawings that were moved, in another folder",
    "feet": "find the characters' feet anew, and list how they stand",
    "piece": "put walls, boxes and the like on the ground, or take them away",
    "style": "put a named look on a character, or list the looks",
    "apply": "take light, looks, ground or the set of one project into others",
    "auto": "make projects and output of many cuts at once, with a report",
    "render": "write the shadow layers as numbered frames",
    "video": "write the finished picture, or one shadow with alpha, as a video",
    "export-ae": "hand shadows and footage to After Effects, with a script that builds the comp",
    "export-scene": "hand all layers to Blender, Nuke and others, with a scene that lays them",
    "timesheet": "write when which drawing is exposed, as XDTS",
    "notes": "list what people said about the cut, as text or a table",
    "farm": "write a job bundle for a render farm",
    "sheet": "draw a contact sheet of characters, their shadows step by step",
    "bench": "measure how fast this machine draws and exports",
    "doctor": "say what this machine has and what it lacks",
    "demo": "make and render a small project to look at",
    "thumbnail": "draw a small picture of a project, for file managers",
    "integrate": "tell a Linux desktop of the program and its files",
}
EXIT_BROKEN_PIPE: Final = 141
_HELP: Final = """\
usage: kagezou [PROJECT.kage | SHEET.xdts]     the window
       kagezou COMMAND ...                     the command line
       kagezou help COMMAND                    what a command takes, with examples
       kagezou @FILE                           all words from a UTF-8 file: a JSON list, or one a line

Cast-shadow layers for 2D animation, from the alpha of the character drawings.

commands:
{verbs}

options:
  -h, --help     show this, or with a command its own help
  --version      show the version
  --quiet        with a command: say problems only
  --verbose      with a command: say how far it is in lines, where no one watches, too
  --log FILE     with a command: add everything that is said to a file
  --json         with a command: one JSON object, of a problem too: code, message, file and values
  --progress-file FILE    with a command: how far it is and how it ended, for a program that waits; it stops where
                 FILE.stop appears

examples:
  kagezou demo
  kagezou new walk.kage --character Hero=drawings/hero
  kagezou set walk.kage light.position=1400,-300,900
  kagezou render walk.kage -o shadows --composite

environment:
  KAGEZOU_AFTER_EXPORT    the command that runs after an export
  KAGEZOU_STYLES, KAGEZOU_PRESETS, KAGEZOU_SHORTCUTS    folders of a studio's own, parted as in PATH

exit codes: 0 everything done, 1 defect, 2 usage, 3 input file, 4 cannot write, 5 disk full, 6 no OpenGL,
            7 project file, 8 some frames or cuts failed, 9 what runs after an export failed, 130 Ctrl-C, 143 terminated
"""


class _Verb(Protocol):
    """What each module of a verb has."""

    DESCRIPTION: str
    EXAMPLES: str

    def add_arguments(self, parser: Parser) -> None: ...

    def run(self, options: Namespace, entry_points: EntryPoints) -> int: ...


def run(arguments: Sequence[str], entry_points: EntryPoints) -> int:
    """Do what a command line says and return the exit code; whatever goes wrong is one line on stderr."""
    try:
        words, path = taken_out(arguments)
        told = None if path is None else ProgressFile(path)
    except Problem as problem:
        tell(str(problem))
        return problem.exit_code
    if told is None:
        return _spoken(words, entry_points)
    with told:
        code = _spoken(words, replace(entry_points, progress=told))
    told.end(code)
    return code


def _spoken(words: Sequence[str], entry_points: EntryPoints) -> int:
    """Run in the manner that a command line asks for."""
    heard: list[str] = []
    given: list[str] = []
    try:
        manner = manner_of(words)
        # Appended to, as several commands of a script write to one; it ends with the command.
        log = None if manner.log is None else manner.log.open("a", encoding="utf-8")
    except Problem as problem:
        tell(str(problem))
        return problem.exit_code
    except OSError as error:
        tell(f"the log cannot be written: {error.strerror}")
        return OutputProblem.exit_code
    with log or nullcontext(), speaking(Voice(manner.is_quiet, manner.is_verbose, log, heard, given)):
        return _run(manner, entry_points, heard, given)


def _run(manner: Manner, entry_points: EntryPoints, heard: Sequence[str], given: Sequence[str]) -> int:
    arguments = manner.words
    try:
        with stopping_at_once():
            code = _dispatched(manner, entry_points, heard)
            sys.stdout.flush()
    except Problem as problem:
        tell(str(problem))
        if manner.wants_json and not given:
            give_json(failure(problem))
        return problem.exit_code
    except Interrupted as stop:
        return stop.exit_code
    except BrokenPipeError:
        return _broken_pipe()
    except OSError as error:
        return _stdout_refused(error, arguments)
    except MemoryError:
        tell("there is not enough memory for this")
        return Problem.exit_code
    except Exception as error:
        return _defect(error, arguments)
    return code


def _dispatched(manner: Manner, entry_points: EntryPoints, heard: Sequence[str]) -> int:
    verb, *rest = manner.words or ("--help",)
    if verb == "help" and rest:
        verb, rest = rest[0], ["--help"]
    if verb in ("-h", "--help", "help"):
        give(_HELP.format(verbs="\n".join(f"  {name:<9} {words}" for name, words in VERBS.items())).rstrip())
        return 0
    if verb in ("-V", "--version"):
        from kagezou.version import __version__

        give(f"{PROGRAM} {__version__}")
        return 0
    if verb not in VERBS:
        hint = did_you_mean(verb, VERBS) or Message("; a project ends in .kage")
        raise UsageProblem(
            Message("{verb!r} is neither a command nor a project{hint} (see kagezou --help)", verb=verb, hint=hint)
        )
    module: _Verb = importlib.import_module(f"kagezou.cli.verbs.{verb.replace('-', '_')}")
    parser = Parser(verb, module.DESCRIPTION, module.EXAMPLES)
    module.add_arguments(parser)
    has_json = not manner.wants_json or parser.has("--json")
    try:
        options = parser.options_of(rest if has_json else [word for word in rest if word != "--json"])
    except SystemExit as done:  # --help has printed itself
        return int(done.code or 0)
    if has_json:
        return module.run(options, entry_points)
    with redirect_stdout(io.StringIO()) as said:
        code = module.run(options, entry_points)
    give_json({"code": code, "lines": said.getvalue().splitlines(), "notes": list(heard)})
    return code


def _broken_pipe() -> int:
    """Whoever read the output has gone: no one is left to tell."""
    # What is still in the buffer would fail again, with a traceback, when Python ends.
    with open(os.devnull, "wb") as nowhere:  # noqa: PTH123 - a device, not a file
        try:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
        except (OSError, ValueError):
            sys.stdout = io.StringIO()
    return EXIT_BROKEN_PIPE


def _stdout_refused(error: OSError, arguments: Sequence[str]) -> int:
    """Rooms below turn refusals of files into problems; what is left is the output itself, or a defect."""
    if error.filename is not None:
        return _defect(error, arguments)
    from kagezou.io.files.faults import cause_of, is_full

    _broken_pipe()
    tell(f"the output cannot be written: {cause_of(error)}")
    return 5 if is_full(error) else 4


def _defect(error: Exception, arguments: Sequence[str]) -> int:
    where = crash_log.noted_at(error, arguments)
    tell(f"a defect of the program: {type(error).__name__}: {str(error).partition(chr(10))[0]} ({where})")
    return Problem.exit_code
