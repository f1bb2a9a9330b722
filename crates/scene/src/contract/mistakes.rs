//! What mistakes have in common; `crates/cli/tests/bad_inputs` lists them one by one.

use super::{GOOD, draft, draft_with, line_of, spoiled};
use crate::{Place, Scene, SceneError};
use std::path::Path;

#[test]
fn a_mistake_in_a_value_is_put_to_the_line_of_its_key() {
    let text = spoiled("diameter = \"15 mm\"", "diameter = \"15 kg\"");
    let line = line_of("diameter");
    assert!(
        text.starts_with(&format!("scene.toml:{line}: pellets.ore.diameter: ")),
        "{text}"
    );
}

#[test]
fn all_mistakes_are_reported_at_once_and_in_order_of_lines() {
    let bad = GOOD
        .replace("density = 7850", "densty = 7850")
        .replace("friction = 0.4", "friction = -0.4")
        .replace("material = \"steel\"", "material = \"steal\"")
        .replace("outlet = \"out\"", "outlet = \"bin\"");
    let mistakes = draft(&bad).expect_err("four mistakes");
    let keys: Vec<&str> = mistakes
        .iter()
        .map(|mistake| mistake.key.as_str())
        .collect();
    assert_eq!(
        keys,
        [
            "materials.steel.densty",
            "pairs.steel-pellet.friction",
            "walls.floor.material",
            "meters.flow.outlet"
        ]
    );
}

#[test]
fn a_missing_pair_comes_with_the_lines_to_add() {
    let start = GOOD.find("[pairs.\"steel-pellet\"]").expect("there");
    let end = GOOD.find("[pellets.ore]").expect("there");
    let bad = format!("{}{}", &GOOD[..start], &GOOD[end..]);
    let text = draft(&bad).expect_err("a pair is missing").to_string();
    assert!(
        text.contains("missing pair: `pellet` and `steel` can meet"),
        "{text}"
    );
    assert!(
        text.contains("[pairs.\"pellet-steel\"]\n    restitution = "),
        "{text}"
    );
}

#[test]
fn a_pair_given_twice_or_of_unknown_materials_is_refused() {
    let twice = format!("{GOOD}\n[pairs.\"pellet-steel\"]\nrestitution = 1\nfriction = 0\n");
    let text = draft(&twice).expect_err("twice").to_string();
    assert!(
        text.contains("`pellet-steel` is the pair `steel-pellet` once more"),
        "{text}"
    );
    let unknown = format!("{GOOD}\n[pairs.\"pellet-stel\"]\nrestitution = 1\nfriction = 0\n");
    let text = draft(&unknown).expect_err("unknown").to_string();
    assert!(text.contains("did you mean `pellet-steel`?"), "{text}");
}

#[test]
fn what_is_missing_is_named_with_an_example() {
    let text = spoiled("density = 7850\n", "");
    assert!(
        text.contains("`density` is missing; write for example `density = \"3700 kg/m3\"`"),
        "{text}"
    );
    let text = spoiled("[time]\nend = \"1 s\"\n", "");
    assert!(
        text.contains("time: `time` is missing; expected a table"),
        "{text}"
    );
    let text = spoiled("youngs_modulus = \"207 GPa\"\n", "");
    assert!(
        text.contains("`youngs_modulus` or `shear_modulus` is missing"),
        "{text}"
    );
}

#[test]
fn a_scene_without_pellets_is_refused() {
    let start = GOOD.find("[fill.bed]").expect("there");
    let end = GOOD.find("[outlets.out]").expect("there");
    let bad = format!("{}{}", &GOOD[..start], &GOOD[end..]);
    let text = draft(&bad).expect_err("no pellets").to_string();
    assert!(
        text.contains("the scene has no pellets; add a [fill.NAME] or an [inlets.NAME]"),
        "{text}"
    );
}

#[test]
fn an_empty_file_is_told_apart_from_a_wrong_one() {
    let text = draft("# nothing\n").expect_err("empty").to_string();
    assert!(text.starts_with("scene.toml: the scene is empty"), "{text}");
}

