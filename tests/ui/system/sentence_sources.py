"""The English sentences that may reach the window, as the program's sources write them.

A sentence is what a problem is made of, what says a cause, and what is noted about files. Where values are put in, the
template has ``{}``.
"""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import kagezou

SOURCES = Path(kagezou.__file__).parent
_ELSEWHERE = ("cli", "__main__.py")
"""Rooms whose sentences only the terminal says."""

_MAKERS = re.compile(r"\w*Problem|\w*_?problem|_?refused|_number")
_NAMES = frozenset({"notes", "cause", "why", "wanted", "hint", "inside", "rest", "_CAUSES"})
_FUNCTIONS = re.compile(r"cause_of|_left_out|\w*_notes?(_\w+)?")
_WORDS = re.compile(r"[A-Za-z]+ |[ ;] *[a-z]+")


@dataclass(frozen=True, slots=True)
class Sentence:
    """A template, and where it stands."""

    template: str
    where: str


def sentences() -> list[Sentence]:
    """Return every sentence once, in the order of the files."""
    found: dict[str, Sentence] = {}
    for file in sorted(SOURCES.rglob("*.py")):
        inner = file.relative_to(SOURCES)
        if inner.parts[0] in _ELSEWHERE:
            continue
        for node in _said(ast.parse(file.read_text(encoding="utf-8"))):
            for template in _templates(node):
                if _WORDS.search(template):
                    found.setdefault(template, Sentence(template, f"app/kagezou/{inner}:{node.lineno}"))
    return list(found.values())


def _said(tree: ast.Module) -> Iterator[ast.expr]:
    """Yield the expressions that make sentences."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=args) if _MAKERS.fullmatch(name):
                yield from args
            case ast.Call(func=ast.Attribute(value=ast.Name(id=name), attr="append" | "insert"), args=args):
                if name in _NAMES:
                    yield from args
            case ast.Assign(targets=[ast.Name(id=name)], value=value) if name in _NAMES:
                yield from _parts(value)
            case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value) if name in _NAMES:
                yield from _parts(value)
            case ast.AugAssign(target=ast.Name(id=name), value=value) if name in _NAMES:
                yield from _parts(value)
            case ast.FunctionDef(name=name) if _FUNCTIONS.fullmatch(name):
                for inner in ast.walk(node):
                    if isinstance(inner, ast.Return) and inner.value is not None:
                        yield from _parts(inner.value)


def _parts(value: ast.expr) -> Iterator[ast.expr]:
    match value:
        case ast.List(elts=each) | ast.Tuple(elts=each) | ast.Dict(values=each):
            for one in each:
                yield from _parts(one)
        case ast.ListComp(elt=one) | ast.Starred(value=one):
            yield from _parts(one)
        case _:
            yield value


def _templates(node: ast.expr) -> list[str]:
    """Return what an expression may say; nothing where it is no text of its own.

    Values that touch are one, and what is hung onto another sentence has that in front of it.
    """
    match node:
        case ast.Constant(value=str(text)):
            return [f"{{}}{text}" if text[:1] in (" ", ";", ",") else text]
        case ast.JoinedStr(values=values):
            text = "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in values)
            return [re.sub(r"(\{\}){2,}", "{}", f"{{}}{text}" if text[:1] in (" ", ";", ",") else text)]
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return [before + after for before in _templates(left) for after in _templates(right) or ["{}"]]
        case ast.IfExp(body=body, orelse=orelse):
            return _templates(body) + _templates(orelse)
        case ast.BoolOp(values=values):
            return [text for value in values for text in _templates(value)]
        case _:
            return []
