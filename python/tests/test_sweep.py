"""Sweeps: points, replicates, what is on disk, and what ends them early."""

import os
import pickle
import signal
import subprocess
import sys
import threading
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from multiprocessing import get_context

import numpy as np
import pelletflow as pf
import pytest

HEIGHTS = [0.05, 0.1, 0.15]
PEAK = ["contacts.max_force_n"]


class Here:
    """An executor that does everything at once, here."""

    def __init__(self):
        self.calls = 0

    def submit(self, function, /, *arguments):
        self.calls += 1
        future = Future()
        try:
            future.set_result(function(*arguments))
        except Exception as error:
            future.set_exception(error)
        return future


@pytest.fixture
def points():
    """Three heights of the drop, and two restitutions."""
    return {
        "fill.one.at": [[[0, 0, 7.5e-3 + height]] for height in HEIGHTS],
        "pairs.pellet-steel.restitution": np.array([0.5, 0.8]),
    }


def test_a_grid_has_every_combination_and_the_physics_of_each(drop, points, tmp_path):
    result = pf.sweep(drop, points, output=tmp_path, measures=PEAK, executor=Here())
    assert result.executed == 6
    assert result.table.rows == 6
    assert result.table["pairs.pellet-steel.restitution"].tolist() == [0.5, 0.8] * 3
    force = result.table["contacts.max_force_n"]
    # F ∝ v^1.2 ∝ h^0.6; the weight of the pellet adds about 0.1 %.
    assert force[2] / force[0] == pytest.approx(2.0**0.6, rel=3e-3)
    assert force[4] / force[2] == pytest.approx(1.5**0.6, rel=3e-3)
    assert force[1] > force[0]


def test_points_may_be_listed_one_by_one(drop, tmp_path):
    points = [{"time.end": 0.01}, {"time.end": "20 ms", "scene.seed": 3}]
    result = pf.sweep(drop, points, output=tmp_path, measures=PEAK, executor=Here())
    assert result.table.rows == 2
    assert result.table["time.end"].tolist() == ["0.01", "20 ms"]
    # A scene that gives no seed has 1.
    assert result.runs["seed"].tolist() == [1, 3]


def test_a_value_of_a_point_counts_above_one_for_all_points_whatever_their_order(drop, tmp_path):
    points = [{"time.end": 0.02}]
    for name, given in {
        "key first": {"time.end": 5.0, "time": {"end": 0.01, "peak_force_error": 1e-3}},
        "table first": {"time": {"end": 0.01, "peak_force_error": 1e-3}, "time.end": 5.0},
    }.items():
        result = pf.sweep(
            drop,
            points,
            output=tmp_path / name,
            set=given,
            executor=Here(),
            measures=lambda run: {"end": run.summary["time"]["simulated_s"]},
        )
        assert result.table["end"][0] == pytest.approx(0.02, rel=1e-2)


def test_a_run_of_a_sweep_has_the_bits_of_the_same_run_alone(drop, points, tmp_path):
    result = pf.sweep(drop, points, output=tmp_path / "sweep", executor=Here())
    values = {"fill.one.at": [[0, 0, 7.5e-3 + 0.05]], "pairs.pellet-steel.restitution": 0.5}
    alone = pf.run(drop, output=tmp_path / "alone", set=values).summary
    own = result.folder / result.runs["hash"][0] / "summary.json"
    assert alone["state_hash"] in own.read_text(encoding="utf-8")
    assert alone["scene_hash"] == result.runs["hash"][0]


def test_replicates_count_their_seeds_up_and_leave_an_interval(box, tmp_path):
    box["time"]["end"] = 0.02
    box["scene"]["seed"] = 7
    box["pellets"]["ore"]["diameter"] = {"min": "12 mm", "max": "15 mm"}
    box["fill"]["heap"]["count"] = 20
    result = pf.sweep(
        box,
        {"pairs.pellet-pellet.friction": [0.5]},
        output=tmp_path,
        replicates=3,
        measures=["mass.inside"],
        executor=Here(),
    )
    assert result.runs["seed"].tolist() == [7, 8, 9]
    masses = result.runs["mass.inside"]
    assert len(set(masses)) == 3
    assert result.table["mass.inside"][0] == pytest.approx(masses.mean(), rel=1e-12)
    # Student's t of two degrees of freedom at 97.5 %: 4.3027.
    half = 4.3027 * masses.std(ddof=1) / np.sqrt(3)
    assert result.table["mass.inside_high"][0] - masses.mean() == pytest.approx(half, rel=1e-4)


