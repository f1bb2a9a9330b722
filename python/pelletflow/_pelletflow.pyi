"""The Rust module: translation only."""

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, final

import numpy as np
import numpy.typing as npt

__all__ = ["Simulation", "__version__", "command", "run"]

__version__: str

def run(
    scene: str | os.PathLike[str] | Mapping[str, Any],
    output: str | os.PathLike[str] | None,
    threads: int | None,
    set: Mapping[str, Any] | None,
    observer: Callable[[float, float, int, int, float, int, int], object] | None,
) -> tuple[dict[str, Any], Path]:
    """Run a scene to its end; the summary and the folder of the output."""

def command(arguments: Sequence[str]) -> int:
    """Run the command line, the program's name first; its exit code [-]."""

@final
class Simulation:
    """A run in memory, stepped by hand.

    The arrays are copies with one row per pellet inside, in order of `ids`.
    """

    def __new__(
        cls,
        scene: str | os.PathLike[str] | Mapping[str, Any],
        *,
        threads: int | None = None,
        set: Mapping[str, Any] | None = None,
    ) -> Simulation:
        """Validate a scene, a file or the same as a dictionary, and place its fills.

        `threads` [-] is one per core if None; the state does not depend on it.
        `set` puts values in place of the scene's, by dotted key: ``{"time.end": "1 s"}``.
        """

    def step(self, n: int = 1) -> None:
        """Advance by `n` time steps [-].

        Other Python threads run meanwhile, and Ctrl-C stops it between two steps.
        """

    @property
    def time(self) -> float:
        """Simulated time [s]."""

    @property
    def time_step(self) -> float:
        """Time step [s]."""

    @property
    def step_count(self) -> int:
        """Steps taken [-]."""

    @property
    def threads(self) -> int:
        """Threads at work [-]."""

    @property
    def ids(self) -> npt.NDArray[np.uint32]:
        """Permanent numbers, rising, in order of insertion, shape (n,) [-]."""

    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """Centers in the world, shape (n, 3) [m]."""

    @property
    def velocities(self) -> npt.NDArray[np.float64]:
        """Velocities, shape (n, 3) [m/s]."""

    @property
    def spins(self) -> npt.NDArray[np.float64]:
        """Spins in the world, shape (n, 3) [rad/s]."""

    @property
    def radii(self) -> npt.NDArray[np.float64]:
        """Radii, shape (n,) [m]."""

    @property
    def masses(self) -> npt.NDArray[np.float64]:
        """Masses, shape (n,) [kg]."""

    @property
    def mass_ledger(self) -> dict[str, Any]:
        """Where every pellet went: inserted = inside + discharged + lost.

        Each a dictionary of `count` [-] and `mass` [kg]; `by_inlet` and `by_outlet` list them
        in order of the scene.
        """

    @property
    def energy_ledger(self) -> dict[str, float]:
        """Where the energy went at the start of the last step [J]."""

    @property
    def state_hash(self) -> str:
        """Hash of the state, 32 hexadecimal digits: equal only for equal bits."""
