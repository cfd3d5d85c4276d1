"""The foot of the section of waves: whether they tear, and loops."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_constant
from kagezou.document.property import AnyProperty
from kagezou.document.wave_properties import SLITS
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.wave_note import WaveNote
from kagezou.ui.project.open_project import OpenProject
from tests.ui.viewing import OwnClipboard

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support propagateSizeHints")


@pytest.fixture
def note(qtbot: QtBot, filled: OpenProject) -> Iterator[WaveNote]:
    inspector = Inspector(filled.bridge, OwnClipboard())
    qtbot.addWidget(inspector)
    inspector.show()
    assert inspector.waves is not None
    yield inspector.waves  # noqa: PT022 - not returned, as the panel around it would go with the fixture


def put(open_project: OpenProject, prop: AnyProperty, value: float) -> None:
    address = Address(prop, open_project.bridge.layer_id)
    open_project.bridge.session.edit("set", set_constant(open_project.bridge.document, address, value))


def number(open_project: OpenProject, prop: AnyProperty) -> float:
    value = value_of(open_project.bridge.document, Address(prop, open_project.bridge.layer_id), 1)
    assert isinstance(value, float)
    return value


def test_it_says_when_the_outline_tears(filled: OpenProject, note: WaveNote) -> None:
    assert note.words.text() == "No waves"
    assert not note.loop.isEnabled()
    put(filled, properties.WAVE1.amplitude, 6.0)
    assert note.words.text() == "Tear 0.63: the outline wobbles"
    put(filled, properties.WAVE1.amplitude, 20.0)
    assert note.words.text() == "Tear 2.09: the outline is torn into stripes"


def test_what_moves_along_the_crests_is_waves_too(filled: OpenProject, note: WaveNote) -> None:
    put(filled, properties.WAVE1.amplitude, 20.0)
    put(filled, properties.WAVE1.depth, 0.0)
    put(filled, properties.WAVE1.direction, 90.0)
    assert note.words.text() == "Tear 0.00: the outline wobbles"
    assert note.loop.isEnabled()


def test_gaps_can_loop_without_waves(filled: OpenProject, note: WaveNote) -> None:
    put(filled, SLITS, 0.5)
    assert note.words.text() == "No waves"
    assert note.loop.isEnabled()


def test_the_speeds_snap_to_the_cut(filled: OpenProject, note: WaveNote) -> None:
    put(filled, properties.WAVE1.amplitude, 6.0)
    before = filled.bridge.document
    note.loop.click()
    length = filled.bridge.document.canvas.length_frames
    for lines in (properties.WAVE1, properties.WAVE2):
        velocity, wavelength = (number(filled, each) for each in (lines.velocity, lines.wavelength))
        assert (velocity * length / wavelength) % 1 == pytest.approx(0.0, abs=1e-9)
    filled.bridge.session.undo()
    assert filled.bridge.document is before
