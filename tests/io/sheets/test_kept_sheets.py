"""What of a sheet is not used here comes back when one is written."""

import json
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.io.sheets import xdts
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts import FIRST_LINE, sheets_of
from kagezou.io.sheets.xdts_writing import xdts_text


def row(frame: int, value: str, **more: object) -> dict[str, Any]:
    return {"frame": frame, "data": [{"id": 0, "values": [value], **more}]}


TALK = {"fieldId": 3, "tracks": [{"trackNo": 0, "frames": [row(2, "Anna"), row(3, "SYMBOL_HYPHEN")]}]}
PAN = {"fieldId": 5, "tracks": [{"trackNo": 0, "frames": [row(0, "PAN")]}]}
ROWS = [row(0, "A01", options=["OPTION_KEYFRAME"]), row(4, "2"), row(6, "SYMBOL_TICK_1"), row(9, "SYMBOL_NULL_CELL")]
TREE: dict[str, Any] = {
    "header": {"cut": "12", "scene": "3"},
    "version": 5,
    "subversion": "p1",
    "timeTables": [
        {
            "name": "c012",
            "duration": 12,
            "books": [1],
            "timeTableHeaders": [{"fieldId": 0, "names": ["A", "B"]}, {"fieldId": 3, "names": ["S1"]}],
            "fields": [{"fieldId": 0, "tracks": [{"trackNo": 0, "frames": ROWS}]}, TALK, PAN],
        }
    ],
}


def tree_in(text: str) -> dict[str, Any]:
    first, _, rest = text.partition("\n")
    assert first == FIRST_LINE
    tree: dict[str, Any] = json.loads(rest)
    return tree


def text_of(tree: object) -> str:
    return f"{FIRST_LINE}\n{json.dumps(tree)}"


def test_a_sheet_that_nobody_changed_is_written_as_it_was() -> None:
    (sheet,) = sheets_of(text_of(TREE))
    assert tree_in(xdts_text(sheet)) == TREE


def test_what_was_changed_is_new_and_the_rest_stays() -> None:
    (sheet,) = sheets_of(text_of(TREE))
    tracks = (SheetTrack("B", ((0, "1"),)), SheetTrack("A", ((0, "1"), (6, "3"))))
    table = tree_in(xdts_text(replace(sheet, length_frames=8, tracks=tracks)))["timeTables"][0]
    assert table["fields"] == [
        {
            "fieldId": 0,
            "tracks": [
                {"trackNo": 0, "frames": [row(0, "1")]},
                {"trackNo": 1, "frames": [ROWS[0], row(6, "3")]},
            ],
        },
        TALK,
        PAN,
    ]
    assert (table["duration"], table["books"], table["timeTableHeaders"][1]["names"]) == (8, [1], ["S1"])


def test_columns_that_have_no_layer_stay_in_their_places() -> None:
    names = ["A", "B", "A", "C"]
    tracks = [{"trackNo": number, "frames": [row(0, str(number + 1))]} for number in range(4)]
    headers, fields = [{"fieldId": 0, "names": names}], [{"fieldId": 0, "tracks": tracks}]
    table = {"name": "c", "duration": 9, "timeTableHeaders": headers, "fields": fields}
    (sheet,) = sheets_of(text_of({"timeTables": [table]}))
    shorter = replace(sheet, tracks=(sheet.tracks[0], sheet.tracks[3], SheetTrack("D", ((0, "9"),))))
    (again,) = sheets_of(xdts_text(shorter))
    assert [(track.name, track.entries[0][1]) for track in again.tracks] == [
        ("A", "1"),
        ("B", "2"),
        ("A", "3"),
        ("C", "4"),
        ("D", "9"),
    ]


def test_of_tdts_what_both_formats_have_is_written() -> None:
    table = TREE["timeTables"][0]
    fields = [{"fieldId": 4, "tracks": [{"trackNo": 0, "frames": ROWS}]}, {"fieldId": 0, "tracks": []}, TALK]
    headers = [{"fieldId": 4, "names": ["A"]}]
    own = {**table, "fields": fields, "timeTableHeaders": headers}
    sheets = {"timeSheets": [{"header": {"cut": "7"}, "timeTables": [own]}]}
    (sheet,) = sheets_of("toeiDigitalTimeSheet Save Data\n" + json.dumps(sheets))
    written = tree_in(xdts_text(sheet))
    assert written["header"] == {"cut": "7"}
    assert written["timeTables"][0]["fields"] == [{"fieldId": 0, "tracks": [{"trackNo": 0, "frames": ROWS}]}, TALK]


def test_a_sheet_too_large_to_be_kept_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xdts, "MAX_KEPT_CHARACTERS", 100)
    (sheet,) = sheets_of(text_of(TREE))
    assert sheet.kept == ""
    assert "too large for what is not used of it to be kept" in str(sheet.notes[-1])


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-3, 9) | st.sampled_from(["A", "frame", "SYMBOL_TICK_1"]),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(
                ["timeTables", "fields", "fieldId", "tracks", "trackNo", "frames", "frame", "data", "values"]
            ),
            inner,
            max_size=4,
        )
    ),
    max_leaves=12,
)


