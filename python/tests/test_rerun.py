"""Recordings written for Rerun, read back by its own reader."""

import sys

import numpy as np
import pelletflow as pf
import pytest

chunk = pytest.importorskip("rerun.chunk", reason="Rerun needs Python 3.11")


@pytest.fixture
def output(box, tmp_path):
    """A fall of sixty pellets onto a floor, beside a gate that opens."""
    box["walls"]["gate"] = {
        "material": "steel",
        "shape": {"kind": "box", "min": [0.2, -0.02, 0.0], "max": [0.21, 0.02, 0.05]},
        "opens_at": 0.05,
    }
    box["output"] = {"hits_above": 1.0}
    return pf.run(box, output=tmp_path / "out")


def values_of(file, entity, component):
    """Times [s] of an entity, and one of its components at each."""
    times, values = [], []
    for part in chunk.RrdReader(file).stream():
        batch = part.to_record_batch()
        if part.entity_path == entity and component in batch.schema.names:
            times += [time.total_seconds() for time in batch.column("time").to_pylist()]
            values += batch.column(component).to_pylist()
    return times, values


def test_spheres_are_where_and_as_large_as_the_recording_has_them(output, tmp_path):
    file = pf.to_rerun(output.output, tmp_path / "run.rrd")
    bodies = output.read(only=["bodies"]).bodies
    times, places = values_of(file, "/pellets", "Points3D:positions")
    _, radii = values_of(file, "/pellets", "Points3D:radii")
    expected = np.column_stack([bodies[axis] for axis in ("x_m", "y_m", "z_m")])
    # Python keeps microseconds of the nanoseconds.
    assert np.allclose(times, np.unique(bodies["time_s"]), rtol=0.0, atol=1e-6)
    assert np.array_equal(np.concatenate(places).astype(np.float32), expected)
    assert np.array_equal(np.concatenate(radii).astype(np.float32), bodies["radius_m"])


def test_frames_that_were_not_kept_leave_the_pellets_where_they_were(box, tmp_path):
    box["output"] = {"frames_of_last": 0.05}
    output = pf.run(box, output=tmp_path / "out")
    file = pf.to_rerun(output.output)
    recording = output.read(only=["bodies", "mass_ledger"])
    times, places = values_of(file, "/pellets", "Points3D:positions")
    kept = np.unique(recording.bodies["time_s"])
    assert np.allclose(times, kept, rtol=0.0, atol=1e-6)
    assert len(kept) < recording.mass_ledger.rows
    assert all(len(row) == 60 for row in places)


def test_pellets_that_have_left_are_gone_from_the_last_frame(drop, tmp_path):
    drop["outlets"] = {
        "below": {"region": {"kind": "box", "min": [-1, -1, -1], "max": [1, 1, 0.05]}}
    }
    output = pf.run(drop, output=tmp_path / "out")
    assert output.summary["bodies"]["inside"] == 0
    _, places = values_of(pf.to_rerun(output.output), "/pellets", "Points3D:positions")
    assert len(places[0]) == 1
    assert places[-1] == []


def test_a_gate_is_drawn_of_its_triangles_until_it_opens(output, tmp_path):
    file = pf.to_rerun(output.read(), tmp_path / "run.rrd")
    (begin,), (corners,) = values_of(file, "/equipment/gate/surface", "Mesh3D:vertex_positions")
    assert begin == 0.0
    triangles = np.array(corners).reshape(-1, 3, 3)
    sides = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    area = 2.0 * (0.01 * 0.04 + 0.04 * 0.05 + 0.05 * 0.01)
    assert 0.5 * np.linalg.norm(sides, axis=1).sum() == pytest.approx(area, rel=1e-5)
    (gone,), _ = values_of(file, "/equipment/gate", "Clear:is_recursive")
    walls = output.read(only=["walls"]).walls
    opened = walls["time_s"][~walls["is_present"]]
    assert gone == pytest.approx(opened[0], abs=1e-6)
    # It is told by the first frame from then on, of which there are 60 in a second.
    assert 0.05 <= opened[0] < 0.05 + 1 / 60


def test_the_hardest_hits_are_marked_from_their_moments_on(output, tmp_path):
    file = pf.to_rerun(output.output, tmp_path / "run.rrd")
    hits = output.read(only=["hits"]).hits
    hardest = np.argmax(hits["peak_force_n"])
    (time,), (places,) = values_of(file, "/hits/worst/01", "Points3D:positions")
    assert time == pytest.approx(hits["peak_time_s"][hardest], abs=1e-6)
    place = [hits[axis][hardest] for axis in ("x_m", "y_m", "z_m")]
    assert np.allclose(places[0], place, rtol=1e-6)


def test_colors_are_those_of_what_was_asked_for(output, tmp_path):
    by_speed = pf.to_rerun(output.output, tmp_path / "speed.rrd")
    by_force = pf.to_rerun(output.output, tmp_path / "force.rrd", color_by="force")
    # Pellets in the air have a speed and no force: nothing but the first color of the scale.
    _, speeds = values_of(by_speed, "/pellets", "Points3D:colors")
    _, forces = values_of(by_force, "/pellets", "Points3D:colors")
    assert len(set(forces[0])) == 1
    assert len(set(speeds[-1])) > 1
    assert forces[0][0] == 0x440154FF  # the first color of viridis


def test_a_hit_of_one_pellet_has_a_color_of_its_own(drop, tmp_path):
    drop["output"] = {"frame_interval": 1e-4}
    output = pf.run(drop, output=tmp_path / "out")
    _, forces = values_of(
        pf.to_rerun(output.output, color_by="force"), "/pellets", "Points3D:colors"
    )
    bodies = output.read(only=["bodies"]).bodies
    touching = bodies["force_n"] > 0
    # Fewer than the share of the values above the scale.
    assert 0 < touching.sum() < 0.01 * len(touching)
    assert len({color[0] for color in forces}) > 1


def test_the_recording_itself_is_never_written_over(output):
    recording = output.output / "run.mcap"
    before = recording.read_bytes()
    with pytest.raises(pf.InputError, match="the recording itself") as caught:
        pf.to_rerun(recording, recording)
    assert caught.value.key == "path"
    assert recording.read_bytes() == before


def test_a_rerun_that_is_too_old_is_told_with_the_cure(output, tmp_path, monkeypatch):
    monkeypatch.setattr("rerun.__version__", "0.22.1")
    with pytest.raises(pf.InputError, match=r"0\.41 or newer") as caught:
        pf.to_rerun(output.output, tmp_path / "run.rrd")
    assert caught.value.value == "0.22.1"


def test_rerun_that_is_missing_is_told_with_the_cure(output, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "rerun", None)
    with pytest.raises(pf.InputError, match="pip install 'rerun-sdk"):
        pf.to_rerun(output.output, tmp_path / "run.rrd")


def test_a_color_of_what_no_pellet_has_is_told_with_what_they_have(output, tmp_path):
    with pytest.raises(pf.InputError, match="`speed`, `force`") as caught:
        pf.to_rerun(output.output, tmp_path / "run.rrd", color_by="mass")
    assert caught.value.value == "mass"


def test_a_file_that_cannot_be_written_is_an_output_error(output, tmp_path):
    with pytest.raises(pf.OutputError, match="nowhere") as caught:
        pf.to_rerun(output.output, tmp_path / "nowhere" / "run.rrd")
    assert caught.value.path == tmp_path / "nowhere" / "run.rrd"
