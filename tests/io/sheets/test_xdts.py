"""Timesheets: what programs really write is read, and what is no sheet is refused in one sentence."""

import json
from pathlib import Path
from typing import Any

import pytest

from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.sheets import reading
from kagezou.io.sheets.reading import read_sheets, read_timesheet
from kagezou.io.sheets.timesheet import SheetMark, SheetTrack, Timesheet
from kagezou.io.sheets.xdts import sheets_of

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


def first_of(text: str) -> Timesheet:
    return sheets_of(text)[0]


def entries(*rows: dict[str, Any], duration: int = 24) -> tuple[tuple[int, str | None], ...]:
    return first_of(HEAD + json.dumps(tree(track(0, *rows), duration=duration))).tracks[0].entries


def test_the_minimal_sheet() -> None:
    first = track(0, row(0, "1"), row(6, "2"), row(9, "SYMBOL_TICK_1"), row(12, NULL))
    sheet = first_of(HEAD + json.dumps(tree(first, track(1, row(0, NULL), row(4, "1")))))
    assert (sheet.name, sheet.length_frames) == ("c012", 24)
    assert sheet.tracks == (SheetTrack("A", ((0, "1"), (6, "2"), (12, None))), SheetTrack("B", ((0, None), (4, "1"))))


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
    sheet = first_of(HEAD + json.dumps(tree(track(2, row(0, "9")), track(0), names=(" A ", "A"))))
    assert sheet.tracks == (SheetTrack("A", ()), SheetTrack("", ((0, "9"),)))


def test_missing_parts_are_empty() -> None:
    bare: dict[str, Any] = {"timeTables": [{"duration": 3}]}
    assert first_of(HEAD + json.dumps(bare)) == Timesheet("", 3, ())
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
    monkeypatch.setattr(reading, "MAX_BYTES", 10)
    (tmp_path / "large.xdts").write_bytes(b" " * 11)
    with pytest.raises(InputProblem, match="it is larger than"):
        read_timesheet(tmp_path / "large.xdts")


def test_a_wrong_row_is_named_with_its_place() -> None:
    with pytest.raises(ProjectProblem, match=r"\.fields\[1\]\.tracks\[0\]\.frames\[0\]\.frame: 'x' is not a whole"):
        first_of(HEAD + json.dumps(tree(track(0, {"frame": "x"}))))
    with pytest.raises(ProjectProblem, match=r"\.tracks\[0\]\.trackNo: -1 is not a whole"):
        first_of(HEAD + json.dumps(tree(track(-1))))


def text(*tracks: dict[str, Any], **more: object) -> str:
    return json.dumps({**tree(*tracks), **more})


@pytest.mark.parametrize(
    ("content", "note"),
    [
        ((HEAD.strip() + text(track(0, row(0, "1")))).encode(), ""),
        (("\n" + HEAD.upper() + text(track(0, row(0, "1"))) + "\0\0\n").encode(), ""),
        ((HEAD.replace("\n", "\r") + text(track(0, row(0, "1")))).encode("utf-8-sig"), ""),
        ((HEAD + text(track(0, row(0, "1")))).encode("utf-16"), "its text is UTF-16, where UTF-8 is usual"),
        ((HEAD + text(track(0, row(0, "1")))).encode("utf-16-le"), "its text is UTF-16, where UTF-8 is usual"),
        ((HEAD + text(track(0, row(0, "1")))).encode("utf-16-be"), "its text is UTF-16, where UTF-8 is usual"),
        ((HEAD + text(track(0, row(0, "1")))[:-1].replace("talk", "台詞") + "}").encode("cp932"), "Shift-JIS"),
        (text(track(0, row(0, "1"))).encode(), "the line that names its format is missing"),
        ((HEAD + text(track(0, row(0, "1"))) + "\n</html>").encode(), "what stands behind its end is not used"),
    ],
)
def test_harmless_deviations_are_read(content: bytes, note: str, tmp_path: Path) -> None:
    path = tmp_path / "c012.xdts"
    path.write_bytes(content)
    sheet = read_timesheet(path)
    assert sheet.tracks == (SheetTrack("A", ((0, "1"),)),)
    assert any(note in str(each) for each in sheet.notes) if note else sheet.notes == ()


