//! What a scene without mistakes becomes.

use super::{GOOD, draft, draft_with};
use crate::{Override, OverrideError, Scene, TEMPLATES, parts_of, schema};
use pelletflow_core::Vec3;
use pelletflow_sim::{
    FillAmount, Motion, Rate, Seats, Setup, SizeDistribution, StepRequest, StopCondition,
};
use serde_json::json;

pub(super) fn setup(text: &str) -> Setup {
    match draft(text) {
        Ok(draft) => draft.resolved.setup,
        Err(mistakes) => panic!("{mistakes}"),
    }
}

#[test]
fn units_names_and_defaults_are_resolved() {
    let setup = setup(GOOD);
    assert_eq!(setup.gravity, Vec3::new(0.0, 0.0, -9.81));
    assert_eq!(setup.materials[0].name, "pellet");
    // E = 2 G (1 + ν); one rounding.
    assert!((setup.materials[0].material.youngs_modulus / 146.4e6 - 1.0).abs() < 1.0e-15);
    assert_eq!(setup.pairs[1].0, [1, 0]);
    assert_eq!(setup.pairs[0].1.rolling_friction, 0.0);
    assert_eq!(
        setup.pellets[0].size,
        SizeDistribution::Single { diameter: 0.015 }
    );
    assert!(matches!(
        setup.fills[0].seats,
        Seats::Lattice {
            amount: FillAmount::Count(10),
            ..
        }
    ));
    assert_eq!(setup.step, StepRequest::PeakForceError(1.0e-3));
    assert!(setup.skips.rotation && setup.skips.distant_walls);
}

#[test]
fn templates_and_examples_pass_every_gate() {
    let examples = [
        include_str!("../../../../examples/scenes/hopper.toml"),
        include_str!("../../../../examples/scenes/chute.toml"),
    ];
    let templates = TEMPLATES.iter().map(|template| template.text);
    for text in templates.chain(examples) {
        if let Err(error) = Scene::parse(text, "scene", &[]) {
            panic!("{error}");
        }
    }
}

