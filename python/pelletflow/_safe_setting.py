"""The value of a setting of a scene at which a share of the pellets breaks."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from pelletflow import _pelletflow
from pelletflow._impact import Floats, _broadcast, _strengths
from pelletflow._scene import SceneLike
from pelletflow._table import Table
from pelletflow.errors import InputError

#: Most seeds that are run at the value found [-].
MOST_SEEDS = 100


@dataclass(frozen=True)
class SafeSetting:
    """The value of a setting at which the share asked for breaks."""

    key: str
    """Key of the scene that was varied; of a velocity its size."""
    unit: str
    """Unit of the values; empty for SI."""
    value: float
    """Value at which the share asked for breaks [the setting's unit]."""
    low: float
    """The least that the sample of the strength test leaves possible; NaN where that is outside
    the range [the setting's unit]."""
    high: float
    """The most, in the same way [the setting's unit]."""
    seed_half_width: float
    """Half the width of its 95 % interval over seeds; NaN for one [the setting's unit]."""
    seed_shares: Floats
    """Share broken at the value found, one for each seed [-]."""
    is_monotone: bool
    """Whether more of the setting breaks more in every run, or less in every run."""
    runs: Table
    """One row for each run of the search: value, share broken with its interval, and hits."""
    details: dict[str, Any] = field(repr=False)
    """What ``pelletflow score --json`` prints of the run at the value found."""

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        value = f"{self.value:.4g} ({self.low:.4g} to {self.high:.4g}) {self.unit}".strip()
        return f"<p>{self.key}: {value}</p>{self.runs._repr_html_()}"


def safe_setting(
    scene: SceneLike,
    range: tuple[float, float],
    *,
    vary: str | None = None,
    unit: str = "",
    risk: float = 0.01,
    strength: float | None = None,
    scatter: float | None = None,
    distribution: Literal["log-normal", "weibull"] = "log-normal",
    tests: int | None = None,
    test_diameter: float | None = None,
    strength_card: str | os.PathLike[str] | None = None,
    tolerance: float = 0.01,
    seeds: int = 3,
    places: int = 10,
    threads: int | None = None,
    set: Mapping[str, Any] | None = None,
    progress: Callable[[int, float], object] | None = None,
) -> SafeSetting:
    """Seek the value of a setting of a scene at which a share of its pellets breaks.

    What `safe_speed` tells of a lone hit in closed form, this tells of a whole scene, by runs in
    memory at several values of one setting; ``pelletflow safe-speed --scene`` does the same.
    Ctrl-C stops it, also amid a run.

    >>> import pelletflow as pf
    >>> scene = {
    ...     "schema_version": 1,
    ...     "materials": {
    ...         "ore": {"density": 3700, "shear_modulus": "60 MPa", "poisson_ratio": 0.22},
    ...         "steel": {"density": 7850, "shear_modulus": "81 GPa", "poisson_ratio": 0.28},
    ...     },
    ...     "pairs": {
    ...         "ore-steel": {"restitution": 0.5, "friction": 0.3},
    ...         "ore-ore": {"restitution": 0.5, "friction": 0.3},
    ...     },
    ...     "pellets": {"pellet": {"material": "ore", "diameter": "15 mm"}},
    ...     "walls": {
    ...         "floor": {
    ...             "material": "steel",
    ...             "shape": {"kind": "half-space", "point": [0, 0, 0], "normal": [0, 0, 1]},
    ...         }
    ...     },
    ...     "fill": {"one": {"pellets": "pellet", "at": [[0, 0, 0.01]]}},
    ...     "domain": {"min": [-1, -1, -1], "max": [1, 1, 1]},
    ...     "time": {"end": "10 ms"},
    ... }
    >>> found = pf.safe_setting(scene, (2, 20), risk=0.05, strength=500, scatter=0.3, seeds=1)
    >>> found.key, bool(found.low == found.value)
    ('fill.one.velocity', True)

    Args:
        scene: A scene file, the same as a dictionary, or a `Scene`.
        range: Values between which it is sought, the lesser first [the setting's unit].
        vary: Key of the scene that is varied; None for how fast pellets come in, where there is
            one way in. Of a velocity the size is varied and the direction kept.
        unit: Unit of the values, such as ``"deg"``; SI where it is empty.
        risk: Share of the pellets that may break [-].
        strength: Mean crushing load [N].
        scatter: Standard deviation of the load over its mean [-]; all break at one load if None.
        distribution: How the load scatters.
        tests: Number of tested pellets, for the interval; the numbers count as exact if None [-].
        test_diameter: Diameter of the tested pellets [m]; the load holds for any size if None.
        strength_card: A card that tells the strength, in place of the five above.
        tolerance: Width of the last bracket over that of the range [-].
        seeds: Runs at the value found, with seeds that count up from the scene's [-].
        places: How many of the places where most breaks are told [-].
        threads: Threads of each run [-]; one per core if None.
        set: Values to put in place of the scene's, by dotted key.
        progress: Called with the runs that are done and the part of this one that is [-]; an
            exception that it raises stops the search.

    Raises:
        SceneError: The scene or the strength card has mistakes, or the scene has at some value.
        InputError: An argument cannot be worked with, or the share is not crossed in the range.
        PhysicsError: A run went wrong.

    """
    strengths, given = _strengths(
        strength, scatter, distribution, tests, test_diameter, strength_card
    )
    shape, arrays = _broadcast(given) if given else ((), {})
    if shape:
        raise InputError(f"the strength has shape {shape}; expected one strength", "strength")
    low, high = _ends(range)
    for name, share in {"risk": risk, "tolerance": tolerance}.items():
        if not 0.0 < share < 1.0:
            raise InputError(
                f"{name} is {share!r}; expected more than 0 and less than 1", name, share
            )
    if not isinstance(seeds, int) or not 1 <= seeds <= MOST_SEEDS:
        raise InputError(f"seeds is {seeds!r}; expected 1 to {MOST_SEEDS}", "seeds", seeds)
    search = {
        "vary": vary,
        "range": [low, high],
        "unit": unit,
        "risk": risk,
        "tolerance": tolerance,
        "seeds": seeds,
        "threads": threads,
        "places": places,
    }
    found = _pelletflow.safe_setting(scene, set, strengths | arrays, search, progress)
    half_width = found["seed_half_width"]
    return SafeSetting(
        key=found["key"],
        unit=found["unit"],
        value=found["value"],
        low=_or_nan(found["interval"][0]),
        high=_or_nan(found["interval"][1]),
        seed_half_width=_or_nan(half_width),
        seed_shares=np.array(found["seed_shares"], dtype=np.float64),
        is_monotone=found["is_monotone"],
        runs=_table(found["runs"], found["unit"]),
        details=found["breakage"],
    )


def _ends(range: tuple[float, float]) -> tuple[float, float]:
    try:
        low, high = (float(end) for end in range)
    except (TypeError, ValueError):
        raise InputError(
            f"range is {range!r}; expected two numbers, such as (1, 12)", "range", range
        ) from None
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise InputError(
            f"range is {range!r}; expected two finite numbers, the lesser first", "range", range
        )
    return low, high


def _table(runs: list[tuple[float, float, list[float], int]], unit: str) -> Table:
    columns: dict[str, npt.ArrayLike] = {
        "value": [value for value, _, _, _ in runs],
        "share": [share for _, share, _, _ in runs],
        "share_low": [low for _, _, (low, _), _ in runs],
        "share_high": [high for _, _, (_, high), _ in runs],
        "hits": [hits for _, _, _, hits in runs],
    }
    return Table(columns, name="runs", units={"value": unit or "-"})


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value
