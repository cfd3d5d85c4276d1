"""Where the whole story of a defect of ours goes, so that the person sees one line and can send the rest."""

import os
import sys
import traceback
from collections.abc import Sequence
from typing import Final

from kagezou.io.files.crash_reports import report_folder, write_report

DEBUG_VARIABLE: Final = "KAGEZOU_DEBUG"


def noted_at(error: BaseException, arguments: Sequence[str]) -> str:
    """Write down a defect and return where that is, or why it could not be done."""
    story = "".join(traceback.format_exception(error))
    if os.environ.get(DEBUG_VARIABLE):
        sys.stderr.write(story)
    try:
        path = write_report(story, [f"called with: {list(arguments)!r}"])
    except OSError as refusal:
        words = f"no report could be written in {report_folder()}: {refusal.strerror}"
        return f"{words}; set {DEBUG_VARIABLE}=1 to see it all"
    return f"the details are in {path}"
