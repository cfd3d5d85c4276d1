"""What an export tells while it works: every step is counted, and the last one is the end."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_background
from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.export.exporters.table import EXPORTERS, exporter_of, sound
from kagezou.io.images.writing import write_rgba
from kagezou.io.project.file import save
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import HEIGHT, WIDTH, cut, with_values

KINDS = [each.key for each in EXPORTERS]
LENGTH = 4


@pytest.fixture
def document(tmp_path: Path) -> Document:
    write_rgba(tmp_path / "meadow.png", np.full((HEIGHT, WIDTH, 4), (60, 160, 90, 255), np.uint8))
    made = set_background(cut(tmp_path, count=3, length=LENGTH), tmp_path / "meadow.png")
    return with_values(made, **{"layers.A.receives": True})


@pytest.fixture
def place(tmp_path: Path, document: Document) -> Place:
    save(document, tmp_path / "walk.kage")
    return Place(tmp_path / "out", tmp_path / "walk.kage", "walk")


def files_in(folder: Path) -> set[Path]:
    return {path for path in folder.rglob("*") if path.is_file() and not path.name.startswith(".")}


class Watch:
    """An export that is watched: its steps, and what lay in the folder when the last one was told."""

    def __init__(self, document: Document, choices: ExportChoices, place: Place) -> None:
        self.steps: list[tuple[int, int]] = []
        self.at_last: set[Path] = set()
        self._stop_at = 0
        self._work = exporter_of(choices).work(document, choices, place)
        self._folder = place.folder

    def run(self, stop_at: int = 1 << 30) -> ExportOutcome:
        self._stop_at = stop_at
        return self._work(open_headless_context, self._note, lambda: self.done >= self._stop_at)

    @property
    def done(self) -> int:
        return self.steps[-1][0] if self.steps else 0

    def _note(self, done: int, whole: int) -> None:
        self.steps.append((done, whole))
        if done == whole:
            self.at_last = files_in(self._folder)


def choices_of_all() -> Iterator[ExportChoices]:
    for kind in KINDS:
        yield sound(ExportChoices(kind, composite=True, receivers=True, mattes=("core", "receivers")))
    yield ExportChoices("after effects", copies=False)
    yield ExportChoices("after effects", per_drawing=True)


@pytest.mark.parametrize("choices", list(choices_of_all()), ids=str)
@pytest.mark.parametrize("again", [False, True])
def test_the_last_step_is_the_end(document: Document, choices: ExportChoices, place: Place, *, again: bool) -> None:
    if again:
        Watch(document, choices, place).run()
    watch = Watch(document, choices, place)
    outcome = watch.run()
    assert outcome.is_whole
    assert watch.steps[-1][0] == watch.steps[-1][1]
    assert len({whole for _, whole in watch.steps}) == 1
    assert [done for done, _ in watch.steps] == sorted({done for done, _ in watch.steps}), "never back, never twice"
    assert watch.at_last == files_in(place.folder), "nothing is made after it"
    assert len(watch.at_last) == outcome.files


def test_frames_that_were_there_are_counted_one_by_one(document: Document, place: Place) -> None:
    choices = ExportChoices()
    Watch(document, choices, place).run()
    watch = Watch(document, choices, place)
    outcome = watch.run()
    assert (outcome.written, outcome.there) == (0, outcome.files)
    assert len(watch.steps) > 1, "the search for what is whole is told too"


def test_stopping_while_frames_are_looked_through_ends_it(document: Document, place: Place) -> None:
    choices = ExportChoices(composite=True)
    Watch(document, choices, place).run()
    outcome = Watch(document, choices, place).run(stop_at=1)
    assert outcome.cancelled
    assert 0 < outcome.there < outcome.files


@pytest.mark.parametrize("stop_at", [1, 2 * LENGTH + 1, 2 * LENGTH + 4])
def test_a_stopped_hand_off_counts_what_is_there(document: Document, place: Place, stop_at: int) -> None:
    outcome = Watch(document, ExportChoices("after effects"), place).run(stop_at)
    counts = {str(each.kind): (each.there, each.files) for each in outcome.counts}
    assert counts["script"] == (0, 1)
    assert [whole for _, whole in counts.values()] == [LENGTH, LENGTH, 3, 1, 1]
    assert stop_at <= outcome.there < outcome.files, "what was in hand is finished"
    assert outcome.there == len(files_in(place.folder))
    assert outcome.cancelled
    assert not list(place.folder.glob("*.jsx"))
    whole = Watch(document, ExportChoices("after effects"), place).run()
    assert whole.is_whole
    frames = counts["shadow frames"][0] + counts["received shadows"][0]
    assert whole.written == whole.files - frames, "frames that were there are not made again"


def test_a_stopped_video_is_not_there(document: Document, place: Place) -> None:
    outcome = Watch(document, ExportChoices("video", format="mp4"), place).run(stop_at=0)
    assert (outcome.there, outcome.files, outcome.where) == (0, 1, place.folder)
    assert [str(each) for each in outcome.next_steps] == [
        "It is there as a whole or not at all: export again to make it."
    ]
    assert files_in(place.folder) == set()


@pytest.mark.parametrize("exporter", EXPORTERS, ids=KINDS)
def test_every_exporter_says_what_to_do_next(document: Document, place: Place, exporter: object) -> None:
    for each in EXPORTERS:
        if each is exporter:
            for form in each.formats(ExportChoices(each.key)):
                choices = sound(ExportChoices(each.key, format=form))
                assert 1 <= len(each.next_steps(document, choices, place)) <= 3


def test_the_next_step_knows_format_rate_and_blend(document: Document, place: Place) -> None:
    def words(document: Document, choices: ExportChoices) -> str:
        return " ".join(map(str, exporter_of(choices).next_steps(document, choices, place)))

    film = replace(document, canvas=replace(document.canvas, frame_rate=document.canvas.frame_rate * 1000 / 1001))
    assert "23.976 frames a second, with straight" in words(film, ExportChoices())
    assert "“Targa Sequence”" in words(film, ExportChoices(format="tga"))
    assert "premultiplied" in words(film, ExportChoices(format="exr", depth=16))
    assert "set it to Multiply" in words(document, ExportChoices())
    normal = with_values(document, layers__A__shadow__blend="normal")
    assert "Multiply" not in words(normal, ExportChoices())
    assert "kagezou:blend" in words(document, ExportChoices("layered", format="exr", depth=16))
    assert "straight" in words(document, ExportChoices("video", format="mov", video_layer="A"))
