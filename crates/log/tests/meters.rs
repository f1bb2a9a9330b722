//! What meters leave beside the recording.

mod common;

use common::{plan, run_into, setup};
use pelletflow_sim::{Meter, MeterKind, WallImpacts};
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

/// A meter of the impacts on the cone.
fn impacts() -> Meter {
    Meter {
        name: "hits".into(),
        kind: MeterKind::WallImpacts(WallImpacts {
            wall: 0,
            cell: 0.02,
            least_speed: 0.1,
        }),
    }
}

fn run_with_impacts(directory: &Path) -> serde_json::Value {
    let mut setup = setup(60);
    setup.meters.push(impacts());
    run_into(directory, setup, &plan(0.2), 0, &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("the hopper runs to its end");
    let text = fs::read_to_string(directory.join("summary.json")).expect("a run leaves a summary");
    serde_json::from_str(&text).expect("it is JSON")
}

#[test]
fn patches_of_a_wall_are_a_table_and_the_worst_stand_in_the_summary() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = run_with_impacts(directory.path());
    let text = fs::read_to_string(directory.path().join("meters/hits.csv"))
        .expect("a meter of patches leaves a table");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a line of names").split(',').collect();
    let rows: Vec<Vec<f64>> = lines
        .map(|line| {
            let values = line.split(',');
            values
                .map(|value| value.parse().expect("a number"))
                .collect()
        })
        .collect();
    let hits = &summary["meters"]["hits"];
    let place = names.iter().position(|name| *name == "impacts");
    let place = place.expect("impacts are counted");
    let total: f64 = rows.iter().map(|row| row[place]).sum();
    assert!(total > 10.0 && rows.len() > 5, "{text}");
    assert_eq!(hits["impacts"], total);
    let worst = hits["worst"].as_array().expect("a list of patches");
    assert_eq!(worst.len(), 5);
    for (patch, row) in worst.iter().zip(&rows) {
        assert_eq!(row.len(), names.len());
        for (name, value) in names.iter().zip(row) {
            assert_eq!(patch[name], *value, "{name}");
        }
    }
    assert!(summary["meters"]["outflow"].get("worst").is_none());
}

#[test]
fn the_table_of_an_earlier_run_is_replaced_before_a_run_begins() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    run_with_impacts(directory.path());
    let table = directory.path().join("meters/hits.csv");
    let mut setup = setup(60);
    setup.meters = vec![impacts()];
    let stopped = run_into(directory.path(), setup, &plan(1.0e6), 0, &mut |_| {
        let text = fs::read_to_string(&table).expect("the table is there");
        assert_eq!(text.lines().count(), 1, "{text}");
        ControlFlow::Break(())
    });
    stopped.expect("an interrupted run is no failure");
}
