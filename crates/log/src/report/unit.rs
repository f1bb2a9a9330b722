//! Names of quantities as they are read: `mass_flow_kg_per_s` is `mass flow` in `kg/s`.

/// Endings of names and the units they stand for, longer ones before those that they end in.
const UNITS: &[(&str, &str)] = &[
    ("_kg_per_m3", "kg/m³"),
    ("_m2_per_s2", "m²/s²"),
    ("_kg_per_s", "kg/s"),
    ("_m_per_s", "m/s"),
    ("_per_s", "1/s"),
    ("_nm", "N·m"),
    ("_m3", "m³"),
    ("_deg", "°"),
    ("_kg", "kg"),
    ("_n", "N"),
    ("_j", "J"),
    ("_s", "s"),
    ("_m", "m"),
];

/// The words of a name and its unit, `-` where it has none.
pub(super) fn words_and_unit(name: &str) -> (String, &'static str) {
    let known = UNITS
        .iter()
        .find_map(|(ending, unit)| Some((name.strip_suffix(ending)?, *unit)));
    let (words, unit) = known.unwrap_or((name, "-"));
    (words.replace('_', " "), unit)
}

#[cfg(test)]
mod tests {
    use super::words_and_unit;

    #[test]
    fn names_are_cut_at_their_unit() {
        for (name, words, unit) in [
            ("mass_flow_kg_per_s", "mass flow", "kg/s"),
            ("pellet_flow_per_s", "pellet flow", "1/s"),
            ("force_z_n", "force z", "N"),
            ("torque_x_nm", "torque x", "N·m"),
            ("greatest_depth_m", "greatest depth", "m"),
            ("solid_fraction", "solid fraction", "-"),
            ("inside", "inside", "-"),
        ] {
            assert_eq!(words_and_unit(name), (words.to_owned(), unit), "{name}");
        }
    }
}
