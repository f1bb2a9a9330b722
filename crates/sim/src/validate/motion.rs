//! What makes a motion impossible.

use super::is_finite;
use crate::motion::{Motion, MotionTable};

/// What is wrong with a motion, and the cure.
pub(super) fn mistake(motion: &Motion) -> Option<String> {
    let is_whole = match motion {
        Motion::Fixed => true,
        Motion::Translating {
            velocity, start, ..
        } => is_finite(*velocity) && start.is_finite(),
        Motion::Rotating {
            center,
            rate,
            start,
            ..
        } => is_finite(*center) && rate.is_finite() && start.is_finite(),
        Motion::Vibrating {
            amplitude,
            frequency,
            swing,
        } => {
            let is_whole =
                |swing: &crate::motion::Swing| is_finite(swing.center) && swing.angle.is_finite();
            is_finite(*amplitude) && frequency.is_finite() && swing.as_ref().is_none_or(is_whole)
        }
        Motion::Table(table) => return mistake_of_table(table),
        Motion::Combined { motions } => return motions.iter().find_map(mistake),
    };
    (!is_whole).then(|| "holds a number that is not finite; correct it".into())
}

fn mistake_of_table(table: &MotionTable) -> Option<String> {
    let rows = table.moments.len();
    if rows < 2 {
        return Some(format!("the table has {rows} rows; expected two or more"));
    }
    let columns = [table.displacements.len(), table.angles.len()];
    if columns != [rows; 2] {
        return Some(format!(
            "the table has {rows} moments, {} displacements and {} angles; expected one of each in every row",
            columns[0], columns[1]
        ));
    }
    let is_whole = table
        .moments
        .iter()
        .chain(&table.angles)
        .all(|value| value.is_finite())
        && table.displacements.iter().copied().all(is_finite)
        && is_finite(table.center);
    if !is_whole {
        return Some("the table holds a number that is not finite; correct it".into());
    }
    let broken = table.moments.windows(2).find(|pair| pair[1] <= pair[0])?;
    Some(format!(
        "the moment {} s does not come after {} s; let the moments of the table rise",
        broken[1], broken[0]
    ))
}
