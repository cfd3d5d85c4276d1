"""The website's reference of properties, from the property table, with the words that the window has for them."""

from collections.abc import Iterator, Sequence
from typing import Final

from kagezou.document.properties import TABLE
from kagezou.document.property import MAX_COORDINATE_PX, AnyProperty, Kind, Scope, Usual
from kagezou.ui.help.pages import MOST_TURNS_DEG
from kagezou.ui.panels.groups import Group, group_of
from kagezou.ui.system.words import choice_name, translated

TITLES: Final = {"en": "Properties", "ja": "プロパティ"}
_SAYS: Final = {
    "en": "Every property there is, as `kagezou set P.kage PATH=VALUE` takes it and as it can be keyed. NAME is the "
    "name of a layer or of a set piece. Lengths are px of the canvas, angles degrees.",
    "ja": "すべてのプロパティです。`kagezou set P.kage PATH=VALUE` で決められ、キーも付けられます。"
    "NAME はレイヤーかセットの部品の名前です。長さはキャンバスの px、角度は度です。",
}
_HEADS: Final = {
    "en": ("property", "path", "values", "default", "what it does"),
    "ja": ("プロパティ", "パス", "値", "初期値", "はたらき"),
}
_KINDS: Final = {
    "en": {
        Kind.NUMBER: "number",
        Kind.POINT: "X,Y",
        Kind.PLACE: "X,Y,Z",
        Kind.POINTS: "any number of [X,Y]",
        Kind.COLOR: "`#RRGGBB`, sRGB",
        Kind.SWITCH: "`true` or `false`",
    },
    "ja": {
        Kind.NUMBER: "数",
        Kind.POINT: "X,Y",
        Kind.PLACE: "X,Y,Z",
        Kind.POINTS: "任意の数の [X,Y]",
        Kind.COLOR: "`#RRGGBB`、sRGB",
        Kind.SWITCH: "`true` か `false`",
    },
}
_USUAL: Final = {
    "en": {Usual.CANVAS_MIDDLE: "the middle of the canvas", Usual.DRAWING_MIDDLE: "the middle of the layer's drawing"},
    "ja": {Usual.CANVAS_MIDDLE: "キャンバスの中心", Usual.DRAWING_MIDDLE: "レイヤーのセルの中心"},
}
_OWNERS: Final = {Scope.DOCUMENT: "", Scope.LAYER: "layers.NAME.", Scope.PIECE: "set.NAME."}


def properties_page(language: str) -> Iterator[str]:
    """Yield the lines of the reference; words are those of the language that is spoken at the time."""
    yield from (f"# {TITLES[language]}", "", _SAYS[language], "")
    for group in Group:
        props = [prop for prop in TABLE if group_of(prop) is group]
        yield from (f"## {group.title}", "", _row(_HEADS[language]), _row(["---"] * len(_HEADS[language])))
        yield from (_row(_cells(prop, language)) for prop in props)
        yield ""


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _cells(prop: AnyProperty, language: str) -> list[str]:
    path = f"`{_OWNERS[prop.scope]}{prop.name}`"
    return [translated(prop.label), path, _values(prop, language), _default(prop, language), translated(prop.help)]


def _values(prop: AnyProperty, language: str) -> str:
    if prop.kind is Kind.CHOICE:
        return ", ".join(f"`{choice}` {choice_name(choice)}" for choice in prop.choices)
    unit = f" {prop.unit}".rstrip()
    most = MOST_TURNS_DEG if prop.unit == "°" else MAX_COORDINATE_PX
    if prop.kind is Kind.NUMBER and prop.high < most:
        return f"{prop.low:g} – {prop.high:g}{unit}"
    return f"{_KINDS[language][prop.kind]}{unit}"


def _default(prop: AnyProperty, language: str) -> str:
    if prop.usual is not Usual.DEFAULT:
        return _USUAL[language][prop.usual]
    match prop.default:
        case bool():
            return f"`{str(prop.default).lower()}`"
        case tuple():
            return f"`{','.join(f'{number:g}' for number in prop.default)}`" if prop.default else "–"
        case float():
            return f"`{prop.default:g}`"
        case _:
            return f"`{prop.default}`"
