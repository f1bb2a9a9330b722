"""The sweep itself: what is missing is handed to an executor."""

from __future__ import annotations

import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol

from pelletflow._run import RunResult
from pelletflow._scene import SceneLike, base_and_set
from pelletflow._sweep import store
from pelletflow._sweep.points import Points, points_of, runs_of
from pelletflow._sweep.result import Measures, SweepResult, gather
from pelletflow.errors import InputError, SweepError


class SupportsSubmit(Protocol):
    """What follows `concurrent.futures.Executor`."""

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Future[Any]:
        """Call a function somewhere, some time."""


def sweep(
    scene: SceneLike,
    points: Points,
    *,
    output: str | os.PathLike[str],
    replicates: int = 1,
    set: Mapping[str, Any] | None = None,
    measures: Measures | None = None,
    confidence: float = 0.95,
    executor: SupportsSubmit | None = None,
    workers: int | None = None,
    threads: int = 1,
    keep_recordings: bool = True,
    keep_going: bool = False,
    progress: bool | Callable[[int, int], object] | None = None,
) -> SweepResult:
    """Run a scene at many points, with replicates, and put what they measure into a table.

    What is done is on disk, in a folder for each run that is named by the hash of its scene.
    A second call runs only what is missing, whatever ended the first one.
    Only mistakes, of any point, are told before the first run.

    >>> import pelletflow as pf
    >>> result = pf.sweep(
    ...     "chute.toml",
    ...     {"walls.floor.shape.incline": ["30 deg", "40 deg"]},
    ...     output="out/sweep",
    ...     replicates=2,
    ...     set={"time.end": "20 ms", "expect": {}},
    ...     measures=["mass.inserted"],
    ...     workers=1,
    ... )
    >>> result.table["runs"].tolist()
    [2, 2]

    A script that sweeps on processes of its own does so under ``if __name__ == "__main__":``.

    Args:
        scene: A scene file, the same as a dictionary, or a `Scene`.
        points: Values for each dotted key, of which all combinations are points; or a list of
            points, each a dictionary of keys and values.
        output: Folder of the sweep; every worker has to reach it under this name.
        replicates: Runs of each point, with seeds that count up from the scene's [-].
        set: Values to put in place of the scene's at every point.
        measures: Numbers of the summary by dotted key, or a function of a `RunResult` that returns
            numbers by name, which is called here; every number of the summary that tells of the
            pellets if None.
        confidence: Of the intervals [-].
        executor: Anything that follows `concurrent.futures`; processes of this machine if None.
        workers: Processes, where no executor is given; one for each core if None [-].
        threads: Threads of each run [-].
        keep_recordings: Whether each run keeps its recording, which is most of its size on disk;
            what was run without is then run again.
        keep_going: Whether runs that fail leave NaN in the tables, in place of an error at the end.
        progress: Called with runs done and all runs; True for a line on the terminal, which is
            also shown if None and there is one.

    Raises:
        SceneError: A point is no right scene, for instance a key that no scene has.
        InputError: An argument cannot be worked with.
        SweepError: Another sweep is at work in the folder, or runs have failed.
        OutputError: The folder cannot be written.

    """
    _check(replicates, confidence, executor, workers, threads)
    listed = points_of(points)
    folder = Path(output).absolute()
    runs = runs_of(scene, listed, replicates, dict(set or {}))
    base, _ = base_and_set(scene, None)
    if isinstance(base, str | os.PathLike):
        base = str(Path(base).absolute())
    show = _shown(progress)
    with store.locked(folder):
        store.remove_unfinished(folder)
        wanted = {run.hash: run for run in runs}
        missing = {
            key: run
            for key, run in wanted.items()
            if not store.done(folder, key, recorded=keep_recordings)
        }
        finished = len(wanted) - len(missing)
        show(finished, len(wanted))
        failures: dict[str, str] = {}
        executed = 0
        with _at_work(executor, workers, len(missing)) as pool:
            futures: dict[Future[Any], str] = {}
            try:
                for key, run in missing.items():
                    arguments = (base, run.set, key, str(folder), threads, keep_recordings)
                    futures[_submitted(pool, *arguments)] = key
                for future in as_completed(futures):
                    try:
                        executed += bool(future.result())
                    except BrokenExecutor:
                        raise
                    except Exception as error:
                        failures[futures[future]] = f"{type(error).__name__}: {error}"
                    finished += 1
                    show(finished, len(wanted))
            except BrokenExecutor as error:
                anew = "" if executor is None else ", with a new executor"
                raise SweepError(
                    f"a worker process was killed: {error}; what is done is in {folder}: call "
                    f"again to go on{anew}, and with fewer workers if memory ran out"
                ) from error
            finally:
                for future in futures:
                    future.cancel()
        if failures and not keep_going:
            first = next(iter(failures.items()))
            raise SweepError(
                f"{len(failures)} of {len(wanted)} runs failed; the first, {first[0]}: {first[1]}; "
                f"the others are done in {folder}; `keep_going=True` leaves the failed out",
                failures,
            )
        results: dict[str, RunResult] = {}
        for key in wanted:
            result = store.done(folder, key)
            if result is not None:
                results[key] = result
    return gather(folder, listed, runs, results, failures, measures, confidence, executed)


