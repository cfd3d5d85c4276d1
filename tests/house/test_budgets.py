"""The house's budgets, which the worst module keeps as well as the median: small rooms, and one word for one thing."""

import ast
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

import kagezou

SOURCES = Path(kagezou.__file__).parent
MOST_LINES_OF = {"module": 300, "class": 200, "function": 40}

EXCEPTIONS: dict[str, str] = {}
"""What may be larger, with the reason: a module's path below the package, ``path:Class`` or ``path:function``."""


@dataclass(frozen=True, slots=True)
class Measured:
    """A module, class or function, and its lines; those of a function are counted without its docstring."""

    place: str
    kind: str
    lines: int


def modules() -> dict[str, ast.Module]:
    return {
        path.relative_to(SOURCES).as_posix(): ast.parse(path.read_text(encoding="utf-8"))
        for path in sorted(SOURCES.rglob("*.py"))
    }


MODULES = modules()


def measured() -> Iterator[Measured]:
    for place, tree in MODULES.items():
        yield Measured(place, "module", len((SOURCES / place).read_text(encoding="utf-8").splitlines()))
        for node in ast.walk(tree):
            match node:
                case ast.ClassDef():
                    yield Measured(f"{place}:{node.name}", "class", span(node))
                case ast.FunctionDef() | ast.AsyncFunctionDef():
                    docstring = node.body[0] if ast.get_docstring(node) else None
                    yield Measured(
                        f"{place}:{node.name}", "function", span(node) - (span(docstring) if docstring else 0)
                    )


def span(node: ast.stmt) -> int:
    return (node.end_lineno or node.lineno) - node.lineno + 1


def test_every_room_keeps_its_budget() -> None:
    over = [each for each in measured() if each.lines > MOST_LINES_OF[each.kind]]
    told = [f"{each.place}: a {each.kind} of {each.lines} lines" for each in over if each.place not in EXCEPTIONS]
    assert not told, "make them smaller, or give the reason in EXCEPTIONS"


def test_no_exception_outlives_its_reason() -> None:
    over = {each.place for each in measured() if each.lines > MOST_LINES_OF[each.kind]}
    assert set(EXCEPTIONS) <= over


def imported(place: str) -> set[str]:
    """Return the modules of the program that one imports, as paths below the package."""
    found = set()
    for node in ast.walk(MODULES[place]):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("kagezou"):
            inner = "/".join((node.module or "").split(".")[1:])
            found |= {f"{inner}.py", f"{inner}/__init__.py"}
            found |= {f"{inner}/{alias.name}.py".lstrip("/") for alias in node.names}
    return found & set(MODULES)


def room(place: str) -> str:
    """Return the folder that a module lies in."""
    return place.rpartition("/")[0]


def test_a_class_name_stands_once_among_rooms_that_import_each_other() -> None:
    named = defaultdict(list)
    for place, tree in MODULES.items():
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                named[node.name].append(place)
    near = {(room(place), room(other)) for place in MODULES for other in imported(place)}
    twice = [
        f"{name}: {place} and {other}"
        for name, places in named.items()
        for index, place in enumerate(places)
        for other in places[index + 1 :]
        if room(place) == room(other) or {(room(place), room(other)), (room(other), room(place))} & near
    ]
    assert not twice


@pytest.mark.parametrize("folder", sorted({room(place) for place in MODULES}))
def test_every_room_says_what_it_is_for_what_it_may_use_and_what_it_must_not_know(folder: str) -> None:
    docstring = ast.get_docstring(MODULES[f"{folder}/__init__.py".lstrip("/")]) or ""
    assert not folder or (" may use " in docstring and " must never " in docstring)


def test_no_room_is_called_by_what_anything_could_be() -> None:
    vague = {"utils", "util", "misc", "helpers", "common", "base", "core", "manager"}
    assert not [place for place in MODULES if Path(place).stem in vague or set(Path(place).parts) & vague]
