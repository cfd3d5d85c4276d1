"""The report of a batch: one page for whoever answers for the cuts, with everything in it, in any language.

It loads nothing: pictures, styles and the few lines that sort it are within. Names and sentences are text wherever they
come from, never markup.
"""

import base64
from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime
from html import escape
from pathlib import Path
from typing import Final
from urllib.parse import quote

from kagezou.animation.frames import format_frames
from kagezou.batch.record import REPORT_NAME, CutRecord, State, Thumbnail
from kagezou.io.clips.catalogues import messages_in
from kagezou.io.files.atomic import write_bytes
from kagezou.locations import resource_folder
from kagezou.message import Message, Translate

_REFRESH_S: Final = 10
_WORTH_TELLING_S: Final = 0.5
_STATES: Final = {
    State.FAILED: Message("failed", "a cut"),
    State.STOPPED: Message("stopped", "a cut"),
    State.RUNNING: Message("being made", "a cut"),
    State.WAITING: Message("waiting", "a cut"),
    State.DONE: Message("made", "a cut"),
    State.KEPT: Message("left alone, as nothing changed", "a cut"),
}
"""How a cut went, in words; the worst first."""

_RANKS: Final = {state: rank for rank, state in enumerate(_STATES)}


def write_report(records: Sequence[CutRecord], output: Path, language: str, now: datetime) -> Path:
    """Write the report of cuts into their output folder, as a whole, and return its file.

    Parameters
    ----------
    records
        How the cuts stand.
    output
        Where the folder of each lies.
    language
        The code of a catalogue.
    now
        When that was.

    Raises
    ------
    OutputProblem, DiskFullProblem
        It cannot be written; the one before is still there.
    """
    path = output / REPORT_NAME
    write_bytes(path, report_page(records, output.name, language, now).encode("utf-8", "replace"))
    return path


def report_page(records: Sequence[CutRecord], title: str, language: str, now: datetime) -> str:
    """Return the text of the page; the arguments are those of `write_report`, and what the batch is called."""
    return "\n".join(_Page(messages_in(language), language).lines(records, title, now)) + "\n"


