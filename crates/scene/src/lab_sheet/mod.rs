//! Sheets of the laboratory: crushing and drop tests as tables of comma-separated values.

mod columns;

use crate::mistakes::Mistakes;
use crate::source::Source;
use crate::units::Kind;
use columns::{Column, Columns};
use pelletflow_impact::{
    CrushTest, DropLevel, crush_test::FEWEST_LOADS, safe_speed::speed_of_fall,
};
use std::io;
use std::path::{Path, PathBuf};

/// Mean loads of a sheet of pellets; beyond, the unit is a slip of the pen [N].
const MEAN_LOADS: (f64, f64) = (10.0, 1.0e5);

/// A sheet of the laboratory as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct LabSheet<Test> {
    /// The test.
    pub test: Test,
    /// Date of the sheet, from a comment `# date: 2024-07-01`, as it stands there.
    pub date: Option<String>,
}

/// A sheet that cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum LabSheetError {
    /// The file could not be read.
    #[error("{}: cannot be read: {source}; name a file of comma-separated values", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// The file was read, and something in it is wrong.
    #[error(transparent)]
    Invalid(#[from] Mistakes),
}

impl LabSheet<CrushTest> {
    /// Reads a crushing test: a column `load`, and where they were measured a column `diameter`.
    ///
    /// A header tells the unit, as in `load [kN]` or `load_kN`; `unit` that of loads where the header tells none.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or there are mistakes in it; all that were found.
    pub fn read(path: &Path, unit: Option<&str>) -> Result<Self, LabSheetError> {
        Ok(Self::parse(
            &text_of(path)?,
            &path.display().to_string(),
            unit,
        )?)
    }

    /// The same of a text; `label` names it in messages.
    ///
    /// # Errors
    ///
    /// The mistakes found in it.
    pub fn parse(text: &str, label: &str, unit: Option<&str>) -> Result<Self, Mistakes> {
        let mut sheet = Columns::new(text, label)?;
        let loads = sheet.quantity(&Column::of(
            Kind::Force,
            &["load", "force", "strength", "ccs"],
            unit,
        ));
        let diameter = Column::of(Kind::Length, &["diameter", "size"], None);
        let diameters = sheet.has(&diameter).then(|| sheet.quantity(&diameter));
        if sheet.is_good() {
            if loads.len() < FEWEST_LOADS {
                sheet.whole(format!(
                    "there are {} loads; expected at least {FEWEST_LOADS} and better 60 (ISO 4700): crush more pellets",
                    loads.len()
                ));
            } else if loads.iter().all(|load| *load == loads[0]) {
                sheet.whole(format!(
                    "all {} loads are {} N; a distribution cannot be fitted to one value: write what each pellet bore, or \
                     write a card with distribution = \"fixed\"",
                    loads.len(),
                    loads[0]
                ));
            }
            let mean = loads.iter().sum::<f64>() / loads.len() as f64;
            if !(MEAN_LOADS.0..=MEAN_LOADS.1).contains(&mean) {
                sheet.whole(format!(
                    "the mean load is {mean:.3e} N; expected between {} N and {} N for a pellet: look at the unit of the \
                     column",
                    MEAN_LOADS.0, MEAN_LOADS.1
                ));
            }
        }
        sheet.end(CrushTest { loads, diameters })
    }
}

impl LabSheet<Vec<DropLevel>> {
    /// Reads a drop test: a column `speed` or `height`, and columns `dropped` and `broken`, one line for each level.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or there are mistakes in it; all that were found.
    pub fn read(path: &Path) -> Result<Self, LabSheetError> {
        Ok(Self::parse(&text_of(path)?, &path.display().to_string())?)
    }

    /// The same of a text; `label` names it in messages.
    ///
    /// # Errors
    ///
    /// The mistakes found in it.
    pub fn parse(text: &str, label: &str) -> Result<Self, Mistakes> {
        let mut sheet = Columns::new(text, label)?;
        let height = Column::of(Kind::Length, &["height"], None);
        let speed = Column::of(Kind::Speed, &["speed"], None);
        let speeds: Vec<f64> = if sheet.has(&height) {
            let heights = sheet.quantity(&height);
            heights.into_iter().map(speed_of_fall).collect()
        } else {
            sheet.quantity(&speed)
        };
        let dropped = sheet.counts("dropped", 1);
        let broken = sheet.counts("broken", 0);
        let levels = if sheet.is_good() {
            let counts = dropped.into_iter().zip(broken);
            let levels = speeds.into_iter().zip(counts);
            levels
                .map(|(speed, (dropped, broken))| DropLevel {
                    speed,
                    dropped,
                    broken,
                })
                .collect()
        } else {
            Vec::new()
        };
        for (row, level) in levels.iter().enumerate() {
            if level.broken > level.dropped {
                sheet.at_row(
                    row,
                    "broken",
                    format!(
                        "{} pellets broke of {} dropped; expected at most as many",
                        level.broken, level.dropped
                    ),
                );
            }
        }
        if sheet.is_good() && levels.is_empty() {
            sheet.whole("there are no drops; write one line for each speed or height".into());
        }
        sheet.end(levels)
    }
}

