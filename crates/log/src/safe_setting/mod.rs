//! The value of a setting at which a share of the pellets breaks, sought by whole runs.
//!
//! Runs are made in memory at values of one setting, such as the speed of a feed or the angle of a plate, and scored.
//! The value at which the share asked for breaks is bracketed by bisection, and found inside the last bracket by a
//! straight line of the logarithm of the share.
//!
//! The bounds that the sample of the strength test leaves are sought in the same way.
//! All runs of the search have the same seed, so that they differ by the setting alone; runs at the value found with
//! other seeds tell how much of it is the course of one run.

mod comparison;
mod error;
mod trial;

pub use comparison::{ClosedForm, Comparison};
pub use error::SafeSettingError;

use crate::accuracy::{Mean, mean};
use crate::breakage::{Breakage, BreakageRequest, Share};
use pelletflow_sim::{RunPlan, Setup};
use std::ops::ControlFlow;
use trial::Trial;

/// What is sought, and how closely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SafeSettingRequest {
    /// How the hits of a run are scored.
    pub breakage: BreakageRequest,
    /// Share of pellets that may break [-].
    pub risk: f64,
    /// Values between which it is sought, the lesser first [the setting's unit].
    pub range: [f64; 2],
    /// Width of the last bracket over that of the range [-].
    pub tolerance: f64,
    /// Number of seeds at the value found, with that of the search [-].
    pub seeds: u32,
    /// Threads of a run; 0 for all there are [-].
    pub threads: usize,
}

/// A run that was made.
#[derive(Debug, Clone, PartialEq)]
pub struct SettingRun {
    /// Value of the setting [the setting's unit].
    pub value: f64,
    /// What broke in it.
    pub breakage: Breakage,
}

/// The value found.
#[derive(Debug, Clone, PartialEq)]
pub struct SafeSetting {
    /// Value at which the share asked for breaks [the setting's unit].
    pub value: f64,
    /// Where the sample of the strength test puts it; none where that lies outside the range [the setting's unit].
    pub interval: [Option<f64>; 2],
    /// Half the width of its 95 % interval over seeds; none for a single seed [the setting's unit].
    pub seed_half_width: Option<f64>,
    /// Whether more of the setting breaks more in every run, or less in every run.
    pub is_monotone: bool,
    /// Runs of the search in order of the setting.
    pub runs: Vec<SettingRun>,
    /// Share broken at the value found, one for each seed [-].
    pub seed_shares: Vec<f64>,
    /// What broke at the value found, by the seed of the search.
    pub breakage: Breakage,
    /// That run beside the closed form of a lone hit; none where none applies.
    pub comparison: Option<Comparison>,
}

/// Seeks the value of a setting at which a share of the pellets breaks.
///
/// `prepare` gives the setup and the plan for a value, or what is wrong with it.
/// `watch` is told, while a run goes on, how many runs are done and how far this one is [-]; the search stops when it
/// breaks.
///
/// # Errors
///
/// A run cannot be set up or fails, the share is not crossed in the range, or the caller broke off.
pub fn safe_setting(
    request: &SafeSettingRequest,
    prepare: &mut dyn FnMut(f64) -> Result<(Setup, RunPlan), String>,
    watch: &mut dyn FnMut(usize, f64) -> ControlFlow<()>,
) -> Result<SafeSetting, SafeSettingError> {
    let mut search = Search {
        request,
        prepare,
        watch,
        runs: Vec::new(),
        done: 0,
    };
    for value in request.range {
        search.visit(value)?;
    }
    let value = search
        .crossing(|share| share.share)?
        .ok_or_else(|| search.not_crossed())?;
    let mut interval = [
        search.crossing(|share| share.interval[0])?,
        search.crossing(|share| share.interval[1])?,
    ];
    // Weaker pellets cross first where the share grows with the setting, and last where it falls.
    if search.is_rising() {
        interval.reverse();
    }
    let mut seed_shares = Vec::new();
    let (setup, breakage) = search.run(value, 0)?;
    seed_shares.push(breakage.believed().share);
    for seed in 1..request.seeds {
        let (_, breakage) = search.run(value, u64::from(seed))?;
        seed_shares.push(breakage.believed().share);
    }
    let seed_half_width = (seed_shares.len() > 1).then(|| {
        let Mean { half_width, .. } = mean(&seed_shares);
        half_width / search.slope(value).abs()
    });
    Ok(SafeSetting {
        value,
        interval,
        seed_half_width,
        is_monotone: search.is_monotone(),
        runs: search.runs,
        seed_shares,
        comparison: Comparison::new(&setup, &breakage, &request.breakage, request.risk),
        breakage,
    })
}

/// Runs made so far, in order of the setting, and how to make more.
struct Search<'a> {
    request: &'a SafeSettingRequest,
    prepare: &'a mut dyn FnMut(f64) -> Result<(Setup, RunPlan), String>,
    watch: &'a mut dyn FnMut(usize, f64) -> ControlFlow<()>,
    runs: Vec<SettingRun>,
    /// Runs made, with those at other seeds [-].
    done: usize,
}

