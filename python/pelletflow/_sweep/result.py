"""What a sweep found, point by point and run by run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from pelletflow import _pelletflow
from pelletflow._run import RunResult
from pelletflow._sweep.points import Point, Run
from pelletflow._table import Table
from pelletflow.errors import InputError

#: Keys of the summary to measure, or a function that measures a run.
Measures = Sequence[str] | Callable[[RunResult], Mapping[str, float]]

#: Parts of the summary that tell of the machine and not of the pellets.
_OF_THE_MACHINE = {"performance", "time", "threads", "seed", "schema_version"}


@dataclass(frozen=True)
class SweepResult:
    """What a sweep found."""

    table: Table
    """One row for each point: its values, how many runs, and of each measure the mean and the
    interval that the replicates leave for it (Student 1908), ``NAME_low`` to ``NAME_high``."""
    runs: Table
    """One row for each run: point, replicate, seed, hash of the scene, and the measures."""
    folder: Path
    """Where the runs are, each in a folder named by the hash of its scene."""
    executed: int
    """How many runs this call has run; the others were done before [-]."""
    failures: Mapping[str, str] = field(repr=False)
    """What went wrong, by hash; their measures are NaN."""

    def plot(self, x: str, y: str | Sequence[str], **options: Any) -> Any:
        """Draw columns of `table` against another one; needs matplotlib."""
        return self.table.plot(x, y, **options)

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return self.table._repr_html_()


def gather(
    folder: Path,
    points: list[Point],
    runs: list[Run],
    results: Mapping[str, RunResult],
    failures: Mapping[str, str],
    measures: Measures | None,
    confidence: float,
    executed: int,
) -> SweepResult:
    """Measure every run and put the points together."""
    measured = {key: _measured(result, measures) for key, result in results.items()}
    names = list(dict.fromkeys(name for row in measured.values() for name in row))
    rows = [measured.get(run.hash, {}) for run in runs]
    by_run = {name: np.array([row.get(name, np.nan) for row in rows]) for name in names}
    of_point = np.array([run.point for run in runs])
    keys = list(dict.fromkeys(key for point in points for key in point))
    per_point: dict[str, Any] = {key: _column([p.get(key) for p in points]) for key in keys}
    counts = [
        sum(run.hash in results for run in runs if run.point == p) for p in range(len(points))
    ]
    per_point["runs"] = np.array(counts)
    for name, values in by_run.items():
        intervals = []
        for index in range(len(points)):
            own = values[of_point == index]
            intervals.append(_pelletflow.mean_interval(own[np.isfinite(own)], confidence))
        low, best, high = np.array(intervals).T
        per_point |= {name: best, f"{name}_low": low, f"{name}_high": high}
    per_run: dict[str, Any] = {
        key: _column([points[run.point].get(key) for run in runs]) for key in keys
    }
    per_run |= {
        "point": of_point,
        "replicate": np.array([run.replicate for run in runs]),
        "seed": np.array([run.seed for run in runs]),
        "hash": [run.hash for run in runs],
    }
    return SweepResult(
        Table(per_point, name="sweep"),
        Table(per_run | by_run, name="runs"),
        folder,
        executed,
        failures,
    )


def _measured(result: RunResult, measures: Measures | None) -> dict[str, float]:
    if measures is None:
        return dict(_numbers("", result.summary))
    if callable(measures):
        return {name: float(value) for name, value in measures(result).items()}
    return {key: _number(result.summary, key) for key in measures}


def _numbers(prefix: str, value: Any) -> Iterator[tuple[str, float]]:
    """Every number of a summary, by dotted key."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            if prefix or key not in _OF_THE_MACHINE:
                yield from _numbers(f"{prefix}.{key}" if prefix else key, inner)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield prefix, float(value)


def _number(summary: Mapping[str, Any], key: str) -> float:
    value: Any = summary
    for part in key.split("."):
        if not isinstance(value, Mapping) or part not in value:
            known = ", ".join(name for name, _ in _numbers("", summary))
            raise InputError(
                f"measure `{key}` is no number of the summary; it has {known}", "measures", key
            )
        value = value[part]
    if value is None:
        return float("nan")
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"measure `{key}` is {value!r}; expected a number", "measures", key)
    return float(value)


def _column(values: list[Any]) -> Any:
    """Numbers as an array; texts, and what is neither, as texts."""
    is_number = all(isinstance(value, int | float) for value in values)
    if is_number:
        return np.array(values, dtype=np.float64)
    return [value if value is None or isinstance(value, str) else str(value) for value in values]
