//! The course of a run: steps, and what is recorded between them.

use crate::message::event::Gravity;
use crate::recording::{Due, Frame, Recording};
use crate::run::Progress;
use crate::summary::Ended;
use mcap::{McapError, McapResult};
use pelletflow_core::Pose;
use pelletflow_sim::{PelletView, RunPlan, Simulation, StepError, StopCondition};
use std::fs::File;
use std::io::{self, BufWriter};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Time by the wall clock between two looks of the observer.
const OBSERVER_INTERVAL: Duration = Duration::from_millis(20);
/// Time by the wall clock after which a chunk ends even if it is small: what a killed run loses.
const FLUSH_INTERVAL: Duration = Duration::from_secs(2);

/// Steps taken between two looks at the run, at most: each look wakes the threads anew.
///
/// A number and not a time, so that stop conditions are met at the same step in every run.
const LONGEST_STRIDE: u64 = 16;

/// What stops a run before its end.
pub(crate) enum Stop {
    Physics(StepError),
    Output(McapError),
}

impl From<McapError> for Stop {
    fn from(error: McapError) -> Self {
        Self::Output(error)
    }
}

/// A run on its way, and what of it is recorded.
pub(crate) struct Course {
    recording: Recording<BufWriter<File>>,
    is_present: Vec<bool>,
    /// Step of the last frame [-].
    last_frame: Option<u64>,
    /// Step of the last meter reading [-].
    last_reading: Option<u64>,
}

impl Course {
    /// A run of which nothing is recorded yet.
    pub(crate) fn new(recording: Recording<BufWriter<File>>) -> Self {
        Self {
            recording,
            is_present: Vec::new(),
            last_frame: None,
            last_reading: None,
        }
    }

