//! Where the time of a run went.

use crate::recording::RecordingTimes;
use crate::summary::Summary;
use pelletflow_sim::Phase;
use std::collections::BTreeMap;

/// Copying what is recorded.
const RECORDING: &str = "recording";
/// Waiting for the writer.
const WAITING: &str = "waiting";
/// All of the run that is in no other phase.
const OTHER: &str = "other";
/// The writer's work, while the run goes on.
const WRITER: &str = "writer";

/// What a part of a run took.
#[derive(Debug, Clone, PartialEq)]
pub struct PhaseCost {
    /// Which part.
    pub name: String,
    /// Time by the wall clock [s].
    pub seconds: f64,
    /// Share of the run's time [-].
    pub share: f64,
    /// Time over pellets times steps [s]; none where no pellet took a step.
    pub seconds_per_pellet_step: Option<f64>,
}

/// Where the time of a run went.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The parts that add up to the run, the longest first and the unnamed rest last.
    pub phases: Vec<PhaseCost>,
    /// The run from its first file to its last.
    pub run: PhaseCost,
    /// The thread that wrote the recording while the run went on.
    pub writer: PhaseCost,
}

impl Profile {
    /// Of a run that is over.
    pub fn of(summary: &Summary) -> Self {
        let wall_time = summary.time.wall_s;
        let pellet_steps = summary.performance.particle_steps_per_s * wall_time;
        let cost = |name: &str, seconds: f64| PhaseCost {
            name: name.into(),
            seconds,
            share: if wall_time > 0.0 {
                seconds / wall_time
            } else {
                0.0
            },
            seconds_per_pellet_step: (pellet_steps > 0.0).then(|| seconds / pellet_steps),
        };
        let seconds_of = &summary.performance.phases;
        let of = |name: &str| cost(name, seconds_of.get(name).copied().unwrap_or(0.0));
        let mut phases: Vec<PhaseCost> = seconds_of
            .iter()
            .filter(|(name, _)| ![OTHER, WRITER].contains(&name.as_str()))
            .map(|(name, seconds)| cost(name, *seconds))
            .collect();
        phases.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
        phases.push(of(OTHER));
        Self {
            phases,
            run: cost("run", wall_time),
            writer: of(WRITER),
        }
    }
}

/// Seconds of each phase [s], by name, of a run of the given time [s]; all but the writer's add up to it.
///
/// Stages of the step are timed in some steps that stand for the others: where one of those was held up,
/// the stages would add up to more than there was, and are shortened together to what the rest leaves them.
pub(crate) fn phases(
    wall_time: f64,
    before: &[Phase],
    after: &[Phase],
    recording: &RecordingTimes,
) -> BTreeMap<String, f64> {
    let mut phases: BTreeMap<String, f64> = after
        .iter()
        .map(|phase| (phase.name.into(), phase.seconds))
        .collect();
    for phase in before {
        if let Some(seconds) = phases.get_mut(phase.name) {
            *seconds -= phase.seconds;
        }
    }
    let left = wall_time - (recording.copying + recording.waiting).as_secs_f64();
    let stages: f64 = phases.values().sum();
    if stages > left {
        for seconds in phases.values_mut() {
            *seconds *= left.max(0.0) / stages;
        }
    }
    phases.insert(RECORDING.into(), recording.copying.as_secs_f64());
    phases.insert(WAITING.into(), recording.waiting.as_secs_f64());
    let named: f64 = phases.values().sum();
    phases.insert(OTHER.into(), (wall_time - named).max(0.0));
    phases.insert(WRITER.into(), recording.writing.as_secs_f64());
    phases
}

#[cfg(test)]
mod tests {
    use super::phases;
    use crate::recording::RecordingTimes;
    use pelletflow_sim::Phase;
    use std::collections::BTreeMap;
    use std::time::Duration;

    fn phase(name: &'static str, seconds: f64) -> Phase {
        Phase { name, seconds }
    }

    /// What the recording took of every run here.
    const RECORDING: RecordingTimes = RecordingTimes {
        copying: Duration::from_millis(250),
        waiting: Duration::from_millis(500),
        writing: Duration::from_secs(7),
    };

    /// What the summary tells, with what the recording took.
    fn expected(forces: f64, motion: f64, other: f64) -> BTreeMap<String, f64> {
        [
            ("forces", forces),
            ("motion", motion),
            ("other", other),
            ("recording", 0.25),
            ("waiting", 0.5),
            ("writer", 7.0),
        ]
        .map(|(name, seconds)| (name.to_owned(), seconds))
        .into()
    }

    #[test]
    fn what_no_phase_covers_is_other_and_what_was_before_the_run_is_left_out() {
        let before = [phase("forces", 1.0), phase("motion", 0.5)];
        let after = [phase("forces", 4.0), phase("motion", 1.5)];
        let found = phases(10.0, &before, &after, &RECORDING);
        assert_eq!(found, expected(3.0, 1.0, 5.25));
    }

    #[test]
    fn stages_whose_samples_tell_more_time_than_there_was_share_what_the_rest_leaves() {
        let after = [phase("forces", 12.0), phase("motion", 4.0)];
        let found = phases(2.75, &[], &after, &RECORDING);
        assert_eq!(found, expected(1.5, 0.5, 0.0));
    }
}
