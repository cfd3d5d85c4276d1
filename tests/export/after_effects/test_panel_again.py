"""Bringing shadows back from the panel again: into compositions in which somebody went on working."""

import sys
from pathlib import Path

import pytest

from tests.export.after_effects.test_panel import Panel, panel, saved

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")
__all__ = ["panel", "saved"]

MADE = """
    app.isoLanguage = 'en_US';
    var cut = newComp('cut', 4); cut.put(file, 'under'); cut.put(file, 'A').selected = true; cut.put(file, 'over');
    press(make); press(bring);
    var at = (name) => cut.all.find((each) => each.name === name);
    cut.selectedLayers.forEach((each) => { each.selected = false; });
"""


def test_what_comes_later_lies_over_the_shadow_and_under_the_character(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {MADE}
        callProgram('set', settings.saveTo, 'layers.A.contact.strength=0.5', 'layers.A.reflection.opacity=0.5');
        press(bring); press(bring);
    """)
    assert run.tree["alerts"] == []
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names == ["Light", "Ground line", "over", "A", "A reflection", "A contact", "A shadow", "under"]
    assert saved.exists()


def test_shadows_that_were_precomposed_with_their_character_are_found(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {MADE}
        cut.layers.precompose([at('A').index, at('A shadow').index], 'pre', true);
        callProgram('set', settings.saveTo, 'layers.A.shadow.opacity=0.9', 'layers.A.contact.strength=0.5');
        press(bring); press(bring);
    """)
    assert run.tree["alerts"] == []
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names == ["Light", "Ground line", "over", "A contact", "pre", "under"]
    opacity = run.layer("pre", "A shadow")["groups"]["ADBE Transform Group"]["children"]["ADBE Opacity"]
    assert opacity["value"] == 90
    assert [each["name"] for each in run.tree["items"]].count("A shadow") == 1
    assert saved.exists()


def test_a_deleted_shadow_stays_deleted_and_that_is_said(panel: Panel, saved: Path) -> None:
    run = panel(f"{MADE} at('A shadow').remove(); at('A').selected = true; press(bring);")
    assert "A shadow" not in [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    (said,) = run.tree["alerts"]
    assert said.splitlines()[-1] == "A shadow"
    assert saved.exists()


def test_another_composition_of_the_project_gets_its_own(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {MADE}
        var other = newComp('other', 4); other.put(file, 'A').selected = true;
        settings.openFile = settings.saveTo; press(bring);
    """)
    assert run.tree["alerts"] == []
    for comp in ("cut", "other"):
        assert [layer["name"] for layer in run.item(comp, "CompItem")["layers"]].count("A shadow") == 1
    assert [each["name"] for each in run.tree["items"]].count("A shadow") == 1, "one footage for both"
    assert saved.exists()
