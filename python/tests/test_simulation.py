"""Stepping by hand."""

import _thread
import threading

import numpy as np
import pelletflow as pf
import pytest

GRAVITY = 9.81
RADIUS = 7.5e-3
HEIGHT = 0.1
RESTITUTION = 0.8


def test_free_fall_follows_half_g_t_squared(drop):
    simulation = pf.Simulation(drop)
    simulation.step(1000)
    fallen = RADIUS + HEIGHT - simulation.positions[0, 2]
    # The scheme is exact for a constant force; what is left is the rounding of 1000 sums.
    assert fallen == pytest.approx(GRAVITY * simulation.time**2 / 2, rel=1e-11)
    assert simulation.velocities[0, 2] == pytest.approx(-GRAVITY * simulation.time, rel=1e-11)


def test_a_pellet_rebounds_to_restitution_squared_of_its_height(drop):
    simulation = pf.Simulation(drop)
    while simulation.velocities[0, 2] <= 0.0:
        simulation.step(100)
    highest = 0.0
    while simulation.velocities[0, 2] > 0.0:
        simulation.step(20)
        highest = max(highest, simulation.positions[0, 2] - RADIUS)
    # Gravity acts during the contact too, which shifts the height by about 0.1 %.
    assert highest == pytest.approx(RESTITUTION**2 * HEIGHT, rel=5e-3)


def test_time_is_steps_times_the_time_step(drop):
    simulation = pf.Simulation(drop)
    simulation.step()
    simulation.step(9)
    assert simulation.step_count == 10
    assert simulation.time == 10 * simulation.time_step


def test_arrays_have_one_row_per_pellet_in_order_of_the_numbers(box):
    simulation = pf.Simulation(box)
    simulation.step(500)
    assert simulation.ids.dtype == np.uint32
    assert np.array_equal(simulation.ids, np.arange(60))
    for vectors in (simulation.positions, simulation.velocities, simulation.spins):
        assert vectors.shape == (60, 3)
        assert vectors.dtype == np.float64
    assert np.allclose(simulation.radii, RADIUS)
    volumes = 4 / 3 * np.pi * simulation.radii**3
    assert np.allclose(simulation.masses, 3700 * volumes, rtol=1e-12)


def test_rows_stay_with_their_pellets_while_storage_is_sorted_anew(box):
    simulation = pf.Simulation(box)
    before = simulation.positions
    simulation.step(1)
    # In one step no pellet moves farther than its speed allows.
    farthest = np.abs(simulation.velocities).max() * simulation.time_step
    assert np.abs(simulation.positions - before).max() <= 1.01 * farthest


def test_arrays_are_copies(drop):
    simulation = pf.Simulation(drop)
    hash_before = simulation.state_hash
    simulation.positions[:] = 0.0
    assert simulation.state_hash == hash_before
    assert simulation.positions[0, 2] == pytest.approx(RADIUS + HEIGHT, rel=1e-15)


def test_arrays_are_empty_once_every_pellet_has_left(drop):
    below = {"kind": "half-space", "point": [0, 0, 0.09], "normal": [0, 0, 1]}
    simulation = pf.Simulation(drop | {"outlets": {"below": {"region": below}}})
    while simulation.time < 0.1:
        simulation.step(1000)
    assert simulation.positions.shape == (0, 3)
    assert simulation.radii.shape == (0,)
    assert simulation.mass_ledger["discharged"]["count"] == 1
    assert simulation.mass_ledger["by_outlet"][0]["count"] == 1


def test_the_ledgers_close(box):
    simulation = pf.Simulation(box)
    simulation.step(3000)
    mass = simulation.mass_ledger
    assert mass["inserted"]["count"] == mass["inside"]["count"] == 60
    assert mass["inside"]["mass"] == pytest.approx(simulation.masses.sum(), rel=1e-12)
    energy = simulation.energy_ledger
    assert energy["dissipated"] > 0.0
    # The step is chosen for a force error of 0.1 %; the energy error is of that order.
    assert abs(energy["residual"]) < 1e-2 * energy["throughput"]


def test_a_dictionary_and_the_same_file_give_the_same_bits(drop, drop_file):
    hashes = set()
    for scene in (drop, drop_file, str(drop_file)):
        simulation = pf.Simulation(scene)
        simulation.step(2000)
        hashes.add(simulation.state_hash)
    assert len(hashes) == 1


def test_the_bits_do_not_depend_on_threads_or_on_how_steps_are_called(box):
    one = pf.Simulation(box, threads=1)
    two = pf.Simulation(box, threads=2)
    assert (one.threads, two.threads) == (1, 2)
    one.step(1200)
    for _ in range(400):
        two.step(3)
    assert one.state_hash == two.state_hash
    two.step()
    assert one.state_hash != two.state_hash


def test_set_puts_values_in_place_of_the_scenes(drop_file):
    simulation = pf.Simulation(
        drop_file, set={"scene.gravity": [0, 0, 0], "pellets.ore.diameter": "20 mm"}
    )
    simulation.step(10)
    assert simulation.radii[0] == 10e-3
    assert not simulation.velocities.any()


def test_numpy_numbers_and_arrays_may_stand_in_a_scene(drop):
    drop["scene"]["gravity"] = np.array([0.0, 0.0, -GRAVITY])
    drop["time"]["end"] = np.float32(0.25)
    drop["scene"]["seed"] = np.int64(7)
    simulation = pf.Simulation(drop)
    simulation.step(10)
    assert simulation.velocities[0, 2] < 0.0


def test_other_threads_run_while_it_steps_and_an_interrupt_ends_it(box, hang_guard):
    simulation = pf.Simulation(box | {"scene": {"gravity": [0, 0, 0]}}, threads=1)

    def interrupt_once_it_steps() -> None:
        while True:
            try:
                _ = simulation.step_count
            except RuntimeError:
                # It is at work and cannot be looked at, and this thread runs all the same.
                _thread.interrupt_main()
                return

    other = threading.Thread(target=interrupt_once_it_steps)
    other.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.step(10**15)
    other.join()
    assert 0 < simulation.step_count < 10**15
