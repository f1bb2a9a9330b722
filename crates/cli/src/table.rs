//! Tables of results, and numbers as they stand in them.

use comfy_table::{CellAlignment, Table, presets};
pub(crate) use pelletflow_log::figures::{LEAST_SHARE, chosen, count, number, percent};

/// Rows of a quantity and its value.
pub(crate) fn facts(rows: impl IntoIterator<Item = (String, String)>) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    for (quantity, value) in rows {
        table.add_row([quantity, value]);
    }
    table.trim_fmt()
}

/// Rows under a header; the columns named as numbers are aligned to the right.
pub(crate) fn listing<const N: usize>(
    header: [&str; N],
    numbers: &[usize],
    rows: impl IntoIterator<Item = [String; N]>,
) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.set_header(header);
    for row in rows {
        table.add_row(row);
    }
    for &number in numbers {
        if let Some(column) = table.column_mut(number) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.trim_fmt()
}

/// A span of time as people say it.
pub(crate) fn span(seconds: f64) -> String {
    if seconds < 1.0e-3 {
        format!("{} µs", number(seconds * 1.0e6))
    } else if seconds < 1.0 {
        format!("{} ms", number(seconds * 1.0e3))
    } else if seconds < 120.0 {
        format!("{} s", number(seconds))
    } else if seconds < 2.0 * 3600.0 {
        format!("{:.1} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}

/// A size of a file or of memory.
pub(crate) fn bytes(bytes: u64) -> String {
    let bytes = bytes as f64;
    if bytes < 1.0e6 {
        format!("{} kB", number(bytes / 1.0e3))
    } else if bytes < 1.0e9 {
        format!("{} MB", number(bytes / 1.0e6))
    } else {
        format!("{} GB", number(bytes / 1.0e9))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_and_counts_their_thousands_apart() {
        assert_eq!(number(0.0), "0");
        assert_eq!(number(264.699), "264.7");
        assert_eq!(number(32.692), "32.69");
        assert_eq!(number(0.006_538_4), "0.006538");
        assert_eq!(number(1.25e-5), "1.250e-5");
        assert_eq!(chosen(15.0), "15");
        assert_eq!(chosen(0.45), "0.45");
        assert_eq!(chosen(1200.0), "1200");
        assert_eq!(count(0), "0");
        assert_eq!(count(5000), "5,000");
        assert_eq!(count(1_234_567), "1,234,567");
    }

    #[test]
    fn spans_are_told_in_the_unit_that_people_use() {
        assert_eq!(span(2.5e-5), "25.00 µs");
        assert_eq!(span(90.0), "90.00 s");
        assert_eq!(span(600.0), "10.0 min");
        assert_eq!(span(7200.0), "2.0 h");
    }
}
