"""Recordings for Rerun, which by itself reads neither their spheres nor their equipment.

Its package is imported when the first one is written.
"""

from __future__ import annotations

import os
import uuid
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pelletflow import _pelletflow
from pelletflow._recording import Recording, read
from pelletflow._table import Table
from pelletflow.errors import InputError, OutputError

if TYPE_CHECKING:
    import rerun

#: What pellets can be colored by: the column, and its unit.
COLORED_BY = {"speed": ("speed_m_per_s", "m/s"), "force": ("force_n", "N")}
#: Tables that are drawn.
DRAWN = (
    "bodies",
    "walls",
    "wall_triangles",
    "wall_edges",
    "hits",
    "meters",
    "mass_ledger",
    "energy_ledger",
    "events",
)
#: The oldest Rerun that has all that is asked of it.
NEEDED = (0, 41)
#: Share of the values below the end of the scale [-]: one fast pellet leaves the others theirs.
BELOW_FULL = 0.99
#: Walls that stay, and those that move, run or open [0 to 255]; seen through up to four surfaces.
FIXED_WALL, ACTIVE_WALL = (140, 153, 168, 20), (230, 140, 51, 60)
#: Sharp edges [0 to 255].
OUTLINE = (89, 97, 107)
#: The hardest hits [0 to 255].
HIT = (214, 39, 40)
#: Hits that are marked [-], and the radius of a mark over the pellet's diameter [-].
WORST, MARK = 20, 0.6
#: Distance of the eye over the longest way through the room that pellets pass [-], and from where.
AWAY, FROM = 1.5, (0.35, -0.85, 0.4)
#: Curves beside the view [-].
CURVES = 4
#: Names of levels of events, where Rerun has others.
LEVELS = {"information": "INFO", "warning": "WARN", "failure": "ERROR", "fatal": "CRITICAL"}


