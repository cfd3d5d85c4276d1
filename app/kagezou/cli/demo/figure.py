"""The child in the raincoat, drawn from a pose: ink, flat colours and one tone of shade, as on a cel."""

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from kagezou.cli.demo.pose import Foot, Pose, knee_of
from kagezou.cli.demo.shapes import (
    Color,
    DrawnShape,
    PaperSheet,
    Point,
    blended,
    circle,
    cone,
    curve,
    ellipse,
    polygon,
    stroke,
)

INK: Color = (58, 38, 48)
COAT: Color = (250, 202, 72)
COAT_SHADE: Color = (229, 160, 56)
LINING: Color = (171, 108, 50)
SKIN: Color = (255, 228, 208)
SKIN_SHADE: Color = (244, 188, 164)
HAIR: Color = (112, 66, 58)
LEGS: Color = (72, 84, 128)
LEGS_SHADE: Color = (52, 60, 98)
BOOTS: Color = (66, 164, 168)
BOOTS_SHADE: Color = (42, 122, 134)
BALLOON: Color = (236, 94, 84)
BALLOON_SHADE: Color = (202, 62, 70)
BLUSH: Color = (247, 152, 136)
WHITE: Color = (255, 255, 255)
LINE_PX = 4.2
_THIGH, _SHIN = 74.0, 76.0


def drawn(pose: Pose, width_px: int, height_px: int) -> NDArray[np.uint8]:
    """Return the drawing of a pose, straight (H, W, 4)."""
    sheet = PaperSheet(width_px, height_px)
    body = _Body(pose)
    _balloon(sheet, pose)
    _arm(sheet, body, pose.hold, is_near=False)
    _leg(sheet, body, pose.far, is_near=False)
    _leg(sheet, body, pose.near, is_near=True)
    _coat(sheet, body)
    _head(sheet, body)
    _arm(sheet, body, body.free_hand, is_near=True)
    return sheet.pixels()


class _Body:
    """The frame of the body that a pose gives: x forward, y up along the spine, both leaning."""

    def __init__(self, pose: Pose) -> None:
        self.pose = pose
        self.neck = self.at(0, 132)
        self.head = self.at(10, 212)
        self.free_hand = self.at(-14 + 94 * sin(pose.swing), 112 - 94 * cos(pose.swing))

    def at(self, x: float, y: float) -> Point:
        """Return a canvas point of the body's frame."""
        lean, tall = self.pose.lean, y * self.pose.stretch
        wide = x / self.pose.stretch**0.5
        return (
            self.pose.hip[0] + wide * cos(lean) + tall * sin(lean),
            self.pose.hip[1] + wide * sin(lean) - tall * cos(lean),
        )


def _inked(
    sheet: PaperSheet, shape: DrawnShape, fill: Color, shade: Color | None = None, away: Point = (-12, -13)
) -> None:
    """Paint a shape with its outline; its shade is what the shape moved ``away`` leaves uncovered."""
    sheet.paint_inked(shape, LINE_PX, INK, fill)
    if shade is not None:
        sheet.paint(shape - shape.moved(*away), shade)


def _leg(sheet: PaperSheet, body: _Body, foot: Foot, *, is_near: bool) -> None:
    hip = body.at(8 if is_near else -6, 0)
    knee = knee_of(hip, foot.ankle, _THIGH, _SHIN)
    fill = LEGS if is_near else LEGS_SHADE
    _inked(sheet, stroke([hip, knee, foot.ankle], [24, 20, 16]), fill, LEGS_SHADE, (8, -2))
    shaft_x, shaft_y = knee[0] - foot.ankle[0], knee[1] - foot.ankle[1]
    length = max((shaft_x**2 + shaft_y**2) ** 0.5, 1.0)
    top = (foot.ankle[0] + shaft_x / length * 34, foot.ankle[1] + shaft_y / length * 34)
    cosine, sine = cos(foot.pitch), sin(foot.pitch)

    def of_foot(x: float, y: float) -> Point:
        return (foot.ankle[0] + x * cosine - y * sine, foot.ankle[1] + x * sine + y * cosine)

    sole = cone(of_foot(-6, 8), of_foot(34, 10), 18, 16)
    boot = blended(cone(foot.ankle, top, 19, 23), sole, 16)
    flat = polygon([of_foot(-60, -80), of_foot(90, -80), of_foot(90, 26), of_foot(-60, 26)])
    _inked(sheet, boot & flat, BOOTS if is_near else BOOTS_SHADE, BOOTS_SHADE, (6, -9))
    rim = cone(_beside(top, foot.ankle, -17), _beside(top, foot.ankle, 17), 5.5, 5.5)
    _inked(sheet, rim, BOOTS if is_near else BOOTS_SHADE)
    if is_near:
        sheet.paint(ellipse(of_foot(30, 2), 8, 3.2, foot.pitch), WHITE, 0.55)


