"""What the tests of batches share."""

from tests.cli.conftest import shell

__all__ = ["shell"]
