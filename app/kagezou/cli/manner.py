"""Options that every command has: how much is said, to whom, and in which form."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.cli.terminal import Json
from kagezou.errors import Problem, UsageProblem
from kagezou.message import Message

_JSON: Final = "--json"
_LOG: Final = "--log"


@dataclass(frozen=True, slots=True)
class Manner:
    """How a command speaks.

    Parameters
    ----------
    words
        The command line without these options; ``--json`` stays in it.
    is_quiet
        Notes are left out, and progress; problems are not.
    is_verbose
        Progress is said in lines where no one watches, too.
    log
        A file to which everything that is said is added.
    """

    words: tuple[str, ...]
    is_quiet: bool = False
    is_verbose: bool = False
    log: Path | None = None

    @property
    def wants_json(self) -> bool:
        """Whether a program reads what comes."""
        return _JSON in self.words

    @property
    def without_json(self) -> tuple[str, ...]:
        """The words for a command that has no JSON of its own."""
        return tuple(word for word in self.words if word != _JSON)


def manner_of(words: Sequence[str]) -> Manner:
    """Return how a command line wants to be answered.

    Raises
    ------
    UsageProblem
        The log has no file behind it.
    """
    kept: list[str] = []
    said: set[str] = set()
    log: Path | None = None
    left = iter(words)
    for word in left:
        if word == _LOG:
            name = next(left, "")
            if not name:
                raise UsageProblem(Message("{option} needs a file", option=_LOG))
            log = Path(name)
        elif word in ("--quiet", "--verbose"):
            said.add(word)
        else:
            kept.append(word)
    if len(said) > 1:
        raise UsageProblem(Message("--quiet and --verbose are one too many"))
    return Manner(tuple(kept), "--quiet" in said, "--verbose" in said, log)


def failure(problem: Problem) -> Json:
    """Return what a program is told of a problem: its exit code, the sentence, its file and its values."""
    values = {name: _plain(value) for name, value in problem.message.values.items()}
    return {"code": problem.exit_code, "message": str(problem), "file": problem.file, "values": values}


def _plain(value: object) -> Json:
    return value if isinstance(value, str | int | float | bool | None) else str(value)
