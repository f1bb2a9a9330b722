//! The columns of a sheet by name, with every mistake in them.

use super::LabSheet;
use crate::mistakes::{Mistake, Mistakes, Place};
use crate::suggest;
use crate::units::{self, Kind, UnitError};
use csv::{ReaderBuilder, StringRecord, Trim};

/// A column that is asked for.
pub(super) struct Column<'a> {
    kind: Kind,
    /// What it may be called; the first is what messages call it.
    names: &'a [&'static str],
    /// Its unit where the header tells none.
    unit: Option<&'a str>,
}

impl<'a> Column<'a> {
    pub(super) fn of(kind: Kind, names: &'a [&'static str], unit: Option<&'a str>) -> Self {
        Self { kind, names, unit }
    }
}

/// A sheet, taken apart.
pub(super) struct Columns {
    label: String,
    header: StringRecord,
    header_line: usize,
    rows: Vec<(usize, StringRecord)>,
    has_decimal_comma: bool,
    date: Option<String>,
    mistakes: Vec<Mistake>,
}

impl Columns {
    pub(super) fn new(text: &str, label: &str) -> Result<Self, Mistakes> {
        // Spreadsheets put a mark before the first letter.
        let text = text.trim_start_matches('\u{feff}');
        let is_content = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with('#');
        let first = text.lines().find(is_content).unwrap_or_default();
        let separator = [b';', b'\t']
            .into_iter()
            .find(|separator| first.as_bytes().contains(separator))
            .unwrap_or(b',');
        let mut reader = ReaderBuilder::new()
            .comment(Some(b'#'))
            .delimiter(separator)
            .flexible(true)
            .has_headers(false)
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        let mut mistakes = Vec::new();
        for record in reader.records() {
            match record {
                Ok(record) if record.iter().all(str::is_empty) => {}
                Ok(record) => {
                    let line = record.position().map_or(0, csv::Position::line) as usize;
                    rows.push((line, record));
                }
                Err(error) => {
                    let line = error.position().map_or(0, csv::Position::line) as usize;
                    let message = format!("this is no row of values: {error}; look at the quotes");
                    mistakes.push(mistake(label, line, "", message));
                }
            }
        }
        if rows.is_empty() {
            let message = "the sheet is empty; write a header such as `load [kN]` and one line for each pellet";
            let place = Place::Whole;
            return Err(Mistakes::new(vec![Mistake {
                file: label.into(),
                place,
                key: String::new(),
                message: message.into(),
            }]));
        }
        let (header_line, header) = rows.remove(0);
        Ok(Self {
            label: label.into(),
            header,
            header_line,
            rows,
            has_decimal_comma: separator != b',',
            date: text.lines().find_map(date),
            mistakes,
        })
    }

    pub(super) fn has(&self, column: &Column<'_>) -> bool {
        self.place(column.names).is_some()
    }

    pub(super) fn is_good(&self) -> bool {
        self.mistakes.is_empty()
    }

    /// The values of a column in SI units, all more than 0.
    pub(super) fn quantity(&mut self, column: &Column<'_>) -> Vec<f64> {
        let Some(place) = self.found(column.names) else {
            return Vec::new();
        };
        let title = self.header[place].to_owned();
        let (name, unit) = name_and_unit(&title);
        let unit = unit.or(column.unit).unwrap_or_default().to_owned();
        let size = match units::parse(&format!("1 {unit}"), &[column.kind]) {
            Ok((size, _)) => size,
            Err(error) => {
                let (phrase, example) = (column.kind.phrase(), unit_of(column.kind));
                let message = match error {
                    UnitError::NoUnit => format!(
                        "the column has no unit; name it `{name} [{example}]`, or give --unit"
                    ),
                    UnitError::WrongKind { found } => format!(
                        "`{unit}` is {}; expected {phrase}, for example `{name} [{example}]`",
                        found.phrase()
                    ),
                    _ => format!("the column {error}; name it for example `{name} [{example}]`"),
                };
                self.mistakes
                    .push(mistake(&self.label, self.header_line, &title, message));
                return Vec::new();
            }
        };
        let noun = column.names[0];
        let mut values = Vec::with_capacity(self.rows.len());
        for row in 0..self.rows.len() {
            let text = self.rows[row].1.get(place).unwrap_or_default().to_owned();
            let written = if self.has_decimal_comma {
                text.replacen(',', ".", 1)
            } else {
                text.clone()
            };
            let problem = match written.parse::<f64>() {
                Ok(value) if value.is_finite() && value > 0.0 => {
                    values.push(value * size);
                    continue;
                }
                Ok(value) if value.is_finite() => format!(
                    "the {noun} is {text} {unit}; expected more than 0: take the line out where no {noun} was measured"
                ),
                _ if text.is_empty() => {
                    "the value is missing; write it, or take the line out".into()
                }
                _ => {
                    format!("`{text}` is no number; expected a {noun} in {unit}, for example 2.45")
                }
            };
            self.at_row(row, &title, problem);
        }
        values
    }

