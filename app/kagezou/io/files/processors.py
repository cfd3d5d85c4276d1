"""How many threads are worth having."""

import os


def processors() -> int:
    """Return how many threads this process may keep busy."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1
