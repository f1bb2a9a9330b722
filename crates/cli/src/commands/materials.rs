//! `pelletflow materials`.

use crate::args::safe_speed::MaterialsArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, chosen};
use pelletflow_core::material::library::{LIBRARY, LibraryMaterial};
use serde_json::{Value, json};

/// Lists the named materials with their sources.
pub(crate) fn materials(arguments: &MaterialsArguments) -> Result<Exit, Failure> {
    if arguments.json {
        let list: Value = LIBRARY.iter().map(json_of).collect();
        screen::json(&list)?;
    } else {
        screen::result(&page())?;
    }
    Ok(Exit::Done)
}

fn page() -> String {
    let known = |value: Option<f64>| value.map_or_else(String::new, chosen);
    let rows = LIBRARY.iter().map(|entry| {
        let material = &entry.material;
        let [least, greatest] = entry.youngs_modulus_range;
        [
            entry.name.to_owned(),
            entry.description.to_owned(),
            chosen(material.density),
            chosen(material.youngs_modulus * 1.0e-6),
            format!(
                "{} to {}",
                chosen(least * 1.0e-6),
                chosen(greatest * 1.0e-6)
            ),
            chosen(material.shear_modulus() * 1.0e-6),
            chosen(material.poisson_ratio),
            known(entry.restitution),
            known(entry.friction),
        ]
    });
    let header = [
        "name",
        "what",
        "density [kg/m3]",
        "E [MPa]",
        "E between [MPa]",
        "G [MPa]",
        "ν [-]",
        "e on pellet [-]",
        "μ on pellet [-]",
    ];
    let table = table::listing(header, &[2, 3, 5, 6, 7, 8], rows);
    let sources: Vec<String> = LIBRARY
        .iter()
        .map(|entry| format!("{}: {}", entry.name, entry.source))
        .collect();
    format!("{table}\n\nSources\n{}", sources.join("\n"))
}

fn json_of(entry: &LibraryMaterial) -> Value {
    json!({
        "name": entry.name,
        "description": entry.description,
        "density_kg_per_m3": entry.material.density,
        "youngs_modulus_pa": entry.material.youngs_modulus,
        "youngs_modulus_range_pa": entry.youngs_modulus_range,
        "shear_modulus_pa": entry.material.shear_modulus(),
        "poisson_ratio": entry.material.poisson_ratio,
        "diameter_m": entry.diameter,
        "restitution_on_pellet": entry.restitution,
        "friction_on_pellet": entry.friction,
        "source": entry.source,
    })
}
