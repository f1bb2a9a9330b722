//! The course of a run: steps, and what is recorded between them.

use crate::checkpoint::Keeper;
use crate::ending::{end_of, reason_of};
use crate::logbook::Logbook;
use crate::message::event::Gravity;
use crate::recording::{Entry, Recorder, RecordingTimes, Stopped};
use crate::run::Progress;
use crate::summary::Ended;
use mcap::{McapError, McapResult};
use pelletflow_sim::{Hit, RunPlan, Simulation, StepError};
use std::fs::File;
use std::io::{self, BufWriter};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Time by the wall clock between two looks of the observer.
const OBSERVER_INTERVAL: Duration = Duration::from_millis(20);
/// Time by the wall clock after which a chunk ends even if it is small: what a killed run loses.
const FLUSH_INTERVAL: Duration = Duration::from_secs(2);
/// The same of a long run, over the time that it took so far [-]: the writer remembers every chunk until the file ends,
/// and those of a week are so no more than 8000.
const FLUSH_SHARE: u32 = 1000;

/// Hits at which their sketch is recorded again, over those in the last [-].
const SKETCH_GROWTH: f64 = 1.1;

/// Steps taken between two looks at the run, at most: each look wakes the threads anew.
///
/// A number and not a time, so that stop conditions are met at the same step in every run.
const LONGEST_STRIDE: u64 = 16;

/// What stops a run before its end.
pub(crate) enum Stop {
    Physics(StepError),
    Output(McapError),
}

/// What came of a run.
pub(crate) struct Outcome {
    /// How it ended.
    pub(crate) ended: Result<Ended, Stop>,
    /// Moments of its hardest hits [s].
    pub(crate) worst_moments: Vec<f64>,
    /// What recording took.
    pub(crate) recording_times: RecordingTimes,
}

/// What breaks off the steps.
enum Break {
    Physics(StepError),
    /// The recording cannot be written; finishing it tells why.
    Recorder,
}

impl From<Stopped> for Break {
    fn from(_: Stopped) -> Self {
        Self::Recorder
    }
}

/// A run on its way, and what of it is recorded.
pub(crate) struct Course<'scope> {
    recorder: Recorder<'scope, BufWriter<File>>,
    keeper: Keeper,
    /// Time that copying took.
    copying: Duration,
    logbook: Logbook,
}

impl<'scope> Course<'scope> {
    /// A run of which the logbook tells what is recorded.
    pub(crate) fn new(
        recorder: Recorder<'scope, BufWriter<File>>,
        keeper: Keeper,
        logbook: Logbook,
    ) -> Self {
        Self {
            recorder,
            keeper,
            copying: Duration::ZERO,
            logbook,
        }
    }

