//! Why no safe value was found.

use pelletflow_impact::ImpactError;
use pelletflow_sim::StepError;

/// A search that found nothing.
#[derive(Debug, thiserror::Error)]
pub enum SafeSettingError {
    /// The scene is not valid at a value.
    #[error("the scene is not valid at {value}: {reason}")]
    Setup {
        /// The value [the setting's unit].
        value: f64,
        /// What is wrong.
        reason: String,
    },
    /// A run failed.
    #[error("the run at {value} failed: {source}")]
    Run {
        /// The value [the setting's unit].
        value: f64,
        /// Why.
        source: StepError,
    },
    /// Nothing was ever hit.
    #[error("no pellet is hit in the run at {value}; let the scene run longer")]
    NoHits {
        /// The value [the setting's unit].
        value: f64,
    },
    /// The share asked for lies outside what the ends of the range break.
    #[error(
        "{} % is not crossed in the range: {} breaks {} %, {} breaks {} %; {}",
        100.0 * .risk, .least[0], rounded(100.0 * .least[1]), .most[0], rounded(100.0 * .most[1]),
        cure(*.risk, .least[1].max(.most[1]))
    )]
    NotCrossed {
        /// The share asked for [-].
        risk: f64,
        /// The least value, and the share that it breaks [the setting's unit and -].
        least: [f64; 2],
        /// The greatest value, and the share that it breaks [the setting's unit and -].
        most: [f64; 2],
    },
    /// A quantity of the strength is outside its bounds.
    #[error(transparent)]
    Strength(#[from] ImpactError),
    /// The caller broke off.
    #[error("interrupted")]
    Interrupted,
}

fn rounded(percent: f64) -> f64 {
    (1.0e4 * percent).round() / 1.0e4
}

fn cure(risk: f64, greatest: f64) -> &'static str {
    if greatest <= risk {
        "all of it is safe; widen the range to find its end"
    } else {
        "none of it is safe; widen the range to find what is"
    }
}
