"""Multi-body flows of iron-ore pellets.

>>> import pelletflow as pf
>>> result = pf.run("hopper.toml", output="out", set={"time.end": "1 s"})  # doctest: +SKIP
>>> result.summary["contacts"]["max_force_n"]  # doctest: +SKIP

SI units throughout; arrays are NumPy arrays of float64 with one row per pellet.
"""

from pelletflow._pelletflow import Simulation, __version__
from pelletflow._run import Progress, RunResult, run
from pelletflow.errors import Mistake, OutputError, PelletflowError, PhysicsError, SceneError

__all__ = [
    "Mistake",
    "OutputError",
    "PelletflowError",
    "PhysicsError",
    "Progress",
    "RunResult",
    "SceneError",
    "Simulation",
    "__version__",
    "run",
]