def to_rerun(
    recording: Recording | str | os.PathLike[str],
    path: str | os.PathLike[str] | None = None,
    *,
    color_by: str = "speed",
) -> Path:
    """Write a recording for Rerun: spheres of true size, equipment, curves and the hardest hits.

    Rerun opens ``run.mcap`` itself, and draws pellets as points without the equipment around them.
    Needs the package ``rerun-sdk`` 0.41 or newer, and so Python 3.11; then ``rerun run.rrd``
    shows it. Contacts are not drawn.

    >>> import pelletflow as pf
    >>> values = {"time.end": "20 ms", "expect": {}}
    >>> output = pf.run("chute.toml", output="out/rerun", set=values).output
    >>> pf.to_rerun(output, output / "run.rrd").name
    'run.rrd'

    Args:
        recording: What `pf.read` returned, a recording, or the folder of a run.
        path: The file to write, ``.rrd``; beside the recording if None.
        color_by: ``speed`` [m/s] or ``force`` [N] of each pellet.

    Returns:
        The file.

    Raises:
        InputError: ``rerun-sdk`` is missing or too old, `color_by` is neither, or `path` is the
            recording itself.
        RecordingError: The file cannot be read, is no recording or is damaged.
        OutputError: The file cannot be written.

    """
    if color_by not in COLORED_BY:
        known = ", ".join(f"`{name}`" for name in COLORED_BY)
        raise InputError(f"color_by is {color_by!r}; expected {known}", "color_by", color_by)
    rerun = _imported()
    tables = recording if isinstance(recording, Recording) else read(recording, only=DRAWN)
    file = tables.path.with_suffix(".rrd") if path is None else Path(path)
    _check(file, tables.path)
    scale = _Scale(tables.bodies, color_by)
    # A name of its own for every file: Rerun shows two of the same name as one.
    stream = rerun.RecordingStream("pelletflow", recording_id=uuid.uuid4())
    try:
        stream.save(file, default_blueprint=_blueprint(tables, scale))
        stream.log("/", rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
        _pellets(stream, tables, scale)
        _equipment(stream, tables)
        _hits(stream, tables)
        _curves(stream, tables)
        _events(stream, tables)
    finally:
        stream.flush()
        stream.disconnect()
    return file


def _imported() -> Any:
    try:
        import rerun
    except ImportError as error:
        raise InputError(
            "Rerun is not there; pip install 'rerun-sdk>=0.41', for Python 3.11 or newer", "rerun"
        ) from error
    found = tuple(int(part) for part in rerun.__version__.split(".")[:2])
    if found < NEEDED:
        raise InputError(
            f"Rerun is {rerun.__version__}; expected 0.41 or newer: pip install 'rerun-sdk>=0.41'",
            "rerun",
            rerun.__version__,
        )
    return rerun


class _Scale:
    """Colors of the pellets."""

    def __init__(self, bodies: Table, color_by: str) -> None:
        self.column, unit = COLORED_BY[color_by]
        values = bodies[self.column]
        # Most pellets of a thin flow feel no force.
        values = values[values > 0.0]
        self.full = float(np.quantile(values, BELOW_FULL)) if values.size else 0.0
        self.words = f"pellets by {color_by}, yellow from {self.full:.3g} {unit}"

    def __call__(self, values: npt.NDArray[Any]) -> npt.NDArray[np.uint8]:
        shares = values.astype(np.float64) / self.full if self.full > 0.0 else np.zeros(len(values))
        return _pelletflow.colors(shares)


def _check(file: Path, recording: Path) -> None:
    """Refuse a file that cannot be written: Rerun says neither where nor why."""
    if file.exists() and recording.exists() and file.samefile(recording):
        raise InputError(
            f"{file} is the recording itself; choose another file, such as {file.stem}.rrd",
            "path",
            str(file),
        )
    try:
        file.open("ab").close()
    except OSError as error:
        raise OutputError(
            f"cannot write {file}: {error.strerror}; make its folder or choose another file", file
        ) from error


def _blueprint(tables: Recording, scale: _Scale) -> Any:
    import rerun
    from rerun import blueprint

    space = blueprint.Spatial3DView(origin="/", name=scale.words, eye_controls=_eye(tables.bodies))
    curves = [
        blueprint.TimeSeriesView(origin=rerun.new_entity_path(["meters", name]), name=name)
        for name in list(tables.meters)[:CURVES]
    ]
    words = blueprint.TextLogView(origin="/log", name="what happened")
    return blueprint.Blueprint(
        blueprint.Horizontal(space, blueprint.Vertical(*curves, words), column_shares=[2, 1]),
        blueprint.TimePanel(timeline="time", state="collapsed"),
        collapse_panels=True,
    )


def _eye(bodies: Table) -> Any:
    """Look at the room that pellets pass, from in front, the right and above."""
    from rerun import blueprint

    if not bodies.rows:
        return None
    spans = np.array([[bodies[axis].min(), bodies[axis].max()] for axis in ("x_m", "y_m", "z_m")])
    middle = spans.mean(axis=1)
    away = AWAY * np.linalg.norm(spans[:, 1] - spans[:, 0]) * np.array(FROM)
    return blueprint.EyeControls3D(position=middle + away, look_target=middle, eye_up=[0, 0, 1])


def _pellets(stream: rerun.RecordingStream, tables: Recording, scale: _Scale) -> None:
    import rerun

    bodies = tables.bodies
    times = bodies["time_s"]
    places = np.column_stack([bodies[name] for name in ("x_m", "y_m", "z_m")])
    radii, colors = bodies["radius_m"], scale(bodies[scale.column])
    # Of an empty hopper there is no row of a pellet; of a frame that was not kept neither.
    ledger = tables.mass_ledger
    for time, inside in zip(ledger["time_s"], ledger["inside"], strict=True):
        rows = slice(*np.searchsorted(times, [time, np.nextafter(time, np.inf)]))
        if rows.start == rows.stop and inside > 0:
            continue
        stream.set_time("time", duration=time)
        stream.log("pellets", rerun.Points3D(places[rows], radii=radii[rows], colors=colors[rows]))


def _equipment(stream: rerun.RecordingStream, tables: Recording) -> None:
    import rerun

    walls = tables.walls
    poses = np.column_stack([walls[name] for name in ("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")])
    shown: set[str] = set()
    rows = zip(
        walls["time_s"], walls["wall"], walls["is_present"], walls["is_active"], poses, strict=True
    )
    for time, wall, is_present, is_active, pose in rows:
        stream.set_time("time", duration=time)
        entity = rerun.new_entity_path(["equipment", wall])
        if not is_present:
            stream.log(entity, rerun.Clear(recursive=True))
            shown.discard(wall)
            continue
        turn = rerun.Quaternion(xyzw=pose[3:])
        stream.log(entity, rerun.Transform3D(translation=pose[:3], quaternion=turn))
        if wall not in shown:
            shown.add(wall)
            color = ACTIVE_WALL if is_active else FIXED_WALL
            corners = _corners(tables.wall_triangles, wall, 3).reshape(-1, 3)
            mesh = rerun.Mesh3D(vertex_positions=corners, albedo_factor=color)
            stream.log(f"{entity}/surface", mesh)
            edges = _corners(tables.wall_edges, wall, 2)
            stream.log(f"{entity}/edges", rerun.LineStrips3D(edges, colors=OUTLINE))


def _corners(pieces: Table, wall: str, count: int) -> npt.NDArray[np.float32]:
    """Corners of the triangles or edges of a wall, shape (pieces, count, 3) [m]."""
    names = [f"{axis}{corner + 1}_m" for corner in range(count) for axis in "xyz"]
    rows = pieces["wall"] == wall
    return np.column_stack([pieces[name][rows] for name in names]).reshape(-1, count, 3)


def _hits(stream: rerun.RecordingStream, tables: Recording) -> None:
    """Mark the hardest hits, each from its moment on."""
    import rerun

    hits = tables.tables.get("hits")
    if hits is None:
        return
    forces = hits["peak_force_n"]
    for rank, row in enumerate(np.argsort(-forces, kind="stable")[:WORST], 1):
        place = [hits[name][row] for name in ("x_m", "y_m", "z_m")]
        met = f"wall {hits['wall'][row]}" if hits["wall"][row] else "a pellet"
        speed = hits["approach_speed_m_per_s"][row]
        words = f"{rank}: {forces[row]:.4g} N, {speed:.3g} m/s onto {met}"
        stream.set_time("time", duration=hits["peak_time_s"][row])
        mark = rerun.Points3D(
            [place],
            radii=MARK * hits["diameter_m"][row],
            colors=HIT,
            labels=words,
            show_labels=False,
        )
        stream.log(f"hits/worst/{rank:02}", mark)
        stream.log("log/hits", rerun.TextLog(f"hardest hit {words}", level="INFO"))


def _curves(stream: rerun.RecordingStream, tables: Recording) -> None:
    import rerun

    curves = [(["meters", name], table) for name, table in tables.meters.items()]
    for name in ("mass_ledger", "energy_ledger"):
        if name in tables.tables:
            curves.append((["ledger", name.removesuffix("_ledger")], tables.tables[name]))
    for parts, table in curves:
        time = rerun.TimeColumn("time", duration=table["time_s"])
        for column in table:
            values = table[column]
            if column != "time_s" and values.dtype.kind in "fiu":
                scalars = rerun.Scalars.columns(scalars=values.astype(np.float64))
                entity = rerun.new_entity_path([*parts, column])
                stream.send_columns(entity, indexes=[time], columns=scalars)


def _events(stream: rerun.RecordingStream, tables: Recording) -> None:
    import rerun

    events = tables.tables.get("events")
    if events is None:
        return
    for time, level, text in zip(events["time_s"], events["level"], events["text"], strict=True):
        stream.set_time("time", duration=time)
        stream.log("log/events", rerun.TextLog(text, level=LEVELS.get(level, "INFO")))
