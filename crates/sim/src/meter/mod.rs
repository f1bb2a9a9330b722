//! Meters: what an engineer would read on site.
//!
//! To add one: write its file with an `Instrument`, then add its module and its row to the table below,
//! and a sample to `contract.rs`; the contract tests then loop over it.
//!
//! A step is watched after it is done, by one thread and in a fixed order, so that no reading depends on the threads.
//! A scene pays for the meters that it has: contacts with a wall are noted only where a meter asks for that wall.

mod heap;
mod mass_flow;
mod patch;
mod plane_flow;
mod region;
mod registry;
mod residence;
mod sample;
mod touch;
mod wall_force;
mod wall_impacts;
mod wear;

pub use patch::PatchTable;
pub(crate) use touch::WallTouch;

use crate::model::Model;
use crate::setup::Setup;
use crate::state::State;
use crate::wall::WallNow;
use pelletflow_core::Vec3;
use registry::registry;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;

registry! {
    /// Mass discharged through one outlet, and its rate.
    MassFlow in mass_flow,
    /// Mass and pellets that pass a plane or a disc of it, by direction.
    PlaneFlow in plane_flow,
    /// Force and torque of all pellets on one wall.
    WallForce in wall_force,
    /// Impacts on one wall and their energy, patch by patch.
    WallImpacts in wall_impacts,
    /// Wear of one wall by impacts and by sliding, patch by patch.
    Wear in wear,
    /// Density, velocity and agitation of the pellets in a box.
    Region in region,
    /// How long pellets stay.
    Residence in residence,
    /// Angle of repose of a heap.
    Heap in heap,
}

/// What is measured while the run goes on.
#[derive(Debug, Clone, PartialEq)]
pub struct Meter {
    /// Name in the scene.
    pub name: String,
    /// What it measures.
    pub kind: MeterKind,
}

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

/// Quantities with their units in their names, and their values.
pub(crate) type Values = Vec<(&'static str, f64)>;

/// One way of measuring; what it does not need it leaves out.
pub(crate) trait Instrument {
    /// What it gathers.
    type Record: Debug + Clone + PartialEq + Default + Serialize + DeserializeOwned;

    /// Name in scenes.
    const NAME: &'static str;

    /// What cannot be measured: keys of the meter's table, and what is wrong there.
    fn mistakes(&self, _setup: &Setup) -> Vec<(&'static str, String)> {
        Vec::new()
    }

    /// The wall whose contacts it watches, by index.
    fn wall(&self) -> Option<usize> {
        None
    }

    /// Whether a record read back can be one: it leads to pellets that are there, of which there are so many [-], and what it
    /// counts can be counted on.
    fn fits(&self, _record: &Self::Record, _pellets: usize) -> bool {
        true
    }

    /// Takes note of the pellets after they have been stored anew.
    fn list(&self, _record: &mut Self::Record, _model: &Model, _state: &State) {}

    /// Watches a step that has been done.
    fn watch(&self, _record: &mut Self::Record, _step: &Watched) {}

    /// Takes note of a pellet that leaves through an outlet after a time inside [s].
    fn discharge(&self, _record: &mut Self::Record, _age: f64) {}

    /// What it reads: the same names at any time, and finite numbers.
    fn values(&self, record: &Self::Record, model: &Model, state: &State) -> Values;

    /// What each patch of its wall received, the worst first.
    fn patches(&self, _record: &Self::Record) -> Option<PatchTable> {
        None
    }
}

/// A step that has been done, as meters see it.
pub(crate) struct Watched<'a> {
    pub(crate) model: &'a Model,
    /// Pellets at the end of the step.
    pub(crate) state: &'a State,
    /// Walls at the start of the step.
    pub(crate) walls: &'a [WallNow],
    /// Contacts with the walls that are watched, in the order of the chunks.
    pub(crate) touches: &'a [WallTouch],
}

impl Watched<'_> {
    /// The time step [s].
    pub(crate) fn time_step(&self) -> f64 {
        self.model.time_step().seconds
    }

    /// The contacts with one wall.
    pub(crate) fn touches_of(&self, wall: usize) -> impl Iterator<Item = &WallTouch> {
        self.touches.iter().filter(move |touch| touch.wall == wall)
    }
}

/// Records of a run that has not begun.
pub(crate) fn records(model: &Model) -> Vec<Record> {
    let meters = model.setup().meters.iter();
    meters.map(|meter| meter.kind.record()).collect()
}

/// Lets the meters take note of the pellets after they have been stored anew.
pub(crate) fn list(model: &Model, state: &mut State) {
    let mut records = std::mem::take(&mut state.meters);
    for (record, meter) in records.iter_mut().zip(&model.setup().meters) {
        record.list(&meter.kind, model, state);
    }
    state.meters = records;
}

/// Lets the meters watch a step that has been done.
pub(crate) fn watch(model: &Model, state: &mut State, walls: &[WallNow], touches: &[WallTouch]) {
    let mut records = std::mem::take(&mut state.meters);
    let step = Watched {
        model,
        state,
        walls,
        touches,
    };
    for (record, meter) in records.iter_mut().zip(&model.setup().meters) {
        record.watch(&meter.kind, &step);
    }
    state.meters = records;
}

/// Lets the meters take note of a pellet that leaves through an outlet.
pub(crate) fn discharge(model: &Model, state: &mut State, index: usize) {
    let age = residence::age(model, state, index);
    for (record, meter) in state.meters.iter_mut().zip(&model.setup().meters) {
        record.discharge(&meter.kind, age);
    }
}

/// What every meter of a model reads.
pub(crate) fn readings(model: &Model, state: &State) -> Vec<MeterReading> {
    let meters = model.setup().meters.iter().zip(&state.meters);
    meters
        .map(|(meter, record)| MeterReading {
            name: meter.name.clone(),
            kind: meter.kind.name(),
            values: record.values(&meter.kind, model, state),
        })
        .collect()
}

/// What each patch of a wall received, by name of the meter.
pub(crate) fn patch_tables(model: &Model, state: &State) -> Vec<(String, PatchTable)> {
    let meters = model.setup().meters.iter().zip(&state.meters);
    meters
        .filter_map(|(meter, record)| Some((meter.name.clone(), record.patches(&meter.kind)?)))
        .collect()
}

/// The mistake of an index that leads nowhere.
fn unknown(key: &'static str, index: usize, count: usize) -> Vec<(&'static str, String)> {
    if index < count {
        return Vec::new();
    }
    let message = format!("is number {index}, and the setup has {count}; name one of them");
    vec![(key, message)]
}

/// The mistake of a point that is nowhere.
fn not_finite(key: &'static str, point: Vec3) -> Vec<(&'static str, String)> {
    if point.iter().all(|coordinate| coordinate.is_finite()) {
        return Vec::new();
    }
    vec![(key, "is not finite; expected three numbers in m".into())]
}

/// Time over which a flow is averaged [s].
const FLOW_AVERAGING_TIME: f64 = 0.1;

/// A running average of a flow, after a time [s] in which it came to `flow`; both flows in [kg/s].
///
/// A rational weight in place of the exponential: no function whose last bit depends on the platform.
pub(crate) fn averaged(average: f64, flow: f64, time: f64) -> f64 {
    average + (flow - average) * time / (FLOW_AVERAGING_TIME + time)
}

#[cfg(test)]
mod contract;
