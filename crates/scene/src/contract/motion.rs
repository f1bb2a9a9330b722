//! Motions: what is read, and which tables are refused.

use super::{GOOD, draft};
use crate::Scene;
use pelletflow_core::Vec3;
use pelletflow_sim::{Interpolation, Motion, Swing};
use std::f64::consts::PI;

/// The good scene with a motion for its wall.
fn moved(motion: &str) -> String {
    GOOD.replacen(
        "[walls.floor]\n",
        &format!("[walls.floor]\nmotion = {motion}\n"),
        1,
    )
}

fn motion(written: &str) -> Motion {
    match draft(&moved(written)) {
        Ok(draft) => draft.resolved.setup.walls[0].motion.clone(),
        Err(mistakes) => panic!("{mistakes}"),
    }
}

#[test]
fn a_table_is_read_with_its_columns_and_defaults() {
    let Motion::Table(table) = motion(
        "{ kind = \"table\", moments = [0, \"500 ms\", 2], angles = [0, \"90 deg\", 0], axis = [0, 2, 0], interpolation = \"smooth\" }",
    ) else {
        panic!("not a table");
    };
    assert_eq!(table.moments, [0.0, 0.5, 2.0]);
    assert_eq!(table.displacements, [Vec3::zeros(); 3]);
    assert!((table.angles[1] - PI / 2.0).abs() < 1.0e-15);
    assert_eq!(table.axis, Vec3::y_axis());
    assert_eq!(table.center, Vec3::zeros());
    assert_eq!(table.interpolation, Interpolation::Smooth);
}

#[test]
fn a_list_of_motions_is_combined_in_its_order() {
    let Motion::Combined { motions } = motion(
        "[{ kind = \"rotating\", center = [0, 0, 0], axis = [0, 0, 1], rate = 1 }, \
         { kind = \"vibrating\", amplitude = [0, 0, \"1 mm\"], frequency = 20, \
           swing = { center = [1, 0, 0], axis = [0, 1, 0], angle = 0.01 } }]",
    ) else {
        panic!("not combined");
    };
    assert!(matches!(motions[0], Motion::Rotating { rate: 1.0, .. }));
    let swing = Swing {
        center: Vec3::x(),
        axis: Vec3::y_axis(),
        angle: 0.01,
    };
    assert!(matches!(motions[1], Motion::Vibrating { swing: Some(found), .. } if found == swing));
}

#[test]
fn a_table_that_cannot_be_followed_is_refused() {
    for (written, expected) in [
        (
            "{ kind = \"table\", moments = [0, 1] }",
            "walls.floor.motion: the table has neither `displacements` nor `angles`",
        ),
        (
            "{ kind = \"table\", moments = [0, 1], angles = [0] }",
            "walls.floor.motion.angles: `angles` has 1 values and `moments` 2; expected one for each moment",
        ),
        (
            "{ kind = \"table\", moments = [0], angles = [0] }",
            "`moments` has 1 values; expected a list of at least 2",
        ),
        (
            "{ kind = \"table\", moments = [0, 2, 1], angles = [0, 1, 0] }",
            "walls.floor.motion: the moment 1 s does not come after 2 s; let the moments of the table rise",
        ),
        (
            "[{ kind = \"fixed\" }, { kind = \"turning\" }]",
            "walls.floor.motion[1].kind: unknown kind `turning`",
        ),
        ("7", "expected a table or a list"),
    ] {
        let error = Scene::parse(&moved(written), "scene.toml", &[]).expect_err(written);
        assert!(error.to_string().contains(expected), "{written}: {error}");
    }
}