fn text_of(path: &Path) -> Result<String, LabSheetError> {
    let text = Source::read(path).map_err(|source| LabSheetError::Unreadable {
        path: path.to_owned(),
        source,
    })??;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crush(text: &str) -> Result<LabSheet<CrushTest>, Mistakes> {
        LabSheet::<CrushTest>::parse(text, "loads.csv", None)
    }

    #[test]
    fn loads_and_diameters_come_in_their_units() {
        let text = "# works A\n# date: 2024-07-01\nnumber,load [kN],diameter_mm\n1,2.4,12\n\n2, 2.6 ,11.5\n3,1.9,12.5\n";
        let sheet = crush(text).expect("a good sheet");
        assert_eq!(sheet.date.as_deref(), Some("2024-07-01"));
        assert_eq!(sheet.test.loads, [2400.0, 2600.0, 1900.0]);
        assert_eq!(
            sheet.test.diameters.as_deref(),
            Some(&[0.012, 0.0115, 0.0125][..])
        );
        for (header, unit, load) in [
            ("Load (N)", None, 2.0),
            ("FORCE_daN", None, 20.0),
            ("strength [kgf]", None, 19.6133),
            ("load", Some("kgf"), 19.6133),
        ] {
            let text = format!("{header}\n200\n201\n2\n");
            let sheet = LabSheet::<CrushTest>::parse(&text, "loads.csv", unit).expect(header);
            assert!(
                (sheet.test.loads[2] / load - 1.0).abs() < 1.0e-12,
                "{header}"
            );
        }
    }

    #[test]
    fn semicolons_go_with_decimal_commas() {
        let sheet =
            crush("load [kN];diameter [mm]\n2,4;12,5\n2,6;12\n1,9;11\n").expect("a good sheet");
        assert_eq!(sheet.test.loads, [2400.0, 2600.0, 1900.0]);
        assert_eq!(
            sheet.test.diameters.as_deref(),
            Some(&[0.0125, 0.012, 0.011][..])
        );
    }

    #[test]
    fn mistakes_of_a_sheet_are_told_with_line_and_cure() {
        for (text, expected) in [
            ("", "loads.csv: the sheet is empty"),
            ("# only a comment\n", "the sheet is empty"),
            (
                "load [N]\n2000\nabout 2000\n2100\n",
                "loads.csv:3: load [N]: `about 2000` is no number; expected a load in N",
            ),
            (
                "load [N]\n2000\n-5\n2100\n",
                "loads.csv:3: load [N]: the load is -5 N; expected more than 0",
            ),
            (
                "load [N]\n2000\n0\n2100\n",
                "loads.csv:3: load [N]: the load is 0 N; expected more than 0",
            ),
            ("load [N]\n2000\nNaN\n2100\n", "`NaN` is no number"),
            (
                "load [N],x\n2000,1\n,2\n2100,1\n",
                "loads.csv:3: load [N]: the value is missing",
            ),
            (
                "load [N]\n2000\n2100\n",
                "there are 2 loads; expected at least 3",
            ),
            ("load [N]\n2000\n2000\n2000\n", "all 3 loads are 2000 N"),
            (
                "load [kg]\n200\n201\n202\n",
                "loads.csv:1: load [kg]: `kg` is a mass; expected a force, for example `load [kN]`",
            ),
            ("load [Nm]\n200\n201\n202\n", "unknown unit `Nm`"),
            (
                "load\n200\n201\n202\n",
                "the column has no unit; name it `load [kN]`",
            ),
            (
                "weight [N]\n200\n201\n202\n",
                "there is no column `load`; the columns are `weight [N]`",
            ),
            (
                "load [kN]\n2000\n2100\n2200\n",
                "the mean load is 2.100e6 N; expected between 10 N and 100000 N",
            ),
        ] {
            let message = crush(text).expect_err(text).to_string();
            assert!(message.contains(expected), "{text}: {message}");
        }
    }

    #[test]
    fn drops_are_levels_of_speed_or_of_height() {
        let parse = |text| LabSheet::<Vec<DropLevel>>::parse(text, "drops.csv");
        let levels = parse("height [m],dropped,broken\n5,40,3\n")
            .expect("good")
            .test;
        // √(2 · 9.80665 · 5).
        assert!((levels[0].speed - 9.902_854).abs() < 1.0e-6);
        let levels = parse("speed [m/s],dropped,broken\n8,40,0\n")
            .expect("good")
            .test;
        assert_eq!(
            (levels[0].speed, levels[0].dropped, levels[0].broken),
            (8.0, 40, 0)
        );
        for (text, expected) in [
            (
                "speed [m/s],dropped,broken\n8,40,41\n",
                "drops.csv:2: broken: 41 pellets broke of 40 dropped",
            ),
            (
                "speed [m/s],dropped,broken\n8,0,0\n",
                "drops.csv:2: dropped: `0` is no count; expected a whole number of 1 or more",
            ),
            (
                "speed [m/s],dropped,broken\n8,40,1.5\n",
                "broken: `1.5` is no count",
            ),
            ("speed [m/s],dropped\n8,40\n", "there is no column `broken`"),
            ("speed [m/s],dropped,broken\n", "there are no drops"),
        ] {
            let message = parse(text).expect_err(text).to_string();
            assert!(message.contains(expected), "{text}: {message}");
        }
    }
}
