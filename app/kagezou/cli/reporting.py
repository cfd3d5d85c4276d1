"""What is said about an export when it is over."""

from typing import TYPE_CHECKING

from kagezou.cli.interruption import Interruption
from kagezou.cli.terminal import give, give_json, note, tell
from kagezou.errors import SomeFramesFailed
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.export.request import Summary


def report(summary: "Summary", *, as_json: bool) -> None:
    """Print the folders, or one object; notes about names go to stderr."""
    from kagezou.io.files.faults import shown

    for layer, name in summary.names.items():
        if layer != name and not as_json:
            words = "layer {layer!r} is written as {name!r}, which every system accepts"
            note(Message(words, layer=layer, name=name))
    for sentence in summary.notes:
        note(sentence)
    if as_json:
        give_json(
            {
                "files": summary.files,
                "written": summary.written,
                "drawn": summary.drawn,
                "trusted": summary.trusted,
                "failed": [{"frames": list(each.frames), "why": str(each.message)} for each in summary.failures],
                "whole": summary.is_whole,
                "folders": [shown(folder) for folder in summary.folders],
                "names": summary.names,
                "notes": [str(each) for each in summary.notes],
                "seconds": round(summary.seconds, 3),
                "fps": round(summary.written / summary.seconds, 2) if summary.seconds > 0 else None,
            }
        )
        return
    for folder in summary.folders:
        give(shown(folder))


def verdict(summary: "Summary", interruption: Interruption) -> int:
    """Say what is not whole and return the exit code."""
    from kagezou.animation.frames import format_frames

    for failure in summary.failures:
        tell(f"frame {format_frames(failure.frames)}: {failure.message}")
    if summary.cancelled:
        done = summary.written + summary.trusted
        tell(f"stopped after {done} of {summary.files} frames, all of them whole; --skip-existing goes on from there")
        return interruption.exit_code
    if summary.failures:
        failed = sum(len(failure.frames) for failure in summary.failures)
        raise SomeFramesFailed(Message("{failed} of {files} frames failed", failed=failed, files=summary.files))
    return 0
