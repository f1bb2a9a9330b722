"""The value of a setting of a scene at which a share of the pellets breaks."""

import _thread
import math

import pelletflow as pf
import pytest

LONE = {"strength": 500.0, "scatter": 0.3, "seeds": 1}


@pytest.fixture
def shot(drop):
    """A lone pellet without weight above a steel floor, elastic: the case of the closed form."""
    drop["scene"]["gravity"] = [0, 0, 0]
    drop["pairs"]["pellet-steel"]["restitution"] = 1.0
    drop["fill"]["one"]["at"] = [[0, 0, 8e-3]]
    drop["fill"]["one"]["velocity"] = [0, 0, -1]
    drop["time"]["end"] = 2e-3
    return drop


def test_a_lone_pellet_breaks_at_the_speed_of_the_closed_form(shot):
    found = pf.safe_setting(shot, (2, 20), risk=0.05, **LONE)
    closed = pf.safe_speed(
        0.05,
        strength=500.0,
        scatter=0.3,
        diameter=15e-3,
        density=3700,
        shear_modulus=60e6,
        poisson_ratio=0.22,
    )
    # The step is chosen for a force within 0.1 %; the share is crossed within 1 % of the range.
    assert found.value == pytest.approx(float(closed.speed), rel=5e-3)
    assert (found.key, found.unit) == ("fill.one.velocity", "m/s")
    assert found.low == found.value == found.high
    assert math.isnan(found.seed_half_width)
    assert found.is_monotone
    assert found.runs["value"].tolist() == sorted(found.runs["value"])
    assert found.runs.units["value"] == "m/s"
    assert found.details["pellets"] == 1
    assert found.seed_shares == pytest.approx([0.05], rel=0.05)
    assert "fill.one.velocity" in found._repr_html_()


def test_the_interval_is_that_of_the_sample_and_has_a_width_over_seeds(shot):
    found = pf.safe_setting(
        shot, (2, 20), risk=0.05, strength=500.0, scatter=0.3, tests=60, seeds=2, tolerance=0.05
    )
    assert found.low < found.value < found.high
    # Nothing of this scene is drawn by lot.
    assert found.seed_half_width == 0.0
    around = (0.99 * found.value, 1.01 * found.value)
    narrow = pf.safe_setting(
        shot, around, risk=0.05, strength=500.0, scatter=0.3, tests=60, seeds=1, tolerance=0.5
    )
    assert math.isnan(narrow.low)
    assert math.isnan(narrow.high)


def test_another_key_is_varied_in_its_unit_with_what_is_set(shot):
    found = pf.safe_setting(
        shot,
        (5, 25),
        vary="pellets.ore.diameter",
        unit="mm",
        risk=0.5,
        tolerance=0.1,
        set={"fill.one.velocity": [0, 0, -8], "fill.one.at": [[0, 0, 0.013]]},
        **LONE,
    )
    # F ∝ R²: the larger the pellet, the more of them break.
    assert 5 < found.value < 25
    assert (found.key, found.unit) == ("pellets.ore.diameter", "mm")


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({"range": (2, 1)}, "range"),
        ({"range": 3}, "range"),
        ({"range": (0, math.inf)}, "range"),
        ({"range": (15, 20)}, "range"),
        ({"risk": 0.0}, "risk"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"seeds": 0}, "seeds"),
        ({"strength": [1.0, 2.0]}, "strength"),
        ({"strength": None, "scatter": None}, "strength"),
    ],
)
def test_bad_arguments_are_named(shot, arguments, key):
    given = {"range": (2, 20), "risk": 0.05} | LONE | arguments
    with pytest.raises(pf.InputError) as caught:
        pf.safe_setting(shot, **given)
    assert caught.value.key == key


def test_a_scene_with_several_ways_in_asks_which_is_varied(shot):
    shot["fill"]["two"] = shot["fill"]["one"] | {"at": [[0.1, 0, 8e-3]]}
    with pytest.raises(pf.InputError, match=r"fill\.one\.velocity.*fill\.two\.velocity") as caught:
        pf.safe_setting(shot, (2, 20), **LONE)
    assert caught.value.key == "vary"


def test_what_is_wrong_with_a_scene_is_told_as_such(shot):
    with pytest.raises(pf.SceneError, match="density"):
        pf.safe_setting(shot, (-2, 1), vary="materials.pellet.density", **LONE)
    with pytest.raises(pf.SceneError, match="finish"):
        pf.safe_setting(shot, (2, 20), set={"time.finish": 1}, **LONE)


def test_a_run_that_goes_wrong_is_told_as_such(leak):
    with pytest.raises(pf.PhysicsError, match="left the domain"):
        pf.safe_setting(leak, (1, 2), **LONE)


def test_progress_and_an_interrupt_stop_the_search(shot):
    seen = []

    def stop(runs: int, part: float) -> None:
        seen.append((runs, part))
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        pf.safe_setting(shot, (2, 20), progress=stop, **LONE)
    assert len(seen) == 1
    assert seen[0][0] == 0
    with pytest.raises(KeyboardInterrupt):
        pf.safe_setting(shot, (2, 20), progress=lambda *_: _thread.interrupt_main(), **LONE)
