"""What the operating system must bring: which libraries, which of them are missing, and how to get them.

Wheels from the package index carry Qt, OpenImageIO and numpy, but not the graphics driver's own libraries and
the X11 and Wayland client libraries: those belong to the system, and a bare Debian or Ubuntu has none of them.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass


class SetupProblem(Exception):
    """Something the person at the keyboard can mend; ``str(problem)`` is the whole sentence."""


@dataclass(frozen=True)
class Library:
    """One thing the system must have.

    Attributes
    ----------
    packages
        Its Debian and Ubuntu names, the newest release's first: 64-bit ``time_t`` renamed some.
    probe
        What to try where there is no apt: a library file to load, a program to find, or ``import`` and a module
        name; empty if nothing tells.
    words
        What to look for in another distribution's package manager.
    """

    packages: tuple[str, ...]
    probe: str
    words: str


HEADLESS = (
    Library(("libegl1",), "libEGL.so.1", "EGL"),
    Library(("libgl1",), "libGL.so.1", "OpenGL (libGL)"),
    Library(("libgl1-mesa-dri",), "", "the Mesa drivers"),
)
_GLIB = Library(("libglib2.0-0t64", "libglib2.0-0"), "libglib-2.0.so.0", "GLib 2")
WINDOW = (
    _GLIB,
    Library(("libdbus-1-3",), "libdbus-1.so.3", "D-Bus (libdbus)"),
    Library(("libfontconfig1",), "libfontconfig.so.1", "fontconfig"),
    Library(("libxkbcommon-x11-0",), "libxkbcommon-x11.so.0", "xkbcommon with X11"),
    Library(("libxcb-cursor0",), "libxcb-cursor.so.0", "xcb-util-cursor"),
    Library(("libxcb-icccm4",), "libxcb-icccm.so.4", "xcb-util-wm"),
    Library(("libxcb-keysyms1",), "libxcb-keysyms.so.1", "xcb-util-keysyms"),
    Library(("libxcb-shape0",), "libxcb-shape.so.0", "libxcb"),
    Library(("libwayland-cursor0",), "libwayland-cursor.so.0", "Wayland cursor"),
    Library(("libwayland-egl1",), "libwayland-egl.so.1", "Wayland EGL"),
)
# Qt's tools for translations are linked with its network library, which the window has no use for.
_KERBEROS = Library(("libgssapi-krb5-2",), "libgssapi_krb5.so.2", "Kerberos 5 (libgssapi_krb5)")
TESTS = (
    Library(("xvfb",), "Xvfb", "Xvfb"),
    Library(("xauth",), "xauth", "xauth"),
    Library(("fonts-noto-cjk",), "", "the Noto CJK fonts"),
    _KERBEROS,
)
TRANSLATIONS = (_GLIB, _KERBEROS)


def virtual_environment_support(version: tuple[int, int]) -> tuple[Library, ...]:
    """Return what Debian splits off from Python and ``venv`` cannot do without; empty where it is there."""
    if importlib.util.find_spec("ensurepip") and importlib.util.find_spec("venv"):
        return ()
    name = f"python{version[0]}.{version[1]}-venv"
    return (Library((name,), "import ensurepip", "Python's own venv and ensurepip modules"),)


def installed_packages(names: Collection[str]) -> set[str]:
    """Return those of the Debian packages that dpkg has fully installed."""
    query = ["dpkg-query", "-W", "-f=${Package} ${db:Status-Status}\\n", *names]
    # dpkg-query ends with 1 when it knows nothing of some names: that is an answer, not a failure.
    answer = subprocess.run(query, capture_output=True, text=True, check=False).stdout
    return {line.split()[0] for line in answer.splitlines() if line.endswith(" installed")}


def available_packages(names: Collection[str]) -> set[str]:
    """Return those of the Debian packages that apt could install from its present lists."""
    environment = {**os.environ, "LC_ALL": "C"}
    query = ["apt-cache", "policy", *names]
    answer = subprocess.run(query, capture_output=True, text=True, check=False, env=environment).stdout
    available, name = set(), ""
    for line in answer.splitlines():
        if not line.startswith(" "):
            name = line.rstrip(":")
        elif line.strip().startswith("Candidate:") and not line.endswith("(none)"):
            available.add(name)
    return available


def is_found(probe: str) -> bool:
    """Tell whether a library loads, a program is on the path or a module can be imported; empty is believed."""
    if not probe:
        return True
    if probe.startswith("import "):
        return importlib.util.find_spec(probe.split()[1]) is not None
    if ".so" not in probe:
        return shutil.which(probe) is not None
    try:
        ctypes.CDLL(probe)
    except OSError:
        return False
    return True


def has_apt() -> bool:
    """Tell whether this is Debian, Ubuntu or a relative."""
    return shutil.which("apt-get") is not None and shutil.which("dpkg-query") is not None


def missing_libraries(libraries: Sequence[Library]) -> list[Library]:
    """Return the libraries this system lacks, in the order given."""
    if not has_apt():
        return [library for library in libraries if not is_found(library.probe)]
    present = installed_packages([name for library in libraries for name in library.packages])
    return [library for library in libraries if present.isdisjoint(library.packages)]


def package_names(libraries: Sequence[Library], available: Collection[str]) -> list[str]:
    """Choose one Debian name per library: the first that apt offers, else the oldest, which is the best known."""
    return [
        next((name for name in library.packages if name in available), library.packages[-1]) for library in libraries
    ]


def way_to_root() -> list[str] | None:
    """Return what to put before a command to run it as root without being asked anything; None if there is no way."""
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        return []
    if shutil.which("sudo") is None:
        return None
    asked = subprocess.run(["sudo", "-n", "true"], capture_output=True, check=False)
    return ["sudo", "-n"] if asked.returncode == 0 else None


def apt_update(root: Sequence[str]) -> list[str]:
    """Compose the command that refreshes apt's lists."""
    return [*root, "apt-get", "-qq", "-o", "DPkg::Lock::Timeout=120", "update"]


