"""Scenes in code."""

import pickle
from pathlib import Path

import pelletflow as pf
import pytest
from scene_types import module

EXAMPLES = Path(__file__).parents[2] / "examples/scenes"


def test_a_scene_in_code_gives_the_bits_of_its_dictionary_and_of_its_text(drop, tmp_path):
    scene = pf.Scene(**drop)
    text = tmp_path / "drop.toml"
    text.write_text(scene.to_toml(), encoding="utf-8")
    hashes = set()
    for each in (scene, drop, text, pf.Scene.read(text)):
        simulation = pf.Simulation(each)
        simulation.step(500)
        hashes.add(simulation.state_hash)
    assert len(hashes) == 1


def test_values_are_set_and_read_by_dotted_key(drop):
    scene = pf.Scene(**drop)
    scene["time.end"] = "50 ms"
    scene["materials.pellet.density"] = 4000.0
    assert scene["time.end"] == "50 ms"
    assert scene["time"]["peak_force_error"] == 1e-3
    assert scene["materials.pellet"]["density"] == 4000.0
    assert drop["materials"]["pellet"]["density"] == 3700
    assert set(scene) == set(drop)
    assert len(scene) == len(drop)
    with pytest.raises(KeyError, match=r"time\.begin"):
        scene["time.begin"]


def test_what_is_set_reaches_a_run_a_simulation_and_the_hash(drop, tmp_path):
    scene = pf.Scene(**drop)
    before = scene.hash
    scene["time.end"] = 0.01
    assert scene.hash != before
    summary = pf.run(scene, output=tmp_path).summary
    assert summary["time"]["simulated_s"] == pytest.approx(0.01, rel=1e-2)
    assert summary["scene_hash"] == scene.hash
    scene["pellets.ore.diameter"] = "20 mm"
    assert pf.Simulation(scene, set={"time.end": 1}).radii[0] == 10e-3


def test_a_table_that_is_set_takes_the_place_of_what_was_set_in_it(drop):
    scene = pf.Scene(**drop)
    scene["time.end"] = 5.0
    scene["time"] = {"end": 0.5}
    assert scene["time"] == {"end": 0.5}


@pytest.fixture(params=["tables", "file"])
def scene(request, drop, drop_file):
    """The drop as a scene in code, and as one that is read from a file."""
    return pf.Scene(**drop) if request.param == "tables" else pf.Scene.read(drop_file)


def test_of_two_values_that_meet_the_one_set_last_counts(scene, tmp_path):
    scene["time.end"] = 3.0
    scene["time"] = {"end": 2.0, "peak_force_error": 1e-3}
    assert scene["time.end"] == 2.0
    # An earlier value of the same key keeps no place before the table.
    summary = pf.run(scene, output=tmp_path / "set", set={"time.end": 0.01}).summary
    assert summary["time"]["simulated_s"] == pytest.approx(0.01, rel=1e-2)
    whole = {"time.end": 3.0, "time": {"end": 0.01, "peak_force_error": 1e-3}}
    summary = pf.run(scene, output=tmp_path / "whole", set=whole).summary
    assert summary["time"]["simulated_s"] == pytest.approx(0.01, rel=1e-2)


def test_values_that_do_not_meet_give_one_scene_in_any_order(scene):
    # Both are new to the scene, so that the text has to find a place for them.
    values = {"scene.seed": 3, "scene.description": "one"}
    one, other = scene.copy(), scene.copy()
    for key in values:
        one[key] = values[key]
    for key in reversed(values):
        other[key] = values[key]
    assert one.hash == other.hash
    assert one.to_toml() == other.to_toml()


def test_a_place_in_a_list_is_set_and_read_by_its_number(scene):
    scene["fill.one.at"] = [[0, 0, 0.2], [0, 0, 0.4]]
    scene["scene.gravity.2"] = -1.62
    assert scene["scene.gravity"] == [0, 0, -1.62]
    assert scene["fill.one.at.1"] == [0, 0, 0.4]
    assert pf.Simulation(scene).positions[:, 2].tolist() == [0.2, 0.4]
    for key in ("scene.gravity.3", "scene.gravity.x", "scene.gravity.2.0"):
        with pytest.raises(KeyError, match=key):
            scene[key]


def test_what_is_no_key_is_not_in_a_scene(scene):
    for key in ("", "a b", "fill..one", "time.begin"):
        assert key not in scene
        assert scene.get(key) is None


def test_a_scene_shares_nothing_with_what_it_is_made_of_or_gives(scene, drop):
    before = scene.hash
    drop["fill"]["one"]["at"][0][2] = 0.9
    assert scene.hash == before
    scene["fill.one.at"][0][2] = 0.9
    scene["time"]["end"] = 9.0
    assert scene.hash == before
    time = {"end": 0.1, "peak_force_error": 1e-3}
    scene["time"] = time
    other = scene.copy()
    other["time.end"] = 0.3
    time["end"] = 0.5
    assert scene["time.end"] == 0.1
    assert other["time.end"] == 0.3
    assert time == {"end": 0.5, "peak_force_error": 1e-3}


@pytest.mark.parametrize(
    ("key", "value"),
    [("time.end", None), ("time.end", object()), ("time end", 1.0), ("time=end", 1.0), ("", 1.0)],
)
def test_what_cannot_be_set_is_refused_at_once_with_its_key(scene, key, value):
    before = scene.to_toml()
    with pytest.raises(pf.SceneError) as caught:
        scene[key] = value
    assert caught.value.mistakes[0].key == key
    assert scene.to_toml() == before


def test_a_scene_that_is_not_yet_whole_can_be_looked_at():
    scene = pf.Scene()
    assert len(scene) == 0
    scene["time.end"] = "1 s"
    assert dict(scene) == {"time": {"end": "1 s"}}
    with pytest.raises(pf.SceneError):
        scene.check()


def test_a_copy_is_another_scene(drop):
    scene = pf.Scene(**drop)
    other = scene.copy()
    assert other == scene
    other["time.end"] = 3.0
    assert other != scene
    assert scene["time.end"] == 0.2


def test_a_scene_survives_the_way_to_another_process(drop):
    scene = pf.Scene(**drop)
    scene["time.end"] = 0.5
    assert pickle.loads(pickle.dumps(scene)) == scene


def test_a_scene_file_is_read_with_its_keys():
    scene = pf.Scene.read(EXAMPLES / "chute.toml")
    assert scene["scene.title"] == "Chute onto a belt"
    scene['pairs."pellet-steel".friction'] = 0.1
    assert scene.hash != pf.Scene.read(EXAMPLES / "chute.toml").hash
    assert isinstance(scene.check(), list)
    assert "<pre>" in scene._repr_html_()
    assert "walls" in repr(scene)


def test_every_mistake_of_a_scene_is_told_when_it_is_checked(drop):
    scene = pf.Scene(**drop)
    scene["pairs.pellet-steel.friction"] = -1.0
    scene["time.finish"] = 1.0
    with pytest.raises(pf.SceneError) as caught:
        scene.check()
    assert {mistake.key for mistake in caught.value.mistakes} == {
        "pairs.pellet-steel.friction",
        "time.finish",
    }


def test_the_types_that_editors_complete_are_those_of_the_schema():
    types = Path(pf.__file__).with_name("_scene_types.py")
    message = "run python/tests/scene_types.py and write what it prints to _scene_types.py"
    assert types.read_text(encoding="utf-8") == module(), message


def test_the_types_can_be_imported():
    from pelletflow import _scene_types

    assert "walls" in _scene_types.SceneSpec.__annotations__
