//! Time, stopping, output, laws, limits and skips.

use super::{OutputOptions, Resolver};
use crate::key_path::KeyPath;
use crate::number::show;
use crate::quantity::Pause;
use crate::spec::header::{ContactSpec, NormalSpec, SearchSpec, TangentialSpec, TurningSpec};
use crate::spec::run::IntegratorSpec;
use crate::spec::run::{LimitsSpec, SkipSpec};
use pelletflow_core::contact::{ContactLaws, NormalLaw, TangentialLaw, TurningLaw};
use pelletflow_sim::{
    HitRequest, Integrator, KeptFrames, Limits, NeighborSearch, RunPlan, Skips, StepRequest,
    StopCondition,
};

/// Error of the peak force that a step is chosen for [-].
const PEAK_FORCE_ERROR: f64 = 1.0e-3;

/// Speed below which a bed counts as at rest: a third of a pellet per second [m/s].
const SETTLED_SPEED: f64 = 5.0e-3;

/// Frames of a run where nothing is said [-].
const FRAMES: f64 = 200.0;

/// Fewest frames of a short run [-].
const FEWEST_FRAMES: f64 = 20.0;

/// Least time between frames where nothing is said, as of a film [s].
const LEAST_FRAME_INTERVAL: f64 = 1.0 / 60.0;

/// Meter readings of a run where nothing is said [-].
const READINGS: f64 = 1000.0;

/// Most frames or readings of a recording [-].
const MOST_RECORDS: f64 = 1.0e6;

/// Time by the wall clock between checkpoints where nothing is said [s].
const CHECKPOINT_INTERVAL: f64 = 600.0;

/// Force from which on every hit is recorded in full, over the load that breaks a pellet [-].
const NOTEWORTHY_SHARE: f64 = 0.1;

/// Number of pellets up to which spheres are recorded where nothing is said [-].
const SPHERES_UP_TO: usize = 2000;

impl Resolver<'_> {
    pub(super) fn step(&mut self) -> StepRequest {
        let time = &self.spec.time;
        match (time.step, time.peak_force_error) {
            (Some(step), None) => {
                if step.0 > time.end.0 {
                    self.findings.add(
                        &KeyPath::of(["time", "step"]),
                        format!(
                            "`step` is {} s; expected at most `end`, {} s",
                            step.0, time.end.0
                        ),
                    );
                }
                StepRequest::Fixed(step.0)
            }
            (step, error) => {
                if step.is_some() {
                    self.findings.add(
                        &KeyPath::of(["time", "step"]),
                        "`step` and `peak_force_error` are both given; keep one, the other follows",
                    );
                }
                StepRequest::PeakForceError(error.map_or(PEAK_FORCE_ERROR, |error| error.0))
            }
        }
    }

    pub(super) fn plan(&mut self) -> RunPlan {
        let spec = self.spec;
        let end_time = spec.time.end.0;
        let frame_interval = spec.output.frame_interval.map_or_else(
            || {
                (end_time / FRAMES)
                    .max(LEAST_FRAME_INTERVAL)
                    .min(end_time / FEWEST_FRAMES)
            },
            |interval| interval.0,
        );
        let meter_interval = spec
            .output
            .meter_interval
            .map_or(end_time / READINGS, |interval| interval.0);
        for (key, interval) in [
            ("frame_interval", frame_interval),
            ("meter_interval", meter_interval),
        ] {
            if end_time / interval > MOST_RECORDS {
                self.findings.add(
                    &KeyPath::of(["output", key]),
                    format!(
                        "`{key}` is {} s, {} times in the run; expected at most {}: lengthen it",
                        show(interval),
                        show((end_time / interval).round()),
                        show(MOST_RECORDS)
                    ),
                );
            }
        }
        if spec.output.frame_interval.is_none() {
            self.notes.push(format!(
                "frames: one every {frame_interval:.4} s, chosen from the length of the run; set it with output.frame_interval"
            ));
        }
        RunPlan {
            end_time,
            stop: self.stop(),
            frame_interval,
            kept_frames: self.kept_frames(frame_interval),
            meter_interval,
            checkpoint_interval: checkpoint_interval(spec.output.checkpoint_interval),
        }
    }

    /// Which frames are kept, of those taken every `interval` [s].
    fn kept_frames(&mut self, interval: f64) -> KeptFrames {
        let (output, end) = (&self.spec.output, self.spec.time.end.0);
        let kept = KeptFrames {
            of_last: output.frames_of_last.map(|span| span.0),
            around_worst_hits: output.frames_around_worst_hits.map(|span| span.0),
        };
        let mut refuse = |key: &str, message: String| {
            self.findings.add(&KeyPath::of(["output", key]), message);
        };
        if let Some(span) = kept.of_last
            && span > end
        {
            refuse(
                "frames_of_last",
                format!(
                    "`frames_of_last` is {} s; expected at most `end`, {} s: leave it out to keep all frames",
                    show(span),
                    show(end)
                ),
            );
        }
        let Some(span) = kept.around_worst_hits else {
            return kept;
        };
        let key = "frames_around_worst_hits";
        if output.hits == Some(false) {
            refuse(
                key,
                format!("`{key}` does nothing where `hits` is false; leave one of them out"),
            );
        }
        // Else there would be hits without a frame.
        if span < interval / 2.0 {
            refuse(
                key,
                format!(
                    "`{key}` is {} s; expected at least half of the time between frames, {} s: lengthen it, or shorten \
                     `frame_interval`",
                    show(span),
                    show(interval / 2.0)
                ),
            );
        }
        kept
    }

    fn stop(&mut self) -> Vec<StopCondition> {
        let stop = &self.spec.stop;
        if stop.settled_speed.is_some() && stop.settled_after.is_none() {
            self.findings.add(
                &KeyPath::of(["stop", "settled_speed"]),
                "`settled_speed` does nothing without `settled_after`; add for example `settled_after = \"1 s\"`",
            );
        }
        let empty = stop
            .empty_after
            .map(|after| StopCondition::Empty { after: after.0 });
        let settled = stop.settled_after.map(|after| StopCondition::Settled {
            after: after.0,
            speed: stop.settled_speed.map_or(SETTLED_SPEED, |speed| speed.0),
        });
        empty.into_iter().chain(settled).collect()
    }

    /// What is kept of hits: of all that reach a tenth of the load that breaks a pellet, unless another is given.
    pub(super) fn hits(&mut self) -> Option<HitRequest> {
        let output = &self.spec.output;
        if output.hits == Some(false) {
            if output.hits_above.is_some() {
                self.findings.add(
                    &KeyPath::of(["output", "hits_above"]),
                    "`hits_above` does nothing where `hits` is false; leave one of them out",
                );
            }
            return None;
        }
        let of_strength = self
            .spec
            .strength
            .as_ref()
            .map(|strength| NOTEWORTHY_SHARE * strength.load.0);
        let threshold = output.hits_above.map(|force| force.0).or(of_strength);
        Some(HitRequest {
            threshold: threshold.unwrap_or(f64::INFINITY),
        })
    }

    pub(super) fn output(&self) -> OutputOptions {
        OutputOptions {
            spheres_up_to: self.spec.output.spheres_up_to.unwrap_or(SPHERES_UP_TO),
            contacts: self.spec.output.contacts.unwrap_or(false),
        }
    }
}

