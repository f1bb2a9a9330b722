//! Motions: what is read, and which tables are refused.

use super::{GOOD, draft};
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
