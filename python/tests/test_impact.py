"""Single hits, safe speeds and scores over arrays."""

import math

import numpy as np
import pelletflow as pf
import pytest

PELLET = {
    "diameter": 15e-3,
    "density": 3700.0,
    "shear_modulus": 60e6,
    "poisson_ratio": 0.22,
}
CARD = """
name = "works A"
source = "60 pellets"
distribution = "log-normal"
mean = "2.45 kN"
coefficient_of_variation = "30 %"
sample_size = 60
"""


def test_an_elastic_hit_has_the_force_and_the_time_of_hertz():
    speed = np.array([0.5, 2.0, 8.0])
    hits = pf.impact(speed, **PELLET)
    # F = k δ^1.5, δ = (5 m v² / (4 k))^(2/5), k = 4/3 E* √R; E* = 153.74 MPa of pellet on steel.
    mass = 3700 * math.pi / 6 * 15e-3**3
    modulus = 1 / ((1 - 0.22**2) / (2 * 60e6 * 1.22) + (1 - 0.28**2) / 207.36e9)
    stiffness = 4 / 3 * modulus * math.sqrt(7.5e-3)
    approach = (1.25 * mass * speed**2 / stiffness) ** 0.4
    # The library's steel and the value above differ in the fourth digit of a small part.
    assert hits.peak_force == pytest.approx(stiffness * approach**1.5, rel=1e-5)
    assert hits.contact_time == pytest.approx(2.943275 * approach / speed, rel=1e-5)
    assert hits.max_approach == pytest.approx(approach, rel=1e-5)
    radius = np.sqrt(7.5e-3 * approach)
    assert hits.contact_radius == pytest.approx(radius, rel=1e-5)
    assert hits.peak_pressure == pytest.approx(
        1.5 * hits.peak_force / (np.pi * radius**2), rel=1e-5
    )
    assert hits.restitution == pytest.approx(1.0, abs=1e-6)
    assert hits.impulse == pytest.approx(2 * mass * speed, rel=1e-5)
    assert hits.specific_impulse == pytest.approx(0.543612, rel=1e-5)
    assert hits.peak_parameter == pytest.approx(hits.peak_force / hits.contact_time, rel=1e-12)
    assert hits.asymmetry == pytest.approx(0.5, abs=1e-6)


def test_a_damped_hit_rebounds_as_told_whatever_its_speed():
    hits = pf.impact(np.array([1.0, 5.0]), restitution=np.array([[0.3], [0.9]]), **PELLET)
    assert hits.peak_force.shape == (2, 2)
    assert hits.restitution == pytest.approx(np.array([[0.3, 0.3], [0.9, 0.9]]), abs=1e-6)
    # Force goes with v^1.2 at any restitution.
    assert hits.peak_force[:, 1] / hits.peak_force[:, 0] == pytest.approx(5.0**1.2, rel=1e-6)
    viscoelastic = pf.impact([1.0, 5.0], relaxation_time=5e-6, **PELLET)
    assert viscoelastic.restitution[1] < viscoelastic.restitution[0] < 1.0


def test_only_the_part_of_the_speed_across_the_surface_counts():
    across = pf.impact(4.0, angle=np.pi / 3, **PELLET)
    assert across.peak_force.shape == ()
    assert across.peak_force == pytest.approx(float(pf.impact(2.0, **PELLET).peak_force))


def test_the_arrays_become_a_table_with_units():
    table = pf.impact([[1.0, 2.0], [3.0, 4.0]], **PELLET).table()
    assert table.rows == 4
    assert table.units["peak_force"] == "N"
    assert table.units["restitution"] == "-"
    assert "[N]" in pf.impact([1.0], **PELLET)._repr_html_()


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({"speed": [1.0, -2.0]}, "speed"),
        ({"speed": "fast"}, "speed"),
        ({"speed": np.array([1 + 1j])}, "speed"),
        ({"speed": [1.0, math.nan]}, "speed"),
        ({"speed": [1.0, 2.0], "angle": [0.0, 0.1, 0.2]}, "shape"),
        ({"speed": 1.0, "pellet": "fried-pellet"}, "pellet"),
        ({"speed": 1.0, "onto": ["steel"]}, "onto"),
        ({"speed": 1.0, "restitution": 1.5}, "restitution"),
        ({"speed": 1.0, "restitution": 0.5, "relaxation_time": 1e-6}, "restitution"),
        ({"speed": 1.0, "poisson_ratio": 0.5}, "Poisson's ratio"),
        ({"speed": 1.0, "angle": 2.0}, "angle"),
        ({"speed": 1.0, "youngs_modulus": 1e9}, "youngs_modulus"),
    ],
)
def test_bad_arguments_are_named(arguments, key):
    with pytest.raises(pf.InputError) as caught:
        pf.impact(**(PELLET | arguments))
    assert caught.value.key == key


