"""Where the time of an export goes, as a flame graph: py-spy looks at the program from outside."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.project.file import save
from kagezou.message import Message
from kagezou.own_process import program_words

_A_SECOND: Final = 200
"""So often it looks."""


def write_flame_graph(document: Document, path: Path) -> None:
    """Export the frames of a document and write where the time went as an SVG picture, all its processes and threads.

    Raises
    ------
    UsageProblem
        py-spy is not installed.
    OutputProblem
        It cannot look at the program, or the picture cannot be written.
    """
    program = _program()
    with tempfile.TemporaryDirectory(prefix="kagezou-profile-") as place:
        folder = Path(place)
        save(document, folder / "cut.kage")
        export = (*program_words(), "render", str(folder / "cut.kage"), "-o", str(folder / "out"))
        looking = [program, "record", "--output", str(folder / "graph.svg"), "--rate", str(_A_SECOND)]
        # What the driver and the codecs do is seen where the system lets it be.
        native = ["--native"] if sys.platform == "linux" else []
        done = subprocess.run(
            [*looking, *native, "--subprocesses", "--threads", "--", *export], capture_output=True, check=False
        )
        if done.returncode or not (folder / "graph.svg").is_file():
            said = (done.stderr.decode("utf-8", "replace").strip().splitlines() or ["?"])[-1]
            raise OutputProblem(Message("py-spy cannot look at the program: {error}", error=said))
        write_bytes(path, (folder / "graph.svg").read_bytes())


def _program() -> str:
    beside = Path(sys.executable).with_name("py-spy")
    found = shutil.which("py-spy") or shutil.which(str(beside))
    if found is None:
        raise UsageProblem(Message("a flame graph needs py-spy, which is not installed: pip install py-spy"))
    return found