def test_replicates_of_a_scene_without_a_seed_differ_from_the_first_on(box, tmp_path):
    box["time"]["end"] = 1e-4
    box["pellets"]["ore"]["diameter"] = {"min": "12 mm", "max": "15 mm"}
    box["fill"]["heap"]["count"] = 20
    result = pf.sweep(
        box,
        {"time.end": [1e-4]},
        output=tmp_path,
        replicates=3,
        measures=["mass.inside"],
        executor=Here(),
    )
    assert result.runs["seed"].tolist() == [1, 2, 3]
    assert len(set(result.runs["mass.inside"])) == 3


def test_one_replicate_has_a_mean_and_no_interval(drop, tmp_path):
    result = pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Here())
    assert np.isfinite(result.table["energy.kinetic_j"][0])
    assert np.isnan(result.table["energy.kinetic_j_low"][0])


def test_a_second_call_runs_only_what_is_missing(drop, points, tmp_path):
    first = pf.sweep(drop, points, output=tmp_path, measures=PEAK, executor=Here())
    again = Here()
    second = pf.sweep(drop, points, output=tmp_path, measures=PEAK, executor=again)
    assert (again.calls, second.executed) == (0, 0)
    assert second.table == first.table
    points["pairs.pellet-steel.restitution"] = [0.8, 0.9]
    third = pf.sweep(drop, points, output=tmp_path, measures=PEAK, executor=again)
    assert (again.calls, third.executed) == (3, 3)


def test_what_a_killed_run_has_left_does_not_count_and_is_removed(drop, tmp_path):
    leftover = tmp_path / "unfinished-0123-abc"
    leftover.mkdir(parents=True)
    (leftover / "summary.json").write_text("{}", encoding="utf-8")
    broken = pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Here())
    assert not leftover.exists()
    summary = tmp_path / broken.runs["hash"][0] / "summary.json"
    summary.write_text(summary.read_text(encoding="utf-8")[:100], encoding="utf-8")
    assert pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Here()).executed == 1


def test_a_function_measures_what_no_summary_holds(drop, tmp_path):
    def hits(result: pf.RunResult) -> dict[str, float]:
        return {"hits": result.read(only=["hits"]).hits.rows}

    result = pf.sweep(
        drop, {"time.end": [0.1, 0.2]}, output=tmp_path, measures=hits, executor=Here()
    )
    assert result.table["hits"].tolist() == [0.0, 1.0]


def test_recordings_need_not_be_kept(drop, tmp_path):
    result = pf.sweep(
        drop, {"time.end": [0.01]}, output=tmp_path, keep_recordings=False, executor=Here()
    )
    names = {path.name for path in (tmp_path / result.runs["hash"][0]).iterdir()}
    assert "summary.json" in names
    assert "run.mcap" not in names
    without = pf.sweep(
        drop, {"time.end": [0.01]}, output=tmp_path, keep_recordings=False, executor=Here()
    )
    kept = pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Here())
    assert (without.executed, kept.executed) == (0, 1)
    assert (tmp_path / result.runs["hash"][0] / "run.mcap").exists()


def test_a_scene_in_code_and_values_for_all_points_may_be_swept(drop, tmp_path):
    scene = pf.Scene(**drop)
    scene["time.end"] = 0.01
    result = pf.sweep(
        scene,
        {"pellets.ore.diameter": ["10 mm", "15 mm"]},
        output=tmp_path,
        set={"scene.seed": 5},
        executor=Here(),
    )
    assert result.runs["seed"].tolist() == [5, 5]
    assert result.table["mass.inside"][1] / result.table["mass.inside"][0] == pytest.approx(3.375)