def test_what_is_missing_is_asked_for_with_the_cure():
    with pytest.raises(pf.InputError, match="fired-pellet") as caught:
        pf.impact(1.0)
    assert caught.value.key == "poisson_ratio"


def test_the_place_of_a_bad_value_is_told():
    with pytest.raises(pf.InputError, match="place 1") as caught:
        pf.impact([1.0, -2.0, 3.0], **PELLET)
    assert (caught.value.value, caught.value.expected) == (-2.0, "more than 0")


def test_a_hit_at_the_safe_speed_has_the_load_that_breaks_the_share():
    safe = pf.safe_speed([0.01, 0.1], strength=2450, scatter=0.3, **PELLET)
    hits = pf.impact(safe.speed, **PELLET)
    assert hits.peak_force == pytest.approx(safe.load, rel=1e-6)
    # Log-normal: the median is below the mean, and z = -2.3263 at 1 %.
    deviation = math.sqrt(math.log(1 + 0.3**2))
    median = 2450 / math.sqrt(1 + 0.3**2)
    assert safe.load[0] == pytest.approx(median * math.exp(-2.32635 * deviation), rel=1e-5)
    assert safe.drop_height == pytest.approx(safe.speed**2 / (2 * 9.80665), rel=1e-12)


def test_the_interval_follows_from_the_sample_and_the_stiffness():
    exact = pf.safe_speed(strength=2450, scatter=0.3, **PELLET)
    assert exact.speed_low == exact.speed == exact.speed_high
    tested = pf.safe_speed(strength=2450, scatter=0.3, tests=60, **PELLET)
    assert tested.load_low < tested.load < tested.load_high
    named = pf.safe_speed(strength=2450, scatter=0.3, pellet="fired-pellet")
    assert named.load_low == named.load
    # v ∝ E^(-1/3), nearly: the steel gives way too.
    assert named.speed_high / named.speed == pytest.approx(10 ** (1 / 3), rel=0.02)
    own = pf.safe_speed(strength=2450, youngs_modulus_range=(1e8, 2e8), **PELLET)
    assert own.speed_low < own.speed < own.speed_high
    heights = [own.drop_height_low, own.drop_height, own.drop_height_high]
    speeds = np.array([own.speed_low, own.speed, own.speed_high])
    assert heights == pytest.approx(speeds**2 / (2 * 9.80665), rel=1e-12)


def test_a_shear_modulus_is_that_of_youngs_modulus():
    shear = pf.impact(4.0, **PELLET)
    own = {name: value for name, value in PELLET.items() if name != "shear_modulus"}
    youngs = pf.impact(4.0, youngs_modulus=2 * 60e6 * 1.22, **own)
    assert shear.peak_force == pytest.approx(float(youngs.peak_force), rel=1e-12)


def test_a_strength_card_tells_the_same_as_its_numbers(tmp_path):
    card = tmp_path / "card.toml"
    card.write_text(CARD, encoding="utf-8")
    by_card = pf.safe_speed(0.02, strength_card=card, **PELLET)
    by_number = pf.safe_speed(0.02, strength=2450, scatter=0.3, tests=60, **PELLET)
    assert by_card.speed_low == pytest.approx(float(by_number.speed_low), rel=1e-12)
    card.write_text(CARD.replace("2.45 kN", "2.45 kg"), encoding="utf-8")
    with pytest.raises(pf.SceneError, match="mean"):
        pf.safe_speed(strength_card=card, **PELLET)
    with pytest.raises(pf.SceneError, match=r"nowhere\.toml"):
        pf.safe_speed(strength_card=tmp_path / "nowhere.toml", **PELLET)


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({}, "strength"),
        ({"strength": 2450, "strength_card": "card.toml"}, "strength_card"),
        ({"strength": 2450, "distribution": "normal"}, "distribution"),
        ({"strength": 2450, "risk": 1.5}, "risk"),
        ({"strength": -1.0}, "strength"),
        ({"strength": 2450, "scatter": 0.3, "tests": 1}, "sample size of the test"),
    ],
)
def test_a_bad_strength_is_named(arguments, key):
    with pytest.raises(pf.InputError) as caught:
        pf.safe_speed(**(PELLET | arguments))
    assert key in caught.value.key or key in str(caught.value)


