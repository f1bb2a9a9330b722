//! `summary.json`: a run in numbers.

use crate::counts_before::CountsBefore;
use crate::hit_summary::HitSummary;
use crate::message::series;
use crate::patches;
use crate::profile;
use crate::recording::RecordingTimes;
use pelletflow_sim::{MassLedger, PatchTable, Setup, Simulation, Skipped};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;

/// A run in numbers; each key ends in its unit where it has one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Version of this table [-].
    pub schema_version: u32,
    /// Version of pelletflow.
    pub version: String,
    /// Name of the scene.
    pub scene: String,
    /// Hash of the scene as it was run.
    pub scene_hash: String,
    /// Seed of every random draw [-].
    pub seed: u64,
    /// Threads at work [-].
    pub threads: usize,
    /// How long it took, in the scene and at the desk.
    pub time: TimeSummary,
    /// Where every pellet went, by number.
    pub bodies: BodySummary,
    /// Where every pellet went, by mass.
    pub mass: MassSummary,
    /// What contacts have done.
    pub contacts: ContactSummary,
    /// Contacts followed from first touch to release; none where the scene asks for none.
    #[serde(default)]
    pub hits: Option<HitSummary>,
    /// Where the energy went.
    pub energy: EnergySummary,
    /// How fast it ran.
    pub performance: PerformanceSummary,
    /// Work that was left out.
    pub skipped: Vec<SkippedSummary>,
    /// Last reading of each meter, by name.
    pub meters: BTreeMap<String, MeterSummary>,
    /// Fed by each inlet, by name.
    pub inlets: BTreeMap<String, TallySummary>,
    /// Left through each outlet, by name.
    pub outlets: BTreeMap<String, TallySummary>,
    /// Hash of the last state, equal only for equal bits.
    pub state_hash: String,
    /// Why the run ended.
    pub ended: Ended,
    /// What failed, where something did.
    pub failure: Option<String>,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ended {
    /// The time asked for has passed.
    EndTime,
    /// No pellet is inside any more.
    Empty,
    /// The bed has come to rest.
    Settled,
    /// It was told to stop.
    Interrupted,
    /// The physics or the output failed.
    Failed,
}

/// How long a run took, in the scene and at the desk.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TimeSummary {
    /// Simulated time at the end [s].
    pub simulated_s: f64,
    /// Time by the wall clock, recording included [s].
    pub wall_s: f64,
    /// Steps taken [-].
    pub steps: u64,
    /// The step [s].
    pub step_s: f64,
    /// Why the step is what it is.
    pub step_reason: String,
    /// Steps of a contact that closed and opened, on average [-]; 0 where none did.
    pub steps_per_contact: f64,
}

/// Where every pellet went, by number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct BodySummary {
    /// Put in by fills and inlets [-].
    pub inserted: u64,
    /// Inside at the end [-].
    pub inside: u64,
    /// Left through an outlet [-].
    pub discharged: u64,
    /// Left elsewhere [-].
    pub lost: u64,
}

/// Where every pellet went, by mass.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MassSummary {
    /// Put in by fills and inlets [kg].
    pub inserted: f64,
    /// Inside at the end [kg].
    pub inside: f64,
    /// Left through an outlet [kg].
    pub discharged: f64,
    /// Left elsewhere [kg].
    pub lost: f64,
    /// What the books miss [kg].
    pub residual_kg: f64,
}

/// What contacts have done.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactSummary {
    /// Greatest normal force [N].
    pub max_force_n: f64,
    /// Greatest overlap over the smaller radius [-].
    pub max_overlap_ratio: f64,
    /// Contacts per pellet at the end [-].
    pub mean_coordination: f64,
    /// Contacts open at the end [-].
    pub open: u64,
    /// Contacts that opened and closed again [-].
    pub finished: u64,
    /// Steps that the shortest of those lasted [-]; 0 where none did.
    pub fewest_steps_per_contact: u64,
}

/// Where the energy went.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EnergySummary {
    /// Of motion and spin at the end [J].
    pub kinetic_j: f64,
    /// In gravity at the end [J].
    pub potential_j: f64,
    /// In contact springs at the end [J].
    pub elastic_j: f64,
    /// Turned into heat [J].
    pub dissipated_j: f64,
    /// What the books miss [J].
    pub residual_j: f64,
    /// Brought in by pellets, less that taken out [J].
    pub carried_in_j: f64,
    /// Done by moving walls and belts [J].
    pub wall_work_j: f64,
    /// Went through the books [J].
    pub throughput_j: f64,
}

/// How fast a run went.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PerformanceSummary {
    /// Pellets times steps, per second of the wall clock [1/s].
    pub particle_steps_per_s: f64,
    /// Contacts times steps, per second of the wall clock [1/s].
    pub contact_steps_per_s: f64,
    /// Most memory that the process held [B]; unknown on some systems.
    pub peak_memory_bytes: Option<u64>,
    /// Time spent in each part of the run [s], by name.
    ///
    /// All but that of `writer`, which works while the run goes on, add up to the run; `other` is in no named part.
    pub phases: BTreeMap<String, f64>,
}

/// Work that was left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SkippedSummary {
    /// What was skipped.
    pub what: String,
    /// Why it could be.
    pub reason: String,
    /// What it saved.
    pub saved: String,
}

/// Last reading of a meter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeterSummary {
    /// What kind of meter it is.
    pub kind: String,
    /// Quantities, each with its unit in the name.
    #[serde(flatten)]
    pub values: BTreeMap<String, f64>,
    /// The worst patches of the wall, each with its place, where the meter keeps patches.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub worst: Vec<PatchSummary>,
}

