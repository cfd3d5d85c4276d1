"""What is new in a release, out of the changelog: ``python3 packaging/release_notes.py v0.2.0`` prints it.

Ends with 1 where the tag is not the program's version or the changelog has no such part.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def version() -> str:
    """Return the program's version."""
    text = (ROOT / "app" / "kagezou" / "version.py").read_text(encoding="utf-8")
    return str(re.findall(r'__version__ = "(.+)"', text)[0])


def notes_of(changelog: str, wanted: str) -> str | None:
    """Return the part of a changelog about a version, without its heading; None where there is none."""
    parts = re.split(r"^## ", changelog, flags=re.MULTILINE)[1:]
    for part in parts:
        heading, _, body = part.partition("\n")
        if re.match(rf"\[?{re.escape(wanted)}\]?(?![\w.])", heading):
            return body.strip() + "\n"
    return None


def main(arguments: list[str]) -> int:
    """Print the notes."""
    tag = arguments[0] if arguments else f"v{version()}"
    if tag != f"v{version()}":
        sys.stderr.write(f"the tag {tag} is not the version, {version()}\n")
        return 1
    notes = notes_of((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version())
    if notes is None:
        sys.stderr.write(f"CHANGELOG.md has no part about {version()}\n")
        return 1
    sys.stdout.write(notes)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