#[test]
fn another_version_is_the_only_mistake_reported() {
    let text = spoiled("schema_version = 1", "schema_version = 2\nnews = true");
    assert_eq!(
        text,
        "scene.toml:1: schema_version: `schema_version` is 2; expected 1"
    );
    let text = spoiled("schema_version = 1\n", "");
    assert!(
        text.contains("`schema_version` is missing; write `schema_version = 1`"),
        "{text}"
    );
}

#[test]
fn what_is_not_toml_has_line_and_column() {
    let mistakes = draft("schema_version = 1\nscene title = 3\n").expect_err("not TOML");
    let mistake = mistakes.iter().next().expect("one");
    assert_eq!(
        mistake.place,
        Place::Line {
            line: 2,
            column: Some(7)
        }
    );
    assert!(
        mistake.message.starts_with("this is not TOML: "),
        "{}",
        mistake.message
    );
}

#[test]
fn a_key_given_twice_is_refused_on_its_second_line() {
    let text = spoiled("density = 7850", "density = 7850\ndensity = 7850");
    let line = line_of("density = 7850") + 1;
    assert!(text.starts_with(&format!("scene.toml:{line}:")), "{text}");
    assert!(text.contains("duplicate key"), "{text}");
}

#[test]
fn a_diameter_in_micrometers_by_mistake_is_caught_by_its_number_of_pellets() {
    let bad = GOOD
        .replace("diameter = \"15 mm\"", "diameter = \"15 um\"")
        .replace("count = 10", "mass = \"50 kg\"");
    let text = draft(&bad).expect_err("too many").to_string();
    assert!(text.contains("pellets; expected at most 5e6"), "{text}");
}

#[test]
fn an_overrides_mistake_is_the_overrides_and_not_a_lines() {
    let text = draft_with(GOOD, &["pellets.ore.diameter=15 kg"])
        .expect_err("a mass")
        .to_string();
    assert!(
        text.starts_with("scene.toml: --set pellets.ore.diameter: `diameter`"),
        "{text}"
    );
    let text = draft_with(GOOD, &["pellets.ore.diametre=15 mm"])
        .expect_err("unknown")
        .to_string();
    assert!(text.contains("--set pellets.ore.diametre:"), "{text}");
    assert!(text.contains("did you mean `diameter`?"), "{text}");
}

#[test]
fn a_directory_a_missing_file_and_other_bytes_are_told_apart() {
    let directory = Scene::read(Path::new(env!("CARGO_MANIFEST_DIR")), &[]);
    let text = directory.expect_err("a directory").to_string();
    assert!(text.contains("this is a directory"), "{text}");
    let missing = Scene::read(Path::new("no-such-scene.toml"), &[]);
    let text = missing.expect_err("missing").to_string();
    assert!(
        text.contains("no-such-scene.toml: there is no such file"),
        "{text}"
    );
    let other = std::env::temp_dir().join(format!("pelletflow-scene-{}.toml", std::process::id()));
    std::fs::write(&other, b"schema_version = 1\ntitle = \"\xff\"\n").expect("writable");
    let error = Scene::read(&other, &[]).expect_err("not text");
    std::fs::remove_file(&other).expect("it was there");
    assert!(matches!(error, SceneError::Invalid(_)));
    assert!(
        error.to_string().contains(":2: byte 28 is not UTF-8"),
        "{error}"
    );
}

#[test]
fn values_without_a_file_give_mistakes_without_lines() {
    let value = serde_json::json!({ "schema_version": 1, "time": { "end": "1 kg", "step": null } });
    let text = Scene::from_value(&value, "sweep", &[])
        .expect_err("a mass")
        .to_string();
    assert!(
        text.contains("sweep: time.end: `end` is a time; `1 kg` is a mass"),
        "{text}"
    );
    assert!(text.contains("sweep: the scene has no pellets"), "{text}");
}
