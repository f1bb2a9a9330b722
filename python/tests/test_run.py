"""Whole runs."""

import json
import math
import signal
import subprocess
import sys
from pathlib import Path

import pelletflow as pf
import pytest
from mcap.reader import make_reader

ENDLESS = """
import os
import signal
import sys
import threading
import time
from pathlib import Path
import pelletflow as pf

scene, output, kind = sys.argv[1:]
simulation = pf.Simulation(scene)

def is_at_work():
    if kind == "run":
        return Path(output, "run.mcap").exists()
    try:
        simulation.step_count
    except RuntimeError:
        return True
    return False

def interrupt():
    while not is_at_work():
        time.sleep(0.01)
    os.kill(os.getpid(), signal.SIGINT)

threading.Thread(target=interrupt).start()
try:
    if kind == "run":
        pf.run(scene, output=output, set={"time.end": 1000})
    else:
        simulation.step(10**15)
except KeyboardInterrupt:
    print("interrupted", simulation.step_count > 0)
"""


def channels(recording: Path) -> dict[str, int]:
    with recording.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    counts = summary.statistics.channel_message_counts
    return {channel.topic: counts.get(id, 0) for id, channel in summary.channels.items()}


def test_the_result_is_what_the_folder_holds(drop, tmp_path):
    result = pf.run(drop, output=tmp_path / "out")
    assert result.output == tmp_path / "out"
    written = json.loads((result.output / "summary.json").read_text(encoding="utf-8"))
    assert result.summary == written
    assert (result.output / "scene.toml").exists()
    assert channels(result.output / "run.mcap")["/pellets"] > 5


def test_a_drop_has_the_peak_force_of_hertz(drop, tmp_path):
    drop["pairs"]["pellet-steel"]["restitution"] = 1.0
    result = pf.run(drop, output=tmp_path)
    # F = k (5 m v² / (4 k))^(3/5) with k = 4/3 E* √R, E* = 153.74 MPa (pellet on steel).
    radius, mass = 7.5e-3, 3700 * 4 / 3 * math.pi * 7.5e-3**3
    stiffness = 4 / 3 * 153.74e6 * math.sqrt(radius)
    speed_squared = 2 * 9.81 * 0.1
    expected = stiffness * (5 * mass * speed_squared / (4 * stiffness)) ** 0.6
    # The step is chosen for 0.1 %; the weight of the pellet adds as much again.
    assert result.summary["contacts"]["max_force_n"] == pytest.approx(expected, rel=3e-3)


def test_a_run_and_the_same_steps_by_hand_give_the_same_bits(drop, tmp_path):
    summary = pf.run(drop, output=tmp_path, threads=1).summary
    simulation = pf.Simulation(drop)
    simulation.step(summary["time"]["steps"])
    assert simulation.state_hash == summary["state_hash"]
    assert simulation.time == summary["time"]["simulated_s"]


def test_a_foreign_reader_finds_every_promise_of_a_recording_kept(tmp_path):
    tests = Path(__file__).parent
    chute = tests.parents[1] / "examples/scenes/chute.toml"
    result = pf.run(chute, output=tmp_path, set={"time.end": "0.2 s"})
    validator = [sys.executable, tests / "validate_recording.py", result.output / "run.mcap"]
    done = subprocess.run(validator, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_set_reaches_the_run(drop_file, tmp_path):
    summary = pf.run(drop_file, output=tmp_path, set={"time.end": "50 ms"}).summary
    assert summary["time"]["simulated_s"] == pytest.approx(0.05, rel=1e-3)
    assert summary["scene"] == "drop"


def test_the_output_goes_to_out_and_the_name_where_none_is_given(drop_file, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = pf.run(drop_file, set={"time.end": 0.01})
    assert result.output == Path("out/drop")
    assert (tmp_path / "out/drop/summary.json").exists()


def test_progress_is_shown_in_order_of_time(box, tmp_path):
    seen: list[pf.Progress] = []
    summary = pf.run(box, output=tmp_path, progress=seen.append).summary
    assert seen
    assert [look.time for look in seen] == sorted(look.time for look in seen)
    assert all(look.pellets == 60 and look.end_time == 0.2 for look in seen)
    assert seen[-1].step <= summary["time"]["steps"]
    assert 0.0 <= seen[-1].max_force <= summary["contacts"]["max_force_n"]
    assert (seen[-1].discharged, seen[-1].lost) == (0, 0)


def test_an_exception_in_progress_stops_the_run_and_comes_through(box, tmp_path):
    def refuse(progress: pf.Progress) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        pf.run(box, output=tmp_path, progress=refuse, set={"time.end": 100})
    # The recording is finished all the same.
    assert "/pellets" in channels(tmp_path / "run.mcap")


def interrupted(kind: str, scene: Path, output: Path, hang_guard: float) -> str:
    """What a process says that begins something without an end and gets Ctrl-C amid it."""
    process = subprocess.run(
        [sys.executable, "-c", ENDLESS, str(scene), str(output), kind],
        capture_output=True,
        text=True,
        timeout=hang_guard,
        check=False,
        # What runs in the background of a script is deaf to Ctrl-C, and so are its children.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert process.returncode == 0, process.stderr
    return process.stdout.strip()


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")
def test_ctrl_c_stops_the_steps_of_a_simulation_amid_them(drop_file, tmp_path, hang_guard):
    assert interrupted("step", drop_file, tmp_path / "out", hang_guard) == "interrupted True"


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")
def test_ctrl_c_stops_a_run_which_leaves_a_recording_and_a_checkpoint(
    drop_file, tmp_path, hang_guard
):
    output = tmp_path / "out"
    assert interrupted("run", drop_file, output, hang_guard) == "interrupted False"
    assert channels(output / "run.mcap")["/pellets"] > 0
    with pytest.raises(pf.OutputError, match="unfinished"):
        pf.run(drop_file, output=output)
    # The checkpoint is there and is taken: one of another scene would be refused.
    with pytest.raises(pf.OutputError, match="another scene"):
        pf.run(drop_file, output=output, unfinished="resume")


def test_a_run_that_was_stopped_goes_on_to_the_bits_of_an_unbroken_one(box, tmp_path):
    unbroken = pf.run(box, output=tmp_path / "unbroken").summary

    def stop(progress):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pf.run(box, output=tmp_path / "out", progress=stop)
    with pytest.raises(pf.OutputError, match="unfinished"):
        pf.run(box, output=tmp_path / "out")
    with pytest.raises(pf.OutputError, match="another scene"):
        pf.run(box, output=tmp_path / "out", set={"time.end": 0.3}, unfinished="resume")
    result = pf.run(box, output=tmp_path / "out", unfinished="resume")
    assert result.summary["state_hash"] == unbroken["state_hash"]
    assert channels(result.output / "run.mcap") == channels(tmp_path / "unbroken" / "run.mcap")
    again = pf.run(box, output=tmp_path / "out", unfinished="resume")
    assert again.summary == result.summary


def test_a_run_that_was_stopped_begins_anew_where_that_is_asked_for(box, tmp_path):
    def stop(progress):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pf.run(box, output=tmp_path, progress=stop)
    with pytest.raises(pf.InputError, match="`again` is none"):
        pf.run(box, output=tmp_path, unfinished="again")
    result = pf.run(box, output=tmp_path, unfinished="restart", set={"time.end": 0.05})
    assert result.summary["time"]["simulated_s"] == pytest.approx(0.05, rel=1e-2)