impl Search<'_> {
    /// Makes a run at a value and a seed that is so much greater than the scene's.
    fn run(&mut self, value: f64, seed: u64) -> Result<(Setup, Breakage), SafeSettingError> {
        let (mut setup, plan) =
            (self.prepare)(value).map_err(|reason| SafeSettingError::Setup { value, reason })?;
        setup.seed = setup.seed.wrapping_add(seed);
        let trial = Trial {
            plan: &plan,
            breakage: &self.request.breakage,
            threads: self.request.threads,
            value,
        };
        let done = self.done;
        let watch = &mut self.watch;
        let breakage = trial.run(setup.clone(), &mut |part| watch(done, part))?;
        self.done += 1;
        Ok((setup, breakage))
    }

    /// Makes a run at a value and keeps it.
    fn visit(&mut self, value: f64) -> Result<(), SafeSettingError> {
        let (_, breakage) = self.run(value, 0)?;
        let place = self.runs.partition_point(|run| run.value < value);
        self.runs.insert(place, SettingRun { value, breakage });
        Ok(())
    }

    fn is_rising(&self) -> bool {
        let share = |run: Option<&SettingRun>| run.map_or(0.0, |run| run.breakage.believed().share);
        share(self.runs.first()) <= share(self.runs.last())
    }

    /// The neighbors between which the share asked for is crossed first, seen from the side where less breaks.
    fn bracket(&self, share: fn(&Share) -> f64) -> Option<[usize; 2]> {
        let is_above = |index: &usize| {
            let believed = self.runs[*index].breakage.believed();
            share(believed) > self.request.risk
        };
        let count = self.runs.len();
        if self.is_rising() {
            let above = (0..count).find(is_above)?;
            (above > 0).then(|| [above - 1, above])
        } else {
            let above = (0..count).rfind(is_above)?;
            (above + 1 < count).then_some([above, above + 1])
        }
    }

    /// The value at which a share crosses that asked for; none where it does not within the range.
    fn crossing(&mut self, share: fn(&Share) -> f64) -> Result<Option<f64>, SafeSettingError> {
        let [least, most] = self.request.range;
        let width = self.request.tolerance * (most - least);
        loop {
            let Some(bracket) = self.bracket(share) else {
                return Ok(None);
            };
            let ends = bracket.map(|index| self.runs[index].value);
            let middle = f64::midpoint(ends[0], ends[1]);
            let is_narrow = ends[1] - ends[0] <= width;
            // No number lies between neighbors.
            if is_narrow || middle <= ends[0] || middle >= ends[1] {
                let shares = bracket.map(|index| share(self.runs[index].breakage.believed()));
                return Ok(Some(between(ends, shares, self.request.risk)));
            }
            self.visit(middle)?;
        }
    }

    /// How fast the share grows about a value, by the neighbors between which it is crossed [1/the setting's unit].
    fn slope(&self, value: f64) -> f64 {
        let above = self.runs.partition_point(|run| run.value < value);
        let above = above.clamp(1, self.runs.len() - 1);
        let (one, other) = (&self.runs[above - 1], &self.runs[above]);
        let share = |run: &SettingRun| run.breakage.believed().share;
        (share(other) - share(one)) / (other.value - one.value)
    }

    fn is_monotone(&self) -> bool {
        let shares = self.runs.iter().map(|run| run.breakage.believed().share);
        if self.is_rising() {
            shares.is_sorted()
        } else {
            shares.rev().is_sorted()
        }
    }

    fn not_crossed(&self) -> SafeSettingError {
        let end = |run: Option<&SettingRun>| {
            run.map_or([0.0; 2], |run| [run.value, run.breakage.believed().share])
        };
        SafeSettingError::NotCrossed {
            risk: self.request.risk,
            least: end(self.runs.first()),
            most: end(self.runs.last()),
        }
    }
}

/// Where a share is crossed between two values, on a straight line of its logarithm, or where one is zero of itself.
fn between(values: [f64; 2], shares: [f64; 2], risk: f64) -> f64 {
    let [one, other, risk] = if shares.iter().all(|&share| share > 0.0) {
        [shares[0], shares[1], risk].map(f64::ln)
    } else {
        [shares[0], shares[1], risk]
    };
    let part = (risk - one) / (other - one);
    values[0] + part * (values[1] - values[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_the_setting_is_crossed_where_it_says_to_second_order() {
        // ln(v⁴) is nearly straight over 2 % of v: the error is that of the secant, (Δv)²/8 of its curvature.
        let share = |value: f64| value.powi(4);
        let found = between([0.30, 0.306], [share(0.30), share(0.306)], share(0.303));
        assert!((found / 0.303 - 1.0).abs() < 1.0e-4, "{found}");
        assert_eq!(between([1.0, 2.0], [0.0, 0.2], 0.1), 1.5);
    }
}
