"""A run by Python against the same run by the command line."""

import json
from pathlib import Path

import pelletflow as pf
from pelletflow import _pelletflow

CHUTE = Path(__file__).parents[2] / "examples/scenes/chute.toml"
VALUES = {"time.end": "0.3 s", "expect": {}}


def summary(output: Path) -> dict:
    return json.loads((output / "summary.json").read_text(encoding="utf-8"))


def test_a_run_by_python_has_the_bits_of_the_command(tmp_path):
    command = ["pelletflow", "run", str(CHUTE), "--output", str(tmp_path / "command")]
    command += ["--quiet", "--threads", "1", "--set", 'time.end="0.3 s"', "--set", "expect={}"]
    assert _pelletflow.command(command) == 0
    seen: list[pf.Progress] = []
    pf.run(CHUTE, output=tmp_path / "python", threads=1, set=VALUES, progress=seen.append)
    for key in ("state_hash", "scene_hash"):
        assert summary(tmp_path / "python")[key] == summary(tmp_path / "command")[key]