def _check(
    replicates: int,
    confidence: float,
    executor: SupportsSubmit | None,
    workers: int | None,
    threads: int,
) -> None:
    for name, count in {"replicates": replicates, "workers": workers, "threads": threads}.items():
        if count is not None and (not isinstance(count, int) or count < 1):
            raise InputError(f"{name} is {count!r}; expected at least 1", name, count)
    if not 0.0 < confidence < 1.0:
        raise InputError(
            f"confidence is {confidence!r}; expected more than 0 and less than 1",
            "confidence",
            confidence,
        )
    if executor is not None and workers is not None:
        raise InputError("workers are those of the executor; leave one of them out", "workers")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError(
            f"executor is {type(executor).__name__}, which has no `submit`; expected one that "
            "follows concurrent.futures, such as ProcessPoolExecutor or Dask's "
            "Client.get_executor()",
            "executor",
            executor,
        )


def _submitted(executor: SupportsSubmit, *arguments: Any) -> Future[Any]:
    """Hand a run over."""
    try:
        future = executor.submit(store.run_once, *arguments)
    except BrokenExecutor:
        raise
    except RuntimeError as error:
        raise SweepError(f"the executor takes no more runs: {error}; start it anew") from error
    if not isinstance(future, Future):
        raise InputError(
            f"`submit` of executor {type(executor).__name__} gives {type(future).__name__}; "
            "expected a concurrent.futures.Future; of a Dask client take client.get_executor()",
            "executor",
            executor,
        )
    return future


@contextmanager
def _at_work(
    executor: SupportsSubmit | None, workers: int | None, runs: int
) -> Iterator[SupportsSubmit]:
    """The executor given, or processes of this machine that end with the sweep."""
    if executor is not None:
        yield executor
        return
    if multiprocessing.current_process().name != "MainProcess":
        raise SweepError(
            "a worker process has begun the sweep anew; put the call under "
            '`if __name__ == "__main__":`, because each process reads the script again'
        )
    count = max(1, min(workers or os.cpu_count() or 1, runs))
    # A forked process would take over locks of threads that it does not have.
    pool = ProcessPoolExecutor(count, mp_context=multiprocessing.get_context("spawn"))
    try:
        yield pool
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _shown(progress: bool | Callable[[int, int], object] | None) -> Callable[[int, int], object]:
    if callable(progress):
        return progress
    is_shown = sys.stderr.isatty() if progress is None else progress
    if not is_shown:
        return lambda done, count: None

    def line(done: int, count: int) -> None:
        filled = 30 * done // count
        end = "\n" if done == count else ""
        bar = "█" * filled + "·" * (30 - filled)
        print(f"\r{bar} {done} of {count} runs", end=end, file=sys.stderr, flush=True)

    return line
