"""Watching a simulation: callbacks, hits and pictures."""

import pickle

import numpy as np
import pelletflow as pf
import pytest


def test_a_callback_sees_every_stride_and_changes_nothing(box):
    seen = []
    watched, alone = pf.Simulation(box), pf.Simulation(box)
    watched.step(1000, every=300, callback=lambda simulation: seen.append(simulation.step_count))
    alone.step(1000)
    assert seen == [300, 600, 900]
    assert watched.step_count == 1000
    assert watched.state_hash == alone.state_hash


def test_a_callback_stops_by_false_and_by_an_exception(box):
    simulation = pf.Simulation(box)
    simulation.step(10_000, every=100, callback=lambda s: s.step_count < 500)
    assert simulation.step_count == 500

    def refuse(simulation: pf.Simulation) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        simulation.step(10_000, callback=refuse)
    assert simulation.step_count == 501
    with pytest.raises(pf.InputError, match="at least 1"):
        simulation.step(10, every=0, callback=refuse)


def test_a_callback_cannot_step_the_simulation_that_calls_it_beyond_its_own_steps(box):
    simulation = pf.Simulation(box)
    simulation.step(10, every=5, callback=lambda s: s.step(1))
    assert simulation.step_count == 12


def test_hits_are_taken_once_and_are_those_of_the_recording(box, tmp_path):
    box["output"] = {"hits_above": 1.0}
    summary = pf.run(box, output=tmp_path, threads=1).summary
    recorded = pf.read(tmp_path, only=["hits"]).hits
    simulation = pf.Simulation(box, hits=True)
    taken = []
    for _ in range(2):
        simulation.step(summary["time"]["steps"] // 2)
        taken.append(simulation.take_hits())
    simulation.step(summary["time"]["steps"] % 2)
    taken.append(simulation.take_hits())
    assert simulation.take_hits().rows == 0
    assert simulation.state_hash == summary["state_hash"]
    ended = ~recorded["is_open"]
    forces = np.concatenate([hits["peak_force_n"] for hits in taken])
    assert np.array_equal(forces, recorded["peak_force_n"][ended])
    assert taken[0].units == recorded.units


def test_hits_that_nobody_takes_are_not_followed_and_the_bits_are_the_same(box):
    with_hits, without = pf.Simulation(box, hits=True), pf.Simulation(box)
    with_hits.step(2000)
    without.step(2000)
    assert with_hits.state_hash == without.state_hash
    with pytest.raises(pf.InputError, match="hits=True"):
        without.take_hits()


def test_a_simulation_is_not_pickled_and_says_what_to_send(box):
    with pytest.raises(pf.InputError, match="send its scene"):
        pickle.dumps(pf.Simulation(box))


def test_a_picture_has_a_circle_for_each_pellet(box):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    simulation = pf.Simulation(box)
    axes = simulation.plot(along="x")
    (circles,) = axes.collections
    assert len(circles.get_offsets()) == 60
    assert axes.get_xlabel() == "y [m]"
    assert axes.get_ylabel() == "z [m]"
    with pytest.raises(pf.InputError, match="along"):
        simulation.plot(along="up")


def test_a_simulation_tells_what_it_is(box):
    assert "60 pellets" in repr(pf.Simulation(box))
