"""What the window says of how figures stand after a step."""

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.ui.window.main_window import MainWindow


def test_a_wall_stands_the_figure_up_in_one_step_and_says_so(walking: MainWindow) -> None:
    bridge = walking.parts.open_project.bridge
    before = bridge.document
    walking.parts.actions["add_wall"].trigger()
    assert [layer.tracks["upright"].constant for layer in bridge.document.layers] == [1.0] * len(before.layers)
    assert "standing upright now" in walking.parts.bar.text
    bridge.session.undo()
    assert bridge.document is before


def test_a_figure_that_is_pushed_through_a_wall_is_said_once(walking: MainWindow) -> None:
    walking.parts.actions["add_wall"].trigger()
    bridge, said = walking.parts.open_project.bridge, []
    walking.parts.sets.standing.noted.connect(lambda note: said.append(str(note)))
    document = bridge.document
    name = document.layers[0].name
    flat = set_constant(document, resolve(document, f"layers.{name}.upright"), 0.0)
    foot = flat.layers[0].figure.bottom
    x = flat.layers[0].figure.middle[0]
    bridge.session.edit(
        "Lay", set_constant(flat, resolve(flat, "set.Wall.position"), (x, foot - 0.1 * flat.layers[0].figure.height))
    )
    assert [words.startswith(f"{name} pokes through Wall") for words in said] == [True]
    after = bridge.document
    bridge.session.edit("Fade", set_constant(after, resolve(after, f"layers.{name}.shadow.opacity"), 0.3))
    assert len(said) == 1


def test_a_figure_that_is_made_to_travel_beside_the_lamp_is_said(walking: MainWindow) -> None:
    bridge = walking.parts.open_project.bridge
    document = bridge.document
    canvas = document.canvas
    position = resolve(document, f"layers.{document.layers[0].name}.position")
    middle = canvas.height_px / 2
    moved = set_key(document, position, 1, (0.1 * canvas.width_px, middle))
    bridge.session.edit("Slide", set_key(moved, position, canvas.length_frames, (0.9 * canvas.width_px, middle)))
    assert "turns round while the figure travels" in walking.parts.bar.text
