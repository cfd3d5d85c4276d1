"""Timesheets: what programs really write is read, and what is no sheet is refused in one sentence."""

import json
from pathlib import Path
from typing import Any

import pytest

from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.sheets import xdts
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts import read_timesheet, sheet_of

HEAD = "exchangeDigitalTimeSheet Save Data\n"
NULL = "SYMBOL_NULL_CELL"


def row(frame: int, *values: object) -> dict[str, Any]:
    return {"frame": frame, "data": [{"id": 0, "values": list(values)}]}


def track(number: int, *rows: dict[str, Any]) -> dict[str, Any]:
    return {"trackNo": number, "frames": list(rows)}


def tree(*tracks: dict[str, Any], names: tuple[str, ...] = ("A", "B"), duration: int = 24) -> dict[str, Any]:
    table = {
        "name": "c012",
        "duration": duration,
        "timeTableHeaders": [{"fieldId": 3, "names": ["talk"]}, {"fieldId": 0, "names": list(names)}],
        "fields": [{"fieldId": 5, "tracks": [{}]}, {"fieldId": 0, "tracks": list(tracks)}],
    }
    return {"version": 5, "header": {"cut": "12", "scene": "1"}, "timeTables": [table]}


def entries(*rows: dict[str, Any], duration: int = 24) -> tuple[tuple[int, str | None], ...]:
    return sheet_of(HEAD + json.dumps(tree(track(0, *rows), duration=duration))).tracks[0].entries


def test_the_minimal_sheet() -> None:
    first = track(0, row(0, "1"), row(6, "2"), row(9, "SYMBOL_TICK_1"), row(12, NULL))
    sheet = sheet_of(HEAD + json.dumps(tree(first, track(1, row(0, NULL), row(4, "1")))))
    assert sheet == Timesheet(
        "c012",
        24,
        (SheetTrack("A", ((0, "1"), (6, "2"), (12, None))), SheetTrack("B", ((0, None), (4, "1")))),
    )


@pytest.mark.parametrize("mark", ["SYMBOL_TICK_1", "SYMBOL_TICK_2", "SYMBOL_HYPHEN", "SYMBOL_OF_TOMORROW", "", "  "])
def test_marks_keep_the_cel_before(mark: str) -> None:
    assert entries(row(0, "1"), row(3, mark)) == ((0, "1"),)


def test_frames_may_come_in_any_order() -> None:
    assert entries(row(8, "3"), row(0, "1"), row(4, "2")) == ((0, "1"), (4, "2"), (8, "3"))


def test_the_last_cel_before_the_first_frame_begins_the_sheet() -> None:
    assert entries(row(-2, "2"), row(-5, "1"), row(3, "4")) == ((0, "2"), (3, "4"))
    assert entries(row(-2, "2"), row(0, "3")) == ((0, "3"),)
    assert entries(row(-2, NULL)) == ((0, None),)


def test_what_lies_behind_the_end_is_left_out() -> None:
    assert entries(row(0, "1"), row(24, NULL), row(30, "2")) == ((0, "1"),)


def test_numbers_written_as_numbers_are_read() -> None:
    assert entries(row(0, 12), row(1, [True]), row(2, 1.5), row(3, None)) == ((0, "12"),)


def test_tracks_are_ordered_and_named_by_their_number() -> None:
    sheet = sheet_of(HEAD + json.dumps(tree(track(2, row(0, "9")), track(0), names=(" A ", "A"))))
    assert sheet.tracks == (SheetTrack("A", ()), SheetTrack("", ((0, "9"),)))


def test_missing_parts_are_empty() -> None:
    bare: dict[str, Any] = {"timeTables": [{"duration": 3}]}
    assert sheet_of(HEAD + json.dumps(bare)) == Timesheet("", 3, ())
    assert entries({"frame": 0}, {"frame": 1, "data": []}, {"frame": 2, "data": [{"id": 0}]}) == ()


def test_byte_order_mark_windows_lines_and_unknown_keys(tmp_path: Path) -> None:
    path = tmp_path / "c012.xdts"
    known = {**tree(track(0, row(0, "1"))), "surprise": [1]}
    path.write_bytes(("\ufeff" + HEAD + json.dumps(known, indent=1)).replace("\n", "\r\n").encode())
    assert read_timesheet(path).tracks[0] == SheetTrack("A", ((0, "1"),))


@pytest.mark.parametrize(
    ("content", "cause"),
    [
        (b"", "it is not a timesheet"),
        (b"{}", "it is not a timesheet"),
        (b"toeiDigitalTimeSheet Save Data\n{}", "the key 'timeTables' is missing"),
        (b"\x11ShiraheiTimeSheet", "the STS timesheet is cut off"),
        (b"\x11ShiraheiTimeSheet\x02\x00\x00\x00\x00", "the STS timesheet has no frames"),
        (b"\x11ShiraheiTimeSheet\xff\xff\xff\x00\x00", "255 columns of 65535 frames do not fit"),
        (HEAD.encode(), "the file is empty"),
        (HEAD.encode() + b"{", "it is not complete JSON text"),
        (HEAD.encode() + b"[" * 100_000, "it is nested too deep"),
        (HEAD.encode() + b"\xff", "it is not UTF-8 text"),
        (HEAD.encode() + b"{}", "$: the key 'timeTables' is missing"),
        (HEAD.encode() + b'{"timeTables": []}', "$.timeTables: it has 0 items"),
        (HEAD.encode() + b'{"timeTables": [{"duration": 0}]}', "$.timeTables[0].duration: 0 is not a whole number"),
        (HEAD.encode() + b'{"timeTables": [{"duration": 1e9}]}', "$.timeTables[0].duration: 1000000000.0 is not"),
    ],
)
def test_what_is_no_timesheet_is_refused(content: bytes, cause: str, tmp_path: Path) -> None:
    path = tmp_path / "c012.xdts"
    path.write_bytes(content)
    with pytest.raises(InputProblem) as caught:
        read_timesheet(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert cause in str(caught.value)


def test_a_missing_folder_large_or_impossible_file_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(InputProblem, match="it does not exist"):
        read_timesheet(tmp_path / "none.xdts")
    with pytest.raises(InputProblem, match="it is not a file"):
        read_timesheet(tmp_path)
    with pytest.raises(InputProblem, match="it cannot be a file name"):
        read_timesheet(tmp_path / "a\0b.xdts")
    monkeypatch.setattr(xdts, "MAX_BYTES", 10)
    (tmp_path / "large.xdts").write_bytes(b" " * 11)
    with pytest.raises(InputProblem, match="it is larger than"):
        read_timesheet(tmp_path / "large.xdts")


def test_a_wrong_row_is_named_with_its_place() -> None:
    with pytest.raises(ProjectProblem, match=r"\.fields\[1\]\.tracks\[0\]\.frames\[0\]\.frame: '0' is not a whole"):
        sheet_of(HEAD + json.dumps(tree(track(0, {"frame": "0"}))))
    with pytest.raises(ProjectProblem, match=r"\.tracks\[0\]\.trackNo: -1 is not a whole"):
        sheet_of(HEAD + json.dumps(tree(track(-1))))


def test_the_sample_sheet(samples: Path) -> None:
    sheet = read_timesheet(samples / "xdts" / "minimal.xdts")
    assert sheet == Timesheet(
        "timeline", 24, (SheetTrack("A", ((0, "A1"),)), SheetTrack("A", ((0, None), (4, "A1.5"))))
    )
