"""Recipes: the same sweep on Dask, Ray and joblib, and a calibration by Optuna."""

import os
import signal
import threading
from concurrent.futures import Future, ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pelletflow as pf
import pytest

HEIGHTS = {"fill.one.at": [[[0, 0, 0.05 + 0.01 * step]] for step in range(8)]}
PEAK = ["contacts.max_force_n"]


@pytest.fixture
def expected(drop, tmp_path):
    """What the sweep gives on processes of this machine."""
    result = pf.sweep(drop, HEIGHTS, output=tmp_path / "here", measures=PEAK, workers=2)
    assert result.executed == 8
    return result.table


def test_a_dask_cluster_of_two_processes_gives_the_same_table(drop, expected, tmp_path):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        result = pf.sweep(
            drop, HEIGHTS, output=tmp_path / "dask", measures=PEAK, executor=client.get_executor()
        )
    assert result.executed == 8
    assert result.table == expected


class AfterSome:
    """An executor that does something once, when a number of its calls is done."""

    def __init__(self, executor, count, action):
        self.executor = executor
        self.left = count
        self.action = action
        self.lock = threading.Lock()

    def submit(self, function, /, *arguments) -> Future:
        future = self.executor.submit(function, *arguments)
        future.add_done_callback(self.count)
        return future

    def count(self, _future) -> None:
        with self.lock:
            self.left -= 1
            is_due = self.left == 0
        if is_due:
            self.action()


def test_a_killed_dask_worker_loses_no_result_and_repeats_only_its_own_runs(drop, tmp_path):
    distributed = pytest.importorskip("distributed")
    # Long enough that both workers are busy when one is killed.
    drop["time"]["end"] = 4.0
    points = {"fill.one.at": [[[0, 0, 0.05 + 0.01 * step]] for step in range(12)]}
    folder = tmp_path / "out"
    stamps: dict[str, int] = {}
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())

        def kill_one() -> None:
            for path in folder.glob("*/summary.json"):
                if not path.parent.name.startswith("unfinished-"):
                    stamps[path.parent.name] = path.stat().st_mtime_ns
            os.kill(pids[0], signal.SIGKILL)

        executor = AfterSome(client.get_executor(), 4, kill_one)
        result = pf.sweep(drop, points, output=folder, measures=PEAK, executor=executor)
    assert 4 <= len(stamps) < 12
    assert result.table["runs"].tolist() == [1] * 12
    # What was done when the worker died was not run again.
    for name, stamp in stamps.items():
        assert (folder / name / "summary.json").stat().st_mtime_ns == stamp


class RayExecutor:
    """Ray's remote functions as an executor."""

    def __init__(self, ray):
        self.ray = ray

    def submit(self, function, /, *arguments) -> Future:
        return self.ray.remote(function).remote(*arguments).future()


def test_ray_gives_the_same_table(drop, expected, tmp_path):
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        result = pf.sweep(
            drop, HEIGHTS, output=tmp_path / "ray", measures=PEAK, executor=RayExecutor(ray)
        )
    finally:
        ray.shutdown()
    assert result.executed == 8
    assert result.table == expected


def test_the_executor_of_joblib_gives_the_same_table(drop, expected, tmp_path):
    pytest.importorskip("joblib")
    from joblib.externals.loky import get_reusable_executor

    with get_reusable_executor(max_workers=2) as executor:
        result = pf.sweep(drop, HEIGHTS, output=tmp_path / "loky", measures=PEAK, executor=executor)
    assert result.executed == 8
    assert result.table == expected


#: A heap that takes a second: few pellets, large and soft.
HEAP = {
    "fill.bed.count": 200,
    "pellets.ore.diameter": "20 mm",
    "materials.pellet.shear_modulus": "0.5 MPa",
    "materials.rubber.youngs_modulus": "1 MPa",
    "materials.steel.shear_modulus": "1 MPa",
    "time.end": "1.4 s",
    "time.peak_force_error": "5 %",
    "limits.overlap_ratio": 0.5,
    "output.hits": False,
    "output.frame_interval": "1 s",
    "expect": {},
}
ANGLE = "meters.pile.angle_deg"


def test_an_optuna_study_finds_the_friction_of_an_angle_of_repose(tmp_path):
    optuna = pytest.importorskip("optuna")
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    scene = Path(__file__).parents[2] / "examples/scenes/heap.toml"
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as executor:

        def angle(friction: float) -> float:
            result = pf.sweep(
                scene,
                {"pairs.pellet-pellet.friction": [friction]},
                output=tmp_path / "heap",
                set=HEAP,
                replicates=2,
                measures=[ANGLE],
                executor=executor,
            )
            return float(result.table[ANGLE][0])

        target = angle(0.3)
        slippery = angle(0.05)
        study = optuna.create_study(sampler=optuna.samplers.RandomSampler(seed=1))
        study.optimize(
            lambda trial: abs(angle(trial.suggest_float("friction", 0.05, 0.8)) - target),
            n_trials=8,
        )
    # Heaps of 200 pellets scatter by some degrees; a slippery one is farther off than that.
    assert target - slippery > 3.0
    assert study.best_value < 1.5
