"""What is promised: the names, their signatures, and that looking at them costs nothing."""

import dataclasses
import inspect
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import kagezou
from tests.cli.projects import make_drawings

PROMISED = Path(__file__).with_name("promised.txt")

_NOT_PROMISED = ("formatted", "sentence")
"""Of problems: for the window, which translates them."""


def lines() -> Iterator[str]:
    """Yield a line for each public name and each public member."""
    for name in kagezou.__all__:
        thing = getattr(kagezou, name)
        if inspect.isclass(thing):
            yield f"class {name}({', '.join(each.__name__ for each in thing.__bases__)})"
            yield from (f"    {line}" for line in members(thing))
        elif callable(thing):
            yield f"{name}{signature(thing)}"
        else:
            yield f"{name}: {type(thing).__name__}"


def members(thing: type) -> Iterator[str]:
    if dataclasses.is_dataclass(thing):
        for each in dataclasses.fields(thing):
            if not each.name.startswith("_"):
                default = "" if each.default is dataclasses.MISSING else f" = {each.default!r}"
                yield f"{each.name}: {plain(each.type)}{default}"
    elif issubclass(thing, tuple):
        yield from (f"{each}: {plain(kind)}" for each, kind in inspect.get_annotations(thing).items())
    for name, member in sorted(vars(thing).items()):
        if name.startswith("_") or name in _NOT_PROMISED:
            continue
        if isinstance(member, property):
            yield f"{name}: {plain(inspect.signature(member.fget).return_annotation)}"  # type: ignore[arg-type]
        elif inspect.isfunction(member):
            yield f"{name}{signature(member)}"


def signature(function: object) -> str:
    return plain(inspect.signature(function))  # type: ignore[arg-type]


def plain(thing: object) -> str:
    """Return a type as text that is the same with every version of Python."""
    text = thing.__name__ if isinstance(thing, type) and not getattr(thing, "__args__", ()) else str(thing)
    text = re.sub(r"<function (\w+) at 0x[0-9a-f]+>", r"\1", text)
    # NumPy and Python say differently from version to version what an array is, and of what.
    text = re.sub(r"\b(?:ndarray|NDArray)\[.*\]", "ndarray", text)
    return re.sub(r"(?<![\w.])(?:\w+\.)+(\w+)", r"\1", text).replace("'", "")


def test_names_and_signatures_are_those_that_were_promised() -> None:
    found = "\n".join(lines()) + "\n"
    assert found == PROMISED.read_text(encoding="utf-8"), (
        "the Python interface has changed: write it down in promised.txt, and in CHANGELOG.md; "
        "what goes or means something else raises the major version"
    )


def test_every_public_name_is_described() -> None:
    described = [kagezou.open, kagezou.new, kagezou.edit, kagezou.styles]
    assert all(each.__doc__ for each in described)
    manuals = Path(kagezou.__file__).parents[2] / "docs"
    for page in (manuals / "en" / "python.md", manuals / "ja" / "python.md"):
        text = page.read_text(encoding="utf-8")
        missing = [name for name in kagezou.__all__ if f"`{name}" not in text and f"`kagezou.{name}" not in text]
        assert not missing, page


def python(program: str) -> str:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def test_importing_it_imports_nothing_heavy() -> None:
    heavy = ["numpy", "OpenGL", "OpenImageIO", "PIL", "psd_tools", "PySide6"]
    program = f"import sys, kagezou; kagezou.__version__; dir(kagezou); print([n for n in {heavy} if n in sys.modules])"
    assert python(program) == "[]"


def test_nothing_of_qt_is_imported_where_pictures_are_drawn(tmp_path: Path) -> None:
    folder = make_drawings(tmp_path / "a", 1)
    program = (
        "import sys, kagezou\n"
        f"cut = kagezou.new({{'A': {str(folder)!r}}})\n"
        "print(len(list(cut.pictures('composite', '1'))), any(n.startswith('PySide6') for n in sys.modules))\n"
    )
    expected = "1 False" if sys.platform == "linux" else "1 True"
    assert python(program) == expected


def test_a_name_that_is_not_there(tmp_path: Path) -> None:
    """The type checker is told of it, too: an ignored complaint that there is not would be one."""
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        kagezou.nothing  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(AttributeError):
        kagezou.new(make_drawings(tmp_path / "a", 1)).with_valu("light.kind", "sun")  # type: ignore[attr-defined]
    assert set(kagezou.__all__) <= set(dir(kagezou))
