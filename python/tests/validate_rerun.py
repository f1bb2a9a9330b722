"""Open a recording in Rerun, without a screen, and look at what is drawn of it.

    python validate_rerun.py RECORDING PICTURE.png

First as Rerun's own importer reads it, then as `pelletflow.to_rerun` writes it.
Needs `pelletflow`, `rerun-sdk` and `pillow`, and a Vulkan driver that draws into memory, as Mesa's
lavapipe.
Exits with 1 when the recording is not shown, and with 3 when the viewer does not start here.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pelletflow as pf
from PIL import Image

try:
    import rerun_cli
    from rerun.experimental import ViewerClient
except ImportError as error:
    # Python 3.10 has no Rerun that is new enough.
    print(f"NO VIEWER: {error}")
    sys.exit(3)

# The viewer itself: what lies on the path only starts it, and leaves it behind when it is stopped.
PROGRAM = Path(rerun_cli.__file__).with_name("rerun")
# Time until the viewer has read the recording [s]; the machine may be busy with other work.
READY_WITHIN = 120.0
# What the importer makes of the topics that a viewer of points and curves can show.
ENTITIES = ["/pellets", "/ledger/mass", "/ledger/energy"]
# Moments at which a hopper is full and runs out [s].
EARLY, LATE = 0.1, 1.0
# Share of the view with a color at least [-]: pellets, and neither the ground nor axes.
COLORED = 0.001
# Share of the view that the flow changes at least [-].
MOVED = 0.001
# Share of the view that the walls of the hopper cover at least, gray and seen through [-].
GRAY = 0.03
# Share of the view that its gate covers, orange: at least while shut, at most once it is open [-].
SHUT, OPEN = 0.003, 0.0001


class Broken(Exception):
    """A promise that a recording breaks."""


class NoViewer(Exception):
    """A viewer that this machine cannot start."""


def expect(condition: bool, message: str) -> None:
    if not condition:
        raise Broken(message)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def connected(port: int) -> ViewerClient:
    """The viewer, once it answers."""
    give_up = time.monotonic() + READY_WITHIN
    while True:
        try:
            viewer = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
            viewer.get_state()
        except Exception as error:
            if time.monotonic() > give_up:
                raise NoViewer(f"it did not answer within {READY_WITHIN} s") from error
            time.sleep(0.2)
        else:
            return viewer


def view_in_space(viewer: ViewerClient) -> str:
    """Its number, once the recording has been read."""
    give_up = time.monotonic() + READY_WITHIN
    while time.monotonic() < give_up:
        state = viewer.get_state()
        views = [view.view_id for view in state.views if view.view_class == "3D"]
        if views and not state.loading:
            return str(views[0])
        time.sleep(0.2)
    raise Broken("Rerun shows no view in space")


def check_entities(viewer: ViewerClient) -> None:
    found = str(viewer.get_recording_schema(paths_only=True))
    missing = [entity for entity in ENTITIES if entity not in found]
    expect(not missing, f"Rerun finds nothing of {missing}")


def picture(
    viewer: ViewerClient, view: str, time_shown: dict[str, float], path: Path
) -> Image.Image:
    viewer.set_time(play_state="paused", **time_shown)
    # The view is drawn again before it is saved, but its camera takes a moment to arrive.
    time.sleep(1.0)
    viewer.save_screenshot(str(path), view)
    return Image.open(path).convert("RGB")


def share(image: Image.Image, hues: range, saturations: range, least_value: int) -> float:
    """Share of an image with hue and saturation in ranges, and not too dark [-]."""
    pixels = image.convert("HSV").tobytes()
    triples = zip(pixels[::3], pixels[1::3], pixels[2::3], strict=True)
    found = sum(h in hues and s in saturations and v >= least_value for h, s, v in triples)
    return found / (image.width * image.height)


def colored(image: Image.Image) -> float:
    return share(image, range(256), range(90, 256), 0)


def gray(image: Image.Image) -> float:
    return share(image, range(256), range(90), 50)


def orange(image: Image.Image) -> float:
    return share(image, range(10, 36), range(120, 256), 60)


def changed(one: Image.Image, other: Image.Image) -> float:
    pairs = zip(one.convert("L").tobytes(), other.convert("L").tobytes(), strict=True)
    different = sum(abs(left - right) > 32 for left, right in pairs)
    return different / (one.width * one.height)


@contextmanager
def opened(file: Path) -> Iterator[ViewerClient]:
    """A viewer with a file."""
    port = free_port()
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(
            # Else it would listen on all interfaces.
            [PROGRAM, "--headless", "--bind", "127.0.0.1", "--port", str(port), file],
            env={"XDG_RUNTIME_DIR": folder, "RERUN_ANALYTICS": "off", **os.environ},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            yield connected(port)
        finally:
            process.kill()
            process.wait()


def imported(recording: Path, path: Path) -> str:
    """What Rerun makes of a recording by itself: points and curves."""

    def at(seconds: float) -> dict[str, float]:
        return {"timeline": "message_log_time", "timestamp": seconds}

    with opened(recording) as viewer:
        view = view_in_space(viewer)
        check_entities(viewer)
        early = picture(viewer, view, at(EARLY), path.with_suffix(".early.png"))
        late = picture(viewer, view, at(LATE), path)
    covered = colored(late)
    expect(covered > COLORED, f"pellets cover {covered:.2%} of the view")
    moved = changed(early, late)
    expect(moved > MOVED, f"{moved:.2%} of the view changes between two times")
    return f"{recording}: pellets cover {covered:.1%} of the view, {moved:.1%} changes"


def converted(recording: Path, path: Path) -> str:
    """What `to_rerun` writes: spheres, and equipment that comes and goes."""

    def at(seconds: float) -> dict[str, float]:
        return {"timeline": "time", "duration": seconds}

    file = pf.to_rerun(recording, path.with_suffix(".rrd"))
    with opened(file) as viewer:
        view = view_in_space(viewer)
        early = picture(viewer, view, at(EARLY), path.with_suffix(".shut.png"))
        late = picture(viewer, view, at(LATE), path.with_suffix(".open.png"))
    covered = colored(late)
    expect(covered > COLORED, f"pellets cover {covered:.2%} of the view")
    walls = gray(late)
    expect(walls > GRAY, f"walls cover {walls:.2%} of the view")
    shut, is_open = orange(early), orange(late)
    expect(shut > SHUT, f"the gate that is shut covers {shut:.2%} of the view")
    expect(is_open < OPEN, f"the gate that is open covers {is_open:.2%} of the view")
    return f"{file}: pellets cover {covered:.1%} of the view, walls {walls:.1%}"


def validate(recording: Path, path: Path) -> str:
    return f"{imported(recording, path)}; {converted(recording, path)}"


def main(arguments: list[str]) -> int:
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        print("ok", validate(*(Path(argument).resolve() for argument in arguments)))
    except NoViewer as error:
        print(f"NO VIEWER: {error}")
        return 3
    except Exception as error:  # a viewer that does not answer is a failure as well
        print(f"BROKEN {arguments[0]}: {type(error).__name__}: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