def apt_install(root: Sequence[str], packages: Sequence[str]) -> list[str]:
    """Compose the command that installs packages without asking; through ``env``, since sudo drops variables."""
    quiet = ["-qq", "-o", "DPkg::Lock::Timeout=120", "install", "-y", "--no-install-recommends"]
    return [*root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", *quiet, *packages]


def line_to_type(packages: Sequence[str]) -> str:
    """Return the one shell line that an administrator can paste."""
    names = shlex.join(packages)
    return f"sudo apt-get update && sudo apt-get install -y --no-install-recommends {names}"


def run_quietly(command: Sequence[str], problem: str) -> None:
    """Run a command without its chatter; if it fails, show the end of what it said and stop with a sentence."""
    done = subprocess.run(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        check=False,
    )
    if done.returncode != 0:
        print("\n".join(done.stdout.splitlines()[-20:]), flush=True)
        raise SetupProblem(f"{problem} with code {done.returncode}; the end of what it said is above.")


def always(_root: Sequence[str]) -> bool:
    """Agree."""
    return True


def may_install(root: Sequence[str]) -> bool:
    """Ask whoever sits at the terminal whether system packages may be installed.

    Where nobody does, only root itself goes on, such as in a container: what takes ``sudo`` may be a machine that
    others use, too.
    """
    if not sys.stdin.isatty():
        return not root
    try:
        return input("Install them now? [y/N] ").strip().lower() in ("y", "yes")
    except EOFError:
        return False


def supply(
    needed: Sequence[Library],
    wished: Sequence[Library],
    say: Callable[[str], None],
    ask: Callable[[Sequence[str]], bool] = always,
) -> None:
    """Install what is missing; where that is not possible, stop over what is needed and only mention what is wished.

    Parameters
    ----------
    needed, wished
        What has to be there, and what is only better to have.
    say
        Told in one line what is going to be installed, before it is.
    ask
        Given what stands before a command that root runs, whether to go on.

    Raises
    ------
    SetupProblem
        Something needed is missing and cannot be installed from here; the sentence holds the way out.
    """
    if sys.platform != "linux":
        return
    missing = missing_libraries([*needed, *wished])
    if not missing:
        return
    stops = any(library in needed for library in missing)
    if not has_apt():
        words = ", ".join(dict.fromkeys(library.words for library in missing))
        _refuse(f"Please install these with your system's package manager: {words}.", say, stops=stops)
        return
    root = way_to_root()
    names = package_names(missing, available_packages([n for one in missing for n in one.packages]))
    if root is None:
        reason = "System packages are missing, and installing them needs an administrator"
        _refuse(f"{reason}; please type: {line_to_type(names)}", say, stops=stops)
        return
    say(f"This machine lacks {len(names)} system packages, which apt-get would install: {' '.join(names)}.")
    if not ask(root):
        _refuse(f"Nothing was installed; add --yes, or type: {line_to_type(names)}", say, stops=stops)
        return
    _install(missing, root, say)


def _refuse(sentence: str, say: Callable[[str], None], *, stops: bool) -> None:
    if stops:
        raise SetupProblem(sentence)
    say(f"{sentence} (Only the window needs them: going on.)")


def _install(missing: Sequence[Library], root: Sequence[str], say: Callable[[str], None]) -> None:
    say("Refreshing the list of system packages ...")
    try:
        run_quietly(apt_update(root), "Refreshing apt's lists failed")
    except SetupProblem as problem:
        # One broken third-party source must not stand in the way of packages that come from elsewhere.
        say(f"{problem} Trying to install all the same.")
    names = package_names(missing, available_packages([n for one in missing for n in one.packages]))
    say(f"Installing {len(names)} system packages ...")
    run_quietly(apt_install(root, names), "Installing system packages failed")
