"""Multi-body flows of iron-ore pellets.

>>> import pelletflow as pf
>>> result = pf.run("chute.toml", output="out", set={"time.end": "20 ms", "expect": {}})
>>> result.summary["bodies"]["lost"]
0

SI units throughout; arrays are NumPy arrays of float64 with one row per pellet.
"""

from pelletflow._impact import Impact, SafeSpeed, impact, safe_speed
from pelletflow._pelletflow import Simulation, __version__
from pelletflow._recording import Recording, read
from pelletflow._rerun import to_rerun
from pelletflow._run import Progress, RunResult, run
from pelletflow._safe_setting import SafeSetting, safe_setting
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
    "SafeSetting",
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
    "safe_setting",
    "safe_speed",
    "score",
    "sweep",
    "to_rerun",
]
