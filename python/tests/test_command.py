"""The command that the wheel installs."""

import json
import subprocess
import sys
from pathlib import Path

import pelletflow as pf


def pelletflow(*arguments: object) -> subprocess.CompletedProcess[str]:
    name = "pelletflow.exe" if sys.platform == "win32" else "pelletflow"
    command = Path(sys.executable).parent / name
    return subprocess.run(
        [command, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False
    )


def test_it_tells_the_version_of_the_package():
    done = pelletflow("--version")
    assert done.returncode == 0
    assert done.stdout.strip() == f"pelletflow {pf.__version__}"


def test_it_runs_a_scene_to_the_same_bits_as_the_package(drop_file, tmp_path):
    done = pelletflow("run", drop_file, "--output", tmp_path / "out", "--quiet")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out/summary.json").read_text(encoding="utf-8"))
    result = pf.run(drop_file, output=tmp_path / "python")
    assert summary["state_hash"] == result.summary["state_hash"]


def test_a_bad_scene_ends_with_code_2_and_names_the_mistake(drop_file):
    text = drop_file.read_text(encoding="utf-8").replace("poisson_ratio", "poisson", 1)
    drop_file.write_text(text, encoding="utf-8")
    done = pelletflow("check", drop_file)
    assert done.returncode == 2
    assert "materials.pellet.poisson" in done.stderr