    /// The values of a column of whole numbers.
    pub(super) fn counts(&mut self, name: &'static str, least: u32) -> Vec<u32> {
        let Some(place) = self.found(&[name]) else {
            return Vec::new();
        };
        let mut counts = Vec::with_capacity(self.rows.len());
        for row in 0..self.rows.len() {
            let text = self.rows[row].1.get(place).unwrap_or_default().to_owned();
            match text.parse::<u32>() {
                Ok(count) if count >= least => counts.push(count),
                _ => self.at_row(
                    row,
                    name,
                    format!("`{text}` is no count; expected a whole number of {least} or more"),
                ),
            }
        }
        counts
    }

    /// A mistake in a row, counted from 0.
    pub(super) fn at_row(&mut self, row: usize, key: &str, message: String) {
        let line = self.rows[row].0;
        self.mistakes.push(mistake(&self.label, line, key, message));
    }

    /// A mistake of the whole sheet.
    pub(super) fn whole(&mut self, message: String) {
        self.mistakes.push(Mistake {
            file: self.label.clone(),
            place: Place::Whole,
            key: String::new(),
            message,
        });
    }

    pub(super) fn end<Test>(self, test: Test) -> Result<LabSheet<Test>, Mistakes> {
        if self.mistakes.is_empty() {
            return Ok(LabSheet {
                test,
                date: self.date,
            });
        }
        Err(Mistakes::new(self.mistakes))
    }

    fn place(&self, names: &[&str]) -> Option<usize> {
        self.header.iter().position(|title| {
            let name = name_and_unit(title).0.to_lowercase();
            names.contains(&name.as_str())
        })
    }

    /// The place of a column that has to be there.
    fn found(&mut self, names: &[&str]) -> Option<usize> {
        let place = self.place(names);
        if place.is_none() {
            let columns: Vec<&str> = self.header.iter().collect();
            let message = format!(
                "there is no column `{}`; the columns are {}: name one so",
                names[0],
                suggest::list(columns.iter().copied())
            );
            self.mistakes
                .push(mistake(&self.label, self.header_line, "", message));
        }
        place
    }
}

/// The unit that an example of a kind is written in.
fn unit_of(kind: Kind) -> &'static str {
    kind.example()
        .split_once(' ')
        .map_or(kind.si(), |(_, unit)| unit)
}

/// A title taken apart: `load [kN]`, `load (kN)` and `load_kN`.
fn name_and_unit(title: &str) -> (&str, Option<&str>) {
    let split = title
        .split_once(['[', '('])
        .map(|(name, unit)| (name, unit.trim_end_matches([']', ')'])))
        .or_else(|| title.rsplit_once('_'));
    match split {
        Some((name, unit)) => (
            name.trim(),
            Some(unit.trim()).filter(|unit| !unit.is_empty()),
        ),
        None => (title.trim(), None),
    }
}

/// What a comment `# date: …` says.
fn date(line: &str) -> Option<String> {
    let comment = line.trim().strip_prefix('#')?;
    let (key, date) = comment.split_once(':')?;
    (key.trim().eq_ignore_ascii_case("date")).then(|| date.trim().to_owned())
}

fn mistake(label: &str, line: usize, key: &str, message: String) -> Mistake {
    Mistake {
        file: label.into(),
        place: Place::Line { line, column: None },
        key: key.into(),
        message,
    }
}
