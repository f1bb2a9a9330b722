//! How far a run is, on standard error.

use crate::screen;
use crate::table;
use indicatif::{ProgressBar, ProgressStyle};
use pelletflow_log::Progress;
use std::time::{Duration, Instant};

/// Steps of the bar over a run [-].
const BAR_STEPS: u64 = 1000;

/// Time between lines where no terminal shows a bar.
const LINE_INTERVAL: Duration = Duration::from_secs(10);

/// Tells of a run: with a bar on a terminal, with a line now and then elsewhere, or not at all.
pub(crate) enum Teller {
    Bar(ProgressBar),
    Lines { began: Instant, last: Instant },
    Silent,
}

impl Teller {
    /// What suits the terminal.
    pub(crate) fn suiting() -> Self {
        if !screen::is_watched() {
            let now = Instant::now();
            return Self::Lines {
                began: now,
                last: now,
            };
        }
        let style = ProgressStyle::with_template("{bar:24} {percent:>3} %  {msg}  {eta} left")
            .expect("the template names fields that indicatif knows");
        Self::Bar(ProgressBar::new(BAR_STEPS).with_style(style))
    }

    pub(crate) fn tell(&mut self, progress: &Progress) {
        let share = (progress.time / progress.end_time).clamp(0.0, 1.0);
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_position((share * BAR_STEPS as f64) as u64);
                bar.set_message(sentence(progress));
            }
            Self::Lines { began, last } => {
                if last.elapsed() < LINE_INTERVAL || share == 0.0 {
                    return;
                }
                *last = Instant::now();
                let left = began.elapsed().as_secs_f64() * (1.0 - share) / share;
                screen::remark(&format!(
                    "{:.0} %  {}  {} left",
                    100.0 * share,
                    sentence(progress),
                    table::span(left)
                ));
            }
        }
    }

    /// Clears the bar.
    pub(crate) fn finish(self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

fn sentence(progress: &Progress) -> String {
    format!(
        "t = {:.3} s  {} pellets  {} out  max {} N  {} lost",
        progress.time,
        table::count(progress.pellets as u64),
        table::count(progress.discharged),
        table::number(progress.max_force),
        progress.lost
    )
}
