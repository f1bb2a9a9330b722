"""Points of a sweep, and the runs that they take."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pelletflow import _pelletflow
from pelletflow._scene import SceneLike, base_and_set, merged
from pelletflow.errors import InputError

Point = dict[str, Any]
#: Values for each key, of which all combinations are points; or the points one by one.
Points = Mapping[str, Iterable[Any]] | Sequence[Mapping[str, Any]]

SEED = "scene.seed"


@dataclass(frozen=True)
class Run:
    """One run of a sweep."""

    point: int
    """Which point it belongs to, counted from 0 [-]."""
    replicate: int
    """Which of the point's replicates it is, counted from 0 [-]."""
    seed: int
    """Seed of its random numbers [-]."""
    set: Point
    """What is put in place of the scene's values."""
    hash: str
    """Hash of the scene as it is run."""


def points_of(points: Points) -> list[Point]:
    """Every point, in order; of a grid the last key changes fastest."""
    if isinstance(points, Mapping):
        values = {key: _values(key, given) for key, given in points.items()}
        listed = [
            dict(zip(values, combination, strict=True))
            for combination in itertools.product(*values.values())
        ]
        if not values:
            listed = []
    elif isinstance(points, Sequence) and not isinstance(points, str):
        listed = []
        for index, point in enumerate(points):
            if not isinstance(point, Mapping):
                raise InputError(
                    f"point {index} is {point!r}; expected a dictionary of keys and values",
                    "points",
                    point,
                )
            listed.append({key: _plain(value) for key, value in point.items()})
    else:
        raise InputError(
            f"points is {type(points).__name__}; expected a dictionary of lists, for a grid, or a "
            "list of dictionaries",
            "points",
            points,
        )
    if not listed:
        raise InputError(
            "the sweep has no point; give every key at least one value", "points", points
        )
    return listed


def runs_of(scene: SceneLike, points: list[Point], replicates: int, given: Point) -> list[Run]:
    """Every run, each validated: mistakes show before anything is run."""
    runs = []
    for index, point in enumerate(points):
        base, values = base_and_set(scene, merged(given, point))
        facts = _pelletflow.scene(base, values)
        own = facts["seed"]
        for replicate in range(replicates):
            seeded = values
            if replicate > 0:
                seeded = merged(values, {SEED: own + replicate})
                facts = _pelletflow.scene(base, seeded)
            runs.append(Run(index, replicate, own + replicate, seeded, facts["hash"]))
    return runs


def _values(key: str, given: Iterable[Any]) -> list[Any]:
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(
            f"`{key}` is {given!r}; expected a list of values, of one value too", key, given
        )
    values = [_plain(value) for value in given]
    if not values:
        raise InputError(f"`{key}` has no values; give it at least one", key, given)
    return values


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays as Python's, which every executor can send."""
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else value
