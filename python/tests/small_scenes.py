"""The example scenes in small, under their names: what examples of the documentation run."""

from pathlib import Path

import pelletflow as pf

EXAMPLES = Path(__file__).parents[2] / "examples/scenes"
#: Fewer pellets and less time, or softer pellets: examples show what to write, not the physics.
SMALLER = {
    "chute.toml": {"inlets.feed.rate": "10 t/h", "time.end": "20 ms", "expect": {}},
    "hopper.toml": {"fill.bed.count": 20, "expect": {}},
    "heap.toml": {
        "fill.bed.count": 30,
        "pellets.ore.diameter": "20 mm",
        "materials.pellet.shear_modulus": "0.5 MPa",
        "materials.rubber.youngs_modulus": "1 MPa",
        "materials.steel.shear_modulus": "1 MPa",
        "time.end": "1 s",
        "time.peak_force_error": "5 %",
        "limits.overlap_ratio": 0.5,
        "expect": {},
    },
}


def write(folder: Path) -> None:
    """Write them into a folder."""
    for name, values in SMALLER.items():
        scene = pf.Scene.read(EXAMPLES / name)
        for key, value in values.items():
            scene[key] = value
        (folder / name).write_text(scene.to_toml(), encoding="utf-8")
