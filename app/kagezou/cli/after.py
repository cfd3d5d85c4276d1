"""What runs after an export that the command line has made."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser
from kagezou.cli.terminal import note, tell
from kagezou.errors import AfterExportFailed

if TYPE_CHECKING:
    from kagezou.export.after.manifest import Handover


def add_after(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument(
        "--after",
        metavar="COMMAND",
        help="run it when everything is there, with a JSON file that says what was made as its last word, instead of "
        "KAGEZOU_AFTER_EXPORT; '' for nothing. Where it fails, the export is whole and the exit code 9",
    )


def hand_on_export(over: "Callable[[], Handover]", command: str | None, stops: Callable[[], bool]) -> bool:
    """Run what comes after an export, and say what came of it; return False where the person stopped it.

    ``over`` makes what is handed on, and is called only where something comes after.

    Raises
    ------
    AfterExportFailed, OutputProblem
        As for `hand_on`.
    """
    from kagezou.export.after.hooks import hand_on, hooks_of

    hooks = hooks_of(command)
    if not hooks:
        return True
    try:
        said = hand_on(over(), hooks, stops)
    except AfterExportFailed as problem:
        for sentence in problem.notes:
            note(sentence)
        if not stops():
            raise
        tell(str(problem))
        return False
    for sentence in said:
        note(sentence)
    return True