#[test]
fn a_mistake_of_the_physics_is_put_to_its_line() {
    let text = format!(
        "{GOOD}
[inlets.feed]
pellets = \"ore\"
rate = \"5000 t/h\"
region = {{ kind = \"box\", center = [0, 0, 1], size = [0.1, 0.1, 0.1] }}
"
    );
    let rate = text.lines().position(|line| line.starts_with("rate = "));
    let line = 1 + rate.expect("there");
    let error = Scene::parse(&text, "scene.toml", &[]).expect_err("too fast");
    let expected = format!("scene.toml:{line}: inlets.feed.rate: ");
    assert!(error.to_string().starts_with(&expected), "{error}");
}

#[test]
fn a_belt_on_a_curved_wall_is_refused_with_the_cure() {
    let text = format!(
        "{GOOD}
[walls.pulley]
material = \"steel\"
shape = {{ kind = \"sphere\", center = [0, 0, 0.5], radius = 0.1 }}
surface_velocity = [\"2 m/s\", 0, 0]
"
    );
    let error = Scene::parse(&text, "scene.toml", &[]).expect_err("a ball is no belt");
    let expected = "walls.pulley.surface_velocity: moves the surface of a sphere along one straight line; \
                    expected a belt of plane faces, such as a box or a plate; let a round wall turn by `motion`";
    assert!(error.to_string().contains(expected), "{error}");
}

#[test]
fn gates_belts_feeders_and_stops_are_read() {
    let setup = setup(&format!(
        "{GOOD}
[walls.gate]
material = \"steel\"
shape = {{ kind = \"sphere\", center = [0, 0, 0], radius = 0.1 }}
opens_at = \"2 s\"
closes_at = \"1 s\"
surface_velocity = [\"2 m/s\", 0, 0]
motion = {{ kind = \"rotating\", center = [0, 0, 0], axis = [0, 0, 3], rate = \"30 rpm\" }}

[inlets.feed]
pellets = \"ore\"
rate = \"200 1/s\"
region = {{ kind = \"box\", center = [0, 0, 1], size = [0.1, 0.1, 0.1] }}
end = 0.5
"
    ));
    let gate = &setup.walls[1];
    assert!(
        !gate.schedule.is_present(0.0)
            && gate.schedule.is_present(1.5)
            && !gate.schedule.is_present(3.0)
    );
    assert_eq!(gate.surface_velocity.x, 2.0);
    assert!(
        matches!(gate.motion, Motion::Rotating { rate, .. } if (rate - std::f64::consts::PI).abs() < 1.0e-12)
    );
    assert_eq!(setup.inlets[0].rate, Rate::Count(200.0));
    assert_eq!(setup.inlets[0].end, 0.5);
    let plan = draft(&format!(
        "{GOOD}[stop]\nempty_after = 0.2\nsettled_after = 0.3\n"
    ))
    .expect("a plan")
    .resolved
    .plan;
    assert!(matches!(
        plan.stop[..],
        [
            StopCondition::Empty { after: 0.2 },
            StopCondition::Settled { after: 0.3, .. }
        ]
    ));
}

#[test]
fn pellets_are_placed_one_by_one() {
    let start = GOOD.find("count = 10").expect("there");
    let end = GOOD.find("[outlets.out]").expect("there");
    let placed = "at = [[0, 0, 0.1], [0, 0, \"300 mm\"]]\nspin = [0, 0, \"60 rpm\"]\n\n";
    let text = format!("{}{placed}{}", &GOOD[..start], &GOOD[end..]);
    let fill = setup(&text).fills.remove(0);
    assert_eq!(
        fill.seats,
        Seats::Points(vec![Vec3::new(0.0, 0.0, 0.1), Vec3::new(0.0, 0.0, 0.3)])
    );
    // One rounding of the product.
    assert!((fill.spin.z / std::f64::consts::TAU - 1.0).abs() < 1.0e-15);
}

#[test]
fn the_chosen_domain_holds_everything_and_is_noted() {
    let resolved = draft(GOOD).expect("good").resolved;
    let bounds = resolved.setup.domain.bounds;
    assert!(bounds.is_finite());
    assert!(
        bounds.contains(Vec3::new(0.1, 0.1, 0.2)) && bounds.contains(Vec3::new(0.0, 0.0, -1.1))
    );
    assert!(
        resolved
            .notes
            .iter()
            .any(|note| note.starts_with("domain: "))
    );
    let given = setup(&format!(
        "{GOOD}[domain]\nmin = [-1, -1, -2]\nmax = [1, 1, 1]\n"
    ));
    assert_eq!(given.domain.bounds.min, Vec3::new(-1.0, -1.0, -2.0));
}

#[test]
fn overrides_change_the_text_as_run_and_nothing_else() {
    let sets = [
        "pellets.ore.diameter=12 mm",
        "contact.rolling = \"none\"",
        "fill.bed.region.max=[0.2, 0.2, 0.2]",
        "scene.gravity=[0, 0, -1.6]",
        "walls.floor.shape.point.2=-0.5",
        "expect.\"mass.lost\"=0",
    ];
    let draft = draft_with(GOOD, &sets).expect("good");
    assert_eq!(
        draft.resolved.setup.pellets[0].size,
        SizeDistribution::Single { diameter: 0.012 }
    );
    assert_eq!(draft.resolved.setup.gravity.z, -1.6);
    assert!(
        draft.text.contains("diameter = \"12 mm\""),
        "{}",
        draft.text
    );
    let again = setup(&draft.text);
    assert_eq!(again, draft.resolved.setup);
    assert!(!draft.resolved.expectations.is_empty());
}

#[test]
fn of_overrides_that_meet_the_last_one_counts() {
    let end_time = |sets: &[&str]| {
        let draft = draft_with(GOOD, sets).expect("good");
        draft.resolved.plan.end_time
    };
    let whole = "time={end = 2.0}";
    assert_eq!(end_time(&["time.end=1.0", "time.end=3.0"]), 3.0);
    assert_eq!(end_time(&["time.end=1.0", whole]), 2.0);
    assert_eq!(end_time(&[whole, "time.end=1.0"]), 1.0);
    assert_eq!(end_time(&["time.end=1.0", whole, "\"time\".end=3.0"]), 3.0);
}

#[test]
fn the_order_of_overrides_that_do_not_meet_leaves_the_text_as_it_is() {
    // All are new to the scene, so that the text has to find a place for them.
    let sets = [
        "scene.seed=3",
        "scene.description=one",
        "output.hits=false",
        "contact.rolling=\"none\"",
    ];
    let mut reversed = sets;
    reversed.reverse();
    let text = |sets: &[&str]| draft_with(GOOD, sets).expect("good").text;
    assert_eq!(text(&sets), text(&reversed));
}

#[test]
fn a_value_is_set_as_json_has_it_and_null_is_none() {
    let set = Override::of_value("scene.\"a.b\".c", &json!([1, 2.5, "x\u{7f}"])).expect("a value");
    assert_eq!(
        parts_of(set.key()),
        Ok(vec!["scene".into(), "a.b".into(), "c".into()])
    );
    let again: Override = set.to_string().parse().expect("what it says of itself");
    assert_eq!(again.to_string(), set.to_string());
    for nothing in [json!(null), json!([null]), json!({ "end": null })] {
        let refused = Override::of_value("time.end", &nothing);
        assert_eq!(
            refused.err(),
            Some(OverrideError::NoValue("time.end".into()))
        );
    }
    let refused = Override::of_value("a=b", &json!(1));
    assert_eq!(refused.err(), Some(OverrideError::NotAKey("a=b".into())));
}

#[test]
fn expectations_are_held_against_a_summary() {
    let text = format!(
        "{GOOD}
[expect]
tolerance = \"1 %\"
\"mass.lost\" = 0
mass.inserted = 32.0
\"bodies.discharged\" = {{ min = 10 }}
\"contacts.max_overlap_ratio\" = {{ max = 0.05 }}
\"energy.kinetic_j\" = {{ value = 2.0, absolute = 0.1 }}
\"ended\" = \"empty\"
\"no.such_key\" = 1
"
    );
    let expectations = draft(&text).expect("good").resolved.expectations;
    let summary = json!({
        "mass": { "lost": 0.0, "inserted": 32.2 },
        "bodies": { "discharged": 9 },
        "contacts": { "max_overlap_ratio": 0.04 },
        "energy": { "kinetic_j": 2.05 },
        "ended": "end-time",
    });
    let outcomes = expectations.check(&summary);
    let met: Vec<(&str, bool)> = outcomes
        .iter()
        .map(|o| (o.key.as_str(), o.is_met))
        .collect();
    assert_eq!(
        met,
        [
            ("mass.lost", true),
            ("mass.inserted", true),
            ("bodies.discharged", false),
            ("contacts.max_overlap_ratio", true),
            ("energy.kinetic_j", true),
            ("ended", false),
            ("no.such_key", false),
        ]
    );
    assert_eq!(outcomes[6].found, "nothing");
    assert_eq!(outcomes[2].expected, "at least 10");
    assert_eq!(outcomes[4].expected, "2 ± 0.1");
}

#[test]
fn the_schema_is_draft_7_and_refuses_unknown_keys_everywhere() {
    let schema = schema();
    assert!(
        schema["$schema"]
            .as_str()
            .is_some_and(|id| id.contains("draft-07"))
    );
    let mut tables = 0;
    every_object(&schema, &mut |object| {
        if object["properties"].is_object() && object["properties"].get("tolerance").is_none() {
            tables += 1;
            assert_eq!(object["additionalProperties"], false, "{object:#}");
        }
        assert_ne!(object["type"], "null");
    });
    // Seventeen kinds of shape, four of motion, eight meters, and some twenty tables.
    assert!(tables > 30, "{tables}");
}

fn every_object(value: &serde_json::Value, visit: &mut impl FnMut(&serde_json::Value)) {
    match value {
        serde_json::Value::Object(object) => {
            visit(value);
            object.values().for_each(|inner| every_object(inner, visit));
        }
        serde_json::Value::Array(list) => list.iter().for_each(|inner| every_object(inner, visit)),
        _ => {}
    }
}

#[test]
fn a_screen_analysis_is_read_as_diameters_by_mass() {
    let text = GOOD.replace(
        "diameter = \"15 mm\"",
        "diameter = { openings = [\"10 mm\", \"12 mm\", \"16 mm\"], passing = [0, \"30 %\", 1] }",
    );
    let draft = draft_with(&text, &[]).expect("no mistake");
    assert_eq!(
        draft.resolved.setup.pellets[0].size,
        SizeDistribution::Sieve {
            openings: vec![0.010, 0.012, 0.016],
            passing: vec![0.0, 0.3, 1.0],
        }
    );
}