    /// Steps to the end, recording what is due on the way.
    pub(crate) fn drive(
        &mut self,
        simulation: &mut Simulation,
        plan: &RunPlan,
        observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Ended, Stop> {
        let step = simulation.model().time_step().seconds;
        let start = simulation.time();
        let mut frame_due = Due::every(plan.frame_interval, step, start);
        let mut meters_due = Due::every(plan.meter_interval, step, start);
        self.begin(simulation)?;
        let (mut last_flush, mut last_look) = (Instant::now(), Instant::now());
        loop {
            if let Some(ended) = end_of(simulation, plan) {
                return Ok(ended);
            }
            let next = frame_due.next().min(meters_due.next()).min(plan.end_time);
            let next = next.min(next_wall_change(simulation));
            simulation
                .advance(stride(simulation.time(), next, step))
                .map_err(Stop::Physics)?;
            self.watch_walls(simulation)?;
            let time = simulation.time();
            if meters_due.is_now(time) {
                self.read_meters(simulation)?;
            }
            if frame_due.is_now(time) {
                self.draw(simulation)?;
            }
            let now = Instant::now();
            if now - last_flush >= FLUSH_INTERVAL {
                self.recording.flush()?;
                last_flush = now;
            }
            if now - last_look >= OBSERVER_INTERVAL {
                last_look = now;
                if observer(&progress(simulation, plan)).is_break() {
                    return Ok(Ended::Interrupted);
                }
            }
        }
    }

    /// Records the beginning.
    fn begin(&mut self, simulation: &Simulation) -> McapResult<()> {
        let time = simulation.time();
        let text = format!(
            "begins with {} pellets; step {:.3e} s: {}",
            simulation.pellet_count(),
            simulation.model().time_step().seconds,
            simulation.model().time_step().reason
        );
        self.recording.event(time, Gravity::Information, &text)?;
        self.is_present = simulation.walls().map(|wall| wall.is_present).collect();
        self.recording.walls(time, &self.is_present)?;
        self.draw(simulation)?;
        self.read_meters(simulation)?;
        // A run killed in its first seconds shows its scene.
        self.recording.flush()
    }

    /// Records gates that have opened or closed.
    fn watch_walls(&mut self, simulation: &Simulation) -> McapResult<()> {
        let time = simulation.time();
        let mut has_changed = false;
        for (wall, was_present) in simulation.walls().zip(&mut self.is_present) {
            if wall.is_present != *was_present {
                *was_present = wall.is_present;
                has_changed = true;
                let name = &simulation.model().setup().walls[wall.index].name;
                let what = if wall.is_present {
                    "is there"
                } else {
                    "is gone"
                };
                let text = format!("wall `{name}` {what}");
                self.recording.event(time, Gravity::Information, &text)?;
            }
        }
        if has_changed {
            self.recording.walls(time, &self.is_present)?;
        }
        Ok(())
    }

    /// Records where everything is, once per step.
    fn draw(&mut self, simulation: &Simulation) -> McapResult<()> {
        let step = simulation.step_count();
        if self.last_frame == Some(step) {
            return Ok(());
        }
        self.last_frame = Some(step);
        let mut pellets: Vec<PelletView> = simulation.pellets().collect();
        pellets.sort_unstable_by_key(|pellet| pellet.id);
        let poses: Vec<Pose> = simulation.walls().map(|wall| wall.pose).collect();
        self.recording.frame(&Frame {
            time: simulation.time(),
            pellets: &pellets,
            poses: &poses,
            mass: &simulation.mass_ledger(),
            energy: &simulation.energy_ledger(),
        })
    }

    /// Records what the meters read, once per step.
    fn read_meters(&mut self, simulation: &Simulation) -> McapResult<()> {
        let step = simulation.step_count();
        if self.last_reading == Some(step) {
            return Ok(());
        }
        self.last_reading = Some(step);
        self.recording
            .meters(simulation.time(), &simulation.meter_readings())
    }

    /// Records the end, whatever it is, and finishes the file.
    pub(crate) fn close(
        mut self,
        simulation: &Simulation,
        ended: Ended,
        failure: Option<&str>,
    ) -> McapResult<()> {
        let drawn = self
            .draw(simulation)
            .and_then(|()| self.read_meters(simulation));
        let time = simulation.time();
        let (gravity, text) = match failure {
            Some(failure) => (Gravity::Failure, failure.to_owned()),
            None => (Gravity::Information, reason_of(ended).to_owned()),
        };
        let noted = self.recording.event(time, gravity, &text);
        let finished = self.recording.finish().and_then(|writer| {
            writer
                .into_inner()
                .map_err(io::IntoInnerError::into_error)?
                .sync_all()?;
            Ok(())
        });
        drawn.and(noted).and(finished)
    }
}

/// Steps [-] to the one nearest to the moment `next` [s], or a stride of the greatest length.
fn stride(time: f64, next: f64, step: f64) -> u64 {
    let steps = ((next - time) / step).round();
    steps.clamp(1.0, LONGEST_STRIDE as f64) as u64
}

/// When the next wall vanishes or comes back [s].
fn next_wall_change(simulation: &Simulation) -> f64 {
    let time = simulation.time();
    let walls = simulation.model().setup().walls.iter();
    walls
        .flat_map(|wall| wall.schedule.changes())
        .copied()
        .filter(|&change| change > time)
        .fold(f64::INFINITY, f64::min)
}

/// Whether the run has ended, and why.
fn end_of(simulation: &Simulation, plan: &RunPlan) -> Option<Ended> {
    let time = simulation.time();
    // The step nearest to the end is the last one.
    if time + simulation.model().time_step().seconds / 2.0 >= plan.end_time {
        return Some(Ended::EndTime);
    }
    plan.stop.iter().find_map(|condition| match *condition {
        StopCondition::Empty { after } => {
            (time >= after && simulation.pellet_count() == 0).then_some(Ended::Empty)
        }
        StopCondition::Settled { after, speed } => {
            (time >= after && is_settled(simulation, speed)).then_some(Ended::Settled)
        }
        _ => None,
    })
}

/// Whether the mean speed of the pellets, root mean square by mass, is below a bound [m/s].
///
/// Spin does not count: nothing stops a pellet from turning on the spot.
fn is_settled(simulation: &Simulation, speed: f64) -> bool {
    let (mass, squares) = simulation
        .pellets()
        .fold((0.0, 0.0), |(mass, squares), pellet| {
            let square = pellet.mass * pellet.velocity.norm_squared();
            (mass + pellet.mass, squares + square)
        });
    mass > 0.0 && squares < mass * speed * speed
}

fn reason_of(ended: Ended) -> &'static str {
    match ended {
        Ended::EndTime => "ends: the time asked for has passed",
        Ended::Empty => "ends: no pellet is inside any more",
        Ended::Settled => "ends: the bed has come to rest",
        Ended::Interrupted => "ends: interrupted",
        Ended::Failed => "ends: failed",
    }
}

fn progress(simulation: &Simulation, plan: &RunPlan) -> Progress {
    let ledger = simulation.mass_ledger();
    Progress {
        time: simulation.time(),
        end_time: plan.end_time,
        step: simulation.step_count(),
        pellets: simulation.pellet_count(),
        max_force: simulation.contact_statistics().max_force,
        lost: ledger.lost.count,
        discharged: ledger.discharged.count,
    }
}