class _Page:
    """A page in one language.

    Parameters
    ----------
    translate, language
        What translates, and its code.
    """

    def __init__(self, translate: Translate, language: str) -> None:
        self._translate, self._language = translate, language

    def lines(self, records: Sequence[CutRecord], title: str, now: datetime) -> Iterator[str]:
        """Yield the page line by line."""
        is_under_way = any(each.state in (State.RUNNING, State.WAITING) for each in records)
        yield "<!doctype html>"
        yield f'<html lang="{escape(self._language)}"><head><meta charset="utf-8">'
        yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
        if is_under_way:
            yield f'<meta http-equiv="refresh" content="{_REFRESH_S}">'
        heading = self._said(Message("Cuts of {name}", name=title or "/"))
        yield f"<title>{heading}</title><style>{_resource('report.css')}</style></head><body>"
        yield f"<header><h1>{heading}</h1>"
        made = Message("Kagezou, {time}", time=f"{now:%Y-%m-%d %H:%M}")
        going = Message("Kagezou, {time}; still being made, this page renews itself", time=f"{now:%Y-%m-%d %H:%M}")
        yield f'<p class="when">{self._said(going if is_under_way else made)}</p>'
        yield from self._totals(records)
        yield from self._choices(records)
        yield "</header><main>"
        placed = sorted(enumerate(records), key=lambda each: (_RANKS[each[1].state], each[0]))
        for place, record in placed:
            yield from self._cut(record, place)
        yield "</main>"
        yield f"<script>{_resource('report.js')}</script></body></html>"

    def _said(self, message: Message) -> str:
        return escape(message.sentence(self._translate))

    def _totals(self, records: Sequence[CutRecord]) -> Iterator[str]:
        count = {state: sum(each.state is state for each in records) for state in State}
        left = count[State.WAITING] + count[State.RUNNING] + count[State.STOPPED]
        rows = [
            ("all", len(records), Message("cuts")),
            ("failed", count[State.FAILED], Message("failed", "cuts")),
            ("doubtful", sum(bool(each.doubtful) for each in records), Message("with doubtful drawings")),
            ("done", count[State.DONE], Message("made", "cuts")),
            ("kept", count[State.KEPT], Message("left alone", "cuts")),
            *([("left", left, Message("still to be made", "cuts"))] if left else []),
        ]
        yield '<ul class="totals">'
        for name, number, words in rows:
            quiet = "" if number else " none"
            yield f'<li class="{name}{quiet}"><b>{number}</b><span>{self._said(words)}</span></li>'
        frames = sum(each.frames for each in records)
        yield f'<li class="frames"><b>{frames}</b><span>{self._said(Message("frames", "of all cuts"))}</span></li>'
        seconds = _clock(sum(each.seconds for each in records))
        yield f'<li class="time"><b>{seconds}</b><span>{self._said(Message("of work, cut by cut"))}</span></li></ul>'

    def _choices(self, records: Sequence[CutRecord]) -> Iterator[str]:
        shown = {
            "all": Message("All cuts"),
            "failed": Message("Failed", "cuts that are shown"),
            "doubtful": Message("Doubtful", "cuts that are shown"),
            "noted": Message("With remarks", "cuts that are shown"),
        }
        orders = {
            "worst": Message("failed ones first"),
            "name": Message("as they were given"),
            "time": Message("the slowest first"),
        }
        if not records:
            yield f'<p class="nothing">{self._said(Message("There are no cuts."))}</p>'
        yield '<div class="choices"><fieldset>'
        for name, words in shown.items():
            checked = " checked" if name == "all" else ""
            yield f'<label><input type="radio" name="show" id="show-{name}"{checked}>{self._said(words)}</label>'
        yield f"</fieldset><label>{self._said(Message('Order', 'of cuts'))} <select>"
        for name, words in orders.items():
            yield f'<option value="{name}">{escape(words.formatted(self._translate))}</option>'
        yield "</select></label></div>"

    def _cut(self, record: CutRecord, place: int) -> Iterator[str]:
        kinds = {
            "cut": True,
            f"is-{record.state.value}": True,
            "is-doubtful": bool(record.doubtful),
            "is-noted": bool(record.notes),
        }
        classes = " ".join(name for name, holds in kinds.items() if holds)
        facts = f'data-rank="{_RANKS[record.state]}" data-place="{place}" data-seconds="{record.seconds:.3f}"'
        yield f'<article class="{classes}" {facts}><div class="head">'
        yield f'<h2>{escape(record.name)}</h2><span class="state">{self._said(_STATES[record.state])}</span>'
        yield f'<span class="facts">{" · ".join(self._facts(record))}</span>'
        yield f'<span class="links">{" ".join(self._links(record))}</span></div>'
        if record.problem is not None:
            yield f'<p class="problem">{self._said(record.problem)}</p>'
        if record.thumbnails:
            yield '<div class="sheet">'
            yield from (self._figure(each) for each in record.thumbnails)
            yield "</div>"
        yield from self._remarks(record)
        yield "</article>"

    def _facts(self, record: CutRecord) -> Iterator[str]:
        if record.layers:
            yield escape(", ".join(record.layers))
        if record.frames:
            width, height = record.size_px
            yield self._said(Message("{count} frames at {rate} fps", count=record.frames, rate=f"{record.rate:g}"))
            yield f"{width} × {height}"
        for kind, there, whole in record.counts:
            number = str(whole) if there == whole else f"{there} / {whole}"
            yield self._said(Message("{count} {kind}", count=number, kind=kind))
        if record.seconds >= _WORTH_TELLING_S:
            yield _clock(record.seconds)

    def _links(self, record: CutRecord) -> Iterator[str]:
        if record.project:
            yield self._link((record.name, record.project), Message("Project", "a link"))
        if record.counts:
            yield self._link((record.name, record.where), Message("Output", "a link"))

    def _link(self, parts: Iterable[str], words: Message) -> str:
        return f'<a href="./{"/".join(quote(each) for each in parts if each)}">{self._said(words)}</a>'

    def _figure(self, thumbnail: Thumbnail) -> str:
        picture = base64.b64encode(thumbnail.jpeg).decode("ascii")
        words = Message("frame {frame}", frame=thumbnail.frame)
        if thumbnail.is_doubtful:
            words = Message("frame {frame}: doubtful", frame=thumbnail.frame)
        mark = ' class="doubt"' if thumbnail.is_doubtful else ""
        said = self._said(words)
        return (
            f'<figure{mark}><img alt="{said}" loading="lazy" src="data:image/jpeg;base64,{picture}">'
            f"<figcaption>{said}</figcaption></figure>"
        )

    def _remarks(self, record: CutRecord) -> Iterator[str]:
        """Yield which drawings are doubtful, and what else was said."""
        for name, frames in record.doubtful:
            words = Message(
                "{name}: which foot carries is doubtful on {count} drawings (frames {frames}); please look at them",
                name=name,
                count=len(frames),
                frames=format_frames(frames),
            )
            yield f'<p class="doubts">{self._said(words)}</p>'
        if record.notes:
            yield '<ul class="notes">'
            yield from (f"<li>{self._said(note)}</li>" for note in record.notes)
            yield "</ul>"


def _resource(name: str) -> str:
    return (resource_folder() / "report" / name).read_text(encoding="utf-8")


def _clock(seconds: float) -> str:
    """Return a duration as minutes and seconds, with hours where there are some."""
    minutes, rest = divmod(max(round(seconds), 0), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
