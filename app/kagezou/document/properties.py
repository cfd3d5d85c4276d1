"""The one table of properties that timeline, inspector, file, command line and exporter share (spec 6).

A new property is one line here.
"""

from types import MappingProxyType

from kagezou.document.property import Kind, Property, Scope, Words

FOV = Property(
    "camera.fov", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Words("Field of view", "視野角"),
    Words("Vertical field of view of the camera; 0 is orthographic.", "カメラの垂直視野角。0 で平行投影。"),
    unit="°", low=0.0, high=120.0,
)  # fmt: skip
GROUND_POSITION = Property(
    "ground.position", Kind.POINT, Scope.DOCUMENT, (0.0, 0.0),
    Words("Ground position", "地面の位置"),
    Words("A point of the ground line, where the ground meets the drawing.", "地面がセルと交わる接地ライン上の点。"),
    unit="px",
)  # fmt: skip
GROUND_ROLL = Property(
    "ground.roll", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Words("Ground roll", "地面の回転"),
    Words("Turn of the ground line in the picture.", "画面内での接地ラインの傾き。"),
    unit="°", low=-90.0, high=90.0,
)  # fmt: skip
GROUND_DECLINATION = Property(
    "ground.declination", Kind.NUMBER, Scope.DOCUMENT, 60.0,
    Words("Declination", "地面の角度"),
    Words("Angle between drawing and ground; 90 is seen edge-on, less is seen from higher.",
          "セル面と地面の角度。90 で真横、小さいほど上から見下ろす。"),
    unit="°", low=1.0, high=90.0,
)  # fmt: skip
LIGHT_KIND = Property(
    "light.kind", Kind.CHOICE, Scope.DOCUMENT, "point",
    Words("Light", "ライト"),
    Words("A lamp at a position, or the sun in a direction.", "位置を持つランプ、または方向だけの太陽。"),
    choices=("point", "sun"),
)  # fmt: skip
LIGHT_POSITION = Property(
    "light.position", Kind.PLACE, Scope.DOCUMENT, (0.0, -600.0, 900.0),
    Words("Light position", "ライトの位置"),
    Words("Where the lamp stands; z > 0 is on the viewer's side and throws shadows behind the character.",
          "ランプの位置。z が正なら手前側にあり、影は奥へ落ちる。"),
    unit="px",
)  # fmt: skip
LIGHT_AZIMUTH = Property(
    "light.azimuth", Kind.NUMBER, Scope.DOCUMENT, 35.0,
    Words("Sun azimuth", "太陽の方位"),
    Words("Direction of the sun around the ground; 0 stands on the viewer's side.", "太陽の方位角。0 で手前側。"),
    unit="°", low=-36000.0, high=36000.0,
)  # fmt: skip
LIGHT_ELEVATION = Property(
    "light.elevation", Kind.NUMBER, Scope.DOCUMENT, 45.0,
    Words("Sun elevation", "太陽の高さ"),
    Words("Height of the sun over the ground; a low sun throws long shadows.",
          "地面からの太陽の高度。低いほど影が長い。"),
    unit="°", low=-90.0, high=90.0,
)  # fmt: skip
OVERHEAD_RADIUS = Property(
    "light.overhead_radius", Kind.NUMBER, Scope.DOCUMENT, 0.0,
    Words("Overhead radius", "真上ライトの範囲"),
    Words("Within this distance over the character the lamp is spread into four, so that light from straight above "
          "still casts.", "キャラの真上でこの距離以内のランプを四つに分け、真上の光でも影を落とす。"),
    unit="px", low=0.0, high=100000.0,
)  # fmt: skip

GROUNDING = Property(
    "grounding", Kind.POINTS, Scope.LAYER, (),
    Words("Grounding points", "接地点"),
    Words("Where the character touches the ground; with two or more the card is folded through them.",
          "キャラが地面に触れる点。二つ以上でセル面が点を通って曲がる。"),
    unit="px",
)  # fmt: skip
TILT = Property(
    "tilt", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Body tilt", "体の傾き"),
    Words("Turn of the body about the vertical; measured, not set, with two grounding points.",
          "垂直軸まわりの体の向き。接地点が二つあるときは自動で決まる。"),
    unit="°", low=-75.0, high=75.0,
)  # fmt: skip
VISIBLE = Property(
    "visible", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Words("Visible", "表示"),
    Words("Whether the layer and its shadow are shown and rendered.", "レイヤーとその影を表示・書き出しするか。"),
)  # fmt: skip
MATTE = Property(
    "shadow.matte", Kind.CHOICE, Scope.LAYER, "solid",
    Words("Matte", "マット"),
    Words("Solid: half-opaque and more casts fully; translucent: alpha casts as it is (smoke, glass).",
          "solid は半透明以上がすべて影、translucent はアルファのまま影（煙・ガラス）。"),
    choices=("solid", "translucent"),
)  # fmt: skip
SIMPLIFY = Property(
    "shadow.simplify", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Simplify", "単純化"),
    Words("How far the shape is rounded toward an ellipse; its edge stays crisp and its area stays the same.",
          "影の形を楕円へ近づける度合い。輪郭はくっきりしたまま、面積も変わらない。"),
    unit="px", low=0.0, high=500.0,
)  # fmt: skip
DISTANCE = Property(
    "shadow.distance", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Distance", "距離"),
    Words("Over this distance from the feet the rounding grows to its full strength; 0 rounds everywhere alike.",
          "足元からこの距離までに単純化が強まる。0 なら全体に同じ強さ。"),
    unit="px", low=0.0, high=5000.0,
)  # fmt: skip
COLOR = Property(
    "shadow.color", Kind.COLOR, Scope.LAYER, "#20203A",
    Words("Colour", "色"),
    Words("Colour of the shadow, sRGB.", "影の色（sRGB）。"),
)  # fmt: skip
OPACITY = Property(
    "shadow.opacity", Kind.NUMBER, Scope.LAYER, 0.6,
    Words("Opacity", "不透明度"),
    Words("Opacity of the shadow, 0 to 1.", "影の不透明度（0〜1）。"),
    low=0.0, high=1.0,
)  # fmt: skip
BLEND = Property(
    "shadow.blend", Kind.CHOICE, Scope.LAYER, "multiply",
    Words("Blend", "合成モード"),
    Words("How the shadow lies on what is under it.", "影を下の絵に重ねる方法。"),
    choices=("multiply", "normal"),
)  # fmt: skip

TABLE: tuple[Property, ...] = (
    FOV, GROUND_POSITION, GROUND_ROLL, GROUND_DECLINATION,
    LIGHT_KIND, LIGHT_POSITION, LIGHT_AZIMUTH, LIGHT_ELEVATION, OVERHEAD_RADIUS,
    GROUNDING, TILT, VISIBLE, MATTE, SIMPLIFY, DISTANCE, COLOR, OPACITY, BLEND,
)  # fmt: skip
"""Every property, in the order in which people read them."""

OF_DOCUMENT = MappingProxyType({line.name: line for line in TABLE if line.scope is Scope.DOCUMENT})
OF_LAYER = MappingProxyType({line.name: line for line in TABLE if line.scope is Scope.LAYER})
