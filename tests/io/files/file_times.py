"""Times of files, which a system counts in steps."""

import time
from pathlib import Path


def wait_for_another_time(path: Path) -> None:
    """Return once a change is given a later time than the last one of a file: a few milliseconds."""
    last_ns = path.stat().st_ctime_ns
    probe = path.with_name(f"{path.name}.probe")
    while True:
        probe.write_bytes(b"")
        now_ns = probe.stat().st_ctime_ns
        probe.unlink()
        if now_ns > last_ns:
            return
        time.sleep(0.001)
