"""What Python costs: of runs, of sweeps on two processes, and of arrays of impacts.

Needs the wheel (`pip install .`), a free machine, and is run by hand:

    python benches/python_costs.py

Of every case the two that are compared are measured in turn; the median of the rounds is told
beside its bound.
"""

import os
import statistics
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pelletflow as pf
from pelletflow import _pelletflow

SCENES = Path(__file__).parents[1] / "examples/scenes"
CHUTE = SCENES / "chute.toml"
ROUNDS = 5

DROP = {
    "schema_version": 1,
    "scene": {"title": "Drop"},
    "materials": {
        "ore": {"density": 3700, "shear_modulus": "60 MPa", "poisson_ratio": 0.22},
        "steel": {"density": 7850, "shear_modulus": "81 GPa", "poisson_ratio": 0.28},
    },
    "pairs": {
        "ore-steel": {"restitution": 0.5, "friction": 0.3},
        "ore-ore": {"restitution": 0.5, "friction": 0.3},
    },
    "pellets": {"pellet": {"material": "ore", "diameter": "15 mm"}},
    "walls": {
        "floor": {
            "material": "steel",
            "shape": {"kind": "half-space", "point": [0, 0, 0], "normal": [0, 0, 1]},
        }
    },
    "fill": {"one": {"pellets": "pellet", "at": [[0, 0, 0.1]]}},
    "time": {"end": "4 s"},
    "output": {"hits": False},
}


def processor_time(action) -> float:
    """Time of the processor that an action takes, all threads together [s]."""
    began = time.process_time()
    action()
    return time.process_time() - began


def wall_time(action) -> float:
    """Time by the clock that an action takes [s]."""
    began = time.perf_counter()
    action()
    return time.perf_counter() - began


def run_over_command(folder: Path) -> float:
    """Processor time of a run by Python, with an observer, over that of the command [-]."""

    def by_command() -> None:
        command = ["pelletflow", "run", str(CHUTE), "--output", str(folder / "command")]
        command += ["--quiet", "--threads", "1", "--set", 'time.end="0.8 s"', "--set", "expect={}"]
        if _pelletflow.command(command) != 0:
            raise SystemExit("the command failed")

    def by_python() -> None:
        values = {"time.end": "0.8 s", "expect": {}}
        pf.run(CHUTE, output=folder / "python", threads=1, set=values, progress=lambda look: None)

    command = processor_time(by_command)
    return processor_time(by_python) / command


def two_processes_over_one(folder: Path) -> float:
    """Time of 64 short runs on two processes that stand ready over that on one [-]."""
    points = {"fill.one.at": [[[0, 0, 0.05 + 0.001 * index]] for index in range(64)]}

    def seconds(workers: int) -> float:
        output = Path(tempfile.mkdtemp(dir=folder))
        with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
            list(pool.map(time.sleep, [0.2] * workers))
            return wall_time(lambda: pf.sweep(DROP, points, output=output, executor=pool))

    one = seconds(1)
    return seconds(2) / one


def ten_thousand_impacts(_folder: Path) -> float:
    """Time of 10,000 impacts of one restitution [s]."""
    speed = np.linspace(0.5, 10.0, 10_000)
    return wall_time(lambda: pf.impact(speed, pellet="fired-pellet", restitution=0.5))


CASES = [
    ("a run by Python over the command [-]", run_over_command, 1.02),
    ("64 runs, two processes over one [-]", two_processes_over_one, 0.6),
    ("10,000 impacts [s]", ten_thousand_impacts, 0.1),
]


def main() -> None:
    """Measures every case."""
    print(f"{os.cpu_count()} cores, {ROUNDS} rounds")
    print(f"{'case':40} {'median':>8} {'least':>8} {'most':>8} {'bound':>8}")
    for name, measure, bound in CASES:
        with tempfile.TemporaryDirectory() as folder:
            found = [measure(Path(folder)) for _ in range(ROUNDS)]
        row = [statistics.median(found), min(found), max(found), bound]
        print(f"{name:40} " + " ".join(f"{value:8.4f}" for value in row))


if __name__ == "__main__":
    main()
