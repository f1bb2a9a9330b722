"""Multi-body flows of iron-ore pellets.

>>> import pelletflow as pf
>>> result = pf.run("hopper.toml", output="out", set={"time.end": "1 s"})  # doctest: +SKIP
>>> result.summary["contacts"]["max_force_n"]  # doctest: +SKIP

SI units throughout; arrays are NumPy arrays of float64 with one row per pellet.
"""

from pelletflow._impact import Impact, SafeSpeed, impact, safe_speed
from pelletflow._pelletflow import Simulation, __version__
from pelletflow._recording import Recording, read
from pelletflow._run import Progress, RunResult, run
from pelletflow._scene import Scene
from pelletflow._score import Score, score
from pelletflow._sweep import SweepResult, sweep
from pelletflow._table import Table
from pelletflow.errors import (
    InputError,
    Mistake,
    OutputError,
    PelletflowError,
    PhysicsError,
    RecordingError,
    SceneError,
    SweepError,
)

__all__ = [
    "Impact",
    "InputError",
    "Mistake",
    "OutputError",
    "PelletflowError",
    "PhysicsError",
    "Progress",
    "Recording",
    "RecordingError",
    "RunResult",
    "SafeSpeed",
    "Scene",
    "SceneError",
    "Score",
    "Simulation",
    "SweepError",
    "SweepResult",
    "Table",
    "__version__",
    "impact",
    "read",
    "run",
    "safe_speed",
    "score",
    "sweep",
]
