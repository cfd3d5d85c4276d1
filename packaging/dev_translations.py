"""The catalogues of translations, one file a language, brought up to date from the sources by Qt's own tools.

What the window says stands in ``tr`` and ``translate``, which Qt's tools find. What the rooms below say stands in
``Message(...)``; it is handed to them as a file of calls that they know.
"""

from __future__ import annotations

import ast
import subprocess
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "app" / "kagezou"
CATALOGUES = ROOT / "app" / "resources" / "translations"
CONTEXT = "Message"
_TERMINAL_ONLY = ("cli", "interface", "contexts.py", "__main__.py")
"""Rooms whose messages only the terminal and scripts show, which speak English."""


def messages(sources: Path = SOURCES) -> dict[tuple[str, str], str]:
    """Return the messages that the window may show: text and what it is about, and where it stands first.

    Raises
    ------
    ValueError
        A message's text does not stand literally in its call.
    """
    found: dict[tuple[str, str], str] = {}
    for file in sorted(sources.rglob("*.py")):
        inner = file.relative_to(sources)
        if inner.parts[0] not in _TERMINAL_ONLY:
            for line, literals in _calls(ast.parse(file.read_text(encoding="utf-8"))):
                where = f"app/kagezou/{inner.as_posix()}:{line}"
                if literals is None:
                    raise ValueError(f"{where}: the text of a message stands literally in its call")
                found.setdefault(literals, where)
    return found


def _calls(tree: ast.Module) -> Iterator[tuple[int, tuple[str, str] | None]]:
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id="Message"), args=[ast.Constant(value=str(text))]):
                yield node.lineno, (text, "")
            case ast.Call(
                func=ast.Name(id="Message"), args=[ast.Constant(value=str(text)), ast.Constant(value=str(about))]
            ):
                yield node.lineno, (text, about)
            case ast.Call(func=ast.Name(id="Message")):
                yield node.lineno, None


def update(tools: Path, folder: Path = CATALOGUES) -> None:
    """Add to every catalogue what is new, take away what is gone, and compile it; translations are kept.

    Parameters
    ----------
    tools
        The folder of Qt's ``lupdate`` and ``lrelease``.
    folder
        The catalogues, ``kagezou_CODE.ts``. The English one holds nothing but plural forms.
    """
    window = sorted((SOURCES / "ui").rglob("*.py"))
    with tempfile.TemporaryDirectory() as temporary:
        rest = Path(temporary) / "messages.py"
        rest.write_text(_as_calls(messages()), encoding="utf-8")
        for catalogue in sorted(folder.glob("kagezou_*.ts")):
            code = catalogue.stem.removeprefix("kagezou_")
            plural = ["-pluralonly"] if code == "en" else []
            languages = ["-source-language", "en", "-target-language", code]
            settings = ["-no-obsolete", "-locations", "none", *languages, *plural]
            _run(tools / "lupdate", *window, rest, "-ts", catalogue, *settings)
            _run(tools / "lrelease", catalogue, "-qm", catalogue.with_suffix(".qm"))


def unfinished(folder: Path = CATALOGUES) -> Iterator[str]:
    """Yield the catalogue, the context and the text of whatever is not translated."""
    for catalogue in sorted(folder.glob("kagezou_*.ts")):
        for context in ET.parse(catalogue).getroot().iter("context"):
            for message in context.iter("message"):
                if message.find("translation[@type='unfinished']") is not None:
                    yield f"{catalogue.name}: {context.findtext('name')}: {message.findtext('source')}"


def _as_calls(found: dict[tuple[str, str], str]) -> str:
    lines = (
        f"translate({CONTEXT!r}, {_literal(text)}, {_literal(about)})\n"
        if about
        else f"translate({CONTEXT!r}, {_literal(text)})\n"
        for text, about in found
    )
    return "".join(sorted(lines))


def _literal(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def _run(program: Path, *arguments: object) -> None:
    subprocess.run([str(program), *map(str, arguments)], check=True, capture_output=True, timeout=120)
