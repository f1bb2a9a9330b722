"""What can go wrong: in a scene, in the physics, in writing files."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Mistake:
    """One thing wrong with a scene."""

    file: str
    """The file, as it was named."""
    line: int | None
    """Line, counted from 1 [-]; None for a dictionary, an override or the whole file."""
    column: int | None
    """Column, counted from 1 [-], where it is known."""
    key: str
    """Dotted key, such as ``walls.cone.material``; empty where the whole file is meant."""
    message: str
    """What is wrong, its value, the bound and the cure."""


class PelletflowError(Exception):
    """Base of every error of this package."""


class SceneError(PelletflowError, ValueError):
    """A scene that cannot be read or has mistakes; all that were found."""

    def __init__(self, message: str, mistakes: Sequence[Mistake] = ()) -> None:
        """Keep the mistakes beside the message."""
        super().__init__(message)
        self.mistakes: tuple[Mistake, ...] = tuple(mistakes)
        """The mistakes, in order of the lines."""


class PhysicsError(PelletflowError, RuntimeError):
    """A run that went wrong: a lost pellet, too deep an overlap, a ledger that does not close."""

    def __init__(self, message: str, summary: dict[str, Any] | None = None) -> None:
        """Keep the summary beside the message."""
        super().__init__(message)
        self.summary = summary
        """What ``summary.json`` holds, up to the last good step; None for a `Simulation`."""


class InputError(PelletflowError, ValueError):
    """An argument that cannot be worked with."""

    def __init__(
        self, message: str, key: str = "", value: Any = None, expected: str | None = None
    ) -> None:
        """Keep what is wrong beside the message."""
        super().__init__(message, key, value, expected)
        self.key = key
        """The argument or the quantity."""
        self.value = value
        """Its value, in the unit that the message tells."""
        self.expected = expected
        """The bound that it breaks, in words."""

    def __str__(self) -> str:
        """What is wrong, its value, the bound and the cure."""
        return str(self.args[0])


class RecordingError(PelletflowError, OSError):
    """A recording that cannot be read, or does not hold what is asked for."""

    def __init__(self, message: str, path: str | os.PathLike[str] | None = None) -> None:
        """Keep the path beside the message."""
        super().__init__(message)
        self.path = path
        """The recording."""


class SweepError(PelletflowError, RuntimeError):
    """A sweep that cannot go on, or points of it that failed."""

    def __init__(self, message: str, failures: Mapping[str, str] | None = None) -> None:
        """Keep the failures beside the message."""
        super().__init__(message)
        self.failures = dict(failures or {})
        """What went wrong, by the folder of the run."""


class OutputError(PelletflowError, OSError):
    """A file or directory of the output that could not be written."""

    def __init__(self, message: str, path: str | os.PathLike[str] | None = None) -> None:
        """Keep the path beside the message."""
        super().__init__(message)
        self.path = path
        """The file or directory."""
