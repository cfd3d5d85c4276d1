"""The one table of properties that timeline, inspector, file, command line and exporter share (spec 6).

A new property is one line here.
"""

from dataclasses import dataclass
from types import MappingProxyType

from kagezou.document.property import AnyProperty, Kind, Property, Scope, Words
from kagezou.document.set_properties import SET_LINES
from kagezou.geometry.vectors import Point2

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
    slides=(1.0, 90.0),
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

GROUNDING: Property[tuple[Point2, ...]] = Property(
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
RECEIVES = Property(
    "receives", Kind.SWITCH, Scope.LAYER, False,  # noqa: FBT003 - a default, named by its column
    Words("Receives shadows", "影を受ける"),
    Words("Whether the shadows of the other characters fall on this one, where the light meets them first.",
          "ほかのキャラの影がこのキャラに落ちるか（光源から見て手前にいるキャラの影だけ）。"),
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
    slides=(0.0, 200.0),
)  # fmt: skip
DISTANCE = Property(
    "shadow.distance", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Distance", "距離"),
    Words("Over this distance from the feet the rounding grows to its full strength; 0 rounds everywhere alike.",
          "足元からこの距離までに単純化が強まる。0 なら全体に同じ強さ。"),
    unit="px", low=0.0, high=5000.0,
    slides=(0.0, 600.0),
)  # fmt: skip
SIMPLIFY_ON = Property(
    "shadow.simplify_on", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Words("Simplification", "単純化フィルター"),
    Words("Whether the shape is simplified; off keeps the values and leaves them out.",
          "単純化を使うか。オフでも値は残る。"),
)  # fmt: skip
ELONGATION = Property(
    "shadow.elongation", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Elongation", "長さの維持"),
    Words("0 rounds toward a disc on the ground, 1 toward the shadow's own long ellipse.",
          "0 で地面上の円へ、1 で影そのものの細長い楕円へ近づく。"),
    low=0.0, high=1.0,
    slides=(0.0, 1.0),
)  # fmt: skip
GROW = Property(
    "shadow.grow", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Grow", "拡張"),
    Words("Moves the outline outward, or inward below 0.", "輪郭を外側へ広げる。負の値で縮める。"),
    unit="px", low=-100.0, high=100.0,
    slides=(-20.0, 20.0),
)  # fmt: skip
SOFTNESS = Property(
    "shadow.softness", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Softness", "ぼかし"),
    Words("Width of the edge; 0 is a crisp cel edge.", "エッジの幅。0 でくっきりしたセルのエッジ。"),
    unit="px", low=0.0, high=200.0,
    slides=(0.0, 60.0),
)  # fmt: skip
PENUMBRA = Property(
    "shadow.penumbra", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Penumbra", "半影"),
    Words("How much wider the edge grows with every px of distance from the feet.",
          "足元から 1px 離れるごとにエッジが広がる量。"),
    low=0.0, high=1.0,
    slides=(0.0, 0.3),
)  # fmt: skip
FADE = Property(
    "shadow.fade", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Fade", "フェード"),
    Words("At this distance from the feet the shadow has faded away; 0 does not fade.",
          "足元からこの距離で影が消える。0 で消えない。"),
    unit="px", low=0.0, high=10000.0,
    slides=(0.0, 2000.0),
)  # fmt: skip
FADE_CURVE = Property(
    "shadow.fade_curve", Kind.NUMBER, Scope.LAYER, 1.0,
    Words("Fade curve", "フェードの曲線"),
    Words("1 fades evenly, more fades early, less fades late.", "1 で均一、大きいと早く、小さいと遅く薄れる。"),
    low=0.1, high=10.0,
    slides=(0.1, 4.0),
)  # fmt: skip
TIP_COLOR = Property(
    "shadow.tip_color", Kind.COLOR, Scope.LAYER, "#4A4A7A",
    Words("Tip colour", "先端の色"),
    Words("Colour toward the tip, where a tip distance is set; sRGB.", "先端の距離を設定したときの先端の色（sRGB）。"),
)  # fmt: skip
TIP_DISTANCE = Property(
    "shadow.tip_distance", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Tip distance", "先端の距離"),
    Words("At this distance from the feet the shadow has the tip colour; 0 keeps one colour.",
          "足元からこの距離で先端の色になる。0 で一色のまま。"),
    unit="px", low=0.0, high=10000.0,
    slides=(0.0, 2000.0),
)  # fmt: skip
TIMING = Property(
    "shadow.timing", Kind.CHOICE, Scope.LAYER, "ones",
    Words("Shadow timing", "影のコマ打ち"),
    Words("On ones the shadow moves every frame; with the exposures it waits for the next drawing.",
          "ones は毎コマ動き、exposures は次の絵まで動かない。"),
    choices=("ones", "exposures"),
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
    slides=(0.0, 1.0),
)  # fmt: skip
BLEND = Property(
    "shadow.blend", Kind.CHOICE, Scope.LAYER, "multiply",
    Words("Blend", "合成モード"),
    Words("How the shadow lies on what is under it.", "影を下の絵に重ねる方法。"),
    choices=("multiply", "normal"),
)  # fmt: skip

WAVES_ON = Property(
    "shadow.waves_on", Kind.SWITCH, Scope.LAYER, True,  # noqa: FBT003 - a default, named by its column
    Words("Waves", "波フィルター"),
    Words("Whether the shadow lies on water; off keeps the values and leaves them out.",
          "影を水面に落とすか。オフでも値は残る。"),
)  # fmt: skip
WAVE_SEED = Property(
    "shadow.wave_seed", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Wave seed", "波の乱数"),
    Words("0 takes the waves as they are set; any other whole number varies them, always in the same way.",
          "0 で設定どおりの波。ほかの整数では、その数ごとに決まった変化を付ける。"),
    low=0.0, high=999999.0,
)  # fmt: skip
WAVE_ANCHOR = Property(
    "shadow.wave_anchor", Kind.NUMBER, Scope.LAYER, 0.0,
    Words("Wave anchor", "波の固定"),
    Words("Over this distance from the feet the waves grow to their full strength; 0 moves the feet too.",
          "足元からこの距離までに波が強まる。0 なら足元も揺れる。"),
    unit="px", low=0.0, high=5000.0,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class WaveLines:
    """The properties of one set of waves (spec 4)."""

    amplitude: Property[float]
    wavelength: Property[float]
    direction: Property[float]
    velocity: Property[float]


def _wave(number: int, wavelength_px: float, direction_deg: float, velocity_px: float) -> WaveLines:
    path = f"shadow.wave{number}"
    return WaveLines(
        Property(
            f"{path}.amplitude", Kind.NUMBER, Scope.LAYER, 0.0,
            Words(f"Wave {number} amplitude", f"波{number} 振幅"),
            Words("How far the waves move the shadow; 0 is no wave.", "波が影を動かす量。0 で波なし。"),
            unit="px", low=0.0, high=500.0, slides=(0.0, 60.0),
        ),
        Property(
            f"{path}.wavelength", Kind.NUMBER, Scope.LAYER, wavelength_px,
            Words(f"Wave {number} length", f"波{number} 波長"),
            Words("From crest to crest on the ground.", "地面上での山から山までの長さ。"),
            unit="px", low=4.0, high=10000.0, slides=(10.0, 300.0),
        ),
        Property(
            f"{path}.direction", Kind.NUMBER, Scope.LAYER, direction_deg,
            Words(f"Wave {number} direction", f"波{number} 方向"),
            Words("Where the crests go on the ground; 0 is to the right, 90 toward the viewer.",
                  "地面上で波が進む向き。0 で右、90 で手前。"),
            unit="°", low=-36000.0, high=36000.0,
        ),
        Property(
            f"{path}.velocity", Kind.NUMBER, Scope.LAYER, velocity_px,
            Words(f"Wave {number} speed", f"波{number} 速さ"),
            Words("How far the crests go in a frame.", "1 コマで波が進む距離。"),
            unit="px", low=-1000.0, high=1000.0, slides=(-20.0, 20.0),
        ),
    )  # fmt: skip


WAVE1 = _wave(1, 60.0, 90.0, 3.0)
WAVE2 = _wave(2, 37.0, 70.0, 2.0)

TABLE: tuple[AnyProperty, ...] = (
    FOV, GROUND_POSITION, GROUND_ROLL, GROUND_DECLINATION,
    LIGHT_KIND, LIGHT_POSITION, LIGHT_AZIMUTH, LIGHT_ELEVATION, OVERHEAD_RADIUS,
    GROUNDING, TILT, VISIBLE, RECEIVES, TIMING, MATTE,
    SIMPLIFY_ON, SIMPLIFY, DISTANCE, ELONGATION, GROW, SOFTNESS, PENUMBRA,
    COLOR, OPACITY, BLEND, FADE, FADE_CURVE, TIP_COLOR, TIP_DISTANCE,
    WAVES_ON, WAVE1.amplitude, WAVE1.wavelength, WAVE1.direction, WAVE1.velocity,
    WAVE2.amplitude, WAVE2.wavelength, WAVE2.direction, WAVE2.velocity, WAVE_ANCHOR, WAVE_SEED,
    *SET_LINES,
)  # fmt: skip
"""Every property, in the order in which people read them."""

OF_DOCUMENT = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.DOCUMENT})
OF_LAYER = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.LAYER})
OF_PIECE = MappingProxyType({prop.name: prop for prop in TABLE if prop.scope is Scope.PIECE})
