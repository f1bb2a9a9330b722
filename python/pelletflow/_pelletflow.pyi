"""The Rust module: translation only."""

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, final

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from pelletflow._table import Table

__all__ = [
    "Batch",
    "Simulation",
    "__version__",
    "colors",
    "command",
    "impacts",
    "library",
    "mean_interval",
    "parts_of",
    "read",
    "restored",
    "run",
    "safe_setting",
    "safe_speeds",
    "scene",
    "scene_tables",
    "scene_value",
    "schema",
    "score_energy",
    "scores",
    "table_kinds",
]

_Floats = npt.NDArray[np.float64]
_Path = str | os.PathLike[str]

__version__: str

def run(
    scene: str | os.PathLike[str] | Mapping[str, Any],
    output: str | os.PathLike[str] | None,
    threads: int | None,
    set: Mapping[str, Any] | None,
    unfinished: str,
    observer: Callable[[float, float, int, int, float, int, int], object] | None,
) -> tuple[dict[str, Any], Path]:
    """Run a scene to its end; the summary and the folder of the output."""

def scene(scene: _Path | Mapping[str, Any], set: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Validate a scene: its name, title, hash, seed, text with all that was set, and notes."""

def scene_tables(
    scene: _Path | Mapping[str, Any], set: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Tables of a scene with what is set in them, not validated."""

def scene_value(key: str, value: object) -> Any:
    """Return a value as a scene holds it, shared with nothing; `key` says where it stands."""

def parts_of(key: str) -> list[str]:
    """Parts of a dotted key."""

def schema() -> dict[str, Any]:
    """JSON Schema of a scene."""

def colors(shares: _Floats) -> npt.NDArray[np.uint8]:
    """Colors of shares of the scale of a recording, from 0 to 1, shape (n, 3) [0 to 255]."""

def table_kinds() -> list[str]:
    """Names of the kinds of tables that a recording is read as."""

def read(path: _Path, kinds: Sequence[str]) -> tuple[dict[str, str], bool, list[Batch]]:
    """Read a recording: facts of the run, whether the file is cut off, and the tables asked for."""

def library() -> list[dict[str, Any]]:
    """Named materials, each with its values in SI units and their source."""

def impacts(
    arrivals: Mapping[str, _Floats], damping: str, values: _Floats | None
) -> list[tuple[str, _Floats]]:
    """Numbers of hits along the normal; `damping` names what the values beside it are."""

def safe_speeds(
    arrivals: Mapping[str, _Floats],
    strengths: Mapping[str, Any],
    risk: _Floats,
    moduli: Sequence[_Floats] | None,
) -> list[tuple[str, _Floats]]:
    """Load that breaks a share of the pellets and the speed that reaches it, with intervals.

    `moduli` are the least and the greatest Young's modulus [Pa]; the pellet's own if None.
    """

def safe_setting(
    scene: _Path | Mapping[str, Any],
    set: Mapping[str, Any] | None,
    strengths: Mapping[str, Any],
    search: Mapping[str, Any],
    observer: Callable[[int, float], object] | None,
) -> dict[str, Any]:
    """Value of a setting of a scene at which a share of the pellets breaks, by whole runs."""

def scores(
    path: _Path,
    strengths: Mapping[str, Any],
    yield_pressure: _Floats | None,
    count: int,
    places: int,
) -> list[tuple[float, list[float], dict[str, Any]]]:
    """Share broken by the hits of a recording, its interval and all else, for `count` strengths."""

def score_energy(
    path: _Path, card: _Path, places: int
) -> list[tuple[float, list[float], dict[str, Any]]]:
    """Tell the same by the fracture energy of a card."""

def mean_interval(values: _Floats, confidence: float) -> list[float]:
    """Mean of what replicates gave with its interval: low, best, high [unit of the values]."""

def command(arguments: Sequence[str]) -> int:
    """Run the command line, the program's name first; its exit code [-]."""

def restored(
    scene: tuple[str, list[tuple[Path, bytes]]], threads: int | None, hits: bool, state: bytes
) -> Simulation:
    """Make a simulation of what it was pickled as."""

@final
class Batch:
    """Named columns of one type each, which never change."""

    def __new__(cls, name: str, columns: Sequence[tuple[str, str, Any, Any]]) -> Batch:
        """Columns of equal length by name, unit, values and rows that have one."""

    @property
    def name(self) -> str:
        """Name of the table."""

    @property
    def names(self) -> list[str]:
        """Names of the columns, in order."""

    @property
    def units(self) -> list[str]:
        """Units of the columns, in order; `-` where there is none."""

    @property
    def rows(self) -> int:
        """Rows [-]."""

    def column(self, name: str) -> tuple[Any, npt.NDArray[np.bool_] | None]:
        """Values of a column, as an array or a list of texts, and which rows have one."""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Arrow's stream of the rows, in a capsule."""

    def __arrow_c_schema__(self) -> object:
        """Arrow's schema of the columns, in a capsule."""

@final
class Simulation:
    """A run in memory, stepped by hand.

    The arrays are copies, with one row per pellet inside, in order of `ids`: what was taken before
    a step is not changed by it.

    >>> import pelletflow as pf
    >>> simulation = pf.Simulation("chute.toml", threads=1)
    >>> simulation.step(10)
    >>> simulation.step_count
    10
    """

    def __new__(
        cls,
        scene: str | os.PathLike[str] | Mapping[str, Any],
        *,
        threads: int | None = None,
        set: Mapping[str, Any] | None = None,
        hits: bool = False,
    ) -> Simulation:
        """Validate a scene, a file or the same as a dictionary, and place its fills.

        `threads` [-] is one per core if None; the state does not depend on it.
        `set` puts values in place of the scene's, by dotted key: ``{"time.end": "1 s"}``.
        With `hits` each contact is followed, for `take_hits`.
        """

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the simulation as its scene and its state, for the same version alone."""

    def step(
        self,
        n: int = 1,
        *,
        callback: Callable[[Simulation], object] | None = None,
        every: int = 1,
    ) -> None:
        """Advance by `n` time steps [-].

        After every `every` of them [-] `callback` is called with the simulation; False stops it.
        Other Python threads run meanwhile, and Ctrl-C stops it between two steps.
        """

    def take_hits(self) -> Table:
        """Take the hits kept in full that have ended since the last call, in SI units [-].

        They are held in memory until then.
        """

    def plot(self, **options: Any) -> Axes:
        """Draw the pellets as circles colored by speed [m/s]; needs matplotlib.

        `along` is the axis of the view, `ax` the axes to draw on.
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
