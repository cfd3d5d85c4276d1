"""Making anew what changed on disk, and nothing else; looks are given one by one, and nothing waits."""

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from kagezou.animation.track import Interpolation
from kagezou.document.address import resolve
from kagezou.document.edits import set_key
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.errors import OutputProblem
from kagezou.export.frames import export_frames
from kagezou.export.request import ExportRequest, Summary
from kagezou.export.watching import FileWatch, Watch, WatchedExport, WatchRound
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.project.file import load, save
from kagezou.message import Message
from kagezou.render.gpu.context import open_headless_context
from tests.batch.cut_folders import picture
from tests.export.small_cuts import bytes_below, cut


@dataclass
class Rounds:
    """A project of four drawings that is watched, and what came of each look."""

    project: Path
    out: Path
    asked: ExportRequest
    exports: int = 0
    fault: Callable[[], None] = field(default=lambda: None)

    def __post_init__(self) -> None:
        self.watch = Watch(WatchedExport(lambda: load(self.project), (self.project,), self._export), FileWatch())

    def _export(self, document: Document, anew: frozenset[Path]) -> Summary:
        self.exports += 1
        self.fault()
        request = replace(self.asked, skip_existing=True, keep_going=True, anew=anew)
        return export_frames(document, request, open_headless_context, lambda _done, _all: None, lambda: False)

    def written(self) -> int:
        """Look twice, as what changes is waited for, and return how many files were written."""
        assert self.watch.look() is None, "what changes is waited for"
        made = self.watch.look()
        return 0 if made is None or made.summary is None else made.summary.written

    @property
    def drawings(self) -> list[Path]:
        return [each.path for each in load(self.project).layers[0].cels.drawings]


@pytest.fixture
def rounds(tmp_path: Path) -> Rounds:
    save(cut(tmp_path, count=4, length=8), tmp_path / "cut.kage")
    made = Rounds(tmp_path / "cut.kage", tmp_path / "out", ExportRequest(tmp_path / "out", composite=True))
    first = made.watch.first()
    assert first.summary is not None
    assert (first.summary.written, first.problems) == (16, ())
    return made


def held(document: Document, frame: int, position: list[float]) -> Document:
    """Return the document with its lamp at a place from a frame on."""
    return set_key(document, resolve(document, "light.position"), frame, position, Interpolation.HOLD)


def frames_of(document: Document, drawing: int) -> int:
    """Return on how many frames a drawing is shown."""
    exposures = document.layers[0].cels.exposures
    ends = [*(each.frame for each in exposures[1:]), document.canvas.length_frames + 1]
    return sum(end - each.frame for each, end in zip(exposures, ends, strict=True) if each.drawing == drawing)


def test_nothing_is_made_while_nothing_changes(rounds: Rounds) -> None:
    assert [rounds.watch.look() for _ in range(12)] == [None] * 12
    assert rounds.exports == 1


def test_of_a_changed_drawing_only_the_frames_that_show_it_are_made(rounds: Rounds) -> None:
    before = bytes_below(rounds.out)
    picture(rounds.drawings[1], 30)
    made = frames_of(load(rounds.project), 1)
    assert 0 < made < 8
    assert rounds.written() == 2 * made, "shadow and composite"
    changed = [name for name, data in bytes_below(rounds.out).items() if before[name] != data]
    assert len(changed) == 2 * made
    assert rounds.watch.look() is None


def test_a_drawing_that_changes_without_its_size_and_time_is_seen(rounds: Rounds) -> None:
    path = rounds.drawings[2]
    status = path.stat()
    data = bytearray(path.read_bytes())
    picture(path, 31)
    other = path.read_bytes()
    path.write_bytes(other[: len(data)].ljust(len(data), b"\0"))
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
    assert path.stat().st_size == status.st_size
    assert rounds.watch.look() is None
    made = rounds.watch.look()
    assert made is not None
    assert made.changed == (path,)
    assert made.summary is not None
    assert made.summary.trusted == 16 - 2 * frames_of(load(rounds.project), 2)


def test_what_is_half_written_is_waited_for(rounds: Rounds) -> None:
    path = rounds.drawings[0]
    whole = picture(path.with_name("aside.png"), 33).read_bytes()
    for part in (20, 40, 60):
        path.write_bytes(whole[:part])
        assert rounds.watch.look() is None
    assert rounds.exports == 1
    path.write_bytes(whole)
    assert rounds.written() > 0


