"""Processes that read USD files badly, in place of the program's own: `KAGEZOU_TEST_CHILD` says how."""

import os
import sys
import time

import numpy as np

from kagezou.io.sets import usd_child
from kagezou.io.sets.triangles import Triangles


def _reads_too_much(*_: object) -> Triangles:
    np.ones(usd_child.MAX_BYTES // 8 + 1)
    raise AssertionError("so much memory should not be had")


def main(words: list[str]) -> None:
    how = os.environ["KAGEZOU_TEST_CHILD"]
    if how == "aborts":
        os.abort()
    if how == "hangs":
        time.sleep(600)
    if how == "writes half":
        with open(words[2], "wb") as stream:  # noqa: PTH123 - as short as it gets
            stream.write(b"PK\3\4 and no more")
    if how == "needs memory":
        vars(usd_child)["triangles_in"] = _reads_too_much
        usd_child.main(words)
    if how == "ends":
        sys.exit(7)


if __name__ == "__main__":
    main(sys.argv[1:])
