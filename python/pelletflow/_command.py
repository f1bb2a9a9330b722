"""The ``pelletflow`` command, as the wheel installs it."""

import sys

from pelletflow import _pelletflow


def main() -> int:
    """Run the command line and return its exit code [-]."""
    return _pelletflow.command(sys.argv)