def test_progress_counts_to_all_runs(drop, tmp_path, capsys):
    seen = []
    points = {"time.end": [0.01, 0.02]}
    count = lambda done, all: seen.append((done, all))  # noqa: E731
    pf.sweep(drop, points, output=tmp_path, executor=Here(), progress=count)
    assert seen == [(0, 2), (1, 2), (2, 2)]
    pf.sweep(drop, points, output=tmp_path, executor=Here(), progress=True)
    assert "2 of 2 runs" in capsys.readouterr().err


def test_the_result_can_be_drawn_shown_and_sent(drop, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    result = pf.sweep(
        drop, {"time.end": [0.1, 0.2]}, output=tmp_path, measures=PEAK, executor=Here()
    )
    assert pickle.loads(pickle.dumps(result)).table == result.table
    assert len(result.plot("time.end", "contacts.max_force_n").lines) == 1
    assert "contacts.max_force_n" in result._repr_html_()


def test_mistakes_of_any_point_are_told_before_the_first_run(drop, tmp_path):
    executor = Here()
    for points in ({"walls.ceiling.angle": [1.0]}, {"time.end": [0.1, -1.0]}):
        with pytest.raises(pf.SceneError):
            pf.sweep(drop, points, output=tmp_path, executor=executor)
    assert executor.calls == 0


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({"points": {}}, "points"),
        ({"points": []}, "points"),
        ({"points": {"time.end": []}}, "time.end"),
        ({"points": {"time.end": 0.1}}, "time.end"),
        ({"points": {"time.end": "0.1 s"}}, "time.end"),
        ({"points": ["time.end"]}, "points"),
        ({"points": 3}, "points"),
        ({"replicates": 0}, "replicates"),
        ({"confidence": 1.0}, "confidence"),
        ({"executor": object()}, "executor"),
        ({"executor": Here(), "workers": 2}, "workers"),
        ({"executor": None, "workers": 0}, "workers"),
        ({"measures": ["contacts.least_force_n"]}, "measures"),
        ({"measures": ["ended"]}, "measures"),
    ],
)
def test_bad_arguments_are_named(drop, tmp_path, arguments, key):
    given = {"points": {"time.end": [0.01]}, "executor": Here()} | arguments
    with pytest.raises(pf.InputError) as caught:
        pf.sweep(drop, output=tmp_path, **given)
    assert caught.value.key == key


def test_runs_that_fail_are_listed_and_the_others_are_done(leak, tmp_path):
    points = {"time.end": [0.01, 0.2]}
    with pytest.raises(pf.SweepError, match="1 of 2 runs failed") as caught:
        pf.sweep(leak, points, output=tmp_path, executor=Here())
    (reason,) = caught.value.failures.values()
    assert "PhysicsError" in reason
    result = pf.sweep(
        leak, points, output=tmp_path, measures=PEAK, executor=Here(), keep_going=True
    )
    assert result.table["runs"].tolist() == [1, 0]
    assert np.isnan(result.table["contacts.max_force_n"][1])
    assert len(result.failures) == 1


def test_an_executor_that_gives_no_futures_or_has_ended_is_told_as_such(drop, tmp_path):
    class Client:
        def submit(self, function, /, *arguments):
            return "a promise"

    with pytest.raises(pf.InputError, match="get_executor") as caught:
        pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Client())
    assert caught.value.key == "executor"
    ended = ThreadPoolExecutor(1)
    ended.shutdown()
    with pytest.raises(pf.SweepError, match="start it anew"):
        pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=ended)


class Killing:
    """A pool whose worker is killed when a number of runs has been handed to it."""

    def __init__(self, pool, after, *, is_noticed):
        self.pool = pool
        self.process = pool.submit(os.getpid).result()
        self.left = after
        self.is_noticed = is_noticed

    def submit(self, function, /, *arguments):
        future = self.pool.submit(function, *arguments)
        self.left -= 1
        if self.left == 0:
            os.kill(self.process, signal.SIGKILL)
            if self.is_noticed:
                # Once the first run has failed, the pool takes no other.
                wait([future])
        return future


