//! How cases become rows.

use super::accuracy;
use super::bench::{Bench, speed};
use super::case::{Case, Figure, Kind};
use super::ours::Told;
use super::race::{self, Floor, Outcome, Spread};
use super::row::{AnswerError, Row};
use anyhow::{Context, Result};

/// Measures a case.
pub(crate) fn row(bench: &mut Bench, case: Case) -> Result<Row> {
    let length = bench.pace.length(case.length);
    match case.kind {
        Kind::Codes {
            scene,
            cores,
            floor,
            codes,
            accuracy,
        } => {
            let finish = bench.race(scene, cores, floor, codes, length)?;
            let error = accuracy::of(bench, accuracy, scene, cores, &finish)?;
            Ok(Row {
                case,
                ours: speed(&finish.ours),
                other: finish.fastest.name().to_owned(),
                theirs: Some(speed(&finish.theirs)),
                ratio: race::ratio(&finish.ours, &finish.theirs),
                error,
            })
        }
        Kind::Threads { scene } => {
            let told = bench.alone(&[(scene, 2), (scene, 1)], length)?;
            let [two, one] = [0, 1].map(|racer| outcomes(&told[racer]));
            let are_same = told.iter().flatten().all(|run| run.hash == told[0][0].hash);
            Ok(Row {
                case,
                ours: speed(&two),
                other: "one thread".to_owned(),
                theirs: Some(speed(&one)),
                ratio: race::ratio(&two, &one),
                error: AnswerError {
                    ours: f64::from(u8::from(!are_same)),
                    theirs: None,
                    of: "bits on one and two threads: 0 same, 1 not".to_owned(),
                },
            })
        }
        Kind::Scenes {
            scene,
            other,
            figure,
        } => {
            let told = bench.alone(&[(scene, 1), (other, 1)], length)?;
            let [ours, theirs] = [0, 1].map(|racer| outcomes(&told[racer]));
            let ratio = told[0]
                .iter()
                .zip(&told[1])
                .map(|(ours, theirs)| match figure {
                    Figure::Speed => theirs.cost() / ours.cost(),
                    Figure::Cost => ours.cost() / theirs.cost(),
                });
            Ok(Row {
                case,
                ours: speed(&ours),
                other: format!("`{other}`"),
                theirs: Some(speed(&theirs)),
                ratio: Spread::of(ratio),
                error: accuracy::of_energy(&told[0][0]),
            })
        }
        Kind::Memory { scene } => {
            let told = bench.ours.run(scene, 1, Floor::Closed, length)?;
            let bytes = told
                .peak_memory
                .context("this system does not tell the memory of a process; measure on Linux")?;
            Ok(Row {
                case,
                ours: speed(&[told.outcome()]),
                other: "pellet".to_owned(),
                theirs: None,
                ratio: Spread::of([bytes / told.pellets]),
                error: accuracy::of_energy(&told),
            })
        }
        Kind::FreePellet { scene } => {
            let told = bench.alone(&[(scene, 1)], length)?;
            let error = told[0][0].flight_error.unwrap_or(f64::NAN);
            Ok(Row {
                case,
                ours: speed(&outcomes(&told[0])),
                other: "step".to_owned(),
                theirs: None,
                ratio: Spread::of(told[0].iter().map(|run| 1.0e6 * run.cost())),
                error: AnswerError {
                    ours: error,
                    theirs: None,
                    of: "place against the parabola, over the way".to_owned(),
                },
            })
        }
    }
}

fn outcomes(told: &[Told]) -> Vec<Outcome> {
    told.iter().map(Told::outcome).collect()
}
