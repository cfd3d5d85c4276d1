"""``kagezou style``: puts a named look on characters, keeps the look of one, or lists the looks there are."""

from argparse import Namespace
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import give, note, tell
from kagezou.errors import UsageProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document, Layer
    from kagezou.document.style import Style
    from kagezou.document.styling import Styled
    from kagezou.io.clips.style_files import StyleFile

DESCRIPTION = """\
Put a style, a named set of the shadow's properties, on one character or on all, and print what it changes. What a
style does not name goes to its default, so that nothing is left of the style before. Properties that have keys get a
key on --frame. A style's own light is left out unless it is asked for. Without a style, list those there are: the
program's own, the studio's from the folders of KAGEZOU_STYLES, and those of the user."""
EXAMPLES = """\
  kagezou style
  kagezou style walk.kage water
  kagezou style walk.kage "Simple" --layer Hero --frame 12 --dry-run
  kagezou style walk.kage "Long evening" --with-light
  kagezou style walk.kage --save "Our evening" --layer Hero --with-light
"""
_ASKING = "--with-light"


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", nargs="?", type=project_path, metavar="PROJECT.kage", help="the project to change")
    parser.add_argument("style", nargs="?", metavar="STYLE", help="its name in English or Japanese")
    parser.add_argument("--layer", metavar="NAME", help="the character (all of them)")
    parser.add_argument(
        "--frame", type=whole_number, default=1, metavar="N", help="where keyed properties get their key (1)"
    )
    parser.add_argument(
        _ASKING, action="store_true", help="the style's own light too, with ground and set-up where it has them"
    )
    parser.add_argument("--save", metavar="NAME", help="keep the look of a character as a style of your own")
    parser.add_argument("--dry-run", action="store_true", help="print what would change, and write nothing")


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """List the styles; or keep one; or load, change and write the project."""
    from kagezou.io.project.file import load, save

    if options.project is None:
        if options.save is not None:
            raise UsageProblem(Message("--save keeps the look of a character of a project: which project?"))
        give("\n".join(map(_line, styles_there())))
        return 0
    if options.save is not None:
        _keep(load(options.project), options)
        return 0
    if options.style is None:
        raise UsageProblem(Message("which style? (kagezou style lists them)"))
    style = named_style(options.style)
    document = load(options.project)
    styled = _styled(document, style, options)
    _say(document, styled)
    if styled.document is not document and not options.dry_run:
        save(styled.document, options.project)
    return 0


def _line(file: "StyleFile") -> str:
    """Return a style as it is listed: its names, and whether it is the studio's."""
    name = file.style.name
    return f"{name.en}\t{name.in_language('ja')}" + ("\tstudio" if file.is_studio else "")


def _keep(document: "Document", options: Namespace) -> None:
    """Keep the look of the one character that is meant."""
    from kagezou.document.style import style_of
    from kagezou.io.clips.style_files import path_of_style, save_style
    from kagezou.io.files.faults import shown
    from kagezou.locations import own_style_folder

    if options.style is not None:
        raise UsageProblem(Message("put on a style, or keep one with --save, not both at once"))
    layers = _meant(document, options.layer)
    if len(layers) > 1:
        names = ", ".join(repr(layer.name) for layer in layers)
        raise UsageProblem(Message("the look of which character? --layer names one of {names}", names=names))
    folder = own_style_folder()
    style = style_of(document, layers[0].id, options.frame, options.save, with_scene=options.with_light)
    path = path_of_style(folder, style)
    if path.exists():
        note(Message("{path} is replaced", path=shown(path)))
    if not options.dry_run:
        save_style(folder, style)
    give(str(path))


def _styled(document: "Document", style: "Style", options: Namespace) -> "Styled":
    """Return the document in the style; refused where its light is asked for and cannot come."""
    from kagezou.document.styling import LeftOut, put_style

    ids = [layer.id for layer in _meant(document, options.layer)]
    styled = put_style(document, ids, style, options.frame, with_light=options.with_light)
    if styled.left_out is LeftOut.NOT_EVERYBODY:
        raise UsageProblem(
            Message(
                "{style} would change the light of all characters: --with-light and --layer do not go together",
                style=style.name.en,
            )
        )
    if options.with_light and not style.scene:
        note(Message("{style} has no light of its own", style=style.name.en))
    return styled


def _say(before: "Document", styled: "Styled") -> None:
    """Give a line for each property that is seen otherwise than before, and say what there is to know."""
    from kagezou.document.address import path_of
    from kagezou.document.styling import notes_on
    from kagezou.document.value_words import text_of_value
    from kagezou.scene.misfits import misfits_of, new_misfits

    for change in styled.changes:
        values = f"{text_of_value(change.before)} -> {text_of_value(change.after)}"
        give(f"{path_of(before, change.address)} {values}")
    for sentence in notes_on(styled, styled.style.name.en, _ASKING, lambda address: path_of(before, address)):
        note(sentence)
    for misfit in new_misfits(misfits_of(before), misfits_of(styled.document)):
        note(misfit.message)


def named_style(name: str) -> "Style":
    """Return the style of a name, in English or Japanese, whatever its case.

    Raises
    ------
    UsageProblem
        There is none.
    """
    from kagezou.io.clips import style_files

    return style_files.named_style(name, styles_there())


def styles_there() -> "tuple[StyleFile, ...]":
    """Return the styles there are; files and folders that cannot be read are told."""
    from kagezou.io.clips import style_files
    from kagezou.locations import own_style_folder

    found, problems = style_files.styles_there(own_style_folder())
    for problem in problems:
        tell(str(problem))
    return found


def _meant(document: "Document", name: str | None) -> "list[Layer]":
    """Return the layer of a name, or without one every figure's."""
    from kagezou.document.layer_named import layer_named

    if name is not None:
        return [layer_named(document, name)]
    found = [layer for layer in document.layers if layer.joins is None]
    if not found:
        raise UsageProblem(Message("there is no character in this project"))
    return found
