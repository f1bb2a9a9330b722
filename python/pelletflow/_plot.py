"""Pictures; matplotlib is imported when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pelletflow.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pelletflow._pelletflow import Simulation
    from pelletflow._table import Table


def axes(ax: Axes | None) -> Axes:
    """Return the axes given, or new ones."""
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise InputError("a plot needs matplotlib; pip install matplotlib", "matplotlib") from error
    return plt.subplots()[1]


def columns(table: Table, x: str, y: list[str], *, ax: Axes | None = None, **options: Any) -> Axes:
    """Draw columns of a table against another one."""
    ax = axes(ax)
    for name in y:
        ax.plot(table[x], table[name], label=name, **options)
    ax.set_xlabel(_label(table, x))
    if len(y) == 1:
        ax.set_ylabel(_label(table, y[0]))
    else:
        ax.legend()
    return ax


def pellets(
    simulation: Simulation, *, along: str = "y", ax: Axes | None = None, **options: Any
) -> Axes:
    """Draw pellets seen along an axis, colored by speed."""
    import numpy as np

    if along not in ("x", "y", "z"):
        raise InputError(f"along is {along!r}; expected `x`, `y` or `z`", "along", along)
    ax = axes(ax)
    from matplotlib.collections import EllipseCollection

    across, up = {"x": (1, 2), "y": (0, 2), "z": (0, 1)}[along]
    places = simulation.positions[:, [across, up]]
    diameters = 2.0 * simulation.radii
    circles = EllipseCollection(
        diameters,
        diameters,
        np.zeros_like(diameters),
        units="xy",
        offsets=places,
        transOffset=ax.transData,
        **options,
    )
    circles.set_array(np.linalg.norm(simulation.velocities, axis=1))
    ax.add_collection(circles)
    ax.figure.colorbar(circles, ax=ax, label="speed [m/s]")
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.set_xlabel(f"{'xyz'[across]} [m]")
    ax.set_ylabel(f"{'xyz'[up]} [m]")
    ax.set_title(f"{simulation.time:.4g} s")
    return ax


def _label(table: Table, name: str) -> str:
    unit = table.units[name]
    return name if unit == "-" else f"{name} [{unit}]"