def _beside(point: Point, toward: Point, offset: float) -> Point:
    """Return the point ``offset`` px beside a line's end, across the line."""
    dx, dy = toward[0] - point[0], toward[1] - point[1]
    length = max((dx * dx + dy * dy) ** 0.5, 1.0)
    return (point[0] - dy / length * offset, point[1] + dx / length * offset)


def _coat(sheet: PaperSheet, body: _Body) -> None:
    sway = body.pose.sway
    flare = 4 * body.pose.joy
    outline = [
        body.at(-22, 138),
        body.at(24, 138),
        body.at(44, 104),
        body.at(62, 50),
        body.at(78 + flare + 0.4 * sway, -22),
        body.at(40 + 0.7 * sway, -31),
        body.at(-10 + sway, -34),
        body.at(-56 + sway, -31),
        body.at(-88 - flare + 1.2 * sway, -20),
        body.at(-64 + 0.3 * sway, 48),
        body.at(-44, 104),
    ]
    coat = polygon(outline, 14)
    _inked(sheet, coat, COAT, COAT_SHADE, (17, -9))
    hem = [body.at(84 + flare + 0.4 * sway, -14), body.at(-10 + sway, -26), body.at(-94 - flare + 1.2 * sway, -12)]
    sheet.paint(stroke(curve(hem[0], hem[1], hem[2], 8), [1.6] * 8) & coat, INK, 0.55)
    front = curve(body.at(22, 130), body.at(40, 60), body.at(44 + 0.6 * sway, -30), 10)
    sheet.paint(stroke(front, [1.7] * 10) & coat, INK)
    for along in (104.0, 62.0, 20.0):
        sheet.paint(circle(body.at(44 - 0.06 * along + 0.25 * sway, along), 5.6), INK)
        sheet.paint(circle(body.at(44 - 0.06 * along + 0.25 * sway, along), 3.2), WHITE)


def _arm(sheet: PaperSheet, body: _Body, hand: Point, *, is_near: bool) -> None:
    shoulder = body.at(-14 if is_near else 22, 112)
    dx, dy = hand[0] - shoulder[0], hand[1] - shoulder[1]
    bend = 16 if is_near else 22
    length = max((dx * dx + dy * dy) ** 0.5, 1.0)
    elbow = ((shoulder[0] + hand[0]) / 2 - dy / length * bend, (shoulder[1] + hand[1]) / 2 + dx / length * bend)
    if is_near:
        elbow = ((shoulder[0] + hand[0]) / 2 + dy / length * -bend, (shoulder[1] + hand[1]) / 2 + dx / length * bend)
    cuff = (elbow[0] + (hand[0] - elbow[0]) * 0.5, elbow[1] + (hand[1] - elbow[1]) * 0.5)
    _inked(sheet, circle(hand, 15), SKIN, SKIN_SHADE, (4, -6))
    sleeve = stroke([shoulder, elbow, cuff], [22, 20, 23])
    _inked(sheet, sleeve, COAT if is_near else COAT_SHADE, COAT_SHADE, (9, -8))


