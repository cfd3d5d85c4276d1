"""An export that processes share; each test is a process of one thread, as no other can be forked."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kagezou.export.forks import processes_for
from kagezou.io.project.file import save
from tests.export.small_cuts import bytes_below, cut, export, with_key

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks are made on Linux alone")

_BEGIN = """\
import os, signal, sys, time
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from kagezou.errors import InputProblem
from kagezou.export.forks import Sharing, shared_flow
from kagezou.export.pipeline import PipelineSteps
from kagezou.message import Message

first = os.getpid()
folder = Path(sys.argv[1])
jobs = [SimpleNamespace(content=SimpleNamespace(scene=object()), name=str(number)) for number in range(60)]
draw = lambda job: job.name
said = []

@contextmanager
def drawing():
    yield draw

def write(job, picture):
    (folder / picture).write_text(str(os.getpid()))
    return picture

def outcomes(cancelled=lambda: False, decode=lambda job: None):
    steps = PipelineSteps(decode, drawing, write)
    return shared_flow(jobs, steps, Sharing(2, 4, 2), cancelled, said.append)

taken = 0

def is_own(number):
    # Whether what this process takes now is the one of this number, of those that it has taken.
    global taken
    taken += 1
    return taken == number

def wait(until):
    while not until(): time.sleep(0.001)

def has_other_made_one():
    return bool({path.read_text() for path in folder.iterdir()} - {str(os.getpid()), ""})
"""


def ran(folder: Path, script: str) -> "subprocess.CompletedProcess[str]":
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    return subprocess.run(
        [sys.executable, "-c", _BEGIN + script, str(folder)],
        capture_output=True,
        text=True,
        timeout=100,
        env=environment,
        check=False,
    )


def is_alive(session: int) -> bool:
    try:
        os.killpg(session, 0)
    except ProcessLookupError:
        return False
    return True


def processes_in(folder: Path) -> int:
    return len({path.read_text() for path in folder.iterdir()})


def test_every_job_is_made_once_and_by_all(tmp_path: Path) -> None:
    done = ran(
        tmp_path,
        # Each makes a few and waits for the other then, however long that does not get its turn.
        "made = [each.written for each in outcomes(decode=lambda job: is_own(6) and wait(has_other_made_one))]\n"
        "assert sorted(made, key=int) == [job.name for job in jobs], made\n",
    )
    assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.iterdir())) == 60
    assert processes_in(tmp_path) == 2


def test_what_fails_elsewhere_fails_here(tmp_path: Path) -> None:
    done = ran(
        tmp_path,
        "def decode(job):\n"
        "    if os.getpid() != first: raise InputProblem(Message('only here'))\n"
        "    if job is jobs[30]: raise InputProblem(Message('cannot be read'))\n"
        "made = list(outcomes(decode=decode))\n"
        "failed = [each.problem.message.text for each in made if each.problem]\n"
        "assert failed == ['cannot be read'], failed\n"
        "assert len(made) == 60\n"
        "assert not said, said\n",
    )
    assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.iterdir())) == 59


def test_what_fails_elsewhere_last_of_all_is_done_here_without_a_word(tmp_path: Path) -> None:
    done = ran(
        tmp_path,
        "jobs = jobs[:8]\n"
        "def decode(job):\n"
        "    if os.getpid() == first: return\n"
        "    # Three are taken ahead at most, so that the first makes the others.\n"
        "    while len(list(folder.iterdir())) < 4: time.sleep(0.001)\n"
        "    raise InputProblem(Message('only here'))\n"
        "made = [each.written for each in outcomes(decode=decode)]\n"
        "assert sorted(made) == [job.name for job in jobs], made\n"
        "assert not said, said\n",
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("end", ["os.kill(os.getpid(), signal.SIGKILL)", "raise ZeroDivisionError", "os._exit(1)"])
def test_the_work_of_one_that_ends_is_done_by_the_first(tmp_path: Path, end: str) -> None:
    done = ran(
        tmp_path,
        f"ends = folder.with_name(folder.name + '.ends')\n"
        f"def ending(job):\n"
        f"    if os.getpid() != first and is_own(3):\n"
        f"        ends.touch()\n"
        f"        {end}\n"
        f"    return job.name\n"
        f"draw = ending\n"
        f"def patient(job):\n"
        f"    if os.getpid() == first and is_own(6): wait(ends.exists)\n"
        f"made = [each.written for each in outcomes(decode=patient)]\n"
        f"assert sorted(made, key=int) == [job.name for job in jobs], made\n"
        f"assert [each.text[:9] for each in said] == ['a process'], said\n",
    )
    assert done.returncode == 0, done.stderr


def test_stopped_each_finishes_what_it_has_in_hand(tmp_path: Path) -> None:
    done = ran(
        tmp_path,
        "seen = []\n"
        "stop = folder.with_name(folder.name + '.stop')\n"
        "def stopped():\n"
        "    if len(seen) > 5: stop.touch()\n"
        "    return stop.exists()\n"
        "def patient(job):\n"
        "    # Else the other may have made all of them before the first comes to say that it is enough.\n"
        "    if os.getpid() != first and is_own(10): wait(stop.exists)\n"
        "for each in outcomes(cancelled=stopped, decode=patient): seen.append(each.written)\n"
        "assert sorted(seen) == sorted(path.name for path in folder.iterdir()), seen\n"
        "assert len(seen) < 40\n",
    )
    assert done.returncode == 0, done.stderr


def test_nobody_is_left_behind(tmp_path: Path) -> None:
    done = ran(
        tmp_path,
        "for each in outcomes(): break\ntry: os.waitpid(-1, 0)\nexcept ChildProcessError: print('alone')\n",
    )
    # Whoever leaves in the middle closes the iterator, with which the others end.
    assert done.stdout == "alone\n", done.stderr


def test_the_others_end_with_the_first(tmp_path: Path) -> None:
    command = [
        sys.executable,
        "-c",
        _BEGIN + "def draw(job):\n"
        "    if int(job.name) > 10: wait(lambda: os.getpid() != first and os.getppid() != first)\n"
        "    return job.name\n"
        "list(outcomes())\n",
        str(tmp_path),
    ]
    with subprocess.Popen(command, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}, start_new_session=True) as process:
        while len(list(tmp_path.iterdir())) < 6:
            time.sleep(0.001)
        process.kill()
        process.wait()
        # Its session is empty when the last of its processes has ended.
        while is_alive(process.pid):
            time.sleep(0.001)
    assert len(list(tmp_path.iterdir())) < 20


def test_a_process_with_threads_is_not_forked(tmp_path: Path) -> None:
    script = """\
