"""Recordings read back as tables."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from pelletflow import _pelletflow
from pelletflow._table import Table
from pelletflow.errors import InputError, RecordingError


@dataclass(frozen=True)
class Recording:
    """What a recording holds, as tables."""

    path: Path
    """The file."""
    facts: Mapping[str, str]
    """Facts of the run: version, scene, seed and so on."""
    is_cut_off: bool
    """Whether the file ends in the middle; the tables then hold what is before the cut."""
    tables: Mapping[str, Table] = field(repr=False)
    """Every table that was read, by name; those of meters are called ``meters/NAME``."""

    @property
    def bodies(self) -> Table:
        """Every pellet in every frame: time, number, place, radius, speed and force."""
        return self._table("bodies")

    @property
    def contacts(self) -> Table:
        """Every contact in every frame: the two that touch, place, force on the pellet and overlap.

        Recorded where the scene asks for it, ``contacts = true`` in its ``[output]``; the first
        frame has none, nor the last of a run that failed.
        What a contact did from touch to release is a row of `hits`.
        """
        return self._table("contacts")

    @property
    def hits(self) -> Table:
        """Hits kept in full, in the order in which they ended, with the names of the walls."""
        return self._table("hits")

    @property
    def hit_classes(self) -> Table:
        """All hits, counted and summed by partner and force."""
        return self._table("hit_classes")

    @property
    def mass_ledger(self) -> Table:
        """Pellets and mass inserted, inside, discharged and lost, frame by frame."""
        return self._table("mass_ledger")

    @property
    def energy_ledger(self) -> Table:
        """Energies, frame by frame."""
        return self._table("energy_ledger")

    @property
    def events(self) -> Table:
        """What happened and when, in words."""
        return self._table("events")

    @property
    def walls(self) -> Table:
        """Where each wall is: a row for every moment at which one comes, goes or is moved.

        The pose takes a wall from its own frame to the world: first the turn, a quaternion,
        then the shift. Only walls that move, run or open are active.
        """
        return self._table("walls")

    @property
    def wall_triangles(self) -> Table:
        """Triangles that each wall is drawn of, in its own frame."""
        return self._table("wall_triangles")

    @property
    def wall_edges(self) -> Table:
        """Sharp edges of each wall, piece by piece, in its own frame."""
        return self._table("wall_edges")

    @property
    def meters(self) -> dict[str, Table]:
        """What each meter read over time, by the name of the meter."""
        return {
            name.removeprefix("meters/"): table
            for name, table in self.tables.items()
            if name.startswith("meters/")
        }

    def _table(self, name: str) -> Table:
        try:
            return self.tables[name]
        except KeyError:
            pass
        if name == "contacts":
            cure = (
                "the run recorded none (`contacts = true` in its [output] does), "
                "or `only` left them out"
            )
        elif name in ("hits", "hit_classes"):
            cure = (
                "the run followed no hits (`hits = false` in its [output]), or `only` left them out"
            )
        else:
            cure = "it was cut off before the first row, or `only` left them out"
        raise RecordingError(f"{self.path} gave no {name}: {cure}", self.path)

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        rows = "".join(
            f"<tr><td>{name}</td><td>{table.rows}</td></tr>" for name, table in self.tables.items()
        )
        cut = " (cut off)" if self.is_cut_off else ""
        return (
            f"<table><caption>{self.path}{cut}</caption>"
            f"<thead><tr><th>table</th><th>rows</th></tr></thead><tbody>{rows}</tbody></table>"
        )


def read(path: str | os.PathLike[str], *, only: Iterable[str] | None = None) -> Recording:
    """Read a recording as tables, in one pass.

    Of a file that is cut off, it reads what is whole.

    >>> import pelletflow as pf
    >>> values = {"time.end": "20 ms", "expect": {}}
    >>> output = pf.run("chute.toml", output="out/chute", set=values).output
    >>> recording = pf.read(output / "run.mcap", only=["bodies"])
    >>> recording.bodies.units["speed_m_per_s"]
    'm/s'

    Args:
        path: The recording, ``run.mcap``, or the folder of the run.
        only: Kinds of tables to read: ``bodies``, ``contacts``, ``hits``, ``hit_classes``,
            ``meters``, ``mass_ledger``, ``energy_ledger``, ``events``, ``walls``,
            ``wall_triangles``, ``wall_edges``; all if None.

    Raises:
        RecordingError: The file cannot be read, is no recording or is damaged.
        InputError: A kind of table is unknown.

    """
    file = Path(path)
    if file.is_dir():
        file = file / "run.mcap"
    kinds = _pelletflow.table_kinds()
    asked = kinds if only is None else list(only)
    for kind in asked:
        if kind not in kinds:
            raise InputError(
                f"`only` names {kind!r}; expected some of {', '.join(kinds)}", "only", kind
            )
    facts, is_cut_off, batches = _pelletflow.read(file, asked)
    tables = (Table._of(batch) for batch in batches)
    return Recording(file, facts, is_cut_off, {table.name: table for table in tables})