def test_a_drawing_that_fails_is_said_once_and_made_when_it_is_whole(rounds: Rounds) -> None:
    path = rounds.drawings[3]
    whole = path.read_bytes()
    path.write_bytes(whole[:50])
    assert rounds.watch.look() is None
    made = rounds.watch.look()
    assert made is not None
    assert "cut short" in str(made.problems[0])
    assert [rounds.watch.look() for _ in range(25)] == [None] * 25, "it is tried again, and not said again"
    assert rounds.exports == 4
    path.write_bytes(whole)
    assert rounds.written() == 2 * frames_of(load(rounds.project), 3)
    assert all(rounds.watch.look() is None for _ in range(12))


def test_a_drawing_that_goes_and_comes_back(rounds: Rounds) -> None:
    path = rounds.drawings[1]
    whole = path.read_bytes()
    path.unlink()
    assert rounds.watch.look() is None
    made = rounds.watch.look()
    assert made is not None
    assert "does not exist" in str(made.problems[0])
    path.write_bytes(whole)
    assert rounds.written() == 2 * frames_of(load(rounds.project), 1)


def test_a_project_that_is_saved_anew_is_read_anew_and_only_its_changed_frames_are_made(rounds: Rounds) -> None:
    document = held(load(rounds.project), 1, [5, -20, 40])
    save(held(document, 7, [40, -25, 45]), rounds.project)
    assert rounds.written() == 16, "another light on all frames"
    document = load(rounds.project)
    save(held(document, 7, [41, -25, 45]), rounds.project)
    assert rounds.written() == 2 * 2, "the last two frames"


def test_a_project_that_cannot_be_read_is_said_once_and_waited_for(rounds: Rounds) -> None:
    whole = rounds.project.read_bytes()
    rounds.project.write_bytes(whole[:100])
    assert rounds.watch.look() is None
    made = rounds.watch.look()
    assert made is not None
    assert (made.summary, len(made.problems)) == (None, 1)
    assert [rounds.watch.look() for _ in range(25)] == [None] * 25
    rounds.project.write_bytes(whole)
    assert rounds.written() == 0
    assert rounds.exports == 2, "looked through, and all of it was there"


def test_a_place_that_refuses_is_said_once_and_what_was_to_be_made_is_not_forgotten(rounds: Rounds) -> None:
    def refuse() -> None:
        raise OutputProblem(Message("no"))

    rounds.fault = refuse
    picture(rounds.drawings[1], 30)
    assert rounds.watch.look() is None
    made = rounds.watch.look()
    assert made == WatchRound((rounds.drawings[1],), None, (Message("no"),), made.notes if made else ())
    rounds.fault = lambda: None
    rest = [rounds.watch.look() for _ in range(12)]
    (again,) = [each for each in rest if each is not None]
    assert again.summary is not None
    assert again.summary.written == 2 * frames_of(load(rounds.project), 1)


def test_a_change_is_told_once_at_the_second_look(tmp_path: Path) -> None:
    watch, path = FileWatch(lambda: 0), tmp_path / "a"
    path.write_bytes(b"one")
    watch.know([path])
    assert watch.look([path]) == ()
    path.write_bytes(b"two!")
    assert watch.look([path]) == ()
    assert watch.look([path]) == (path,)
    assert watch.look([path]) == ()


def test_two_changes_within_one_tick_of_the_clock_are_told_apart_by_content(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"one")
    frozen = path.stat()
    monkeypatch.setattr(Path, "stat", lambda _self, **_: frozen)
    watch = FileWatch(lambda: frozen.st_mtime_ns)
    watch.know([path])
    path.write_bytes(b"two")
    assert [watch.look([path]) for _ in range(3)] == [(), (path,), ()]


def test_a_buffer_of_a_set_makes_anew_what_the_set_is_in(tmp_path: Path) -> None:
    buffer, path = tmp_path / "a.bin", tmp_path / "a.gltf"
    buffer.write_bytes(bytes(4))
    path.write_text('{"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin", "byteLength": 4}]}', encoding="utf-8")
    document = add_piece(cut(tmp_path, count=1), "set", PieceKind.BOX)
    document = replace(document, pieces=tuple(replace(piece, source=path) for piece in document.pieces))
    asked: list[frozenset[Path]] = []

    def export(_document: Document, anew: frozenset[Path]) -> Summary:
        asked.append(anew)
        return Summary(1, 0, 0, 1, (), False, (), {}, 0.0)  # noqa: FBT003

    watch = Watch(WatchedExport(lambda: document, (), export), FileWatch())
    watch.first()
    buffer.write_bytes(bytes(8))
    assert watch.look() is None
    made = watch.look()
    assert made is not None
    assert made.changed == (buffer,)
    assert asked == [frozenset(), {buffer, path}]