@pytest.fixture
def recorded(drop, tmp_path):
    """A drop of 0.1 m, recorded."""
    return pf.run(drop, output=tmp_path / "out").output


def test_a_recorded_drop_breaks_as_its_peak_force_tells(recorded):
    hits = pf.read(recorded).hits
    force = hits["peak_force_n"].max()
    scores = pf.score(recorded, strength=np.array([0.5, 2.0]) * force)
    assert scores.share.tolist() == [1.0, 0.0]
    median = pf.score(recorded, strength=force * math.sqrt(1 + 0.3**2), scatter=0.3, tests=20)
    # Half of the pellets are weaker than the median of a log-normal strength.
    assert median.share == pytest.approx(0.5, abs=1e-9)
    assert median.share_low < 0.5 < median.share_high
    assert scores.table().rows == 2
    assert "share" in scores._repr_html_()
    assert median.details[0]["by_wall"][0]["name"] == "wall `floor`"


def test_a_yield_pressure_is_scored_beside(recorded):
    # A force of 14 N: of a pellet that hardly bears pressure it stays below 10 N.
    answer = pf.score(recorded, strength=10.0, yield_pressure=[1e5, 1e12])
    yielding = [details["broken_yielding"]["share"] for details in answer.details]
    assert yielding == [0.0, 1.0]
    assert answer.share.tolist() == [1.0, 1.0]
    assert pf.score(recorded, strength=10.0).details[0]["broken_yielding"] is None


def test_the_yield_pressure_of_a_card_counts_unless_another_is_given(recorded, tmp_path):
    card = tmp_path / "card.toml"
    text = CARD.replace('mean = "2.45 kN"', 'mean = "10 N"') + 'yield_pressure = "0.1 MPa"\n'
    card.write_text(text, encoding="utf-8")
    (own,) = pf.score(recorded, strength_card=card).details
    (given,) = pf.score(recorded, strength_card=card, yield_pressure=1e12).details
    # Log-normal with a scatter of 30 %: 14 N breaks most pellets, the yielded force a few in 100.
    assert own["broken_yielding"]["share"] < 0.05 < 0.5 < own["broken"]["share"]
    assert given["broken_yielding"]["share"] == pytest.approx(own["broken"]["share"], rel=1e-9)


def test_a_softened_run_is_scored_at_true_stiffness(drop, tmp_path):
    drop["materials"]["pellet"] |= {"shear_modulus": 6e6, "true_youngs_modulus": 2 * 60e6 * 1.22}
    output = pf.run(drop, output=tmp_path / "soft").output
    hits = pf.read(output).hits
    score = pf.score(output, strength=1.5 * hits["peak_force_n"].max())
    (details,) = score.details
    assert details["is_softened"]
    # F ∝ E*^0.4: ten times as stiff has 2.5 times the force.
    assert (details["broken"]["share"], score.share) == (0.0, 1.0)
    assert score.share_low == details["broken_at_true_stiffness"]["interval"][0]


def test_a_bad_score_is_refused(recorded, tmp_path, drop):
    card = tmp_path / "card.toml"
    card.write_text(CARD, encoding="utf-8")
    # A force of 14 N and a strength of 2450 N.
    assert pf.score(recorded, strength_card=card).share < 1e-9
    with pytest.raises(pf.InputError, match="fracture_energy"):
        pf.score(recorded, strength_card=card, law="energy")
    with pytest.raises(pf.InputError, match="card"):
        pf.score(recorded, strength=1.0, law="energy")
    with pytest.raises(pf.InputError, match="law"):
        pf.score(recorded, strength=1.0, law="force")
    drop["output"] = {"hits": False}
    without = pf.run(drop, output=tmp_path / "without").output
    with pytest.raises(pf.RecordingError, match="no hits"):
        pf.score(without, strength=1.0)
