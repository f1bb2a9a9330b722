//! Meters: what an engineer would read on site.

use crate::model::Model;
use crate::setup::Meter;
use crate::state::State;

/// What a meter reads.
#[derive(Debug, Clone, PartialEq)]
pub struct MeterReading {
    /// Name in the scene.
    pub name: String,
    /// What kind of meter it is, as in the scene: `mass-flow`, `wall-force`.
    pub kind: &'static str,
    /// Quantity with its unit in the name, such as `mass_flow_kg_per_s`, and its value.
    pub values: Vec<(&'static str, f64)>,
}

/// Time over which a mass flow is averaged [s].
const FLOW_AVERAGING_TIME: f64 = 0.1;

/// What every meter of a model reads.
pub(crate) fn readings(model: &Model, state: &State) -> Vec<MeterReading> {
    let books = &state.books;
    let read = |meter: &Meter| match *meter {
        Meter::MassFlow { outlet, .. } => {
            let since = state.steps_since_search as f64 * model.time_step().seconds;
            let tally = &books.by_outlet[outlet];
            MeterReading {
                name: meter.name().to_owned(),
                kind: "mass-flow",
                values: vec![
                    (
                        "mass_flow_kg_per_s",
                        averaged(books.outlet_flow[outlet], 0.0, since),
                    ),
                    ("mass_kg", tally.mass),
                    ("pellets", tally.count as f64),
                ],
            }
        }
        Meter::WallForce { wall, .. } => {
            let force = books.wall_force[wall];
            MeterReading {
                name: meter.name().to_owned(),
                kind: "wall-force",
                values: vec![
                    ("force_x_n", force.x),
                    ("force_y_n", force.y),
                    ("force_z_n", force.z),
                ],
            }
        }
    };
    model.setup().meters.iter().map(read).collect()
}

/// A running average of a flow, after a time [s] in which it came to `flow`; both flows in [kg/s].
///
/// A rational weight in place of the exponential: no function whose last bit depends on the platform.
pub(crate) fn averaged(average: f64, flow: f64, time: f64) -> f64 {
    average + (flow - average) * time / (FLOW_AVERAGING_TIME + time)
}
