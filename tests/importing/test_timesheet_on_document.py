"""Timesheets on documents: columns find layers, cels find drawings."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import edits, invariants
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Marker
from kagezou.document.slate import Slate
from kagezou.errors import InputProblem
from kagezou.geometry.box import Box
from kagezou.importing.staging import CharacterSource, new_document, with_timesheet
from kagezou.importing.timesheet_on_document import sheet_of, timed
from kagezou.io.sheets.timesheet import SheetMark, SheetTrack, Timesheet
from kagezou.io.sheets.xdts import FIRST_LINE, sheets_of
from kagezou.io.sheets.xdts_writing import xdts_text
from tests.importing.cel_files import write_walk

FIGURE = Box(0, 0, 9, 9)


def document_with(**layers: list[str]) -> Document:
    """Return a document with layers of drawings; files are called like the layer and the drawing."""
    document = Document(Canvas(10, 10, length_frames=99))
    for key, cels in layers.items():
        name = key.replace("_", " ")
        drawings = tuple(Drawing(cel, Path(f"/c/{name}_{cel}.png")) for cel in cels)
        document = edits.add_layer(document, name, Cels(drawings, (Exposure(1, 0),)), FIGURE)
    return document


def exposed(document: Document, *tracks: SheetTrack, length: int = 24) -> tuple[list[tuple[Exposure, ...]], list[str]]:
    changed, notes = timed(document, Timesheet("c", length, tracks))
    invariants.check(changed)
    return [layer.cels.exposures for layer in changed.layers], [str(note) for note in notes]


def test_cels_are_found_by_number_not_by_place() -> None:
    track = SheetTrack("A", ((0, "5"), (6, "2"), (12, None), (18, "5")))
    (exposures,), notes = exposed(document_with(A=["2", "5"]), track)
    assert exposures == (Exposure(1, 1), Exposure(7, 0), Exposure(13, None), Exposure(19, 1))
    assert notes == []


@pytest.mark.parametrize("cel", ["12a", "12A", "0012a", "A12a", "a_0012A", "A-12a", "cut12a", "A_12a"])
def test_a_cel_may_be_called_in_many_ways(cel: str) -> None:
    (exposures,), notes = exposed(document_with(A=["12", "12a"]), SheetTrack("A", ((0, cel),)))
    assert exposures == (Exposure(1, 1),)
    assert notes == []


def test_a_cel_may_begin_with_the_name_of_its_column_though_that_has_a_number() -> None:
    drawings = (Drawing("2", Path("/c/x2.png")), Drawing("3", Path("/c/x3.png")))
    document = edits.add_layer(Document(Canvas(10, 10, length_frames=99)), "A2", Cels(drawings, ()), FIGURE)
    (exposures,), notes = exposed(document, SheetTrack("A2", ((0, "A2_3"), (4, "a2-2"))))
    assert exposures == (Exposure(1, 1), Exposure(5, 0))
    assert notes == []


def test_a_cel_may_be_called_by_its_file() -> None:
    document = document_with(A=["5", "x"])
    drawings = (Drawing("5", Path("/c/A1.5.png")), Drawing("x", Path("/c/x.png")))
    layer = document.layers[0]
    document = edits.remove_layer(document, layer.id)
    document = edits.add_layer(document, "A", Cels(drawings, ()), FIGURE)
    (exposures,), _ = exposed(document, SheetTrack("A", ((0, "A1.5"), (3, "X"))))
    assert exposures == (Exposure(1, 0), Exposure(4, 1))


def test_missing_cels_stay_empty_and_are_told_once() -> None:
    cels = tuple((frame, str(cel)) for frame, cel in enumerate((1, 7, 1, 8, 7, 9, 10, 11, 12)))
    (exposures,), notes = exposed(document_with(A=["1"]), SheetTrack("A", cels))
    assert exposures == (Exposure(1, 0), Exposure(2, None), Exposure(3, 0), Exposure(4, None))
    assert notes == ["A: the timesheet names cels without a drawing; they stay empty: 7, 8, 9, 10, 11, …"]


def test_a_decimal_is_no_number_of_another_cel() -> None:
    _, notes = exposed(document_with(A=["1", "5"]), SheetTrack("A", ((0, "A1.5"),)))
    assert len(notes) == 1


def test_columns_find_layers_by_name() -> None:
    document = document_with(B=["1"], Hero_A=["1"])
    two, three = ((1, "1"),), ((2, "1"),)
    exposures, notes = exposed(document, SheetTrack(" a ", two), SheetTrack("b", three))
    assert exposures == [(Exposure(3, 0),), (Exposure(2, 0),)]
    assert notes == []


def test_two_columns_of_one_name_find_two_layers() -> None:
    document = document_with(A=["1"], A_2=["1"])
    exposures, _ = exposed(document, SheetTrack("A", ((1, "1"),)), SheetTrack("A", ((2, "1"),)))
    assert exposures == [(Exposure(2, 0),), (Exposure(3, 0),)]


def test_what_does_not_match_is_told() -> None:
    document = document_with(A=["1"], Hero_C=["1"], Prop_C=["1"])
    tracks = (SheetTrack("A", ()), SheetTrack("C", ((0, "1"),)), SheetTrack("", ()), SheetTrack("Z", ()))
    exposures, notes = exposed(document, *tracks)
    assert exposures == [(), (Exposure(1, 0),), (Exposure(1, 0),)]
    assert notes == [
        "there is no layer for the timesheet's column 'C'",
        "Hero C: the timesheet has no column for it; it keeps its timing",
        "Prop C: the timesheet has no column for it; it keeps its timing",
    ]


def test_the_sheet_decides_the_length() -> None:
    document, _ = timed(document_with(A=["1"]), Timesheet("c", 36, ()))
    assert document.canvas.length_frames == 36


def test_a_sheet_on_a_new_document(tmp_path: Path) -> None:
    document = new_document([CharacterSource("A", write_walk(tmp_path / "walk", [1, 2, 4]))]).document
    table = {
        "duration": 12,
        "timeTableHeaders": [{"fieldId": 0, "names": ["A"]}],
        "fields": [
            {"fieldId": 0, "tracks": [{"trackNo": 0, "frames": [{"frame": 2, "data": [{"id": 0, "values": ["4"]}]}]}]}
        ],
    }
    sheet = tmp_path / "c.xdts"
    text = json.dumps({"timeTables": [table]})
    sheet.write_text(f"exchangeDigitalTimeSheet Save Data\n{text}", encoding="utf-8")
    imported = with_timesheet(document, sheet)
    assert imported.document.layers[0].cels.exposures == (Exposure(3, 2),)
    assert (imported.notes, imported.layer_ids) == ((), ("layer-1",))
    assert imported.document.canvas.length_frames == 12
    with pytest.raises(InputProblem, match=r"none\.xdts: it does not exist"):
        with_timesheet(document, tmp_path / "none.xdts")


def test_what_is_said_and_done_beside_the_cels_becomes_markers() -> None:
    marks = (SheetMark(0, 1, "PAN"), SheetMark(4, 3, "Taro: Hello"), SheetMark(4, 1, "T.U"))
    sheet = Timesheet("c012", 24, (), marks=marks)
    document = replace(document_with(A=["1"]), markers=(Marker(5, "step", 1), Marker(9, "end")))
    once, _ = timed(document, sheet)
    assert once.markers == (Marker(1, "PAN", 1), Marker(5, "step / Taro: Hello / T.U", 3), Marker(9, "end"))
    again, _ = timed(once, sheet)
    assert again.markers == once.markers
    invariants.check(again)


def test_scene_and_cut_of_the_head_are_those_of_the_slate_where_it_has_none() -> None:
    sheet = Timesheet("c012", 24, (), scene="3", cut="12A")
    named = replace(document_with(A=["1"]), slate=Slate(name="ep04"))
    told, notes = timed(named, sheet)
    assert (told.slate, notes[:-1]) == (Slate("ep04", "3", "12A"), [])
    again, notes = timed(told, sheet)
    assert (again.slate, notes[:-1]) == (told.slate, [])
    other, notes = timed(told, replace(sheet, cut="13"))
    assert other.slate == told.slate
    assert str(notes[-1]) == "the timesheet is of scene '3', cut '13'; the project keeps '3' and '12A'"
    long, notes = timed(named, replace(sheet, cut="9" * 61))
    assert long.slate == named.slate
    assert "cannot stand on a slate" in str(notes[-1])


def test_numbers_that_a_writer_puts_in_for_none_are_no_slate() -> None:
    document, _ = timed(document_with(A=["1"]), Timesheet("c", 9, (), scene="1", cut="1"))
    assert document.slate == Slate()


def test_what_a_sheet_says_comes_back_through_a_document() -> None:
    def row(frame: int, *said: str) -> dict[str, object]:
        return {"frame": frame, "data": [{"id": 0, "values": list(said)}]}

    cels = [row(0, "1"), row(3, "SYMBOL_TICK_1"), row(6, "2"), row(9, "SYMBOL_TICK_2")]
    talk = [row(2, "Anna", "Good morning"), row(3, "SYMBOL_HYPHEN"), row(5, "SYMBOL_NULL_CELL")]
    fields = [
        {"fieldId": 0, "tracks": [{"trackNo": 0, "frames": cels}]},
        {"fieldId": 3, "tracks": [{"trackNo": 0, "frames": talk}]},
        {"fieldId": 5, "tracks": [{"trackNo": 0, "frames": [row(0, "PAN"), row(8, "SYMBOL_NULL_CELL")]}]},
    ]
    headers = [{"fieldId": 0, "names": ["A"]}, {"fieldId": 3, "names": ["S1"]}]
    table = {"name": "c012", "duration": 12, "timeTableHeaders": headers, "fields": fields}
    tree = {"header": {"cut": "0012", "scene": "3"}, "timeTables": [table], "version": 5}
    (sheet,) = sheets_of(f"{FIRST_LINE}\n{json.dumps(tree)}")
    document, _ = timed(document_with(A=["1", "2"]), sheet)
    text = xdts_text(sheet_of(document, "cut"))
    assert json.loads(text.partition("\n")[2]) == tree
    (again,) = sheets_of(text)
    assert (again.marks, again.scene, again.cut) == (sheet.marks, "3", "0012")
    assert [mark.text for mark in again.marks] == ["PAN", "Anna: Good morning"]
