//! Each mistake has its message, line and cure.

use super::{GOOD, draft, draft_with, line_of, spoiled};
use crate::{Place, Scene, SceneError};
use std::path::Path;

/// The shape of the wall of the good scene.
const WALL: &str = "{ kind = \"half-space\", point = [0, 0, 0], normal = [0, 0, 2] }";

/// The meter of the good scene.
const METER: &str = "kind = \"mass-flow\"\noutlet = \"out\"";

/// What of the good scene is replaced, by what, and a part of the message.
#[rustfmt::skip]
const CASES: &[(&str, &str, &str)] = &[
    ("density = 7850", "densty = 7850", "unknown key `densty`; did you mean `density`?"),
    ("density = 7850", "density = -7850", "`density` is -7850; expected more than 0 kg/m3 and at most 100000 kg/m3"),
    ("density = 7850", "density = 7.85e9", "expected more than 0 kg/m3 and at most 100000 kg/m3"),
    ("density = 7850", "density = nan", "`density` is nan; expected a finite number"),
    ("density = 7850", "density = inf", "`density` is inf; expected a finite number"),
    ("density = 7850", "density = true", "`density` is true; expected a density"),
    ("density = 7850", "density = \"7850\"", "has no unit; write for example \"3700 kg/m3\", or 7850 without quotes"),
    ("poisson_ratio = 0.28", "poisson_ratio = 0.5", "`poisson_ratio` is 0.5; expected more than -1 and less than 0.5"),
    ("poisson_ratio = 0.28", "poisson_ratio = -1", "`poisson_ratio` is -1; expected more than -1 and less than 0.5"),
    ("restitution = 0.5", "restitution = 1.2", "`restitution` is 1.2; expected more than 0 and at most 1"),
    ("friction = 0.4", "friction = \"much\"", "`friction` is the text \"much\"; expected a number"),
    ("diameter = \"15 mm\"", "diameter = \"15 kg\"", "`diameter` is a length; `15 kg` is a mass; write for example \"15 mm\""),
    ("diameter = \"15 mm\"", "diameter = \"15 mn\"", "has the unknown unit `mn`, expected `m`, `km`, `cm`, `mm` or `um`"),
    ("diameter = \"15 mm\"", "diameter = { min = 0.02, max = 0.01 }", "`min` is 0.02 m and `max` 0.01 m; exchange them"),
    ("diameter = \"15 mm\"", "diameter = { mean = \"12 mm\" }", "only `mean` is given; expected `min` and `max`, or `mean` and `deviation`"),
    ("diameter = \"15 mm\"", "diameter = { mean = 0.012, deviation = 0.005 }", "three deviations below the mean is -0.0030 m; expected more than 0: give `min`"),
    ("diameter = \"15 mm\"", "diameter = { median = 0.012, spread = 0.1, mean = 0.012 }", "`mean`, `median`, `spread` are given"),
    ("diameter = \"15 mm\"", "diameter = { openings = [0.01, 0.012], passing = [0.1, 1] }", "the shares that pass go from 0.1 to 1; expected from 0 to 1"),
    ("diameter = \"15 mm\"", "diameter = { openings = [0.012, 0.01], passing = [0, 1] }", "the openings 0.012 m and 0.01 m follow each other; expected more than 0 and rising"),
    ("diameter = \"15 mm\"", "diameter = { openings = [0.01], passing = [0, 1] }", "there are 1 openings and 2 shares that pass them"),
    ("diameter = \"15 mm\"", "diameter = [1]", "`diameter` is a list; expected a length or a table"),
    ("material = \"pellet\"", "material = \"pelet\"", "unknown material `pelet`; did you mean `pellet`?"),
    ("outlet = \"out\"", "outlet = \"bin\"", "unknown outlet `bin`; expected `out`"),
    (METER, "kind = \"plane-flow\"\npoint = [0, 0, 0]\nnormal = [0, 0, 0]", "`normal` is a zero vector; expected a direction"),
    (METER, "kind = \"plane-flow\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 0", "`radius` is 0; expected more than 0 m"),
    (METER, "kind = \"wall-force\"\nwall = \"floors\"", "unknown wall `floors`; did you mean `floor`?"),
    (METER, "kind = \"wall-impacts\"\nwall = \"floors\"\ncell = 0.1", "unknown wall `floors`; did you mean `floor`?"),
    (METER, "kind = \"wall-impacts\"\nwall = \"floor\"\ncell = 0", "`cell` is 0; expected more than 0 m"),
    (METER, "kind = \"wall-impacts\"\nwall = \"floor\"", "`cell` is missing"),
    (METER, "kind = \"wear\"\nwall = \"floor\"\ncell = 0.1\narchard = \"1e-13 Pa\"", "`archard` is an inverse pressure; `1e-13 Pa` is a pressure; write for example"),
    (METER, "kind = \"heap\"\npoint = [0, 0, 0]\nup = [0, 0, 0]", "`up` is a zero vector; expected a direction"),
    (METER, "kind = \"residence\"\noutlet = \"out\"", "unknown key `outlet`"),
    ("kind = \"mass-flow\"", "kind = \"mass_flow\"", "unknown kind `mass_flow`; did you mean `mass-flow`?"),
    ("shape = { kind = \"half-space\",", "shape = { kind = \"pyramid\",", "unknown kind `pyramid`; expected `half-space`, `sphere`"),
    ("normal = [0, 0, 2] }", "normal = [0, 0, 0] }", "`normal` is a zero vector"),
    ("normal = [0, 0, 2] }", "normal = [0, 0] }", "`normal` has 2 values; expected a list of 3 values"),
    (WALL, "{ kind = \"torus\", center = [0, 0, 0], ring_radius = 0.2, tube_radius = 0.3 }", "`tube_radius` is 0.3 m and `ring_radius` 0.2 m; expected `tube_radius` below `ring_radius`"),
    (WALL, "{ kind = \"capsule\", base = [0, 0, 0], radius = 0, height = 1 }", "`radius` is 0; expected more than 0 m"),
    (WALL, "{ kind = \"shell\", thickness = \"600 mm\", of = { kind = \"box\", center = [0, 0, 0], size = [1, 2, 3] } }", "`thickness` is 0.6 m; expected less than 0.5 m, half of the smallest side of `of`; make the wall thinner"),
    (WALL, "{ kind = \"ellipsoid\", center = [0, 0, 0], half_axes = [1, 1] }", "`half_axes` has 2 values; expected a list of 3 values"),
    (WALL, "{ kind = \"mirror\", point = [0, 0, 0], normal = [0, 0, 0], of = { kind = \"sphere\", center = [0, 0, 0], radius = 1 } }", "`normal` is a zero vector; expected a direction"),
    (WALL, "{ kind = \"scale\", factor = 0, of = { kind = \"sphere\", center = [0, 0, 0], radius = 1 } }", "`factor` is 0; expected more than 0 and at most"),
    (WALL, "{ kind = \"offset\", by = \"-1 mm\", of = { kind = \"sphere\", center = [0, 0, 0], radius = 1 } }", "`by` is \"-1 mm\"; expected more than 0 m"),
    (WALL, "{ kind = \"offset\", by = 1, of = { kind = \"torus\", center = [0, 0, 0], ring_radius = 1, tube_radius = 1 } }", "`tube_radius` is 1 m and `ring_radius` 1 m"),
    ("count = 10", "count = 0", "`count` is 0; expected at least 1"),
    ("count = 10", "count = 10.5", "`count` is 10.5; expected a whole number"),
    ("count = 10", "count = 10\nmass = 1", "`count` and `mass` are both given; keep one"),
    ("count = 10", "count = 1_000_000_000", "this is about 1e9 pellets; expected at most 5e6"),
    ("end = \"1 s\"", "end = \"1 s\"\nstep = \"1 us\"\npeak_force_error = 0.01", "`step` and `peak_force_error` are both given"),
    ("end = \"1 s\"", "end = \"-1 s\"", "`end` is \"-1 s\"; expected more than 0 s"),
    ("end = \"1 s\"", "end = \"2 s\"\n[output]\nframe_interval = \"1 ns\"", "times in the run; expected at most 1e6"),
];

#[test]
fn each_mistake_names_its_line_its_key_and_its_cure() {
    for (good, bad, expected) in CASES {
        let text = spoiled(good, bad);
        assert!(text.contains(expected), "{bad}: {text}");
        let first_line = line_of(good);
        let last_line = first_line + bad.matches('\n').count();
        let is_on_line = (first_line.saturating_sub(3)..=last_line)
            .any(|line| text.starts_with(&format!("scene.toml:{line}: ")));
        assert!(
            is_on_line,
            "{bad}, lines {first_line} to {last_line}: {text}"
        );
        assert_eq!(text.matches("scene.toml:").count(), 1, "{bad}: {text}");
    }
}

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
