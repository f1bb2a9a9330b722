"""A whole run, from a scene to a recording and a summary."""

import html
import json
import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, NamedTuple

from pelletflow import _pelletflow
from pelletflow._recording import Recording, read
from pelletflow._scene import SceneLike


class Progress(NamedTuple):
    """How far a run is."""

    time: float
    """Simulated time [s]."""
    end_time: float
    """Simulated time at which the run ends at the latest [s]."""
    step: int
    """Steps taken [-]."""
    pellets: int
    """Pellets inside [-]."""
    max_force: float
    """Greatest normal force so far [N]."""
    discharged: int
    """Pellets discharged so far [-]."""
    lost: int
    """Pellets lost so far [-]."""


@dataclass(frozen=True)
class RunResult:
    """What a run leaves."""

    summary: dict[str, Any]
    """What ``summary.json`` holds; the unit of each value is in its name."""
    output: Path
    """The folder with ``run.mcap``, ``summary.json``, ``scene.toml`` and ``layout.json``."""

    def read(self, *, only: Iterable[str] | None = None) -> Recording:
        """Read the recording as tables; `only` names the kinds, as in `pelletflow.read`."""
        return read(self.output, only=only)

    def _repr_html_(self) -> str:
        """The summary, as a notebook shows it."""
        text = json.dumps(self.summary, indent=2, ensure_ascii=False)
        return f"<p>{html.escape(str(self.output))}</p><pre>{html.escape(text)}</pre>"


def run(
    scene: SceneLike,
    *,
    output: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    set: Mapping[str, Any] | None = None,
    unfinished: Literal["refuse", "resume", "restart"] = "refuse",
    progress: Callable[[Progress], object] | None = None,
) -> RunResult:
    """Run a scene to its end and write its recording and summary.

    Ctrl-C stops the run within a fraction of a second; the recording is finished and a checkpoint
    written first, so that ``unfinished="resume"`` goes on from there, to the same bits.

    >>> import pelletflow as pf
    >>> values = {"time.end": "20 ms", "expect": {}}
    >>> result = pf.run("chute.toml", output="out/chute", set=values)
    >>> result.summary["ended"], (result.output / "run.mcap").exists()
    ('end-time', True)

    Args:
        scene: A scene file, the same as a dictionary, or a `Scene`.
        output: Folder for what is written; ``out/NAME`` if None, with the name of the scene.
        threads: Threads at work [-]; one per core if None. The result does not depend on it.
        set: Values to put in place of the scene's, by dotted key: ``{"time.end": "1 s"}``.
        unfinished: What becomes of an earlier run in the folder that did not end: ``"refuse"`` it,
            ``"resume"`` from its last checkpoint, or ``"restart"``. With ``"resume"``, a run that
            is over gives its summary again.
        progress: Called about 50 times a second; an exception that it raises stops the run.

    Raises:
        SceneError: The scene has mistakes; all are listed.
        PhysicsError: The run went wrong; the recording holds it up to there.
        OutputError: A file could not be written, or the folder holds another run.

    """
    observer = None if progress is None else lambda *values: progress(Progress(*values))
    summary, folder = _pelletflow.run(scene, output, threads, set, unfinished, observer)
    return RunResult(summary, folder)
