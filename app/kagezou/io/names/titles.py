"""What runs of names are called."""

import unicodedata
from collections import Counter
from collections.abc import Sequence
from itertools import takewhile
from typing import Final

from kagezou.io.names.joining import Draft
from kagezou.io.names.marks import words_of

_BETWEEN: Final = "_-. ~#"
_OPENING: Final = "([{【「"


def titles_of(drafts: Sequence[Draft], names: Sequence[str]) -> list[str]:
    """Return what each run is called: what stands before its numbers, with what follows them where that tells it apart.

    Parameters
    ----------
    drafts
        The runs.
    names
        All names as they are written.
    """
    heads = Counter(draft.members[0].head_key for draft in drafts)
    return [_title(draft, names, is_shared=heads[draft.members[0].head_key] > 1) for draft in drafts]


def _title(draft: Draft, names: Sequence[str], *, is_shared: bool) -> str:
    first = min(draft.members, key=lambda member: member.place)
    if len({member.head_key for member in draft.members}) > 1:
        spellings = zip(*(member.head for member in draft.members), strict=False)
        head = "".join(letters[0] for letters in takewhile(lambda each: len(set(each)) == 1, spellings))
    else:
        head = _as_written(names[first.index], first.head)
    head = head.strip(_BETWEEN).rstrip(_BETWEEN + _OPENING)
    tail = words_of(first.tail) if is_shared or not head else ""
    return unicodedata.normalize("NFC", "_".join(filter(None, (head, tail))))


def _as_written(name: str, head: str) -> str:
    """Return what of a name is ``head`` in half width; that itself where it is no beginning."""
    wanted = unicodedata.normalize("NFD", head)
    for end in range(len(name) + 1):
        if unicodedata.normalize("NFKD", name[:end]) == wanted:
            return name[:end]
    return head
