"""Scenes in code."""

from __future__ import annotations

import html
import os
from collections.abc import Iterator, Mapping
from copy import deepcopy
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from pelletflow import _pelletflow
from pelletflow.errors import SceneError

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from pelletflow._scene_types import SceneSpec

#: A scene file, or the same as a dictionary.
Base: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]


class Scene(Mapping[str, Any]):
    """A scene: what is in it, how long it runs, what is recorded.

    Its tables are those of a scene file, and editors complete their keys.
    Numbers are SI; texts carry a unit: ``"15 mm"``.
    Values are set by dotted key, which leaves other scenes made from the same tables alone.

    >>> import pelletflow as pf
    >>> scene = pf.Scene(
    ...     schema_version=1,
    ...     materials={
    ...         "pellet": {"density": 3700, "shear_modulus": "60 MPa", "poisson_ratio": 0.22}
    ...     },
    ...     pairs={"pellet-pellet": {"restitution": 0.8, "friction": 0.3}},
    ...     pellets={"ore": {"material": "pellet", "diameter": "15 mm"}},
    ...     fill={"one": {"pellets": "ore", "at": [[0, 0, 0.5]]}},
    ...     domain={"min": [-1, -1, -1], "max": [1, 1, 1]},
    ...     time={"end": "0.1 s"},
    ... )
    >>> scene["time.end"] = "50 ms"
    >>> scene["time"]
    {'end': '50 ms'}
    >>> pf.Simulation(scene).time
    0.0
    """

    def __init__(self, **tables: Unpack[SceneSpec]) -> None:
        """Take the tables of a scene; they are validated by `check`, or when it is run.

        Raises:
            SceneError: A value is nothing that a scene can hold.

        """
        self._base: Base = _pelletflow.scene_value("", dict(tables))
        self._set: dict[str, Any] = {}

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Scene:
        """Take a scene file; meshes that it names are sought beside it."""
        scene = cls.__new__(cls)
        scene._base = Path(path)
        scene._set = {}
        return scene

    def copy(self) -> Scene:
        """Return another scene with the same values."""
        scene = type(self).__new__(type(self))
        scene._base = deepcopy(self._base)
        scene._set = deepcopy(self._set)
        return scene

    def __setitem__(self, key: str, value: Any) -> None:
        """Set a value by its dotted key, such as ``walls.chute.shape.radius``.

        A place in a list is a number: ``walls.chute.shape.of.0``, counted from 0.
        What was set before in a table that is set as a whole is gone.

        Raises:
            SceneError: The key is no dotted key, or the value nothing that a scene can hold.

        """
        set_last = {key: _pelletflow.scene_value(key, value)}
        if isinstance(self._base, Mapping):
            self._base = _pelletflow.scene_tables(self._base, set_last)
        else:
            # What cannot be set alone cannot be set in a file.
            _pelletflow.scene_tables({}, set_last)
            self._set = merged(self._set, set_last)

    def __getitem__(self, key: str) -> Any:
        """Return a copy of a value or a table by its dotted key, as it was written.

        Raises:
            KeyError: The scene has no such key.

        """
        try:
            parts = _pelletflow.parts_of(key)
        except SceneError:
            raise KeyError(key) from None
        value: Any = self._tables()
        for part in parts:
            if isinstance(value, Mapping) and part in value:
                value = value[part]
            elif isinstance(value, list) and part.isdecimal() and int(part) < len(value):
                value = value[int(part)]
            else:
                raise KeyError(key)
        return value

    def __iter__(self) -> Iterator[str]:
        """Go through the names of the tables."""
        return iter(self._tables())

    def __len__(self) -> int:
        """Return the number of tables [-]."""
        return len(self._tables())

    def check(self) -> list[str]:
        """Validate the scene.

        Returns:
            What was chosen for the user, in sentences.

        Raises:
            SceneError: The scene has mistakes; all are listed.

        """
        notes: list[str] = self._facts()["notes"]
        return notes

    @property
    def hash(self) -> str:
        """Hash of the text and of the files that it names, 32 hexadecimal digits."""
        digits: str = self._facts()["hash"]
        return digits

    def to_toml(self) -> str:
        """Return the text of the scene as it is run, a scene file."""
        text: str = self._facts()["text"]
        return text

    def __eq__(self, other: object) -> bool:
        """Tell whether another scene has the same values, as they were written."""
        if not isinstance(other, Scene):
            return NotImplemented
        return bool(self._tables() == other._tables())

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        """Names of the tables."""
        return f"<pelletflow.Scene: {', '.join(self)}>"

    def _repr_html_(self) -> str:
        """The text of the scene, as a notebook shows it."""
        return f"<pre>{html.escape(self.to_toml())}</pre>"

    def _base_and_set(self) -> tuple[Base, dict[str, Any]]:
        """What the Rust module reads, and what it puts in place of its values."""
        return self._base, dict(self._set)

    def _facts(self) -> dict[str, Any]:
        return _pelletflow.scene(self._base, self._set)

    def _tables(self) -> dict[str, Any]:
        """Return the tables with all that was set in them."""
        return _pelletflow.scene_tables(self._base, self._set)


#: Whatever tells a scene.
SceneLike: TypeAlias = Base | Scene


def base_and_set(scene: SceneLike, values: Mapping[str, Any] | None) -> tuple[Base, dict[str, Any]]:
    """Return what the Rust module reads, and what it puts in place of the scene's values."""
    if isinstance(scene, Scene):
        base, own = scene._base_and_set()
        return base, merged(own, values or {})
    return scene, dict(values or {})


def merged(first: Mapping[str, Any], later: Mapping[str, Any]) -> dict[str, Any]:
    """Values to set, the later ones last, because of two that meet the last one counts."""
    return {key: value for key, value in first.items() if key not in later} | dict(later)
