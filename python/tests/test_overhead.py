"""A run by Python against the same run by the command line."""

import json
import time
from pathlib import Path

import pelletflow as pf
from pelletflow import _pelletflow

CHUTE = Path(__file__).parents[2] / "examples/scenes/chute.toml"
VALUES = {"time.end": "0.8 s", "expect": {}}


def by_command(output: Path) -> float:
    """Processor time of the command [s], without that of starting an interpreter around it."""
    command = ["pelletflow", "run", str(CHUTE), "--output", str(output), "--threads", "1"]
    command += ["--set", 'time.end="0.8 s"', "--set", "expect={}"]
    began = time.process_time()
    assert _pelletflow.command(command) == 0
    return time.process_time() - began


def by_python(output: Path) -> float:
    """Processor time of `run` with an observer [s]."""
    began = time.process_time()
    pf.run(CHUTE, output=output, threads=1, set=VALUES, progress=lambda look: None)
    return time.process_time() - began


def summary(output: Path) -> dict:
    return json.loads((output / "summary.json").read_text(encoding="utf-8"))


def test_python_adds_under_2_percent_to_a_run_of_the_same_bits(tmp_path):
    ratios = []
    # Other programs empty the caches of either; one attempt in quiet shows what Python adds.
    for _ in range(8):
        command, python = by_command(tmp_path / "command"), by_python(tmp_path / "python")
        ratios.append(python / command)
        if ratios[-1] < 1.02:
            break
    for key in ("state_hash", "scene_hash"):
        assert summary(tmp_path / "python")[key] == summary(tmp_path / "command")[key]
    assert min(ratios) < 1.02, ratios
