"""Recordings read back as tables."""

import pickle

import numpy as np
import pelletflow as pf
import pytest


@pytest.fixture
def output(box, tmp_path):
    """A heap of sixty pellets, with a meter of the force on the floor, run and recorded."""
    box["meters"] = {"load": {"kind": "wall-force", "wall": "floor"}}
    box["output"] = {"hits_above": 1.0, "contacts": True}
    return pf.run(box, output=tmp_path / "out")


def test_bodies_are_all_pellets_of_all_frames(output):
    bodies = output.read().bodies
    times = np.unique(bodies["time_s"])
    assert bodies.rows == 60 * len(times)
    assert bodies.units["speed_m_per_s"] == "m/s"
    assert np.allclose(bodies["radius_m"], 7.5e-3)


def test_hits_name_their_walls_and_have_partners_only_among_pellets(output):
    hits = output.read(only=["hits"]).hits
    at_wall = hits["wall"] == "floor"
    assert at_wall.any()
    assert (~at_wall).any()
    assert np.array_equal(np.ma.getmaskarray(hits["partner"]), at_wall)
    assert np.array_equal(np.isnan(hits["partner_diameter_m"]), at_wall)
    greatest = output.summary["contacts"]["max_force_n"]
    # Both look between the steps, which are chosen for a force error of 0.1 %.
    assert hits["peak_force_n"].max() == pytest.approx(greatest, rel=2e-3)


def test_meters_and_ledgers_end_as_the_summary_does(output):
    recording = output.read()
    assert list(recording.meters) == ["load"]
    assert recording.meters["load"].units["force_z_n"] == "N"
    kinetic = recording.energy_ledger["kinetic_j"][-1]
    assert kinetic == output.summary["energy"]["kinetic_j"]
    assert recording.mass_ledger["inside"][-1] == 60
    assert recording.events["level"][0] == "information"
    assert recording.facts["scene_hash"] == output.summary["scene_hash"]
    assert recording.hit_classes["count"].sum() >= recording.hits.rows


def test_contacts_bear_the_heap_and_name_one_partner_each(output):
    contacts = output.read(only=["contacts"]).contacts
    assert contacts.units["normal_force_n"] == "N"
    on_floor = contacts["wall"] == "floor"
    assert np.array_equal(np.ma.getmaskarray(contacts["partner"]), on_floor)
    at_end = contacts["time_s"] == contacts["time_s"].max()
    load = contacts["force_z_n"][on_floor & at_end].sum()
    # As the meter of the floor reads it, to the digits that are recorded.
    meter = output.read(only=["meters"]).meters["load"]["force_z_n"][-1]
    assert load == pytest.approx(-meter, rel=2e-4)


def test_a_run_that_recorded_no_contacts_says_how_to(drop, tmp_path):
    recording = pf.run(drop, output=tmp_path).read()
    with pytest.raises(pf.RecordingError, match="contacts = true"):
        _ = recording.contacts


def test_a_floor_is_one_wall_that_stays_and_is_drawn_of_level_triangles(output):
    recording = output.read()
    walls = recording.walls
    assert list(walls["wall"]) == ["floor"]
    assert list(walls["is_present"]) == [True]
    pose = np.array([walls[name][0] for name in ("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")])
    assert np.array_equal(pose, [0, 0, 0, 0, 0, 0, 1])
    triangles = recording.wall_triangles
    heights = np.concatenate([triangles[f"z{corner}_m"] for corner in (1, 2, 3)])
    assert np.allclose(heights, 0.0, atol=1e-7)
    # Its outline lies in it.
    assert np.allclose(recording.wall_edges["z1_m"], 0.0, atol=1e-7)


def test_a_folder_and_its_recording_read_alike_and_only_what_is_asked_for(output):
    by_file = pf.read(output.output / "run.mcap", only=["events"])
    by_folder = pf.read(str(output.output), only=["events"])
    assert by_file.events == by_folder.events
    assert list(by_file.tables) == ["events"]
    with pytest.raises(pf.RecordingError, match="only"):
        _ = by_file.bodies


def test_a_run_and_its_recording_survive_the_way_to_another_process(output):
    recording = output.read()
    assert pickle.loads(pickle.dumps(output)) == output
    assert pickle.loads(pickle.dumps(recording)).tables == recording.tables


def test_a_run_without_hits_says_why_it_has_none(drop, tmp_path):
    drop["output"] = {"hits": False}
    recording = pf.run(drop, output=tmp_path).read()
    with pytest.raises(pf.RecordingError, match="hits = false"):
        _ = recording.hits


def test_a_recording_that_is_cut_off_gives_its_beginning_and_says_so(output, tmp_path):
    whole = (output.output / "run.mcap").read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(whole[: len(whole) * 6 // 10])
    recording = pf.read(cut)
    assert recording.is_cut_off
    assert not output.read().is_cut_off
    assert 0 < recording.bodies.rows <= output.read().bodies.rows


def test_what_is_no_recording_is_refused_by_its_own_error(tmp_path):
    with pytest.raises(pf.RecordingError, match="does not exist") as caught:
        pf.read(tmp_path / "nowhere.mcap")
    assert isinstance(caught.value.__cause__, FileNotFoundError)
    assert caught.value.path == tmp_path / "nowhere.mcap"
    text = tmp_path / "scene.toml"
    text.write_text("schema_version = 1", encoding="utf-8")
    with pytest.raises(pf.RecordingError, match="not an MCAP file"):
        pf.read(text)


def test_a_kind_of_table_that_is_none_is_told_with_those_that_are(output):
    with pytest.raises(pf.InputError, match="bodies") as caught:
        output.read(only=["pellets"])
    assert caught.value.key == "only"
    assert caught.value.value == "pellets"


def test_a_notebook_shows_the_tables_of_a_recording_and_the_summary_of_a_run(output):
    assert "<td>bodies</td>" in output.read()._repr_html_()
    assert "max_force_n" in output._repr_html_()
