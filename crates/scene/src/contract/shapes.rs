//! Shapes stand where they are put.

use super::GOOD;
use super::good::setup;
use pelletflow_core::Vec3;
use pelletflow_sim::WallShape;

/// The scene with another shape for its wall.
fn shape(written: &str) -> WallShape {
    let kept = "{ kind = \"half-space\", point = [0, 0, 0], normal = [0, 0, 2] }";
    setup(&GOOD.replacen(kept, written, 1))
        .walls
        .remove(0)
        .shape
}

/// Shapes, each with a point of its surface and the way out there.
const PLACED: &[(&str, [f64; 3], [f64; 3])] = &[
    (
        "{ kind = \"sphere\", center = [1, 2, 3], radius = 0.5 }",
        [1.5, 2.0, 3.0],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"cylinder\", base = [0, 0, 1], radius = 0.5, height = 2 }",
        [0.1, 0.0, 3.0],
        [0.0, 0.0, 1.0],
    ),
    (
        "{ kind = \"cylinder\", base = [0, 0, 1], axis = [1, 0, 0], radius = 0.5, height = 2 }",
        [2.0, 0.1, 1.0],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"cone\", base = [0, 0, 1], axis = [0, 0, -1], lower_radius = 0.5, upper_radius = 0.2, height = 2 }",
        [0.1, 0.0, -1.0],
        [0.0, 0.0, -1.0],
    ),
    (
        "{ kind = \"torus\", center = [1, 0, 0], axis = [1, 0, 0], ring_radius = 0.5, tube_radius = 0.2 }",
        [1.2, 0.0, 0.5],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"capsule\", base = [0, 0, 1], axis = [0, -1, 0], radius = 0.5, height = 2 }",
        [0.0, -2.5, 1.0],
        [0.0, -1.0, 0.0],
    ),
    (
        "{ kind = \"box\", min = [0, 0, 0], max = [1, 2, 3] }",
        [0.5, 2.0, 1.5],
        [0.0, 1.0, 0.0],
    ),
    (
        "{ kind = \"box\", center = [1, 1, 1], size = [1, 1, 1] }",
        [1.0, 1.0, 0.5],
        [0.0, 0.0, -1.0],
    ),
    (
        "{ kind = \"plate\", center = [0, 0, 1], size = [2, 1, 0.1], incline = \"30 deg\" }",
        [0.0, 0.0, 1.0],
        [0.5, 0.0, 0.866_025_403_784_438_6],
    ),
    (
        "{ kind = \"plate\", center = [0, 0, 1], size = [2, 1, 0.1], incline = \"30 deg\", heading = \"90 deg\" }",
        [0.0, 0.0, 1.0],
        [0.0, 0.5, 0.866_025_403_784_438_6],
    ),
    (
        "{ kind = \"revolution\", profile = [[0.2, 0], [0.4, 0], [0.4, 1], [0.2, 1]], base = [0, 0, 2] }",
        [0.3, 0.0, 3.0],
        [0.0, 0.0, 1.0],
    ),
    (
        "{ kind = \"revolution\", profile = [[0.3, 0], [0.3, 1]], thickness = 0.1 }",
        [0.35, 0.0, 0.5],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"union\", of = [{ kind = \"sphere\", center = [0, 0, 0], radius = 1 }, { kind = \"sphere\", center = [3, 0, 0], radius = 1 }] }",
        [4.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"difference\", of = { kind = \"sphere\", center = [0, 0, 0], radius = 1 }, minus = { kind = \"sphere\", center = [0, 0, 0], radius = 0.5 } }",
        [0.0, 0.5, 0.0],
        [0.0, -1.0, 0.0],
    ),
    (
        "{ kind = \"ellipsoid\", center = [1, 0, 0], half_axes = [0.1, \"200 mm\", 0.3] }",
        [1.0, -0.2, 0.0],
        [0.0, -1.0, 0.0],
    ),
    (
        "{ kind = \"mirror\", point = [2, 0, 0], normal = [3, 0, 0], of = { kind = \"sphere\", center = [0, 1, 0], radius = 1 } }",
        [5.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"scale\", factor = 2, about = [0, 0, 1], of = { kind = \"sphere\", center = [0, 0, 2], radius = 1 } }",
        [0.0, 0.0, 5.0],
        [0.0, 0.0, 1.0],
    ),
    (
        "{ kind = \"blend\", radius = \"20 mm\", of = [{ kind = \"sphere\", center = [0, 0, 1], radius = 1 }] }",
        [1.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"shell\", thickness = 0.2, of = { kind = \"sphere\", center = [0, 0, 1], radius = 1 } }",
        [0.8, 0.0, 1.0],
        [-1.0, 0.0, 0.0],
    ),
    (
        "{ kind = \"offset\", by = \"100 mm\", of = { kind = \"box\", min = [0, 0, 0], max = [1, 2, 3] } }",
        [1.06, 2.08, 1.0],
        [0.6, 0.8, 0.0],
    ),
    (
        "{ kind = \"sphere\", center = [1, 0, 0], radius = 0.5, rotate = { axis = [0, 0, 1], angle = \"90 deg\", about = [2, 0, 0] }, translate = [0, 0, 1] }",
        [2.0, -1.5, 1.0],
        [0.0, -1.0, 0.0],
    ),
];

#[test]
fn shapes_stand_where_they_are_put() {
    for (written, point, normal) in PLACED {
        let surface = shape(written).surface(Vec3::from(*point));
        // Rounding of a few turns and moves.
        assert!(surface.distance.abs() < 1.0e-12, "{written}: {surface:?}");
        assert!(
            (surface.normal - Vec3::from(*normal)).norm() < 1.0e-12,
            "{written}: {surface:?}"
        );
    }
}
