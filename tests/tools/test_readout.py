from kagezou.document import properties
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.tools.handle import Handle
from kagezou.tools.readout import height_words, readout
from tests.scene.jumps import jumping
from tests.tools.tool_scenes import Hand, address, document_with, handle


def read(held: Handle, before: Document, after: Document, frame: int) -> str:
    return "  ".join(map(str, readout(held, before, after, frame)))


def test_a_point_reads_its_place_and_the_way() -> None:
    document = document_with((properties.GROUND_POSITION, (394.0, 207.0)))
    after = Hand(document, "ground.position").to(18, -4)
    assert read(handle(document, "ground.position"), document, after, 1) == "X 412 (+18)  Y 203 (-4)"


def test_tenths_are_read_where_there_are_any() -> None:
    document = document_with()
    after = Hand(document, "ground.position").to(0.26, -0.04)
    assert read(handle(document, "ground.position"), document, after, 1) == "X 500.3 (+0.3)  Y 900 (+0)"


def test_a_lamp_reads_three_numbers() -> None:
    document = document_with((properties.LIGHT_POSITION, (10, 20, 30)))
    after = set_constant(document, address(properties.LIGHT_POSITION), (11, 20, 25))
    assert read(handle(document, "light.lamp"), document, after, 1) == "X 11 (+1)  Y 20 (+0)  Z 25 (-5)"


def test_angles_have_names() -> None:
    document = document_with((properties.LIGHT_KIND, "sun"))
    after = set_constant(document, address(properties.LIGHT_AZIMUTH), 40.0)
    sun = handle(document, "light.sun")
    assert read(sun, document, after, 1) == "Sun azimuth 40° (+5°)  Sun elevation 45° (+0°)"


def test_a_grounding_point_reads_its_own_place() -> None:
    document = document_with((properties.GROUNDING, ((450, 900), (550, 880))))
    after = Hand(document, "grounding.1").to(2, 3)
    assert read(handle(document, "grounding.1"), document, after, 1) == "X 552 (+2)  Y 883 (+3)"
    gone = set_constant(document, address(properties.GROUNDING), ((450, 900),))
    assert read(handle(document, "grounding.1"), document, gone, 1) == ""


def test_the_height_of_a_jump_is_said_in_the_air_only() -> None:
    document = jumping()
    words = [height_words(document, "layer-1", frame) for frame in (4, 5, 7, 10)]
    assert [word and str(word) for word in words] == [None, "Height 40 px", "Height 120 px", None]