def test_numbers_may_be_texts_and_the_length_may_be_missing() -> None:
    loose = tree(
        {"trackNo": "0", "frames": [row(0, "1"), {**row(3, NULL), "frame": "3"}, {**row(5, "2"), "frame": 5.0}]}
    )
    del loose["timeTables"][0]["duration"]
    sheet = first_of(HEAD + json.dumps(loose))
    assert (sheet.length_frames, sheet.tracks[0].entries) == (6, ((0, "1"), (3, None), (5, "2")))
    assert list(map(str, sheet.notes)) == ["its length is missing; it ends with its last entry"]


def test_what_is_not_used_is_said() -> None:
    full = tree(
        track(0, row(0, "1", "2"), row(2, "SYMBOL_TICK_1"), row(3, "SYMBOL_TICK_2"), row(4, "SYMBOL_X"), row(30, "5"))
    )
    talk = {"fieldId": 3, "tracks": [track(0, row(0, "Anna", "Hello"))]}
    full["timeTables"][0]["fields"] += [talk, {"fieldId": 5, "tracks": [track(0, row(0, "PAN"))]}]
    full["timeTables"][0]["fields"] += [{"fieldId": 9, "tracks": [track(0, row(0, "?"))]}]
    assert list(map(str, first_of(HEAD + json.dumps(full)).notes)) == [
        "its columns of the kind 9 are not used",
        "marks of inbetweens and reverse sheets (○ ●) are not used: 2",
        "marks of a kind not known here are passed over: 1",
        "of several cels on one frame the first counts: 1 times",
        "what lies behind its last frame is not used: 1 entries",
    ]


def test_dialogue_and_camera_work_are_marks_for_as_long_as_they_go_on() -> None:
    full = tree(track(0, row(0, "1")))
    talk = track(
        0, row(1, "Taro", "Good\nmorning"), row(2, "SYMBOL_HYPHEN"), row(3, "SYMBOL_HYPHEN"), row(6, NULL),
        row(8, "Hanako", "Yes"), row(30, "Taro", "late"),
    )  # fmt: skip
    moves = track(0, row(-2, "FI"), row(0, "PAN"), row(4, "T.U"), row(5, "SYMBOL_HYPHEN"))
    full["timeTables"][0]["fields"] += [{"fieldId": 3, "tracks": [talk]}, {"fieldId": 5, "tracks": [moves]}]
    sheet = first_of(HEAD + json.dumps(full))
    assert sheet.marks == (
        SheetMark(0, 1, "PAN"),
        SheetMark(1, 3, "Taro: Good morning"),
        SheetMark(4, 2, "T.U"),
        SheetMark(8, 1, "Hanako: Yes"),
    )
    assert sheet.notes == ()


def test_a_column_of_dialogue_that_cannot_be_read_is_left_out_and_said() -> None:
    full = tree(track(0, row(0, "1")))
    full["timeTables"][0]["fields"].append({"fieldId": 3, "tracks": [{"trackNo": 0, "frames": "?"}]})
    sheet = first_of(HEAD + json.dumps(full))
    assert (sheet.marks, sheet.tracks) == ((), (SheetTrack("A", ((0, "1"),)),))
    assert list(map(str, sheet.notes)) == ["a column of dialogue or camera work cannot be read"]


def test_one_of_several_sheets_is_chosen_by_name_or_number(tmp_path: Path) -> None:
    first, second = (tree(track(0, row(0, number)))["timeTables"][0] for number in "12")
    tables = [first, {**second, "name": "Ｃ１３"}, {**second, "name": ""}]
    path = tmp_path / "cuts.xdts"
    path.write_text(HEAD + json.dumps({"timeTables": tables}), encoding="utf-8")
    assert len(read_sheets(path)) == 3
    assert list(map(str, read_timesheet(path).notes)) == ["of its 3 sheets c012 is used, not Ｃ１３, 3"]
    for which in ("c13", "2"):
        assert read_timesheet(path, which).tracks[0].entries == ((0, "2"),)
    assert read_timesheet(path, "3").name == ""
    with pytest.raises(InputProblem, match=r"no sheet '4' in it, but 1 \(c012\), 2 \(Ｃ１３\), 3 \(3\)"):
        read_timesheet(path, "4")
    path.write_text("toei" + HEAD[8:] + json.dumps({"timeSheets": [{"timeTables": [each]} for each in tables]}))
    assert [sheet.name for sheet in read_sheets(path)] == ["c012", "Ｃ１３", ""]


def test_the_sample_sheet(samples: Path) -> None:
    sheet = read_timesheet(samples / "xdts" / "minimal.xdts")
    assert sheet == Timesheet(
        "timeline", 24, (SheetTrack("A", ((0, "A1"),)), SheetTrack("A", ((0, None), (4, "A1.5"))))
    )