/// What one patch of a wall received, each quantity with its unit in the name.
pub type PatchSummary = BTreeMap<String, f64>;

/// A number of pellets and their mass.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TallySummary {
    /// How many [-].
    pub count: u64,
    /// Their mass [kg].
    pub mass_kg: f64,
}

/// What a simulation does not know of its run.
pub(crate) struct RunFacts<'a> {
    pub(crate) scene: &'a str,
    pub(crate) scene_hash: &'a str,
    /// Time by the wall clock [s].
    pub(crate) wall_time: f64,
    pub(crate) recording_times: RecordingTimes,
    pub(crate) before: CountsBefore,
    pub(crate) ended: Ended,
    pub(crate) failure: Option<String>,
}

/// Version of the summary's keys [-].
const SCHEMA_VERSION: u32 = 1;

impl Summary {
    pub(crate) fn new(simulation: &Simulation, facts: &RunFacts) -> Self {
        let model = simulation.model();
        let ledger = simulation.mass_ledger();
        let contacts = simulation.contact_statistics();
        let energy = simulation.energy_ledger();
        let rate = |now: u64, before: u64| {
            if facts.wall_time > 0.0 {
                now.saturating_sub(before) as f64 / facts.wall_time
            } else {
                0.0
            }
        };
        let (inlets, outlets) = totals(model.setup(), &ledger);
        Self {
            schema_version: SCHEMA_VERSION,
            version: env!("CARGO_PKG_VERSION").into(),
            scene: facts.scene.into(),
            scene_hash: facts.scene_hash.into(),
            seed: model.setup().seed,
            threads: simulation.threads(),
            time: TimeSummary {
                simulated_s: simulation.time(),
                wall_s: facts.wall_time,
                steps: simulation.step_count(),
                step_s: model.time_step().seconds,
                step_reason: model.time_step().reason.clone(),
                steps_per_contact: contacts.mean_steps,
            },
            bodies: BodySummary {
                inserted: ledger.inserted.count,
                inside: ledger.inside.count,
                discharged: ledger.discharged.count,
                lost: ledger.lost.count,
            },
            mass: MassSummary {
                inserted: ledger.inserted.mass,
                inside: ledger.inside.mass,
                discharged: ledger.discharged.mass,
                lost: ledger.lost.mass,
                residual_kg: series::mass_residual(&ledger),
            },
            contacts: ContactSummary {
                max_force_n: contacts.max_force,
                max_overlap_ratio: contacts.max_overlap_ratio,
                mean_coordination: contacts.mean_coordination,
                open: contacts.open,
                finished: contacts.finished,
                fewest_steps_per_contact: contacts.fewest_steps,
            },
            hits: HitSummary::of(simulation),
            energy: EnergySummary {
                kinetic_j: energy.kinetic,
                potential_j: energy.potential,
                elastic_j: energy.elastic,
                dissipated_j: energy.dissipated,
                residual_j: energy.residual,
                carried_in_j: energy.carried_in,
                wall_work_j: energy.wall_work,
                throughput_j: energy.throughput,
            },
            performance: PerformanceSummary {
                particle_steps_per_s: rate(
                    simulation.particle_steps(),
                    facts.before.particle_steps,
                ),
                contact_steps_per_s: rate(contacts.contact_steps, facts.before.contact_steps),
                peak_memory_bytes: peak_memory(),
                phases: profile::phases(
                    facts.wall_time,
                    &facts.before.phases,
                    &simulation.phases(),
                    &facts.recording_times,
                ),
            },
            skipped: simulation.skipped().into_iter().map(skipped).collect(),
            meters: meters(simulation),
            inlets,
            outlets,
            state_hash: simulation.state_hash(),
            ended: facts.ended,
            failure: facts.failure.clone(),
        }
    }
}

fn skipped(skipped: Skipped) -> SkippedSummary {
    SkippedSummary {
        what: skipped.what.into(),
        reason: skipped.reason,
        saved: skipped.saved,
    }
}

fn meters(simulation: &Simulation) -> BTreeMap<String, MeterSummary> {
    let tables: BTreeMap<String, PatchTable> = simulation.patch_tables().into_iter().collect();
    simulation
        .meter_readings()
        .into_iter()
        .map(|reading| {
            let summary = MeterSummary {
                kind: reading.kind.into(),
                values: reading
                    .values
                    .iter()
                    .map(|(quantity, value)| ((*quantity).into(), *value))
                    .collect(),
                worst: tables
                    .get(&reading.name)
                    .map_or_else(Vec::new, patches::worst),
            };
            (reading.name, summary)
        })
        .collect()
}

type Totals = BTreeMap<String, TallySummary>;

fn totals(setup: &Setup, ledger: &MassLedger) -> (Totals, Totals) {
    let inlets = setup.inlets.iter().map(|inlet| inlet.name.clone());
    let outlets = setup.outlets.iter().map(|outlet| outlet.name.clone());
    let tally = |tally: &pelletflow_sim::PelletTally| TallySummary {
        count: tally.count,
        mass_kg: tally.mass,
    };
    (
        inlets.zip(ledger.by_inlet.iter().map(tally)).collect(),
        outlets.zip(ledger.by_outlet.iter().map(tally)).collect(),
    )
}

/// Most memory that this process has held [B], where the system tells.
fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}
