"""What system this is, for whoever helps."""

import os
import sys


def system_words() -> str:
    """Return the system, its release, its C library where it tells that, and the kind of machine, in one line.

    Python's own `platform` runs another program to find that out, which takes as long as half a frame; this is written
    down at every start.
    """
    if sys.platform == "win32":
        version = sys.getwindowsversion()
        return f"Windows {version.major}.{version.minor}.{version.build}, {os.environ.get('PROCESSOR_ARCHITECTURE')}"
    system = os.uname()
    library = os.confstr("CS_GNU_LIBC_VERSION") if "CS_GNU_LIBC_VERSION" in os.confstr_names else None
    return ", ".join(filter(None, (f"{system.sysname} {system.release}", library, system.machine)))