@given(_JSON.map(json.dumps) | st.text(max_size=20))
def test_whatever_a_project_claims_to_have_kept_a_sheet_is_written(kept: str) -> None:
    sheet = Timesheet("c1", 9, (SheetTrack("A", ((0, "1"), (4, None))),), kept=kept)
    (again,) = sheets_of(xdts_text(sheet))
    assert (again.tracks, again.length_frames) == (sheet.tracks, 9)


_NUMBERS = st.none() | st.fixed_dictionaries(
    {"cut": st.sampled_from(["12", "0012", "12A", 12]), "scene": st.sampled_from(["1", "3", "003"])}
)
_VALUES = st.sampled_from(
    [
        "1",
        "2",
        "A0003",
        "12a",
        "第",
        4,
        "SYMBOL_NULL_CELL",
        "SYMBOL_TICK_1",
        "SYMBOL_TICK_2",
        "SYMBOL_HYPHEN",
        "SYMBOL_NEW",
    ]
)
_LINES = st.sampled_from([["Anna", "Good morning"], ["PAN"], ["SYMBOL_HYPHEN"], ["SYMBOL_NULL_CELL"], ["", "…"]])


@st.composite
def _columns(draw: st.DrawFn, values: st.SearchStrategy[Any]) -> list[dict[str, Any]]:
    """Columns of a field, some without rows, others with rows in any order, also outside of the cut."""
    tracks = []
    for number in draw(st.lists(st.integers(0, 6), max_size=5, unique=True)):
        frames = draw(st.lists(st.integers(-2, 27), max_size=8, unique=True))
        rows = []
        for frame in frames:
            said = draw(values)
            more = draw(st.sampled_from([{}, {"options": ["OPTION_KEYFRAME"]}]))
            rows.append(
                {"frame": frame, "data": [{"id": 0, "values": said if isinstance(said, list) else [said], **more}]}
            )
        tracks.append({"trackNo": number, "frames": rows})
    return tracks


@st.composite
def _files(draw: st.DrawFn) -> dict[str, Any]:
    names = draw(st.lists(st.sampled_from(["A", "B", "Ｃ", "", "影", "A "]), max_size=6))
    fields = [
        {"fieldId": 0, "tracks": draw(_columns(_VALUES))},
        {"fieldId": 3, "tracks": draw(_columns(_LINES))},
        {"fieldId": 5, "tracks": draw(_columns(_LINES))},
        *draw(st.sampled_from([[], [{"fieldId": 7, "tracks": [{"trackNo": 0, "frames": [row(1, "x")]}]}]])),
    ]
    headers = [{"fieldId": 0, "names": names}, {"fieldId": 3, "names": ["S1", "S2"]}]
    table = {
        "name": draw(st.sampled_from(["c012", "影", ""])),
        "duration": 24,
        "timeTableHeaders": headers,
        "fields": fields,
    }
    header = draw(_NUMBERS)
    return {"version": 5, "timeTables": [table], **({} if header is None else {"header": header})}


def _told(sheet: Timesheet) -> tuple[object, ...]:
    """All that a sheet says, but what is said about the file."""
    return (sheet.name, sheet.length_frames, sheet.tracks, sheet.scene, sheet.cut, sheet.marks)


def _ticks(tree: dict[str, Any]) -> list[tuple[int, int, str]]:
    """Where marks on cels stand within the cut, by column and frame."""
    (field,) = [each for each in tree["timeTables"][0]["fields"] if each["fieldId"] == 0]
    found = [
        (track["trackNo"], line["frame"], str(line["data"][0]["values"][0]))
        for track in field["tracks"]
        for line in track["frames"]
        if 0 <= line["frame"] < 24
    ]
    return sorted(each for each in found if each[2].startswith("SYMBOL") and each[2] != "SYMBOL_NULL_CELL")


@given(_files())
def test_what_is_read_is_written_and_read_again(tree: dict[str, Any]) -> None:
    (sheet,) = sheets_of(text_of(tree))
    text = xdts_text(sheet)
    (again,) = sheets_of(text)
    assert _told(again) == _told(sheet)
    assert xdts_text(again) == text
    written = tree_in(text)
    assert written.get("header") == tree.get("header")
    assert _ticks(written) == _ticks(tree)
    others = [[part for part in each["timeTables"][0]["fields"] if part["fieldId"] != 0] for each in (tree, written)]
    assert others[0] == others[1]


def test_the_numbers_of_a_head_are_read_and_win_where_they_are_changed() -> None:
    (sheet,) = sheets_of(text_of(TREE))
    assert (sheet.scene, sheet.cut) == ("3", "12")
    changed = tree_in(xdts_text(replace(sheet, cut="13")))
    assert changed["header"] == {"cut": "13", "scene": "3"}
    (bare,) = sheets_of(text_of({key: value for key, value in TREE.items() if key != "header"}))
    assert "header" not in tree_in(xdts_text(bare))
    assert tree_in(xdts_text(replace(bare, cut="7")))["header"] == {"cut": "7", "scene": "1"}
    assert tree_in(xdts_text(Timesheet("new", 3, ())))["header"] == {"cut": "1", "scene": "1"}
    heads: list[object] = [[], "12", None, {"cut": None}]
    for header in heads:
        (odd,) = sheets_of(text_of({**TREE, "header": header}))
        assert (odd.scene, odd.cut) == ("", "")