    /// Steps to the end, records it whatever it is, and finishes the file.
    pub(crate) fn run(
        mut self,
        simulation: &mut Simulation,
        plan: &RunPlan,
        observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Outcome {
        let outcome = self.drive(simulation, plan, observer);
        let (gravity, text) = match &outcome {
            Ok(ended) => (Gravity::Information, reason_of(*ended).to_owned()),
            Err(Break::Physics(error)) => (Gravity::Failure, error.to_string()),
            Err(Break::Recorder) => (Gravity::Failure, reason_of(Ended::Failed).to_owned()),
        };
        // A recorder that has stopped tells why when it is finished.
        let _ = self
            .tell_last_hits(simulation)
            .and_then(|()| self.end(simulation, gravity, text));
        let hits = self.logbook.worst_hits.as_slice().iter();
        let worst_moments = hits.map(|hit| hit.peak_time).collect();
        let (finished, recording_times) = self.finish();
        let ended = match (outcome, finished) {
            (Err(Break::Physics(error)), _) => Err(Stop::Physics(error)),
            (_, Err(error)) => Err(Stop::Output(error)),
            (Ok(ended), Ok(())) => Ok(ended),
            (Err(Break::Recorder), Ok(())) => {
                unreachable!("a recorder that stops has an error to tell")
            }
        };
        Outcome {
            ended,
            worst_moments,
            recording_times,
        }
    }

    /// Steps to the end, recording what is due on the way.
    fn drive(
        &mut self,
        simulation: &mut Simulation,
        plan: &RunPlan,
        observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Ended, Break> {
        let step = simulation.model().time_step().seconds;
        if self.logbook.last_frame.is_none() {
            self.begin(simulation)?;
        }
        let began = Instant::now();
        let (mut last_flush, mut last_look) = (began, began);
        let mut is_interrupted = false;
        loop {
            if let Some(ended) = end_of(simulation, plan) {
                return Ok(ended);
            }
            // Only where steps follow: the last frame shows forces, and a restart has none before its first step.
            if is_interrupted || self.keeper.is_due() {
                self.save(simulation)?;
            }
            if is_interrupted {
                return Ok(Ended::Interrupted);
            }
            let next = self.logbook.next_due().min(plan.end_time);
            let next = next.min(next_wall_change(simulation));
            simulation
                .advance(stride(simulation.time(), next, step))
                .map_err(Break::Physics)?;
            self.watch_walls(simulation)?;
            let time = simulation.time();
            if self.logbook.meters_due.is_now(time) {
                self.read_meters(simulation)?;
            }
            if self.logbook.frame_due.is_now(time) {
                self.tell_hits(simulation)?;
                self.draw(simulation)?;
            }
            let now = Instant::now();
            if now - last_flush >= FLUSH_INTERVAL.max((now - began) / FLUSH_SHARE) {
                self.recorder.put(Entry::Flush)?;
                last_flush = now;
            }
            if now - last_look >= OBSERVER_INTERVAL {
                last_look = now;
                is_interrupted = observer(&progress(simulation, plan)).is_break();
            }
        }
    }

    /// Has the run as it is now written beside the recording.
    fn save(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        let began = Instant::now();
        let times = RecordingTimes {
            copying: self.copying,
            waiting: self.recorder.waiting(),
            writing: Duration::ZERO,
        };
        let save = self.keeper.save(simulation, &self.logbook, times);
        self.copying += began.elapsed();
        self.recorder.put(Entry::Checkpoint(Box::new(save)))
    }

    /// Records the beginning.
    fn begin(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        let text = format!(
            "begins with {} pellets; step {:.3e} s: {}",
            simulation.pellet_count(),
            simulation.model().time_step().seconds,
            simulation.model().time_step().reason
        );
        self.note(simulation, Gravity::Information, text)?;
        self.draw_walls(simulation)?;
        self.draw(simulation)?;
        self.read_meters(simulation)?;
        // A run killed in its first seconds shows its scene.
        self.recorder.put(Entry::Flush)
    }

    /// Records gates that have opened or closed.
    fn watch_walls(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        let mut has_changed = false;
        for wall in simulation.walls() {
            if wall.is_present != self.logbook.is_present[wall.index] {
                self.logbook.is_present[wall.index] = wall.is_present;
                has_changed = true;
                let name = &simulation.model().setup().walls[wall.index].name;
                let what = if wall.is_present {
                    "is there"
                } else {
                    "is gone"
                };
                let text = format!("wall `{name}` {what}");
                self.note(simulation, Gravity::Information, text)?;
            }
        }
        if has_changed {
            self.draw_walls(simulation)?;
        }
        Ok(())
    }

    /// Records what happens now.
    fn note(
        &mut self,
        simulation: &Simulation,
        gravity: Gravity,
        text: String,
    ) -> Result<(), Stopped> {
        self.recorder.put(Entry::Event {
            time: simulation.time(),
            gravity,
            text,
        })
    }

    /// Records which walls are there.
    fn draw_walls(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        self.recorder.put(Entry::Walls {
            time: simulation.time(),
            is_present: self.logbook.is_present.clone(),
        })
    }

    /// Records where everything is, once per step.
    fn draw(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        let step = simulation.step_count();
        if self.logbook.last_frame == Some(step) {
            return Ok(());
        }
        self.logbook.last_frame = Some(step);
        let mut frame = self.recorder.blank()?;
        let began = Instant::now();
        frame.fill(simulation);
        self.copying += began.elapsed();
        self.recorder.put(Entry::Frame(frame))
    }

    /// Records what the meters read, once per step.
    fn read_meters(&mut self, simulation: &Simulation) -> Result<(), Stopped> {
        let step = simulation.step_count();
        if self.logbook.last_reading == Some(step) {
            return Ok(());
        }
        self.logbook.last_reading = Some(step);
        let began = Instant::now();
        let readings = simulation.meter_readings();
        self.copying += began.elapsed();
        self.recorder.put(Entry::Meters {
            time: simulation.time(),
            readings,
        })
    }

    /// Records the hits that have ended since the last time, and the sketch of all when it has grown.
    fn tell_hits(&mut self, simulation: &mut Simulation) -> Result<(), Stopped> {
        let hits = simulation.take_hits();
        if hits.is_empty() {
            return Ok(());
        }
        let time = simulation.time();
        self.mark_worst(time, &hits)?;
        self.recorder.put(Entry::Hits { time, hits })?;
        let ledger = &simulation.state().hits;
        let count = ledger.total().count;
        if count as f64 >= SKETCH_GROWTH * self.logbook.sketched as f64 {
            self.logbook.sketched = count;
            let classes = ledger.classes().clone();
            self.recorder.put(Entry::HitClasses { time, classes })?;
        }
        Ok(())
    }

    /// Records the last hits, those still open too, and the sketch of all.
    fn tell_last_hits(&mut self, simulation: &mut Simulation) -> Result<(), Stopped> {
        if simulation.model().setup().hits.is_none() {
            return Ok(());
        }
        self.tell_hits(simulation)?;
        let time = simulation.time();
        let all = simulation.hits_with_open();
        let hits = all.rows().to_vec();
        self.mark_worst(time, &hits)?;
        self.recorder.put(Entry::Hits { time, hits })?;
        let classes = all.classes().clone();
        self.recorder.put(Entry::HitClasses { time, classes })
    }

    /// Records which of some new hits are among the hardest so far, and which these are now.
    fn mark_worst(&mut self, time: f64, hits: &[Hit]) -> Result<(), Stopped> {
        let worst = &mut self.logbook.worst_hits;
        let mut entered: Vec<Hit> = Vec::new();
        for hit in hits {
            if worst.enter(hit) {
                entered.push(*hit);
            }
        }
        // Some may have given way to others of these.
        entered.retain(|hit| worst.as_slice().contains(hit));
        if entered.is_empty() {
            return Ok(());
        }
        let worst = worst.as_slice().to_vec();
        self.recorder.put(Entry::WorstHits {
            time,
            entered,
            worst,
        })
    }

    /// Records the end.
    fn end(
        &mut self,
        simulation: &Simulation,
        gravity: Gravity,
        text: String,
    ) -> Result<(), Stopped> {
        self.draw(simulation)?;
        self.read_meters(simulation)?;
        self.note(simulation, gravity, text)
    }

    /// Finishes the file; whether it is whole, and what recording took.
    fn finish(self) -> (McapResult<()>, RecordingTimes) {
        let waiting = self.recorder.waiting();
        let began = Instant::now();
        let (written, writing) = self.recorder.finish();
        let finished = written.and_then(|writer| {
            writer
                .into_inner()
                .map_err(io::IntoInnerError::into_error)?
                .sync_all()?;
            Ok(())
        });
        let times = RecordingTimes {
            copying: self.copying,
            waiting: waiting + began.elapsed(),
            writing,
        };
        (finished, times)
    }
}

/// Steps [-] to the one nearest to the moment `next` [s], or a stride of the greatest length.
pub(crate) fn stride(time: f64, next: f64, step: f64) -> u64 {
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
