//! A run from its first step to its last, recorded.

use crate::error::RunError;
use crate::layout::layout;
use crate::message::event::Gravity;
use crate::output::Output;
use crate::recording::{Due, Frame, Recording, Title};
use crate::summary::{Ended, RunFacts, Summary};
use mcap::{McapError, McapResult};
use pelletflow_core::Pose;
use pelletflow_sim::{PelletView, RunPlan, Simulation, StepError, StopCondition};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufWriter};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

/// Time by the wall clock between two looks of the observer.
const OBSERVER_INTERVAL: Duration = Duration::from_millis(20);
/// Time by the wall clock after which a chunk ends even if it is small: what a killed run loses.
const FLUSH_INTERVAL: Duration = Duration::from_secs(2);

/// Steps taken between two looks at the run, at most: each look wakes the threads anew.
///
/// A number and not a time, so that stop conditions are met at the same step in every run.
const LONGEST_STRIDE: u64 = 16;

/// What to run, how long, and where to put it.
#[derive(Debug, Clone, Copy)]
pub struct RunRequest<'a> {
    /// Directory of the output; made where it does not exist.
    pub directory: &'a Path,
    /// Name of the scene.
    pub scene_name: &'a str,
    /// Title of the scene, in words.
    pub scene_title: &'a str,
    /// The scene file as it is run.
    pub scene_text: &'a str,
    /// Hash of the scene.
    pub scene_hash: &'a str,
    /// How long the run goes on and how often it is looked at.
    pub plan: &'a RunPlan,
    /// Spheres of true size are recorded of at most this many pellets [-].
    pub spheres_up_to: usize,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Simulated time [s].
    pub time: f64,
    /// Simulated time at which the run ends at the latest [s].
    pub end_time: f64,
    /// Steps taken [-].
    pub step: u64,
    /// Pellets inside [-].
    pub pellets: usize,
    /// Greatest normal force so far [N].
    pub max_force: f64,
    /// Pellets lost so far [-].
    pub lost: u64,
    /// Pellets discharged so far [-].
    pub discharged: u64,
}

/// Drives a simulation to its end, and writes `scene.toml`, `layout.json`, `run.mcap` and `summary.json`.
///
/// The observer is called about every 20 ms; the run stops when it breaks.
/// However the run ends, the recording is finished and a summary is written.
///
/// # Errors
/// The physics failed, or a file could not be written.
pub fn run(
    simulation: &mut Simulation,
    request: &RunRequest,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let began = Instant::now();
    let full_speed = simulation.model().time_step().expected_speed;
    let layout = layout(
        &simulation.model().setup().domain.bounds,
        &simulation.meter_readings(),
        request.spheres_up_to,
        full_speed,
    );
    let output = Output::create(request.directory)?;
    output.write("scene.toml", request.scene_text)?;
    output.write("layout.json", &layout)?;
    let recording = output.path("run.mcap");
    let in_recording = |error: McapError| RunError::output(&recording, as_io(error));

    let file = output.file("run.mcap")?;
    let title = Title {
        scene_text: request.scene_text,
        layout: &layout,
        facts: facts(simulation, request),
    };
    let setup = simulation.model().setup();
    let recording_of_run = Recording::start(file, setup, &title, request.spheres_up_to, full_speed);
    let particle_steps_before = simulation.particle_steps();
    let contact_steps_before = simulation.contact_statistics().contact_steps;
    let mut course = Course {
        recording: recording_of_run.map_err(in_recording)?,
        is_present: Vec::new(),
        last_frame: None,
        last_reading: None,
    };
    let outcome = course.drive(simulation, request.plan, observer);
    let (ended, failure) = match &outcome {
        Ok(ended) => (*ended, None),
        Err(Stop::Physics(error)) => (Ended::Failed, Some(error.to_string())),
        Err(Stop::Output(error)) => (Ended::Failed, Some(error.to_string())),
    };
    let closed = course.close(simulation, ended, failure.as_deref());
    let summary = Summary::new(
        simulation,
        &RunFacts {
            scene: request.scene_name,
            scene_hash: request.scene_hash,
            wall_time: began.elapsed().as_secs_f64(),
            particle_steps_before,
            contact_steps_before,
            ended,
            failure,
        },
    );
    let written = output.write_summary(&summary);
    match outcome {
        Err(Stop::Physics(error)) => Err(RunError::Physics {
            error,
            summary: Box::new(summary),
        }),
        Err(Stop::Output(error)) => Err(in_recording(error)),
        Ok(_) => {
            closed.map_err(in_recording)?;
            written?;
            Ok(summary)
        }
    }
}

/// What stops a run before its end.
enum Stop {
    Physics(StepError),
    Output(McapError),
}

impl From<McapError> for Stop {
    fn from(error: McapError) -> Self {
        Self::Output(error)
    }
}

/// A run on its way, and what of it is recorded.
struct Course {
    recording: Recording<BufWriter<File>>,
    is_present: Vec<bool>,
    /// Step of the last frame [-].
    last_frame: Option<u64>,
    /// Step of the last meter reading [-].
    last_reading: Option<u64>,
}

impl Course {
    fn drive(
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
    fn close(
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

fn facts(simulation: &Simulation, request: &RunRequest) -> BTreeMap<String, String> {
    let model = simulation.model();
    [
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("scene", request.scene_name.to_owned()),
        ("title", request.scene_title.to_owned()),
        ("scene_hash", request.scene_hash.to_owned()),
        ("seed", model.setup().seed.to_string()),
        ("threads", simulation.threads().to_string()),
        ("step_s", model.time_step().seconds.to_string()),
        ("step_reason", model.time_step().reason.clone()),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

fn as_io(error: McapError) -> io::Error {
    match error {
        McapError::Io(error) => error,
        other => io::Error::other(other),
    }
}
