//! What scenes promise: every mistake is found, named and put to its line.

mod domain;
mod fill;
mod good;
mod meters;
mod mistakes;
mod motion;
mod shapes;

use crate::draft::Draft;
use crate::mistakes::{Mistakes, SceneError};
use crate::overrides::Override;
use crate::source::Source;

/// A small scene without mistakes, to spoil in one way or another.
const GOOD: &str = r#"schema_version = 1

[materials.pellet]
density = "3700 kg/m3"
shear_modulus = "60 MPa"
poisson_ratio = 0.22

[materials.steel]
density = 7850
youngs_modulus = "207 GPa"
poisson_ratio = 0.28

[pairs."pellet-pellet"]
restitution = 0.4
friction = 0.5

[pairs."steel-pellet"]
restitution = 0.5
friction = 0.4
rolling_friction = 0.1

[pellets.ore]
material = "pellet"
diameter = "15 mm"

[walls.floor]
material = "steel"
shape = { kind = "half-space", point = [0, 0, 0], normal = [0, 0, 2] }

[fill.bed]
pellets = "ore"
count = 10
region = { kind = "box", min = [0, 0, 0.1], max = [0.1, 0.1, "200 mm"] }

[outlets.out]
region = { kind = "half-space", point = [0, 0, -1], normal = [0, 0, 1] }

[meters.flow]
kind = "mass-flow"
outlet = "out"

[time]
end = "1 s"
"#;

fn draft(text: &str) -> Result<Draft, Mistakes> {
    Draft::new(Source::new("scene.toml", text)?, "scene", &[]).map_err(mistakes)
}

fn mistakes(error: SceneError) -> Mistakes {
    match error {
        SceneError::Invalid(mistakes) => mistakes,
        unreadable @ SceneError::Unreadable { .. } => panic!("{unreadable}"),
    }
}

fn draft_with(text: &str, overrides: &[&str]) -> Result<Draft, Mistakes> {
    let overrides: Vec<Override> = overrides
        .iter()
        .map(|set| set.parse().expect("an override"))
        .collect();
    Draft::new(Source::new("scene.toml", text)?, "scene", &overrides).map_err(mistakes)
}

/// The mistakes of the good scene after a replacement, as printed.
fn spoiled(good: &str, bad: &str) -> String {
    assert!(GOOD.contains(good), "{good}");
    match draft(&GOOD.replacen(good, bad, 1)) {
        Ok(_) => panic!("`{bad}` was accepted"),
        Err(mistakes) => mistakes.to_string(),
    }
}

/// Line of the good scene on which a text stands [-].
fn line_of(text: &str) -> usize {
    let place = GOOD.find(text).expect("a text of the good scene");
    1 + GOOD[..place].matches('\n').count()
}
