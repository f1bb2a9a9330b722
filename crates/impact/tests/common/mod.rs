//! Hits that the tests share.

use pelletflow_impact::ElasticImpact;

/// The paper's pellet on steel at a normal speed [m/s]: D 15 mm, E* `153.74e6` Pa, density 3700 kg/m³.
pub(crate) fn papers_pellet(speed: f64) -> ElasticImpact {
    let radius = 7.5e-3_f64;
    ElasticImpact {
        effective_youngs_modulus: 153.74e6,
        effective_radius: radius,
        effective_mass: 3700.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3),
        speed,
    }
}

/// Whether a value is within a share of what is expected.
pub(crate) fn is_near(found: f64, expected: f64, share: f64) -> bool {
    (found / expected - 1.0).abs() <= share
}
