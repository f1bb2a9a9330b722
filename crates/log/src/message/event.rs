//! `/log`: what happened and when, in words.

use super::timestamp;
use foxglove::messages::Log;
use foxglove::messages::log::Level;

/// How grave an event is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gravity {
    Information,
    Warning,
    Failure,
}

/// One event at a time [s].
pub(crate) fn message(time: f64, gravity: Gravity, text: &str) -> Log {
    let level = match gravity {
        Gravity::Information => Level::Info,
        Gravity::Warning => Level::Warning,
        Gravity::Failure => Level::Error,
    };
    Log {
        timestamp: Some(timestamp(time)),
        level: level as i32,
        message: text.into(),
        name: "pelletflow".into(),
        ..Log::default()
    }
}
