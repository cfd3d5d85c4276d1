"""The reference of commands on the website: in English as each says it, in Japanese from a catalogue beside."""

import importlib
import json
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final

from kagezou.cli.arguments import Parser
from kagezou.cli.main import VERBS

CATALOGUE: Final = Path(__file__).resolve().parent / "site" / "commands_ja.json"
"""``summaries`` has a line for each command, ``texts`` what its help says, each by its English text."""
_TITLES: Final = {
    "en": ("Commands", "Every command of the command line; `kagezou help COMMAND` says the same."),
    "ja": (
        "コマンド",
        "コマンドラインの全コマンドです。`kagezou help COMMAND` は同じことを英語で表示します。",
    ),
}
_WORDS: Final = {
    "en": (("what is typed", "what it does"), "Examples:"),
    "ja": (("引数とオプション", "意味"), "例："),
}
_WIDTH: Final = "100"
_NOTE: Final = re.compile(r"(?<=\S)\s{4,}(?=\S)")
"""What parts an example from what is said of it."""


def commands_page(language: str) -> Iterator[str]:
    """Yield the lines of the reference of commands."""
    title, says = _TITLES[language]
    yield from (f"# {title}", "", says, "")
    os.environ["COLUMNS"] = _WIDTH
    english = {each: _with_code(each) for each in english_texts()}
    known = catalogue() if language == "ja" else {"summaries": VERBS, "texts": english}
    for verb in VERBS:
        yield from _section(verb, known, language)


def english_texts() -> frozenset[str]:
    """Return all that the help of any command says, but for usage and the examples themselves."""
    found: set[str] = set()
    for verb in VERBS:
        parser, examples = _parser_of(verb)
        found.update(_paragraphs(parser), (says for _, says in parser.described()))
        found.update(parts[1] for parts in map(_NOTE.split, examples) if len(parts) > 1)
    return frozenset(found)


def catalogue() -> Mapping[str, Mapping[str, str]]:
    """Return the Japanese texts."""
    read: Mapping[str, Mapping[str, str]] = json.loads(CATALOGUE.read_text(encoding="utf-8"))
    return read


def _section(verb: str, known: Mapping[str, Mapping[str, str]], language: str) -> Iterator[str]:
    """Yield what one command does, how it is typed, what can be typed, and examples."""
    texts, (heads, example) = known["texts"], _WORDS[language]
    parser, examples = _parser_of(verb)
    yield from (f"## kagezou {verb}", "", known["summaries"][verb], "")
    for paragraph in _paragraphs(parser):
        yield from (texts[paragraph], "")
    usage = re.sub(r"\n +", "\n    ", parser.format_usage().removeprefix("usage: ").rstrip())
    yield from ("```text", usage, "```", "")
    yield from (f"| {' | '.join(heads)} |", "|---|---|")
    yield from (f"| `{_in_cell(typed)}` | {_in_cell(texts[says])} |" for typed, says in parser.described())
    yield from ("", example, "", "```text", *(_example(line, texts) for line in examples), "```", "")


def _parser_of(verb: str) -> tuple[Parser, list[str]]:
    module = importlib.import_module(f"kagezou.cli.verbs.{verb.replace('-', '_')}")
    parser = Parser(verb, module.DESCRIPTION, module.EXAMPLES)
    module.add_arguments(parser)
    return parser, [line.strip() for line in module.EXAMPLES.splitlines()]


def _paragraphs(parser: Parser) -> list[str]:
    return [" ".join(each.split()) for each in (parser.description or "").split("\n\n")]


def _example(line: str, texts: Mapping[str, str]) -> str:
    command, *notes = _NOTE.split(line)
    return "        ".join([command, *(texts[each].replace("`", "") for each in notes)])


def _with_code(text: str) -> str:
    """Return what a help says in Markdown: options, and what it has in quotes, as code."""
    return re.sub(r"(?<![\w-])--[a-z][a-z-]*|'([^' ]*)'", lambda found: f"`{found[1] or found[0]}`", text)


def _in_cell(text: str) -> str:
    return text.replace("|", r"\|")
