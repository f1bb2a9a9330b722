//! What contact laws need of the pairs of materials.

use crate::error::SetupError;
use crate::setup::Setup;
use crate::time_step;
use pelletflow_core::PairProperties;
use pelletflow_core::contact::NormalLaw;
use std::collections::BTreeSet;

/// Materials that can touch: those of pellets with each other and with those of walls, each pair once.
pub(crate) fn pairs_that_meet(setup: &Setup) -> Vec<[usize; 2]> {
    let of_pellets: BTreeSet<usize> = setup.pellets.iter().map(|kind| kind.material).collect();
    let of_walls: BTreeSet<usize> = setup.walls.iter().map(|wall| wall.material).collect();
    let mut pairs = BTreeSet::new();
    for &a in &of_pellets {
        for &b in of_pellets.iter().chain(&of_walls) {
            pairs.insert([a.min(b), a.max(b)]);
        }
    }
    pairs.into_iter().collect()
}

/// What the laws need and do not have, in a setup that has no other mistakes.
pub(crate) fn missing(setup: &Setup) -> Vec<SetupError> {
    let pairs = pairs_that_meet(setup);
    let is_given = |value: fn(&PairProperties) -> Option<f64>| {
        pairs
            .iter()
            .any(|[a, b]| setup.pair_properties(*a, *b).and_then(value).is_some())
    };
    match setup.laws.normal {
        NormalLaw::Linear => {
            let without = |[a, b]: &[usize; 2]| {
                let properties = setup.pair_properties(*a, *b);
                properties.is_some_and(|properties| properties.stiffness.is_none())
            };
            pairs
                .into_iter()
                .filter(without)
                .map(|pair| missing_stiffness(setup, pair))
                .collect()
        }
        NormalLaw::Plastic if !is_given(|properties| properties.yield_pressure) => {
            vec![SetupError::new(
                "contact.normal",
                "is `plastic`, but no pair of materials that meet has a `yield_pressure`; add one, such as \
                 `yield_pressure = \"20 MPa\"`, or use `hertz`",
            )]
        }
        NormalLaw::Jkr if !is_given(|properties| properties.surface_energy) => {
            vec![SetupError::new(
                "contact.normal",
                "is `jkr`, but no pair of materials that meet has a `surface_energy`; add one, such as \
                 `surface_energy = \"50 mJ/m2\"`, or use `hertz`",
            )]
        }
        _ => Vec::new(),
    }
}

fn missing_stiffness(setup: &Setup, pair: [usize; 2]) -> SetupError {
    let [a, b] = pair.map(|material| setup.materials[material].name.as_str());
    let stiffness = time_step::stiffness_of_fastest_hit(setup, pair);
    SetupError::new(
        format!("pairs.{a}-{b}.stiffness"),
        format!(
            "is missing, and the normal law `linear` needs it; `stiffness = {stiffness:.2e}` stores the fastest hit \
             expected at the overlap of Hertz"
        ),
    )
}
