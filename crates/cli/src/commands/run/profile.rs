//! Where the time of a run went, as `--profile` shows it.

use crate::table::{self, number};
use pelletflow_log::{PhaseCost, Profile, Summary};

/// A row for each phase, then the run as a whole, then the writer, whose work goes on meanwhile.
pub(super) fn table(summary: &Summary) -> String {
    let Profile {
        phases,
        run,
        writer,
    } = Profile::of(summary);
    let writer = PhaseCost {
        name: format!("{}, meanwhile", writer.name),
        ..writer
    };
    let rows = phases.into_iter().chain([run, writer]).map(row);
    let header = ["phase", "seconds", "share [%]", "ns per pellet-step"];
    table::listing(header, &[1, 2, 3], rows)
}

fn row(cost: PhaseCost) -> [String; 4] {
    [
        cost.name,
        number(cost.seconds),
        format!("{:.1}", 100.0 * cost.share),
        cost.seconds_per_pellet_step
            .map_or_else(String::new, |seconds| number(1.0e9 * seconds)),
    ]
}
