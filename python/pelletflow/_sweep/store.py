"""The folder of a sweep: what is done, by the hash of its scene."""

from __future__ import annotations

import json
import shutil
import sys
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from pelletflow import _pelletflow
from pelletflow._run import RunResult, run
from pelletflow._scene import Base
from pelletflow.errors import OutputError, SweepError

#: What a run that is not yet done is called, before the hash of its scene.
UNFINISHED = "unfinished-"
SUMMARY = "summary.json"
RECORDING = "run.mcap"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold a folder for one sweep; the system lets go of it when the process ends."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = (folder / "sweep.lock").open("a+", encoding="utf-8")
    except OSError as error:
        raise OutputError(
            f"cannot write {folder}: {error}; choose another folder", folder
        ) from error
    with lock:
        try:
            _take(lock)
        except OSError as error:
            raise SweepError(
                f"another sweep is at work in {folder}; wait for it, or choose another folder"
            ) from error
        yield


def remove_unfinished(folder: Path) -> None:
    """Remove what runs that were killed have left."""
    for leftover in folder.glob(f"{UNFINISHED}*"):
        shutil.rmtree(leftover, ignore_errors=True)


def done(folder: Path, scene_hash: str, *, recorded: bool = False) -> RunResult | None:
    """Return the result of a scene if this version has run it here.

    Where the recording is asked for, one whose recording was not kept counts as not done.
    """
    output = folder / scene_hash
    try:
        summary = json.loads((output / SUMMARY).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    if summary["version"] != _pelletflow.__version__:
        return None
    if recorded and not (output / RECORDING).exists():
        return None
    return RunResult(summary, output)


def run_once(
    base: Base, values: dict[str, Any], scene_hash: str, folder: str, threads: int, keep: bool
) -> bool:
    """Run a scene unless it is done, and put its folder in place at once; tell whether it ran.

    Whoever is killed on the way leaves nothing that counts as done.
    """
    place = Path(folder)
    final = place / scene_hash
    if done(place, scene_hash, recorded=keep):
        return False
    unfinished = place / f"{UNFINISHED}{scene_hash}-{uuid.uuid4().hex}"
    try:
        result = run(base, output=unfinished, threads=threads, set=values)
        if result.summary["scene_hash"] != scene_hash:
            raise SweepError(
                f"the scene of {final} has changed since the sweep began; call the sweep again"
            )
        if not keep:
            (unfinished / RECORDING).unlink()
        if final.exists() and not done(place, scene_hash, recorded=keep):
            # An earlier version ran it, or its recording was not kept.
            shutil.rmtree(final)
        try:
            unfinished.rename(final)
        except OSError:
            # Another worker was as fast; both have the same bits.
            if not done(place, scene_hash, recorded=keep):
                raise
        return True
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


if sys.platform == "win32":
    import msvcrt

    def _take(lock: IO[str]) -> None:
        msvcrt.locking(lock.fileno(), msvcrt.LK_NBLCK, 1)

else:
    import fcntl

    def _take(lock: IO[str]) -> None:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
