//! The unit at the end of a quantity's name.

/// Endings of names, the longer ones before those that they end in, and their units.
const UNITS: [(&str, &str); 15] = [
    ("_kg_per_m3", "kg/m³"),
    ("_m2_per_s2", "m²/s²"),
    ("_kg_per_s", "kg/s"),
    ("_m_per_s", "m/s"),
    ("_per_s", "1/s"),
    ("_n_s", "N·s"),
    ("_nm", "N·m"),
    ("_deg", "°"),
    ("_m3", "m³"),
    ("_kg", "kg"),
    ("_pa", "Pa"),
    ("_j", "J"),
    ("_n", "N"),
    ("_m", "m"),
    ("_s", "s"),
];

/// The unit that a name ends in; `-` where it ends in none.
pub(crate) fn unit_of(name: &str) -> &'static str {
    UNITS
        .iter()
        .find(|(ending, _)| name.ends_with(ending))
        .map_or("-", |(_, unit)| unit)
}

/// A name without its unit, as words: `mass_flow_kg_per_s` is `mass flow`.
pub(crate) fn words_of(name: &str) -> String {
    let mut endings = UNITS.iter().map(|(ending, _)| *ending);
    let words = endings.find_map(|ending| name.strip_suffix(ending));
    words.unwrap_or(name).replace('_', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_the_longest_ending_of_a_name() {
        assert_eq!(unit_of("approach_speed_m_per_s"), "m/s");
        assert_eq!(unit_of("pellet_flow_per_s"), "1/s");
        assert_eq!(unit_of("normal_impulse_n_s"), "N·s");
        assert_eq!(unit_of("bulk_density_kg_per_m3"), "kg/m³");
        assert_eq!(unit_of("median_s"), "s");
        assert_eq!(unit_of("pellets"), "-");
        assert_eq!(unit_of("steps"), "-");
    }

    #[test]
    fn words_are_what_stands_before_the_unit() {
        assert_eq!(words_of("mass_flow_kg_per_s"), "mass flow");
        assert_eq!(words_of("greatest_depth_m"), "greatest depth");
        assert_eq!(words_of("solid_fraction"), "solid fraction");
    }

    #[test]
    fn no_ending_hides_a_longer_one() {
        for (place, (long, _)) in UNITS.iter().enumerate() {
            let is_hidden = UNITS[..place]
                .iter()
                .any(|(short, _)| long.ends_with(short));
            assert!(!is_hidden, "{long}");
        }
    }
}