@pytest.mark.skipif(sys.platform == "win32", reason="processes are killed otherwise there")
@pytest.mark.parametrize(
    ("after", "is_noticed"), [(2, False), (1, True)], ids=["amid a run", "before the next run"]
)
def test_a_worker_that_is_killed_ends_the_sweep_with_the_cure(
    drop, tmp_path, hang_guard, after, is_noticed
):
    endless = {"time.end": [1000.0, 1001.0]}
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        executor = Killing(pool, after, is_noticed=is_noticed)
        with pytest.raises(pf.SweepError, match=r"killed.*call again.*with a new executor"):
            pf.sweep(drop, endless, output=tmp_path, executor=executor)
    assert pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path, executor=Here()).executed == 1
    assert not list(tmp_path.glob("unfinished-*"))


def test_two_sweeps_into_one_folder_are_refused(drop, tmp_path, hang_guard):
    began, may_end = threading.Event(), threading.Event()

    class Waiting(Here):
        def submit(self, function, /, *arguments):
            began.set()
            may_end.wait()
            return super().submit(function, *arguments)

    points = {"time.end": [0.01]}
    with ThreadPoolExecutor(1) as threads:
        first = threads.submit(pf.sweep, drop, points, output=tmp_path, executor=Waiting())
        began.wait()
        with pytest.raises(pf.SweepError, match="another sweep"):
            pf.sweep(drop, points, output=tmp_path, executor=Here())
        may_end.set()
        assert first.result().executed == 1
    assert pf.sweep(drop, points, output=tmp_path, executor=Here()).executed == 0


def test_a_folder_that_cannot_be_made_is_an_output_error(drop, tmp_path):
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    with pytest.raises(pf.OutputError):
        pf.sweep(drop, {"time.end": [0.01]}, output=tmp_path / "file", executor=Here())


def test_exceptions_of_a_sweep_survive_the_way_back_from_another_process():
    error = pickle.loads(pickle.dumps(pf.SweepError("bad", {"0123": "worse"})))
    assert error.failures == {"0123": "worse"}
    error = pickle.loads(pickle.dumps(pf.InputError("bad", "key", 3, "more")))
    assert (str(error), error.key, error.value, error.expected) == ("bad", "key", 3, "more")


SCRIPT = """
import sys
import pelletflow as pf
if __name__ == "__main__":
    scene, output, workers, count, end = sys.argv[1:]
    points = {"fill.one.at": [[[0, 0, 0.05 + 0.001 * i]] for i in range(int(count))]}
    result = pf.sweep(
        scene, points, output=output, workers=int(workers), set={"time.end": end},
        keep_recordings=False, progress=lambda done, all: print(done, all, flush=True),
    )
    print("executed", result.executed, flush=True)
"""


def script(tmp_path, *arguments):
    path = tmp_path / "script.py"
    path.write_text(SCRIPT, encoding="utf-8")
    return [sys.executable, str(path), *(str(argument) for argument in arguments)]


@pytest.mark.skipif(sys.platform == "win32", reason="processes are killed otherwise there")
def test_a_sweep_that_is_killed_is_completed_by_calling_again(drop_file, tmp_path):
    command = script(tmp_path, drop_file, tmp_path / "out", 2, 16, "1 s")
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, start_new_session=True)
    assert process.stdout is not None
    for line in process.stdout:
        if int(line.split()[0]) >= 3:
            break
    # The whole group: the sweep and its workers, without a chance to clean up.
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    done = [path for path in (tmp_path / "out").iterdir() if len(path.name) == 32]
    assert 3 <= len(done) < 16
    stamps = {path: (path / "summary.json").stat().st_mtime_ns for path in done}
    again = subprocess.run(command, capture_output=True, text=True, check=True)
    assert again.stdout.splitlines()[-1] == f"executed {16 - len(done)}"
    assert stamps == {path: (path / "summary.json").stat().st_mtime_ns for path in done}
    assert not list((tmp_path / "out").glob("unfinished-*"))