import sys, threading
from pathlib import Path
from types import SimpleNamespace
from kagezou.export.forks import processes_for
from tests.export.small_cuts import cut
document = cut(Path(sys.argv[1]))
jobs = [SimpleNamespace(content=SimpleNamespace(scene=object())) for _ in range(60)]
alone = processes_for(document, jobs, 3), processes_for(document, jobs[:5], 3), processes_for(document, jobs, 1)
end = threading.Event()
thread = threading.Thread(target=end.wait)
thread.start()
print(alone, processes_for(document, jobs, 3))
end.set()
"""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path)],
        capture_output=True,
        text=True,
        timeout=100,
        env=environment,
        check=False,
    )
    assert done.stdout == "(3, 1, 1) 1\n", done.stderr


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_the_bytes_are_those_of_one_process(tmp_path: Path, workers: int) -> None:
    document = with_key(cut(tmp_path, count=4, length=24), "light.position", 1, [10, -20, 40])
    document = with_key(document, "light.position", 24, [55, -25, 60])
    save(document, tmp_path / "cut.kage")
    assert processes_for(document, (), workers) == 1
    export(document, tmp_path / "whole")
    words = ["render", str(tmp_path / "cut.kage"), "-o", str(tmp_path / "out"), "--workers", str(workers)]
    subprocess.run([sys.executable, "-m", "kagezou", *words], check=True, capture_output=True)
    assert bytes_below(tmp_path / "out") == bytes_below(tmp_path / "whole")


def test_ctrl_c_for_all_of_them_leaves_whole_frames(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path, count=4, length=2000), "light.position", 1, [10, -20, 40])
    document = with_key(document, "light.position", 2000, [55, -25, 60])
    save(document, tmp_path / "cut.kage")
    words = ["render", str(tmp_path / "cut.kage"), "-o", str(tmp_path / "out"), "--workers", "2"]
    command = [sys.executable, "-m", "kagezou", *words]
    with subprocess.Popen(
        command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, start_new_session=True
    ) as process:
        while len(list((tmp_path / "out").rglob("*.png"))) < 12 and process.poll() is None:
            time.sleep(0.001)
        os.killpg(process.pid, signal.SIGINT)
        process.communicate()
    assert process.returncode == 130
    made = bytes_below(tmp_path / "out")
    assert 12 <= len(made) < 2000
    assert not [name for name in made if "part" in str(name)]
