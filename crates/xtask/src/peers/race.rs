//! Rounds in which codes run the same scene one after the other, so that what else the machine does falls on all.

use anyhow::Result;

/// Whether the silo stays closed while the time is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Floor {
    Closed,
    Opens,
}

/// How long a run is, in steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Length {
    /// Before the time is taken.
    pub(crate) warm: u64,
    /// While it is taken.
    pub(crate) steps: u64,
}

/// What one run did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outcome {
    /// Time of the part that counts [s].
    pub(crate) seconds: f64,
    /// Kinetic energy at the end, without spin [J].
    pub(crate) kinetic: f64,
    /// Pellets that left [-].
    pub(crate) left: f64,
    /// Pellets times steps [-].
    pub(crate) pellet_steps: f64,
}

/// Median, least and greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spread {
    pub(crate) median: f64,
    pub(crate) least: f64,
    pub(crate) greatest: f64,
}

impl Spread {
    /// Of some numbers; there is at least one.
    pub(crate) fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        let middle = values.len() / 2;
        let median = if values.len() % 2 == 1 {
            values[middle]
        } else {
            f64::midpoint(values[middle - 1], values[middle])
        };
        Self {
            median,
            least: values[0],
            greatest: values[values.len() - 1],
        }
    }
}

/// The outcomes of each racer, by round; each round begins with another, so that all have each of the others before them.
pub(crate) fn run(
    racers: usize,
    rounds: usize,
    mut start: impl FnMut(usize) -> Result<Outcome>,
) -> Result<Vec<Vec<Outcome>>> {
    let mut outcomes = vec![Vec::with_capacity(rounds); racers];
    for round in 0..rounds {
        for turn in 0..racers {
            let racer = (round + turn) % racers;
            outcomes[racer].push(start(racer)?);
        }
    }
    Ok(outcomes)
}

/// Median time of a racer [s].
pub(crate) fn median_seconds(outcomes: &[Outcome]) -> f64 {
    Spread::of(outcomes.iter().map(|outcome| outcome.seconds)).median
}

/// How many times as fast one racer was as another, round by round.
pub(crate) fn ratio(one: &[Outcome], other: &[Outcome]) -> Spread {
    Spread::of(
        one.iter()
            .zip(other)
            .map(|(one, other)| other.seconds / one.seconds),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn took(seconds: f64) -> Outcome {
        Outcome {
            seconds,
            kinetic: 0.0,
            left: 0.0,
            pellet_steps: 1.0,
        }
    }

    #[test]
    fn every_racer_runs_once_a_round_and_the_first_of_a_round_changes() {
        let mut order = Vec::new();
        let outcomes = run(3, 3, |racer| {
            order.push(racer);
            Ok(took(1.0))
        })
        .expect("nothing fails");
        assert_eq!(order, [0, 1, 2, 1, 2, 0, 2, 0, 1]);
        assert!(outcomes.iter().all(|rounds| rounds.len() == 3));
    }

    #[test]
    fn the_ratio_is_that_of_runs_of_the_same_round() {
        // A disturbed round slows both down and leaves the ratio as it is.
        let ours = [took(1.0), took(5.0), took(1.0)];
        let theirs = [took(2.0), took(10.0), took(3.0)];
        let ratio = ratio(&ours, &theirs);
        assert_eq!((ratio.least, ratio.median, ratio.greatest), (2.0, 2.0, 3.0));
        assert_eq!(Spread::of([1.0, 4.0]).median, 2.5);
    }
}
