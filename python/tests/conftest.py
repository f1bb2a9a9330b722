"""Scenes that the tests share."""

import faulthandler
from typing import Any

import pytest

#: After so long a test that waits for something hangs, however busy the machine is [s].
HANG = 300.0

GRAVITY = 9.81


@pytest.fixture
def drop() -> dict[str, Any]:
    """One pellet whose lowest point is 0.1 m above a steel floor; restitution 0.8, no friction."""
    return {
        "schema_version": 1,
        "scene": {"title": "Drop", "gravity": [0, 0, -GRAVITY]},
        "materials": {
            "pellet": {"density": 3700, "shear_modulus": 60e6, "poisson_ratio": 0.22},
            "steel": {"density": 7850, "shear_modulus": 81e9, "poisson_ratio": 0.28},
        },
        "pairs": {
            "pellet-steel": {"restitution": 0.8, "friction": 0.0},
            "pellet-pellet": {"restitution": 0.8, "friction": 0.0},
        },
        "pellets": {"ore": {"material": "pellet", "diameter": 15e-3}},
        "walls": {
            "floor": {
                "material": "steel",
                "shape": {"kind": "half-space", "point": [0, 0, 0], "normal": [0, 0, 1]},
            }
        },
        "fill": {"one": {"pellets": "ore", "at": [[0, 0, 0.1075]]}},
        "domain": {"min": [-1, -1, -1], "max": [1, 1, 1]},
        "time": {"end": 0.2, "peak_force_error": 1e-3},
    }


@pytest.fixture
def hang_guard():
    """End the tests with a trace where one waits for what never comes; no claim on speed."""
    faulthandler.dump_traceback_later(HANG, exit=True)
    yield HANG
    faulthandler.cancel_dump_traceback_later()


@pytest.fixture
def drop_file(tmp_path, drop):
    """Write the same scene as a file."""
    text = """
schema_version = 1
[scene]
title = "Drop"
gravity = [0, 0, -9.81]
[materials.pellet]
density = "3700 kg/m3"
shear_modulus = "60 MPa"
poisson_ratio = 0.22
[materials.steel]
density = "7850 kg/m3"
shear_modulus = "81 GPa"
poisson_ratio = 0.28
[pairs."pellet-steel"]
restitution = 0.8
friction = 0.0
[pairs."pellet-pellet"]
restitution = 0.8
friction = 0.0
[pellets.ore]
material = "pellet"
diameter = "15 mm"
[walls.floor]
material = "steel"
shape = { kind = "half-space", point = [0, 0, 0], normal = [0, 0, 1] }
[fill.one]
pellets = "ore"
at = [[0, 0, 0.1075]]
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[time]
end = "0.2 s"
peak_force_error = "0.1 %"
"""
    path = tmp_path / "drop.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture
def box(drop) -> dict[str, Any]:
    """Sixty pellets that fall into a heap on the floor, with friction and spin."""
    return drop | {
        "pairs": {
            "pellet-steel": {"restitution": 0.4, "friction": 0.4, "rolling_friction": 0.05},
            "pellet-pellet": {"restitution": 0.4, "friction": 0.5, "rolling_friction": 0.05},
        },
        "fill": {
            "heap": {
                "pellets": "ore",
                "count": 60,
                "region": {"kind": "box", "min": [-0.05, -0.05, 0.01], "max": [0.05, 0.05, 0.2]},
            }
        },
    }


@pytest.fixture
def leak(drop) -> dict[str, Any]:
    """One pellet that falls out of the domain: there is no floor in its way."""
    return drop | {"domain": {"min": [-1, -1, 0.05], "max": [1, 1, 1]}}
