"""Open a recording in Rerun, without a screen, and look at what its importer draws.

    python validate_rerun.py RECORDING PICTURE.png

Needs `rerun-sdk` and `pillow`, and a Vulkan driver that draws into memory, as Mesa's lavapipe.
Exits with 1 when the recording is not shown, and with 3 when the viewer does not start here.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import rerun_cli
from PIL import Image
from rerun.experimental import ViewerClient

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


def picture(viewer: ViewerClient, view: str, seconds: float, path: Path) -> Image.Image:
    viewer.set_time("message_log_time", timestamp=seconds, play_state="paused")
    # The view is drawn again before it is saved, but its camera takes a moment to arrive.
    time.sleep(1.0)
    viewer.save_screenshot(str(path), view)
    return Image.open(path).convert("RGB")


def colored(image: Image.Image) -> float:
    saturations = image.convert("HSV").getchannel("S").histogram()
    return sum(saturations[90:]) / sum(saturations)


def changed(one: Image.Image, other: Image.Image) -> float:
    pairs = zip(one.convert("L").tobytes(), other.convert("L").tobytes(), strict=True)
    different = sum(abs(left - right) > 32 for left, right in pairs)
    return different / (one.width * one.height)


def validate(recording: Path, path: Path) -> str:
    port = free_port()
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(
            # Else it would listen on all interfaces.
            [PROGRAM, "--headless", "--bind", "127.0.0.1", "--port", str(port), recording],
            env={"XDG_RUNTIME_DIR": folder, "RERUN_ANALYTICS": "off", **os.environ},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            viewer = connected(port)
            view = view_in_space(viewer)
            check_entities(viewer)
            early = picture(viewer, view, EARLY, path.with_suffix(".early.png"))
            late = picture(viewer, view, LATE, path)
        finally:
            process.kill()
            process.wait()
    share = colored(late)
    expect(share > COLORED, f"pellets cover {share:.2%} of the view")
    moved = changed(early, late)
    expect(moved > MOVED, f"{moved:.2%} of the view changes between two times")
    return f"{recording}: pellets cover {share:.1%} of the view, {moved:.1%} changes"


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
