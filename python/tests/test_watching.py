"""Watching a simulation: callbacks, hits and pictures."""

import copy
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


def test_steps_that_a_callback_takes_come_on_top_of_those_asked_for(box):
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


def test_hits_are_not_asked_of_a_scene_that_leaves_them_out(box):
    box["output"] = {"hits": False}
    with pytest.raises(pf.InputError, match="hits = false") as caught:
        pf.Simulation(box, hits=True)
    assert caught.value.key == "hits"


@pytest.mark.parametrize("threads", [1, 2])
def test_a_simulation_survives_the_way_to_another_process_and_goes_on_to_the_same_bits(
    box, threads
):
    box["output"] = {"hits_above": 1.0}
    here = pf.Simulation(box, threads=threads, hits=True)
    # Long enough for the heap to have fallen: contacts remember something.
    here.step(4000)
    assert here.energy_ledger["elastic"] > 0.0
    there = pickle.loads(pickle.dumps(here))
    assert there.state_hash == here.state_hash
    assert there.threads == threads
    for simulation in (here, there):
        simulation.step(100)
    assert there.state_hash == here.state_hash
    assert there.take_hits() == here.take_hits()
    assert np.array_equal(there.positions, here.positions)


def test_a_pickled_simulation_takes_its_meshes_along(box, tmp_path):
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["f 1 2 3", "f 1 3 4"]
    mesh = tmp_path / "floor.obj"
    mesh.write_text("\n".join(lines), encoding="utf-8")
    box["walls"]["floor"] = {"material": "steel", "mesh": {"file": str(mesh), "unit": "m"}}
    here = pf.Simulation(box)
    here.step(1000)
    sent = pickle.dumps(here)
    mesh.unlink()
    there = pickle.loads(sent)
    for simulation in (here, there):
        simulation.step(100)
    assert there.state_hash == here.state_hash


def test_a_copy_of_a_simulation_leaves_it_alone(box):
    simulation = pf.Simulation(box)
    other = copy.copy(simulation)
    other.step(10)
    assert (simulation.step_count, other.step_count) == (0, 10)


def test_a_simulation_of_another_version_or_a_damaged_one_is_refused(box):
    restored, (scene, threads, hits, state) = pf.Simulation(box).__reduce__()
    version = pf.__version__.encode()
    assert version in state
    with pytest.raises(pf.InputError, match="step the scene anew") as caught:
        restored(scene, threads, hits, state.replace(version, b"9" * len(version), 1))
    assert "9" * len(version) in str(caught.value)
    for damaged in (b"", state[:-1], state + b"0"):
        with pytest.raises(pf.InputError, match="damaged"):
            restored(scene, threads, hits, damaged)
    with_meter = scene[0] + '\n[meters.load]\nkind = "wall-force"\nwall = "floor"\n'
    with pytest.raises(pf.InputError, match="does not fit the scene"):
        restored((with_meter, scene[1]), threads, hits, state)


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
