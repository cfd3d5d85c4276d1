"""Path mapping: where the files of one machine lie on another, by the rules that Open Job Description hands over."""

from dataclasses import dataclass
from pathlib import Path, PurePath, PurePosixPath, PureWindowsPath

from kagezou.document.model import Document
from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.project.path_changes import as_on_disk, with_paths
from kagezou.message import Message

_MOST_RULES = 10_000
_MOST_CHARACTERS = 32_768
_FORMATS = {"POSIX": PurePosixPath, "WINDOWS": PureWindowsPath}


@dataclass(frozen=True, slots=True)
class Rule:
    """What lies below ``source``, as its own system writes paths, lies below ``destination`` here."""

    source: PurePath
    destination: Path


def read_rules(path: Path) -> tuple[Rule, ...]:
    """Return the rules of a file of the form ``pathmapping-1.0``; one without rules has none.

    Raises
    ------
    InputProblem
        It cannot be read, or is something else: one sentence.
    """
    try:
        tree = parse(path.read_bytes().decode("utf-8"))
    except OSError as error:
        raise input_problem(path, error) from error
    except (UnicodeDecodeError, ProjectProblem) as problem:
        raise InputProblem(
            Message("{path}: these are not rules of path mapping: {cause}", path=shown(path), cause=problem)
        ) from problem
    try:
        return _rules(Reader(tree))
    except ProjectProblem as problem:
        raise InputProblem(Message("{path}: {cause}", path=shown(path), cause=problem)) from problem


def with_mapped_paths(document: Document, rules: tuple[Rule, ...]) -> Document:
    """Return the document with its pictures and sets where the rules say; of several the first that fits counts."""
    if not rules:
        return document
    return as_on_disk(with_paths(document, lambda path: mapped(path, rules)))


def mapped(path: Path, rules: tuple[Rule, ...]) -> Path:
    """Return where a path lies by the first rule that fits, else itself."""
    for rule in rules:
        as_written = type(rule.source)(str(path))
        if as_written.is_relative_to(rule.source):
            return rule.destination.joinpath(*as_written.relative_to(rule.source).parts)
    return path


def _rules(reader: Reader) -> tuple[Rule, ...]:
    members = reader.members()
    if not members:
        return ()
    found = reader.record(["version", "path_mapping_rules"])
    found["version"].word(["pathmapping-1.0"])
    return tuple(_rule(each) for each in found["path_mapping_rules"].items(_MOST_RULES))


def _rule(reader: Reader) -> Rule:
    found = reader.record(["source_path_format", "source_path", "destination_path"])
    kind = _FORMATS[found["source_path_format"].word(list(_FORMATS))]
    source = kind(found["source_path"].text(_MOST_CHARACTERS))
    return Rule(source, Path(found["destination_path"].text(_MOST_CHARACTERS)))
