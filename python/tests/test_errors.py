"""Exceptions and what they carry."""

import pickle

import pelletflow as pf
import pytest


def test_every_mistake_of_a_file_has_its_line_and_key(drop_file):
    text = drop_file.read_text(encoding="utf-8")
    text = text.replace("friction = 0.0", "friction = -1.0", 1)
    text = text.replace('diameter = "15 mm"', 'diameter = "15 kg"')
    drop_file.write_text(text, encoding="utf-8")
    with pytest.raises(pf.SceneError) as caught:
        pf.Simulation(drop_file)
    lines = text.splitlines()
    found = {mistake.key: mistake for mistake in caught.value.mistakes}
    assert len(found) == 2
    for key, mistake in found.items():
        assert mistake.file == str(drop_file)
        assert mistake.line is not None
        # The column is known of what is no TOML alone.
        assert mistake.column is None
        assert key.split(".")[-1] in lines[mistake.line - 1]
        assert mistake.message in str(caught.value)


def test_what_is_no_toml_is_told_with_line_and_column(drop_file):
    drop_file.write_text("[scene\n", encoding="utf-8")
    with pytest.raises(pf.SceneError) as caught:
        pf.Simulation(drop_file)
    (mistake,) = caught.value.mistakes
    assert (mistake.line, mistake.column) == (1, 7)


def test_mistakes_of_a_dictionary_have_keys_but_no_lines(drop):
    drop["pellets"]["ore"]["materiel"] = "pellet"
    with pytest.raises(pf.SceneError) as caught:
        pf.run(drop)
    (mistake,) = caught.value.mistakes
    assert mistake.key == "pellets.ore.materiel"
    assert mistake.line is None


def test_a_fill_that_does_not_fit_is_a_mistake_of_the_scene(box):
    box["fill"]["heap"]["count"] = 100_000
    with pytest.raises(pf.SceneError) as caught:
        pf.Simulation(box)
    assert any(mistake.key.startswith("fill.heap") for mistake in caught.value.mistakes)


def test_a_missing_file_is_named_and_is_the_cause(tmp_path):
    with pytest.raises(pf.SceneError, match=r"nowhere\.toml") as caught:
        pf.Simulation(tmp_path / "nowhere.toml")
    assert isinstance(caught.value.__cause__, FileNotFoundError)
    assert caught.value.mistakes[0].file == str(tmp_path / "nowhere.toml")


@pytest.mark.parametrize("value", [float("nan"), object(), {1, 2}.__len__])
def test_a_value_that_no_scene_can_hold_is_named_by_its_key(drop, value):
    drop["time"]["end"] = value
    with pytest.raises(pf.SceneError) as caught:
        pf.Simulation(drop)
    assert caught.value.mistakes[0].key == "time.end"


def test_a_key_of_set_that_the_scene_does_not_know_is_a_mistake(drop_file):
    with pytest.raises(pf.SceneError, match=r"time\.finish"):
        pf.Simulation(drop_file, set={"time.finish": 1})


def test_a_lost_pellet_is_a_physics_error(leak):
    simulation = pf.Simulation(leak)
    with pytest.raises(pf.PhysicsError, match="left the domain") as caught:
        simulation.step(10**6)
    assert caught.value.summary is None


def test_the_physics_error_of_a_run_carries_the_summary(leak, tmp_path):
    with pytest.raises(pf.PhysicsError) as caught:
        pf.run(leak, output=tmp_path)
    summary = caught.value.summary
    assert summary is not None
    assert summary["bodies"]["lost"] == 1
    assert summary["ended"] == "failed"
    assert summary["failure"] == str(caught.value)


def test_a_folder_that_cannot_be_made_is_an_output_error(drop, tmp_path):
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    with pytest.raises(pf.OutputError) as caught:
        pf.run(drop, output=tmp_path / "file" / "out")
    assert str(tmp_path / "file") in str(caught.value.path)
    assert isinstance(caught.value, OSError)


def test_every_exception_has_one_base_and_a_standard_one():
    assert issubclass(pf.SceneError, ValueError)
    assert issubclass(pf.PhysicsError, RuntimeError)
    assert issubclass(pf.OutputError, OSError)
    for exception in (pf.SceneError, pf.PhysicsError, pf.OutputError):
        assert issubclass(exception, pf.PelletflowError)


def test_exceptions_survive_the_way_back_from_another_process():
    mistake = pf.Mistake("a.toml", 3, None, "time.end", "is 0 s; expected more")
    scene = pickle.loads(pickle.dumps(pf.SceneError("bad", [mistake])))
    assert scene.mistakes == (mistake,)
    physics = pickle.loads(pickle.dumps(pf.PhysicsError("bad", {"failure": "bad"})))
    assert physics.summary == {"failure": "bad"}
    output = pickle.loads(pickle.dumps(pf.OutputError("bad", "out")))
    assert output.path == "out"
