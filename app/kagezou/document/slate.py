"""What a cut is called, as it stands on its slate, and the numbers that its frames bear."""

from dataclasses import dataclass
from typing import Final

from kagezou.errors import UsageProblem
from kagezou.message import Message

MAX_WORD_CHARACTERS: Final = 60
MAX_FIRST_FRAME: Final = 1_000_000


@dataclass(frozen=True, slots=True)
class Slate:
    """The name of a production or an episode, the scene and the cut; numbers with letters as people write them.

    All three may be empty.
    """

    name: str = ""
    scene: str = ""
    cut: str = ""

    @property
    def label(self) -> str:
        """All of it as the beginning of files' names, such as ``ep03_s2_c012``; empty where nothing is said."""
        parts = (self.name, self.scene and f"s{self.scene}", self.cut and f"c{self.cut}")
        return "_".join(part for part in parts if part)


NO_SLATE: Final = Slate()


def checked_slate(slate: Slate) -> Slate:
    """Return a slate without spaces around its words.

    Raises
    ------
    UsageProblem
        A word is too long or cannot be printed.
    """
    words = [word.strip() for word in (slate.name, slate.scene, slate.cut)]
    for word in words:
        if len(word) > MAX_WORD_CHARACTERS or not word.isprintable():
            raise UsageProblem(
                Message(
                    "{word!r} cannot stand on a slate: at most {most} printable characters",
                    word=word[:MAX_WORD_CHARACTERS],
                    most=MAX_WORD_CHARACTERS,
                )
            )
    return Slate(*words)
