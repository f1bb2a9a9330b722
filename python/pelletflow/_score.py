"""Breakage by the hits of a run, without a new run."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from pelletflow import _pelletflow
from pelletflow._impact import Floats, _broadcast, _strengths
from pelletflow._table import Table
from pelletflow.errors import InputError


@dataclass(frozen=True)
class Score:
    """Share of the pellets that the hits of a run break, in the shape of the arguments.

    Of a run with softened pellets it is told by the forces at true stiffness, else by those of the
    run; `details` holds both.
    """

    share: Floats
    """Share of the pellets put in that break [-]."""
    share_low: Floats
    """The least that the sample of the strength test leaves possible [-]."""
    share_high: Floats
    """The most [-]."""
    details: list[dict[str, Any]] = field(repr=False)
    """What ``pelletflow score --json`` prints for each strength, in C order of the arrays."""

    def table(self) -> Table:
        """Return one row for each strength, in C order of the arrays."""
        columns = {
            "share": np.ravel(self.share),
            "share_low": np.ravel(self.share_low),
            "share_high": np.ravel(self.share_high),
        }
        return Table(columns, name="score")

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return self.table()._repr_html_()


def score(
    recording: str | os.PathLike[str],
    *,
    strength: npt.ArrayLike | None = None,
    scatter: npt.ArrayLike | None = None,
    distribution: Literal["log-normal", "weibull"] = "log-normal",
    tests: int | None = None,
    test_diameter: npt.ArrayLike | None = None,
    strength_card: str | os.PathLike[str] | None = None,
    law: Literal["load", "energy"] = "load",
    yield_pressure: npt.ArrayLike | None = None,
    places: int = 10,
) -> Score:
    """Tell which share of the pellets the recorded hits of a run break.

    The recording is read once, for all strengths.

    >>> import pelletflow as pf
    >>> values = {"time.end": "0.25 s", "expect": {}, "output.hits_above": "1 N"}
    >>> chute = pf.run("chute.toml", output="out/chute", set=values).output
    >>> pf.score(chute, strength=[1e3, 1e9]).share
    array([0., 0.])

    Args:
        recording: The recording, ``run.mcap``, or the folder of the run.
        strength: Mean crushing load [N].
        scatter: Standard deviation of the load over its mean [-]; all break at one load if None.
        distribution: How the load scatters.
        tests: Number of tested pellets, for the interval; the numbers count as exact if None [-].
        test_diameter: Diameter of the tested pellets [m]; the load holds for any size if None.
        strength_card: A card that tells the strength, in place of the five above.
        law: Whether the load of a hit or its energy breaks a pellet; the energy needs a card.
        yield_pressure: Pressure that a pellet yields under [Pa]; that of the card if None.
        places: How many of the places where most breaks are told [-].

    Raises:
        RecordingError: The recording cannot be read, or holds no hits.
        InputError: A quantity is missing, unknown, no number or outside its bounds.
        SceneError: The strength card has mistakes or cannot be read.

    """
    path = Path(recording)
    if path.is_dir():
        path = path / "run.mcap"
    strengths, given = _strengths(
        strength, scatter, distribution, tests, test_diameter, strength_card
    )
    if law not in ("load", "energy"):
        raise InputError(f"law is {law!r}; expected `load` or `energy`", "law", law)
    if law == "energy":
        if strength_card is None or yield_pressure is not None:
            raise InputError(
                "law `energy` takes a strength_card with [fracture_energy], and no yield_pressure",
                "law",
                law,
            )
        return _gathered((), _pelletflow.score_energy(path, strength_card, places))
    if yield_pressure is not None:
        given = given | {"yield_pressure": yield_pressure}
    shape, arrays = _broadcast(given) if given else ((), {})
    pressure = arrays.pop("yield_pressure", None)
    count = int(np.prod(shape))
    return _gathered(shape, _pelletflow.scores(path, strengths | arrays, pressure, count, places))


def _gathered(
    shape: tuple[int, ...], answers: list[tuple[float, list[float], dict[str, Any]]]
) -> Score:
    def column(values: list[float]) -> Floats:
        return np.array(values, dtype=np.float64).reshape(shape)

    return Score(
        column([share for share, _, _ in answers]),
        column([low for _, (low, _), _ in answers]),
        column([high for _, (_, high), _ in answers]),
        [details for _, _, details in answers],
    )
