//! What ran, printed at the end.

use anyhow::Result;
use std::time::Instant;

/// The parts of a command so far, each with its outcome.
pub(crate) struct Report {
    started: Instant,
    rows: Vec<Row>,
}

struct Row {
    part: &'static str,
    outcome: String,
    seconds: f64,
}

impl Report {
    /// An empty report; the clock starts.
    pub(crate) fn new() -> Self {
        Self {
            started: Instant::now(),
            rows: Vec::new(),
        }
    }

    /// Runs one part; its outcome is the text that it returns.
    pub(crate) fn part(
        &mut self,
        part: &'static str,
        work: impl FnOnce() -> Result<String>,
    ) -> Result<()> {
        println!("\n== {part}");
        let started = Instant::now();
        let result = work();
        self.rows.push(Row {
            part,
            outcome: match &result {
                Ok(outcome) => outcome.clone(),
                Err(_) => "FAILED".to_owned(),
            },
            seconds: started.elapsed().as_secs_f64(),
        });
        result.map(drop)
    }

    /// Prints a row for each part that ran, and nothing where there was none.
    pub(crate) fn print(&self) {
        if self.rows.is_empty() {
            return;
        }
        println!("\n== summary");
        for row in &self.rows {
            println!("{:<24}{:>7.1} s  {}", row.part, row.seconds, row.outcome);
        }
        println!(
            "{:<24}{:>7.1} s",
            "all",
            self.started.elapsed().as_secs_f64()
        );
    }
}
