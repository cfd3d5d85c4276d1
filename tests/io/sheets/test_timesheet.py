"""Timesheets of every kind: there and back, and whatever a stranger puts into one."""

import json
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from kagezou.errors import InputProblem
from kagezou.io.sheets.reading import read_timesheet
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts import sheets_of
from kagezou.io.sheets.xdts_writing import write_xdts, xdts_text
from tests.effort import tries

FIRST_XDTS = b"exchangeDigitalTimeSheet Save Data\n"
FIRST_TDTS = b"toeiDigitalTimeSheet Save Data\n"

cels = st.one_of(st.none(), st.integers(1, 999).map(str), st.sampled_from(["1a", "12b", "目パチ"]))


@st.composite
def sheets(draw: st.DrawFn) -> Timesheet:
    length = draw(st.integers(1, 200))
    tracks = []
    for name in draw(st.lists(st.sampled_from("ABCDE影"), max_size=4)):
        frames = sorted({0, *draw(st.sets(st.integers(0, length - 1), max_size=6))})
        tracks.append(SheetTrack(name, tuple((frame, draw(cels)) for frame in frames)))
    return Timesheet(draw(st.sampled_from(["", "c012", "カット 3"])), length, tuple(tracks))


def sts(columns: dict[str, list[int]], length: int) -> bytes:
    data = b"\x11ShiraheiTimeSheet" + bytes([len(columns)]) + length.to_bytes(2, "little") + b"\0\0"
    for row in columns.values():
        data += b"".join(cel.to_bytes(2, "little") for cel in row)
    for name in columns:
        raw = name.encode("shift_jis")
        data += bytes([len(raw)]) + raw
    return data


def tdts(field: int = 4, *, wrapped: bool = True) -> bytes:
    frames = [{"frame": 0, "data": [{"values": ["3"]}]}, {"frame": 4, "data": [{"values": ["SYMBOL_NULL_CELL"]}]}]
    table = {
        "name": "c1",
        "duration": 12,
        "timeTableHeaders": [{"fieldId": field, "names": ["A"]}, {"fieldId": 0, "names": ["genga"]}],
        "fields": [{"fieldId": field, "tracks": [{"trackNo": 0, "frames": frames}]}],
    }
    tree = {"timeSheets": [{"timeTables": [table]}]} if wrapped else {"timeTables": [table]}
    return FIRST_TDTS + json.dumps(tree).encode()


@given(sheets())
def test_what_is_written_reads_the_same(sheet: Timesheet) -> None:
    assert sheets_of(xdts_text(sheet)) == (sheet,)


def test_a_column_that_begins_late_begins_with_an_empty_cel(tmp_path: Path) -> None:
    write_xdts(tmp_path / "a.xdts", Timesheet("c", 9, (SheetTrack("A", ()), SheetTrack("B", ((4, "2"),)))))
    again = read_timesheet(tmp_path / "a.xdts")
    assert again.tracks == (SheetTrack("B", ((0, None), (4, "2"))),)


@pytest.mark.parametrize("data", [tdts(), tdts(wrapped=False), tdts(0)])
def test_tdts_is_read_with_its_own_field_for_cels(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "a.tdts").write_bytes(data)
    sheet = read_timesheet(tmp_path / "a.tdts")
    assert sheet == Timesheet("c1", 12, (SheetTrack("A", ((0, "3"), (4, None))),))


def test_sts_is_read_with_its_japanese_names(tmp_path: Path) -> None:
    (tmp_path / "a.sts").write_bytes(sts({"A": [0, 1, 1, 2], "影": [3, 3, 3, 0]}, 4))
    sheet = read_timesheet(tmp_path / "a.sts")
    assert sheet.length_frames == 4
    assert sheet.tracks == (
        SheetTrack("A", ((0, None), (1, "1"), (3, "2"))),
        SheetTrack("影", ((0, "3"), (3, None))),
    )


def test_columns_of_sts_without_names_have_letters(tmp_path: Path) -> None:
    (tmp_path / "a.sts").write_bytes(sts({"A": [1], "B": [2]}, 1)[:-4])
    assert [track.name for track in read_timesheet(tmp_path / "a.sts").tracks] == ["A", "B"]


@settings(max_examples=tries(40, 150), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    whole=st.sampled_from([xdts_text(Timesheet("c", 24, (SheetTrack("A", ((0, "1"),)),))).encode(), tdts()]),
    cut=st.integers(0, 400),
    changes=st.lists(st.tuples(st.integers(0, 400), st.integers(0, 255)), max_size=4),
)
@example(whole=FIRST_XDTS + b"[" * 100_000, cut=200_000, changes=[])
@example(whole=FIRST_XDTS + b'{"timeTables":[{"duration":1e999}]}', cut=10_000, changes=[])
@example(whole=FIRST_XDTS + b'{"timeTables":[{"duration":' + b"9" * 5000 + b"}]}", cut=10_000, changes=[])
@example(whole=sts({"A": [1, 2], "B": [3, 4]}, 2), cut=30, changes=[(18, 255), (19, 255)])
def test_whatever_is_in_a_sheet_there_is_a_result_or_a_sentence(
    tmp_path: Path, whole: bytes, cut: int, changes: list[tuple[int, int]]
) -> None:
    data = bytearray(whole[: cut + 40])
    for place, value in changes:
        if place < len(data):
            data[place] = value
    file = tmp_path / "sheet.xdts"
    file.write_bytes(bytes(data))
    said, length = "sheet.xdts", 1
    try:
        length = read_timesheet(file).length_frames
    except InputProblem as problem:
        said = str(problem)
    assert "sheet.xdts" in said
    assert "\n" not in said
    assert 1 <= length <= 1_000_000
