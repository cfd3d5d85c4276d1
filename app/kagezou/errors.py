"""What goes wrong outside the program, as one sentence and one exit code.

A ``Problem`` is meant for the person who works: its message names the file and the cause and needs no traceback.
Anything else that escapes is a defect of ours.
"""

from typing import ClassVar

from kagezou.message import Message, Translate


class Problem(Exception):
    """Something the user can understand and mend; ``str(problem)`` is the whole sentence in English.

    Parameters
    ----------
    message
        The sentence with its values, to be translated where it is shown.
    """

    exit_code: ClassVar[int] = 1

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    @property
    def file(self) -> str | None:
        """The file or folder that it is about, where its sentence names one."""
        values = self.message.values
        named = values.get("path") or values.get("file") or values.get("folder")
        return None if named is None else str(named)

    @property
    def code(self) -> int:
        """The exit code that the command line ends with for it."""
        return self.exit_code

    def formatted(self, translate: Translate) -> str:
        """Return the sentence in the language of ``translate``."""
        return self.message.formatted(translate)

    def sentence(self, translate: Translate) -> str:
        """Return it with a capital where English begins with one."""
        return self.message.sentence(translate)


class Stopped(Exception):
    """The person asked to stop in the middle of something that takes long; no problem of anything."""


class UsageProblem(Problem):
    """The command line or a typed value does not make sense."""

    exit_code = 2


class InputProblem(Problem):
    """A file that was asked for is missing, broken or of the wrong kind."""

    exit_code = 3


class OutputProblem(Problem):
    """A place that should be written to refuses."""

    exit_code = 4


class DiskFullProblem(OutputProblem):
    """There is no room left for what should be written."""

    exit_code = 5


class GraphicsProblem(Problem):
    """OpenGL 3.3 is not available, or it failed."""

    exit_code = 6


class ProjectProblem(Problem):
    """The project file is invalid, damaged or from a newer version."""

    exit_code = 7


class SomeFramesFailed(Problem):
    """The work went on past failed frames, as asked, but is not whole."""

    exit_code = 8


class AfterExportFailed(Problem):
    """The export is whole, but what was to run after it could not be run, failed or was stopped.

    Parameters
    ----------
    message
        What went wrong first.
    notes
        What else is to be said.
    """

    exit_code = 9

    def __init__(self, message: Message, notes: tuple[Message, ...] = ()) -> None:
        super().__init__(message)
        self.notes = notes
