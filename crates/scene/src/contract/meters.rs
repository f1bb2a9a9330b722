//! What the meters of a scene become.

use super::GOOD;
use super::good::setup;
use crate::Scene;
use pelletflow_core::Vec3;
use pelletflow_sim::{MeterKind, PlaneFlow, Residence, WallForce, Wear};
use std::collections::BTreeSet;

/// The scene with another meter.
fn metered(written: &str) -> String {
    GOOD.replacen("kind = \"mass-flow\"\noutlet = \"out\"", written, 1)
}

fn meter(written: &str) -> MeterKind {
    setup(&metered(written)).meters.remove(0).kind
}

#[test]
fn meters_are_read_with_their_defaults() {
    let plane = meter("kind = \"plane-flow\"\npoint = [0, 0, \"50 mm\"]\nnormal = [0, 0, -2]");
    let expected = PlaneFlow {
        point: Vec3::new(0.0, 0.0, 0.05),
        normal: -Vec3::z_axis(),
        radius: f64::INFINITY,
    };
    assert_eq!(plane, MeterKind::PlaneFlow(expected));
    // A half-space has no center.
    let force = meter("kind = \"wall-force\"\nwall = \"floor\"");
    let about = Vec3::zeros();
    assert_eq!(force, MeterKind::WallForce(WallForce { wall: 0, about }));
    let wear =
        meter("kind = \"wear\"\nwall = \"floor\"\ncell = \"50 mm\"\narchard = \"2e-13 1/Pa\"");
    let expected = Wear {
        wall: 0,
        cell: 0.05,
        archard: 2.0e-13,
        finnie: 0.0,
        least_speed: 0.1,
    };
    assert_eq!(wear, MeterKind::Wear(expected));
    assert_eq!(
        meter("kind = \"residence\""),
        MeterKind::Residence(Residence)
    );
}

#[test]
fn the_torque_on_a_wall_is_about_its_center_where_nothing_is_said() {
    let text = metered("kind = \"wall-force\"\nwall = \"floor\"").replacen(
        "{ kind = \"half-space\", point = [0, 0, 0], normal = [0, 0, 2] }",
        "{ kind = \"box\", min = [0, 0, -1], max = [2, 4, 0] }",
        1,
    );
    let MeterKind::WallForce(force) = setup(&text).meters.remove(0).kind else {
        panic!("it is a meter of the force on a wall");
    };
    assert_eq!(force.about, Vec3::new(1.0, 2.0, -0.5));
}

#[test]
fn a_box_inside_out_is_put_to_its_line() {
    let text = metered("kind = \"box\"\nmin = [0, 0, 1]\nmax = [1, 1, 0]");
    let error = Scene::parse(&text, "scene.toml", &[]).expect_err("inside out");
    let line = 1 + text
        .lines()
        .position(|line| line.starts_with("max = "))
        .expect("there");
    let start = format!("scene.toml:{line}: meters.flow.max: is 0 m along z and `min` 1 m");
    assert!(error.to_string().contains(&start), "{error}");
}

#[test]
fn the_guide_shows_a_meter_of_every_kind() {
    let guide = include_str!("../../../../docs/guide/scene.md");
    let blocks: Vec<&str> = guide
        .split("```toml\n")
        .skip(1)
        .filter_map(|block| block.split("```").next())
        .collect();
    let is_scene = |block: &&&str| block.starts_with("schema_version");
    let scene = blocks.iter().find(is_scene).expect("a complete scene");
    let (start, end) = (scene.find("[meters."), scene.find("[domain]"));
    let mut text = scene.to_string();
    text.drain(start.expect("it has meters")..end.expect("it has a domain"));
    for block in blocks.iter().filter(|block| block.starts_with("[meters.")) {
        text.push_str(block);
    }
    let shown: BTreeSet<&str> = match Scene::parse(&text, "guide", &[]) {
        Ok(_) => setup(&text)
            .meters
            .iter()
            .map(|meter| meter.kind.name())
            .collect(),
        Err(mistakes) => panic!("{mistakes}"),
    };
    assert_eq!(shown, MeterKind::NAMES.iter().copied().collect());
}
