"""The lines of the property table for set pieces: ``set.NAME.*``, and the look of the set's own shadow."""

from kagezou.document.property import AnyProperty, Kind, Property, Scope, Words
from kagezou.geometry.sets.measures import PieceKind

UP_AXES = ("y", "z")
DISPLAYS = ("none", "wireframe", "clay")

GROUND_RECEIVES = Property(
    "ground.receives", Kind.SWITCH, Scope.DOCUMENT, True,  # noqa: FBT003 - a default, named by its column
    Words("Flat ground", "平らな地面"),
    Words("Whether shadows fall on the flat ground; off where an imported set is all there is.",
          "平らな地面に影を落とすか。読み込んだセットだけを使うときはオフ。"),
)  # fmt: skip

PIECE_KIND = Property(
    "kind", Kind.CHOICE, Scope.PIECE, "wall",
    Words("Shape", "形"),
    Words("What the piece is; it keeps its place and its measures.", "セットの形。位置と寸法はそのまま。"),
    choices=tuple(kind.value for kind in PieceKind),
)  # fmt: skip
PIECE_PRESENT = Property(
    "present", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Words("In the set", "使用"),
    Words("Whether the piece is there at all.", "このセットを使うかどうか。"),
)  # fmt: skip
PIECE_POSITION = Property(
    "position", Kind.POINT, Scope.PIECE, (0.0, 0.0),
    Words("Place", "位置"),
    Words("The point of the ground on which the middle of the piece stands, as it is seen on the canvas.",
          "セットの中心が立つ地面上の点（画面上の位置）。"),
    unit="px",
)  # fmt: skip
PIECE_ANGLE = Property(
    "angle", Kind.NUMBER, Scope.PIECE, 0.0,
    Words("Turn", "回転"),
    Words("Turn about the vertical of the ground; at 0 the front is the viewer's side.",
          "地面に垂直な軸まわりの回転。0 で正面が手前を向く。"),
    unit="°", low=-36000.0, high=36000.0, slides=(-180.0, 180.0),
)  # fmt: skip
PIECE_LEAN = Property(
    "lean", Kind.NUMBER, Scope.PIECE, 0.0,
    Words("Lean", "傾斜"),
    Words("How far a wall leans back; below 0 it leans over its front.", "壁を奥へ倒す角度。負の値で手前へ倒れる。"),
    unit="°", low=-80.0, high=80.0, slides=(-60.0, 60.0),
)  # fmt: skip
PIECE_WIDTH = Property(
    "width", Kind.NUMBER, Scope.PIECE, 400.0,
    Words("Width", "幅"),
    Words("Canvas px at the depth where the piece stands; of a cylinder or a sphere the diameter.",
          "セットが立つ奥行きでの画面上の px。円柱と球では直径。"),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_HEIGHT = Property(
    "height", Kind.NUMBER, Scope.PIECE, 300.0,
    Words("Height", "高さ"),
    Words("Canvas px at the depth where the piece stands; a sphere is as high as it is wide.",
          "セットが立つ奥行きでの画面上の px。球では使わない。"),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_DEPTH = Property(
    "depth", Kind.NUMBER, Scope.PIECE, 200.0,
    Words("Depth", "奥行き"),
    Words("From front to back on the ground, canvas px at the depth where the piece stands: of boxes, steps and ramps.",
          "地面上の手前から奥までの長さ。箱・階段・スロープで使う。"),
    unit="px", low=1.0, high=100000.0, slides=(1.0, 2000.0),
)  # fmt: skip
PIECE_COUNT = Property(
    "count", Kind.NUMBER, Scope.PIECE, 4.0,
    Words("Steps", "段数"),
    Words("How many steps there are; taken as a whole number.", "階段の段数（整数に丸める）。"),
    low=1.0, high=40.0, slides=(1.0, 20.0),
)  # fmt: skip
PIECE_RECEIVES = Property(
    "receives", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Words("Receives", "影を受ける"),
    Words("Whether the characters' shadows fall on it; it hides what is behind it in either case.",
          "キャラの影がこのセットに落ちるか。オフでも後ろの影は隠す。"),
)  # fmt: skip
PIECE_BLOCKS = Property(
    "blocks", Kind.SWITCH, Scope.PIECE, True,  # noqa: FBT003 - a default, named by its column
    Words("Blocks light", "光をさえぎる"),
    Words("Whether the characters' shadows end where this piece takes the light.",
          "このセットが光をさえぎる場所でキャラの影を切るか。"),
)  # fmt: skip
PIECE_CASTS = Property(
    "casts", Kind.SWITCH, Scope.PIECE, False,  # noqa: FBT003 - a default, named by its column
    Words("Casts a shadow", "影を落とす"),
    Words("Whether its own shadow is drawn, on itself, the ground and the other pieces; it then blocks light too.",
          "自身の影を地面やほかのセットに描くか。オンなら光もさえぎる。"),
)  # fmt: skip

PIECE_SCALE = Property(
    "scale", Kind.NUMBER, Scope.PIECE, 100.0,
    Words("Scale", "スケール"),
    Words("Of an imported set: canvas px for one unit of the file, at the depth where it stands.",
          "読み込んだセットの大きさ。ファイルの1単位が、立つ奥行きで何 px か。"),
    unit="px", low=1e-6, high=1e6,
)  # fmt: skip
PIECE_UP = Property(
    "up", Kind.CHOICE, Scope.PIECE, "y",
    Words("Up axis", "上方向の軸"),
    Words("Which axis of the file of an imported set points up.", "読み込んだセットのファイルで上を向く軸。"),
    choices=UP_AXES,
)  # fmt: skip
PIECE_ANCHOR = Property(
    "anchor", Kind.PLACE, Scope.PIECE, (0.0, 0.0, 0.0),
    Words("Anchor", "基準点"),
    Words("The point of an imported set, in the units of its file, that stands on the ground at the piece's place.",
          "セットの位置で地面に立つ点（ファイルの単位）。"),
)  # fmt: skip
PIECE_DISPLAY = Property(
    "display", Kind.CHOICE, Scope.PIECE, "wireframe",
    Words("Drawn as", "表示方法"),
    Words("How an imported set is drawn: not at all, as a wireframe in the window only, or as clay in composites too.",
          "読み込んだセットの表示。ワイヤーフレームは画面のみ、クレイは合成にも入る。"),
    choices=DISPLAYS,
)  # fmt: skip
PIECE_UNDER = Property(
    "under", Kind.SWITCH, Scope.PIECE, False,  # noqa: FBT003 - a default, named by its column
    Words("Under the background", "背景の下"),
    Words("Whether an imported set is drawn under the background picture rather than over it.",
          "読み込んだセットを背景の上ではなく下に描く。"),
)  # fmt: skip

SET_COLOR = Property(
    "set.shadow.color", Kind.COLOR, Scope.DOCUMENT, "#20203A",
    Words("Set shadow colour", "セットの影の色"),
    Words("Colour of the shadow that set pieces cast, sRGB.", "セットが落とす影の色（sRGB）。"),
)  # fmt: skip
SET_OPACITY = Property(
    "set.shadow.opacity", Kind.NUMBER, Scope.DOCUMENT, 0.6,
    Words("Set shadow opacity", "セットの影の不透明度"),
    Words("Opacity of the shadow that set pieces cast, 0 to 1.", "セットが落とす影の不透明度（0〜1）。"),
    low=0.0, high=1.0, slides=(0.0, 1.0),
)  # fmt: skip
SET_BLEND = Property(
    "set.shadow.blend", Kind.CHOICE, Scope.DOCUMENT, "multiply",
    Words("Set shadow blend", "セットの影の合成モード"),
    Words("How the shadow that set pieces cast lies on what is under it.", "セットの影を下の絵に重ねる方法。"),
    choices=("multiply", "normal"),
)  # fmt: skip

SET_LINES: tuple[AnyProperty, ...] = (
    GROUND_RECEIVES, SET_COLOR, SET_OPACITY, SET_BLEND,
    PIECE_KIND, PIECE_PRESENT, PIECE_POSITION, PIECE_ANGLE, PIECE_LEAN,
    PIECE_WIDTH, PIECE_HEIGHT, PIECE_DEPTH, PIECE_COUNT,
    PIECE_RECEIVES, PIECE_BLOCKS, PIECE_CASTS,
    PIECE_SCALE, PIECE_UP, PIECE_ANCHOR, PIECE_DISPLAY, PIECE_UNDER,
)  # fmt: skip
"""Every line of the set, in the order in which people read them."""
