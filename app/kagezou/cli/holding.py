"""Verbs that change a project hold it meanwhile, so that two at once never lose what the other did."""

from argparse import Namespace
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import TypeAlias

from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import note

Run: TypeAlias = Callable[[Namespace, EntryPoints], int]


def holding_project(run: Run) -> Run:
    """Hold ``options.project`` while a verb runs that loads, changes and saves it; say if a window has it open."""

    @wraps(run)
    def held(options: Namespace, entry_points: EntryPoints) -> int:
        # What takes long to import is imported before anyone has to wait for it.
        import kagezou.io.project.file  # noqa: F401 - for the time it takes

        if _only_looks(options):
            return run(options, entry_points)
        with held_project(options.project):
            return run(options, entry_points)

    return held


@contextmanager
def held_project(path: Path) -> Iterator[None]:
    """Hold a project that is there while it is changed, as long as the ``with`` lasts; say if a window has it open."""
    from kagezou.io.files.exclusive import exclusive
    from kagezou.io.project.open_elsewhere import open_elsewhere

    said = open_elsewhere(path)
    if said is not None:
        note(said)
    with exclusive(path.resolve()):
        yield


def _only_looks(options: Namespace) -> bool:
    """Return whether nothing will be written, or there is nothing yet that could be: the verb says so itself."""
    looks = getattr(options, "dry_run", False) or getattr(options, "list", False)
    return bool(looks) or options.project is None or not options.project.is_file()
