"""``kagezou style``: puts a named look on a character, or lists the looks there are."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, did_you_mean, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import give, tell
from kagezou.errors import UsageProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document
    from kagezou.document.style import Style

DESCRIPTION = """\
Put a style, a named set of the shadow's properties, on one character or on all. Properties that have keys get a key on
--frame. Without a style, list those there are: the program's own and the ones saved in the window."""
EXAMPLES = """\
  kagezou style
  kagezou style walk.kage water
  kagezou style walk.kage "Long evening" --layer Hero --frame 12
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", nargs="?", type=project_path, metavar="PROJECT.kage", help="the project to change")
    parser.add_argument("style", nargs="?", metavar="STYLE", help="its name in English or Japanese")
    parser.add_argument("--layer", metavar="NAME", help="the character (all of them)")
    parser.add_argument("--frame", type=int, default=1, metavar="N", help="where keyed properties get their key (1)")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """List the styles, or load, change and write the project."""
    from kagezou.document.style import apply_style
    from kagezou.io.project.file import load, save

    styles = _styles()
    if options.style is None:
        if options.project is not None:
            raise UsageProblem(Message("which style? (kagezou style lists them)"))
        give("\n".join(f"{each.name.en}\t{each.name.in_language('ja')}" for each in styles.values()))
        return 0
    wanted = options.style.casefold()
    style = next(
        (
            each
            for each in styles.values()
            if wanted in (each.name.en.casefold(), each.name.in_language("ja").casefold())
        ),
        None,
    )
    if style is None:
        hint = did_you_mean(options.style, list(styles)) or Message("; kagezou style lists them")
        raise UsageProblem(Message("there is no style {style!r}{hint}", style=options.style, hint=hint))
    before = document = load(options.project)
    for layer_id in _layer_ids(document, options.layer):
        document = apply_style(document, layer_id, style, options.frame)
    if document is not before:
        save(document, options.project)
    return 0


def _styles() -> "dict[str, Style]":
    import platformdirs

    from kagezou.io.clips.style_files import bundled_styles, own_styles

    own, problems = own_styles(Path(platformdirs.user_config_path("kagezou", appauthor=False)) / "styles")
    for problem in problems:
        tell(str(problem))
    return {each.style.name.en: each.style for each in (*bundled_styles(), *own)}


def _layer_ids(document: "Document", name: str | None) -> list[str]:
    ids = [layer.id for layer in document.layers if name in (None, layer.name)]
    if not ids:
        known = ", ".join(repr(layer.name) for layer in document.layers) or "none at all"
        raise UsageProblem(Message("there is no layer {name!r} in this project, only {known}", name=name, known=known))
    return ids
