//! The hits of `pelletflow check --walls`.

use crate::table::{self, number};
use pelletflow_scene::Scene;
use pelletflow_sim::{Spot, WallTrial, WallTrials};
use serde_json::{Value, json};

pub(super) fn page(scene: &Scene, walls: &[WallTrials]) -> String {
    let rows = walls.iter().flat_map(|wall| {
        Spot::ALL
            .iter()
            .zip(&wall.trials)
            .map(|(spot, trial)| row(&wall.wall, *spot, trial.as_ref()))
    });
    let header = [
        "wall",
        "spot",
        "at [m]",
        "force [N]",
        "by Hertz [N]",
        "off [%]",
        "rebound [-]",
    ];
    format!(
        "One elastic hit of a pellet of `{}` at {} m/s on each wall at rest\n\n{}",
        scene.setup.pellets[0].name,
        number(scene.model.time_step().expected_speed),
        table::listing(header, &[3, 4, 5, 6], rows)
    )
}

fn row(wall: &str, spot: Spot, trial: Option<&WallTrial>) -> [String; 7] {
    let told = |tell: &dyn Fn(&WallTrial) -> String| trial.map_or_else(|| "-".into(), tell);
    [
        wall.to_owned(),
        spot.name().to_owned(),
        told(&|trial| {
            let at = trial.place;
            format!("({:.4}, {:.4}, {:.4})", at.x, at.y, at.z)
        }),
        told(&|trial| number(trial.peak_force)),
        told(&|trial| number(trial.expected_force)),
        told(&|trial| format!("{:.3}", 100.0 * trial.force_error())),
        told(&|trial| format!("{:.4}", trial.rebound)),
    ]
}

pub(super) fn json(wall: &WallTrials) -> Value {
    let mut spots = json!({ "wall": wall.wall });
    for (spot, trial) in Spot::ALL.iter().zip(&wall.trials) {
        spots[spot.name()] = trial.map_or(Value::Null, |trial| {
            json!({
                "at_m": trial.place.as_slice(),
                "peak_force_n": trial.peak_force,
                "hertz_force_n": trial.expected_force,
                "force_error": trial.force_error(),
                "rebound": trial.rebound,
            })
        });
    }
    spots
}
