"""A name that a file brings in several languages, such as that of a style."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Self


@dataclass(frozen=True, slots=True)
class LocalName:
    """What something is called.

    Attributes
    ----------
    en
        In English, and in every language that has no name of its own for it.
    others
        In other languages, by their codes.
    """

    en: str
    others: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    @classmethod
    def of(cls, en: str, **others: str) -> Self:
        """Return a name by languages' codes; what is called as in English has no name of its own."""
        return cls(en, MappingProxyType({code: name for code, name in others.items() if name != en}))

    def in_language(self, code: str) -> str:
        """Return it in the language of a code such as "ja"."""
        return self.others.get(code, self.en)
