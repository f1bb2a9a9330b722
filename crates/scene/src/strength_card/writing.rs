//! A strength card as the text of its file.

use super::{Provenance, StrengthCard};
use pelletflow_impact::{FractureEnergy, MedianEnergy, Scatter};
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, Table, Value, value};

/// What stands at the head of a written card.
const HEAD: &str = "# A strength card; plain numbers are in SI units: N, m, J/kg, m/s.\n";

impl StrengthCard {
    /// The text of a file that [`Self::read`] takes for the same card.
    pub fn to_toml(&self) -> String {
        let mut document = DocumentMut::new();
        let root = document.as_table_mut();
        put(root, "name", Some(self.name.as_str()));
        put(root, "source", Some(self.source.as_str()));
        match self.strength.scatter {
            Scatter::Fixed(load) => {
                put(root, "distribution", Some("fixed"));
                put(root, "mean", Some(load));
            }
            Scatter::Weibull { scale, modulus } => {
                put(root, "distribution", Some("weibull"));
                put(root, "scale", Some(scale));
                put(root, "modulus", Some(modulus));
            }
            Scatter::LogNormal { median, deviation } => {
                put(root, "distribution", Some("log-normal"));
                put(root, "median", Some(median));
                put(root, "deviation", Some(deviation));
            }
        }
        put(root, "test_diameter", self.strength.test_diameter);
        put(
            root,
            "sample_size",
            self.strength.sample_size.map(i64::from),
        );
        put(root, "yield_pressure", self.yield_pressure);
        if let Some(provenance) = &self.provenance {
            root.insert("provenance", Item::Table(provenance_table(provenance)));
        }
        if let Some(energy) = &self.fracture_energy {
            root.insert("fracture_energy", Item::Table(energy_table(energy)));
        }
        if let Some(tumble) = &self.tumble {
            let mut table = Table::new();
            put(&mut table, "tumble_index", Some(tumble.tumble_index));
            put(&mut table, "abrasion_index", tumble.abrasion_index);
            root.insert("tumble", Item::Table(table));
        }
        if !self.drops.is_empty() {
            let levels = self.drops.iter().map(|level| {
                let mut table = Table::new();
                put(&mut table, "speed", Some(level.speed));
                put(&mut table, "dropped", Some(i64::from(level.dropped)));
                put(&mut table, "broken", Some(i64::from(level.broken)));
                table
            });
            root.insert(
                "drops",
                Item::ArrayOfTables(levels.collect::<ArrayOfTables>()),
            );
        }
        format!("{HEAD}{document}")
    }
}

fn provenance_table(provenance: &Provenance) -> Table {
    let mut table = Table::new();
    put(&mut table, "file", provenance.file.as_deref());
    put(&mut table, "date", provenance.date.as_deref());
    put(&mut table, "method", provenance.method.as_deref());
    put(&mut table, "fit", provenance.fit.as_deref());
    put(
        &mut table,
        "center_interval",
        provenance.center_interval.map(list),
    );
    put(
        &mut table,
        "shape_interval",
        provenance.shape_interval.map(list),
    );
    put(
        &mut table,
        "distance",
        provenance.goodness.map(|goodness| goodness.distance),
    );
    put(
        &mut table,
        "p_value",
        provenance.goodness.map(|goodness| goodness.p_value),
    );
    table
}

fn energy_table(energy: &FractureEnergy) -> Table {
    let mut table = Table::new();
    match energy.median {
        MedianEnergy::OfAnySize(median) => put(&mut table, "median", Some(median)),
        MedianEnergy::BySize {
            large,
            stiffness_ratio,
            diameter,
            exponent,
        } => {
            put(&mut table, "large", Some(large));
            put(&mut table, "stiffness_ratio", Some(stiffness_ratio));
            put(&mut table, "characteristic_diameter", Some(diameter));
            put(&mut table, "exponent", Some(exponent));
        }
    }
    put(&mut table, "deviation", Some(energy.deviation));
    put(&mut table, "truncation", energy.truncation);
    put(&mut table, "damage_constant", energy.damage_constant);
    put(&mut table, "sample_size", energy.sample_size.map(i64::from));
    table
}

fn list(ends: [f64; 2]) -> Array {
    ends.into_iter().collect()
}

/// Puts a value where there is one.
fn put(table: &mut Table, key: &str, entry: Option<impl Into<Value>>) {
    if let Some(entry) = entry {
        table.insert(key, value(entry));
    }
}
