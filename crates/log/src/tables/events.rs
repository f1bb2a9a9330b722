//! What happened, in words.

use super::{Column, Table, TableKind, Values};
use foxglove::messages::Log;
use prost::Message;

/// Levels of the message, from its number 0 on.
const LEVELS: [&str; 6] = [
    "unknown",
    "debug",
    "information",
    "warning",
    "failure",
    "fatal",
];

/// A row for every event.
#[derive(Default)]
pub(super) struct Events {
    time: Vec<f64>,
    level: Vec<u32>,
    text: Vec<String>,
}

impl Events {
    pub(super) fn take(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let event = Log::decode(data).map_err(|error| error.to_string())?;
        self.time.push(time);
        self.level.push(event.level() as u32);
        self.text.push(event.message);
        Ok(())
    }

    pub(super) fn table(self) -> Table {
        let level = Values::Label {
            labels: LEVELS.map(String::from).to_vec(),
            indices: self.level,
        };
        Table {
            name: TableKind::Events.name().into(),
            columns: vec![
                Column::new("time_s", self.time),
                Column::new("level", level),
                Column::new("text", self.text),
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foxglove::messages::log::Level;

    #[test]
    fn levels_stand_in_the_order_of_their_numbers() {
        assert_eq!(LEVELS[Level::Info as usize], "information");
        assert_eq!(LEVELS[Level::Warning as usize], "warning");
        assert_eq!(LEVELS[Level::Error as usize], "failure");
        assert_eq!(LEVELS.len(), Level::Fatal as usize + 1);
    }
}
