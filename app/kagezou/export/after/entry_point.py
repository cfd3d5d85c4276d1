"""Calls one entry point of `kagezou.after_export` with a manifest: ``python -m … MODULE:FUNCTION MANIFEST.json``."""

import json
import sys
from importlib.metadata import EntryPoint
from pathlib import Path


def main(value: str, manifest: str) -> None:
    """Call the entry point; what it raises is the end of this process."""
    found = EntryPoint("after", value, "kagezou.after_export").load()
    found(json.loads(Path(manifest).read_text(encoding="utf-8")))


if __name__ == "__main__":
    main(*sys.argv[1:])