/// Time by the wall clock between checkpoints [s]; no time stands for none.
fn checkpoint_interval(asked: Option<Pause>) -> f64 {
    match asked {
        None => CHECKPOINT_INTERVAL,
        Some(Pause(interval)) if interval > 0.0 => interval,
        Some(_) => f64::INFINITY,
    }
}

pub(super) fn laws(spec: &ContactSpec) -> ContactLaws {
    let default = ContactLaws::default();
    ContactLaws {
        normal: match spec.normal {
            NormalSpec::Hertz => NormalLaw::Hertz,
            NormalSpec::Linear => NormalLaw::Linear,
            NormalSpec::Plastic => NormalLaw::Plastic,
            NormalSpec::Jkr => NormalLaw::Jkr,
        },
        tangential: match spec.tangential {
            TangentialSpec::None => TangentialLaw::None,
            TangentialSpec::Coulomb => TangentialLaw::Coulomb,
            TangentialSpec::Mindlin => TangentialLaw::Mindlin,
            TangentialSpec::PartialSlip => TangentialLaw::PartialSlip,
        },
        rolling: spec.rolling.map_or(default.rolling, turning_law),
        twisting: spec.twisting.map_or(default.twisting, turning_law),
    }
}

fn turning_law(spec: TurningSpec) -> TurningLaw {
    match spec {
        TurningSpec::None => TurningLaw::None,
        TurningSpec::ConstantTorque => TurningLaw::ConstantTorque,
        TurningSpec::SpringDashpot => TurningLaw::SpringDashpot,
    }
}

pub(super) fn integrator(spec: Option<IntegratorSpec>) -> Integrator {
    match spec {
        None => Integrator::default(),
        Some(IntegratorSpec::SemiImplicitEuler) => Integrator::SemiImplicitEuler,
        Some(IntegratorSpec::VelocityVerlet) => Integrator::VelocityVerlet,
        Some(IntegratorSpec::LocatedVerlet) => Integrator::LocatedVerlet,
    }
}

pub(super) fn search(spec: SearchSpec) -> NeighborSearch {
    match spec {
        SearchSpec::Auto => NeighborSearch::Auto,
        SearchSpec::Grid => NeighborSearch::Grid,
        SearchSpec::HierarchicalGrid => NeighborSearch::HierarchicalGrid,
        SearchSpec::Tree => NeighborSearch::Tree,
        SearchSpec::AllPairs => NeighborSearch::AllPairs,
    }
}

pub(super) fn limits(spec: &LimitsSpec) -> Limits {
    let default = Limits::default();
    Limits {
        overlap_ratio: spec
            .overlap_ratio
            .map_or(default.overlap_ratio, |share| share.0),
        energy_residual: spec
            .energy_residual
            .map_or(default.energy_residual, |share| share.0),
    }
}

pub(super) fn skips(spec: &SkipSpec) -> Skips {
    let default = Skips::default();
    Skips {
        rotation: spec.rotation.unwrap_or(default.rotation),
        distant_walls: spec.distant_walls.unwrap_or(default.distant_walls),
        free_flight: spec.free_flight.unwrap_or(default.free_flight),
    }
}
