"""Single hits and safe speeds, over whole arrays."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from pelletflow import _pelletflow
from pelletflow._table import Table
from pelletflow.errors import InputError

Floats = npt.NDArray[np.float64]

#: Units of what is told of a hit.
_UNITS = {
    "peak_force": "N",
    "contact_time": "s",
    "max_approach": "m",
    "contact_radius": "m",
    "peak_pressure": "Pa",
    "impulse": "N·s",
    "peak_parameter": "N/s",
    "load": "N",
    "speed": "m/s",
    "drop_height": "m",
}


class _Results:
    """Arrays of one shape with names and units."""

    def table(self) -> Table:
        """Return one row for each hit, in C order of the arrays."""
        columns = {each.name: np.ravel(getattr(self, each.name)) for each in fields(self)}  # type: ignore[arg-type]
        units = {name: _unit(name) for name in columns}
        return Table(columns, name=type(self).__name__.lower(), units=units)

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return self.table()._repr_html_()


@dataclass(frozen=True)
class Impact(_Results):
    """Hits from first touch to release; the arrays have the shape that the arguments make."""

    peak_force: Floats
    """Greatest normal force [N]."""
    contact_time: Floats
    """Time from first touch to release [s]."""
    max_approach: Floats
    """Greatest approach of the two bodies [m]."""
    contact_radius: Floats
    """Radius of the contact circle at the greatest approach [m]."""
    peak_pressure: Floats
    """Greatest pressure, in the middle of the contact [Pa]."""
    restitution: Floats
    """Rebound speed over approach speed, along the normal [-]."""
    impulse: Floats
    """Impulse along the normal [N·s]."""
    specific_impulse: Floats
    """Impulse over greatest force times contact time [-]."""
    peak_parameter: Floats
    """Greatest force over the contact time [N/s]."""
    asymmetry: Floats
    """Moment of the greatest force over the contact time [-]."""


@dataclass(frozen=True)
class SafeSpeed(_Results):
    """Speeds that break a share of the pellets; the arrays have the shape of the arguments."""

    load: Floats
    """Force that breaks the share [N]."""
    load_low: Floats
    """The least that the sample of the strength test leaves possible [N]."""
    load_high: Floats
    """The most [N]."""
    speed: Floats
    """Speed across the surface at which an elastic hit reaches the load [m/s]."""
    speed_low: Floats
    """Of the weakest load and the stiffest pellet [m/s]."""
    speed_high: Floats
    """Of the strongest load and the softest pellet [m/s]."""
    drop_height: Floats
    """Height of a fall from rest that ends at the speed, without drag [m]."""
    drop_height_low: Floats
    """Of the least speed [m]."""
    drop_height_high: Floats
    """Of the greatest speed [m]."""


def impact(
    speed: npt.ArrayLike,
    *,
    pellet: str | None = None,
    onto: str = "steel",
    angle: npt.ArrayLike = 0.0,
    diameter: npt.ArrayLike | None = None,
    density: npt.ArrayLike | None = None,
    youngs_modulus: npt.ArrayLike | None = None,
    shear_modulus: npt.ArrayLike | None = None,
    poisson_ratio: npt.ArrayLike | None = None,
    restitution: npt.ArrayLike | None = None,
    relaxation_time: npt.ArrayLike | None = None,
) -> Impact:
    """Follow hits of pellets on a flat surface, from first touch to release.

    The arguments broadcast against each other as NumPy arrays do.
    Only the motion along the normal is followed; ``pelletflow impact`` follows sliding too.

    >>> import numpy as np
    >>> import pelletflow as pf
    >>> hits = pf.impact(np.array([1.0, 4.0, 8.0]), pellet="papers-pellet")
    >>> hits.peak_force.round(1)
    array([ 44.4, 234.2, 538.1])

    Args:
        speed: Speed of arrival [m/s].
        pellet: A pellet of the library, for what is not given; ``pelletflow materials`` lists it.
        onto: The surface's material in the library.
        angle: Angle between the path and the normal of the surface [rad].
        diameter: Of the pellet [m].
        density: Of the pellet [kg/m³].
        youngs_modulus: Of the pellet [Pa].
        shear_modulus: Of the pellet, in place of Young's modulus [Pa].
        poisson_ratio: Of the pellet [-].
        restitution: Rebound speed over approach speed [-]; the hit is elastic if None.
        relaxation_time: Of a viscoelastic pellet, in place of the restitution [s].

    Raises:
        InputError: A quantity is missing, unknown, no number or outside its bounds.

    """
    damping, values = _one_of(restitution=restitution, relaxation_time=relaxation_time)
    given = _arrivals(
        pellet, onto, speed, angle, diameter, density, youngs_modulus, shear_modulus, poisson_ratio
    )
    if values is not None:
        given["damping"] = values
    shape, arrays = _broadcast(given)
    columns = _pelletflow.impacts(arrays, damping, arrays.pop("damping", None))
    return Impact(**{name: column.reshape(shape) for name, column in columns})


def safe_speed(
    risk: npt.ArrayLike = 0.01,
    *,
    strength: npt.ArrayLike | None = None,
    scatter: npt.ArrayLike | None = None,
    distribution: Literal["log-normal", "weibull"] = "log-normal",
    tests: int | None = None,
    test_diameter: npt.ArrayLike | None = None,
    strength_card: str | os.PathLike[str] | None = None,
    pellet: str | None = None,
    onto: str = "steel",
    diameter: npt.ArrayLike | None = None,
    density: npt.ArrayLike | None = None,
    youngs_modulus: npt.ArrayLike | None = None,
    shear_modulus: npt.ArrayLike | None = None,
    poisson_ratio: npt.ArrayLike | None = None,
    youngs_modulus_range: tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
) -> SafeSpeed:
    """Tell how fast pellets may arrive before a share of them breaks.

    The force is elastic, so that it errs to the safe side as far as the stiffness is right;
    slow crushing is not an impact, and each hit is taken alone.
    The arguments broadcast against each other as NumPy arrays do.

    >>> import pelletflow as pf
    >>> safe = pf.safe_speed([0.01, 0.1], pellet="fired-pellet", strength=2450, scatter=0.3)
    >>> safe.speed.round(2)
    array([ 9.23, 11.92])

    Args:
        risk: Share of the pellets that may break [-].
        strength: Mean crushing load [N].
        scatter: Standard deviation of the load over its mean [-]; all break at one load if None.
        distribution: How the load scatters.
        tests: Number of tested pellets, for the interval; the numbers count as exact if None [-].
        test_diameter: Diameter of the tested pellets [m]; the load holds for any size if None.
        strength_card: A card that tells the strength, in place of the five above.
        pellet: A pellet of the library, for what is not given.
        onto: The surface's material in the library.
        diameter: Of the pellet [m].
        density: Of the pellet [kg/m³].
        youngs_modulus: Of the pellet [Pa].
        shear_modulus: Of the pellet, in place of Young's modulus [Pa].
        poisson_ratio: Of the pellet [-].
        youngs_modulus_range: Between which the pellet's modulus lies [Pa]; that of the library
            where the stiffness is from there, else none.

    Raises:
        InputError: A quantity is missing, unknown, no number or outside its bounds.
        SceneError: The strength card has mistakes or cannot be read.

    """
    strengths, strength_arrays = _strengths(
        strength, scatter, distribution, tests, test_diameter, strength_card
    )
    given = _arrivals(
        pellet, onto, 1.0, 0.0, diameter, density, youngs_modulus, shear_modulus, poisson_ratio
    )
    is_own = youngs_modulus is not None or shear_modulus is not None
    if youngs_modulus_range is None and not is_own and pellet is not None:
        youngs_modulus_range = _named(pellet, "pellet")["youngs_modulus_range"]
    given |= {"risk": risk} | strength_arrays
    if youngs_modulus_range is not None:
        given["least"], given["greatest"] = youngs_modulus_range
    shape, arrays = _broadcast(given)
    strengths |= {name: arrays.pop(name) for name in strength_arrays}
    ends = [arrays.pop(name) for name in ("least", "greatest") if name in arrays]
    columns = _pelletflow.safe_speeds(arrays, strengths, arrays.pop("risk"), ends or None)
    return SafeSpeed(**{name: column.reshape(shape) for name, column in columns})


def _strengths(
    strength: npt.ArrayLike | None,
    scatter: npt.ArrayLike | None,
    distribution: str,
    tests: int | None,
    test_diameter: npt.ArrayLike | None,
    card: str | os.PathLike[str] | None,
) -> tuple[dict[str, Any], dict[str, npt.ArrayLike]]:
    """What the Rust module takes as strengths, and the arrays that are still to be broadcast."""
    if distribution not in ("log-normal", "weibull"):
        raise InputError(
            f"distribution is {distribution!r}; expected `log-normal` or `weibull`",
            "distribution",
            distribution,
        )
    own = {"mean": strength, "variation": scatter, "test_diameter": test_diameter}
    arrays = {name: values for name, values in own.items() if values is not None}
    if card is None and strength is None:
        raise InputError("the strength is missing; give strength or strength_card", "strength")
    if card is not None and (arrays or tests is not None):
        raise InputError(
            "strength_card tells all of the strength; leave out strength, scatter, tests and "
            "test_diameter",
            "strength_card",
            str(card),
        )
    strengths: dict[str, Any] = dict.fromkeys(own)
    return strengths | {"card": card, "distribution": distribution, "tests": tests}, arrays


def _arrivals(
    pellet: str | None,
    onto: str,
    speed: npt.ArrayLike,
    angle: npt.ArrayLike,
    diameter: npt.ArrayLike | None,
    density: npt.ArrayLike | None,
    youngs_modulus: npt.ArrayLike | None,
    shear_modulus: npt.ArrayLike | None,
    poisson_ratio: npt.ArrayLike | None,
) -> dict[str, npt.ArrayLike]:
    """Values by name, with those of the library where none is given."""
    base = {} if pellet is None else _named(pellet, "pellet")
    surface = _named(onto, "onto")

    def value(name: str, own: npt.ArrayLike | None) -> npt.ArrayLike:
        if own is None:
            own = base.get(name)
        if own is None:
            raise InputError(
                f"{name} is missing; give it, or a pellet of the library that has it, for example "
                'pellet="fired-pellet"',
                name,
            )
        return own

    poisson = value("poisson_ratio", poisson_ratio)
    if shear_modulus is None:
        stiffness = {"youngs_modulus": value("youngs_modulus", youngs_modulus)}
    else:
        _one_of(youngs_modulus=youngs_modulus, shear_modulus=shear_modulus)
        stiffness = {"shear_modulus": shear_modulus}
    return stiffness | {
        "speed": speed,
        "angle": angle,
        "diameter": value("diameter", diameter),
        "density": value("density", density),
        "poisson_ratio": poisson,
        "onto_youngs_modulus": surface["youngs_modulus"],
        "onto_poisson_ratio": surface["poisson_ratio"],
    }


def _named(name: str, argument: str) -> dict[str, Any]:
    library: dict[str, dict[str, Any]] = {row["name"]: row for row in _pelletflow.library()}
    try:
        return library[name]
    except (KeyError, TypeError):
        raise InputError(
            f"{argument} is {name!r}; expected one of {', '.join(library)}", argument, name
        ) from None


def _one_of(**arguments: npt.ArrayLike | None) -> tuple[str, npt.ArrayLike | None]:
    """Name and values of the one argument that is given; of none, no name."""
    given = [(name, values) for name, values in arguments.items() if values is not None]
    if len(given) > 1:
        names = " and ".join(name for name, _ in given)
        raise InputError(f"{names} are both given; leave one of them out", given[0][0])
    return given[0] if given else ("", None)


def _floats(name: str, values: npt.ArrayLike) -> Floats:
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "fiu":
            raise TypeError
        return array.astype(np.float64)
    except (TypeError, ValueError):
        raise InputError(
            f"{name} is {values!r}; expected numbers in SI units", name, values
        ) from None


def _broadcast(
    given: Mapping[str, npt.ArrayLike],
) -> tuple[tuple[int, ...], dict[str, Floats]]:
    """The common shape, and each array stretched to it and laid flat."""
    arrays = {name: _floats(name, values) for name, values in given.items()}
    try:
        stretched = np.broadcast_arrays(*arrays.values())
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise InputError(
            f"the shapes do not broadcast: {shapes}; expected shapes that are equal or 1 in every "
            "dimension",
            "shape",
        ) from None
    flat = (np.ascontiguousarray(array).ravel() for array in stretched)
    return stretched[0].shape, dict(zip(arrays, flat, strict=True))


def _unit(name: str) -> str:
    return _UNITS.get(name.removesuffix("_low").removesuffix("_high"), "-")
