//! The table: on the screen and in `docs/performance.md`.

use super::case;
use super::row::Row;
use std::collections::BTreeMap;

const HEADINGS: [&str; 9] = [
    "case",
    "ours [M/s]",
    "against",
    "theirs [M/s]",
    "ratio (least to greatest)",
    "target",
    "met",
    "error ours / theirs",
    "of what",
];

/// All rows as a Markdown table.
pub(crate) fn of(rows: &[Row]) -> String {
    let lines: Vec<String> = rows.iter().map(line).collect();
    format!("{}{}", head(), lines.concat())
}

/// A table with new rows in place of those of the same cases; the others of the old table stay.
pub(crate) fn renewed(old: &str, rows: &[Row]) -> String {
    let name = |line: &str| line.split('`').nth(1).map(str::to_owned);
    let mut lines: BTreeMap<String, String> = old
        .lines()
        .filter_map(|line| Some((name(line)?, format!("{line}\n"))))
        .collect();
    for row in rows {
        lines.insert(row.case.name.to_owned(), line(row));
    }
    let kept: Vec<String> = case::names()
        .filter_map(|name| lines.remove(name))
        .collect();
    format!("{}{}", head(), kept.concat())
}

fn head() -> String {
    let rule = ["---"; HEADINGS.len()];
    format!("| {} |\n| {} |\n", HEADINGS.join(" | "), rule.join(" | "))
}

fn line(row: &Row) -> String {
    format!("| {} |\n", row.cells().join(" | "))
}

#[cfg(test)]
mod tests {
    use super::super::race::Spread;
    use super::super::row::AnswerError;
    use super::*;

    fn row(index: usize, ratio: f64) -> Row {
        Row {
            case: case::ALL[index],
            ours: 9.0,
            other: "LIGGGHTS".into(),
            theirs: Some(3.0),
            ratio: Spread::of([ratio - 0.5, ratio, ratio + 0.5]),
            error: AnswerError {
                ours: 1.0e-6,
                theirs: Some(2.0e-6),
                of: "energy left".into(),
            },
        }
    }

    #[test]
    fn a_row_tells_speed_ratio_target_and_error() {
        let table = of(&[row(0, 3.0)]);
        let expected = "| `settled-10k-1-core` | 9.00 | LIGGGHTS | 3.00 | 3.00 (2.50 to 3.50) | ≥ 2.5 | yes | 1.0e-6 / 2.0e-6 | energy left |";
        assert!(table.lines().any(|line| line == expected), "{table}");
        assert!(table.starts_with("| case | ours"), "{table}");
    }

    #[test]
    fn measuring_some_cases_anew_keeps_the_others_in_the_order_of_the_cases() {
        let old = of(&[row(0, 3.0), row(2, 1.0)]);
        let new = renewed(&old, &[row(1, 2.0), row(2, 4.0)]);
        let names: Vec<&str> = new
            .lines()
            .skip(2)
            .filter_map(|line| line.split('`').nth(1))
            .collect();
        let expected: Vec<&str> = case::names().take(3).collect();
        assert_eq!(names, expected);
        assert!(
            new.contains("4.00 (3.50") && !new.contains("1.00 (0.50"),
            "{new}"
        );
    }

    #[test]
    fn json_has_the_numbers_that_a_program_asks_for() {
        let json = row(0, 2.0).json();
        assert_eq!(json["case"], "settled-10k-1-core");
        assert_eq!(
            (json["ratio"].as_f64(), json["target"].as_f64()),
            (Some(2.0), Some(2.5))
        );
        assert_eq!(
            (json["error"].as_f64(), json["met"].as_bool()),
            (Some(1.0e-6), Some(false))
        );
    }
}