def _head(sheet: PaperSheet, body: _Body) -> None:
    pose = body.pose
    x, y = body.head
    tip = -5 - 10 * pose.gaze
    hood = circle((x - 8, y), 94)
    for side, point, height in ((-50.0, -14.0, 106.0), (34.0, 10.0, 112.0)):
        ear = polygon(
            [(x + side - 20, y - 66), (x + side + point, y - height + tip * 0.4), (x + side + 24, y - 70)], 12
        )
        hood = blended(hood, ear, 14)
    hood = blended(hood, cone((x - 22, y + 70), (x + 16, y + 76), 34, 30), 22)
    _inked(sheet, hood, COAT, COAT_SHADE, (16, -12))
    face = ellipse((x + 22, y + 10 + tip * 0.3), 66, 64)
    _inked(sheet, face.grown(5), LINING)
    sheet.paint(face, SKIN)
    sheet.paint(face - face.moved(8, 9), SKIN_SHADE)
    _hair(sheet, face, (x + 22, y + 10 + tip * 0.3))
    _features(sheet, pose, face, (x + 34, y + 18 + tip))
    sheet.paint(face.grown(1.6) - face.grown(-1.6), INK)


def _hair(sheet: PaperSheet, face: DrawnShape, middle: Point) -> None:
    x, y = middle
    fringe = polygon(
        [
            (x - 76, y + 26), (x - 64, y + 0), (x - 56, y - 16), (x - 34, y - 28), (x - 28, y - 18), (x - 8, y - 34),
            (x + 0, y - 22), (x + 20, y - 37), (x + 30, y - 25), (x + 48, y - 34), (x + 60, y - 12), (x + 74, y + 4),
            (x + 84, y - 90), (x - 90, y - 90),
        ],
        3,
    )  # fmt: skip
    sheet.paint(fringe.grown(LINE_PX - 0.8) & face, INK)
    sheet.paint(fringe & face, HAIR)


def _features(sheet: PaperSheet, pose: Pose, face: DrawnShape, middle: Point) -> None:
    x, y = middle
    opening = max(1 - pose.blink, 0.12)
    for offset, width in ((-24.0, 8.4), (22.0, 7.4)):
        center = (x + offset, y + 2)
        if opening < 0.45:
            lid = curve((center[0] - 9, center[1] + 2), (center[0], center[1] + 9), (center[0] + 9, center[1] + 2), 6)
            sheet.paint(stroke(lid, [2.0] * 6), INK)
            continue
        sheet.paint(ellipse(center, width, 13.0 * opening), INK)
        sheet.paint(circle((center[0] + 2.4, center[1] - 5.2 * opening), 3.3), WHITE)
        sheet.paint(circle((center[0] - 2.6, center[1] + 5.0 * opening), 1.7), WHITE, 0.8)
    for offset in (-42.0, 36.0):
        sheet.paint(ellipse((x + offset, y + 24), 11, 6.5) & face, BLUSH, 0.7)
    wide, deep = 9 + 5 * pose.joy, 4 + 14 * pose.joy
    mouth = ellipse((x + 1, y + 22), wide, deep) & polygon(
        [(x - 40, y + 22), (x + 40, y + 22), (x + 40, y + 60), (x - 40, y + 60)]
    )
    sheet.paint(mouth.grown(1.8), INK)
    if pose.joy > 0.3:
        sheet.paint(mouth, (200, 80, 84))


def _balloon(sheet: PaperSheet, pose: Pose) -> None:
    x, y = pose.balloon
    knot = (x - 2, y + 84)
    slack = curve(knot, ((knot[0] + pose.hold[0]) / 2 - 16, (knot[1] + pose.hold[1]) / 2), pose.hold)
    sheet.paint(stroke(slack, [2.1] * len(slack)), INK)
    skin = blended(ellipse((x, y), 62, 72), cone((x - 1, y + 58), (x - 2, y + 72), 20, 6), 18)
    _inked(sheet, polygon([(x - 2, y + 76), (x - 10, y + 88), (x + 6, y + 88)], 2), BALLOON_SHADE)
    _inked(sheet, skin, BALLOON, BALLOON_SHADE, (-13, -12))
    sheet.paint(ellipse((x + 22, y - 34), 9, 17, -0.5), WHITE, 0.85)
    sheet.paint(circle((x + 36, y - 8), 4.4), WHITE, 0.85)
