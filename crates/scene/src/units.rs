//! Units of measurement: `"15 mm"` to 0.015.

use crate::suggest;
use std::fmt;

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A length.
    Length,
    /// A time.
    Time,
    /// A mass.
    Mass,
    /// A speed.
    Speed,
    /// An acceleration.
    Acceleration,
    /// A density.
    Density,
    /// A pressure or a modulus of elasticity.
    Pressure,
    /// A mass per time.
    MassFlow,
    /// A number per time.
    CountRate,
    /// An angle.
    Angle,
    /// A turn per time.
    TurnRate,
    /// A force.
    Force,
    /// A force per length.
    Stiffness,
    /// An energy per area.
    SurfaceEnergy,
    /// An inverse pressure, as a volume worn off over energy.
    Compliance,
    /// An energy per mass.
    SpecificEnergy,
    /// A share of a whole.
    Share,
}

/// What there is to say of a kind.
struct KindFacts {
    kind: Kind,
    /// Name in the schema.
    name: &'static str,
    /// Name in a sentence.
    phrase: &'static str,
    /// Unit of plain numbers.
    si: &'static str,
    example: &'static str,
    /// Largest magnitude that a pellet plant can need, in SI units; more is a slip of the pen.
    largest: f64,
}

#[rustfmt::skip]
const KINDS: &[KindFacts] = &[
    KindFacts { kind: Kind::Length,       name: "length",       phrase: "a length",            si: "m",     example: "15 mm",       largest: 1.0e4 },
    KindFacts { kind: Kind::Time,         name: "time",         phrase: "a time",              si: "s",     example: "2 s",         largest: 1.0e6 },
    KindFacts { kind: Kind::Mass,         name: "mass",         phrase: "a mass",              si: "kg",    example: "250 kg",      largest: 1.0e9 },
    KindFacts { kind: Kind::Speed,        name: "speed",        phrase: "a speed",             si: "m/s",   example: "2 m/s",       largest: 1.0e4 },
    KindFacts { kind: Kind::Acceleration, name: "acceleration", phrase: "an acceleration",     si: "m/s2",  example: "9.81 m/s2",   largest: 1.0e5 },
    KindFacts { kind: Kind::Density,      name: "density",      phrase: "a density",           si: "kg/m3", example: "3700 kg/m3",  largest: 1.0e5 },
    KindFacts { kind: Kind::Pressure,     name: "pressure",     phrase: "a pressure",          si: "Pa",    example: "60 MPa",      largest: 1.0e13 },
    KindFacts { kind: Kind::MassFlow,     name: "mass-flow",    phrase: "a mass flow",         si: "kg/s",  example: "250 t/h",     largest: 1.0e6 },
    KindFacts { kind: Kind::CountRate,    name: "count-rate",   phrase: "a number per time",   si: "1/s",   example: "200 1/s",     largest: 1.0e9 },
    KindFacts { kind: Kind::Angle,        name: "angle",        phrase: "an angle",            si: "rad",   example: "30 deg",      largest: 1.0e3 },
    KindFacts { kind: Kind::TurnRate,     name: "turn-rate",    phrase: "a rate of rotation",  si: "rad/s", example: "10 rpm",      largest: 1.0e5 },
    KindFacts { kind: Kind::Force,        name: "force",        phrase: "a force",             si: "N",     example: "2 kN",        largest: 1.0e12 },
    KindFacts { kind: Kind::Stiffness,    name: "stiffness",    phrase: "a stiffness",         si: "N/m",   example: "200 kN/m",    largest: 1.0e13 },
    KindFacts { kind: Kind::SurfaceEnergy, name: "surface-energy", phrase: "a surface energy",  si: "J/m2",  example: "50 mJ/m2",    largest: 1.0e4 },
    KindFacts { kind: Kind::Compliance,   name: "compliance",   phrase: "an inverse pressure", si: "1/Pa",  example: "1e-13 1/Pa",  largest: 1.0e-3 },
    KindFacts { kind: Kind::SpecificEnergy, name: "specific-energy", phrase: "an energy per mass", si: "J/kg", example: "100 J/kg",  largest: 1.0e7 },
    KindFacts { kind: Kind::Share,        name: "share",        phrase: "a share",             si: "",      example: "0.1 %",       largest: 1.0e3 },
];

const HOUR: f64 = 3600.0;
const TURN: f64 = std::f64::consts::TAU;

/// Symbol, what it measures and its size in SI units.
#[rustfmt::skip]
const UNITS: &[(&str, Kind, f64)] = &[
    ("m", Kind::Length, 1.0), ("km", Kind::Length, 1.0e3), ("cm", Kind::Length, 1.0e-2), ("mm", Kind::Length, 1.0e-3), ("um", Kind::Length, 1.0e-6),
    ("s", Kind::Time, 1.0), ("ms", Kind::Time, 1.0e-3), ("us", Kind::Time, 1.0e-6), ("ns", Kind::Time, 1.0e-9), ("min", Kind::Time, 60.0), ("h", Kind::Time, HOUR),
    ("kg", Kind::Mass, 1.0), ("g", Kind::Mass, 1.0e-3), ("mg", Kind::Mass, 1.0e-6), ("t", Kind::Mass, 1.0e3),
    ("m/s", Kind::Speed, 1.0), ("mm/s", Kind::Speed, 1.0e-3), ("cm/s", Kind::Speed, 1.0e-2), ("km/h", Kind::Speed, 1.0e3 / HOUR), ("m/min", Kind::Speed, 1.0 / 60.0),
    ("m/s2", Kind::Acceleration, 1.0),
    ("kg/m3", Kind::Density, 1.0), ("g/cm3", Kind::Density, 1.0e3), ("t/m3", Kind::Density, 1.0e3),
    ("Pa", Kind::Pressure, 1.0), ("kPa", Kind::Pressure, 1.0e3), ("MPa", Kind::Pressure, 1.0e6), ("GPa", Kind::Pressure, 1.0e9), ("N/mm2", Kind::Pressure, 1.0e6), ("bar", Kind::Pressure, 1.0e5),
    ("kg/s", Kind::MassFlow, 1.0), ("g/s", Kind::MassFlow, 1.0e-3), ("kg/min", Kind::MassFlow, 1.0 / 60.0), ("kg/h", Kind::MassFlow, 1.0 / HOUR), ("t/s", Kind::MassFlow, 1.0e3), ("t/h", Kind::MassFlow, 1.0e3 / HOUR),
    ("1/s", Kind::CountRate, 1.0), ("/s", Kind::CountRate, 1.0), ("Hz", Kind::CountRate, 1.0), ("kHz", Kind::CountRate, 1.0e3), ("1/min", Kind::CountRate, 1.0 / 60.0), ("1/h", Kind::CountRate, 1.0 / HOUR),
    ("rad", Kind::Angle, 1.0), ("deg", Kind::Angle, TURN / 360.0), ("°", Kind::Angle, TURN / 360.0),
    ("rad/s", Kind::TurnRate, 1.0), ("deg/s", Kind::TurnRate, TURN / 360.0), ("rpm", Kind::TurnRate, TURN / 60.0),
    ("N", Kind::Force, 1.0), ("kN", Kind::Force, 1.0e3), ("MN", Kind::Force, 1.0e6), ("daN", Kind::Force, 10.0), ("kgf", Kind::Force, 9.806_65),
    ("N/m", Kind::Stiffness, 1.0), ("kN/m", Kind::Stiffness, 1.0e3), ("MN/m", Kind::Stiffness, 1.0e6), ("N/mm", Kind::Stiffness, 1.0e3),
    ("J/m2", Kind::SurfaceEnergy, 1.0), ("mJ/m2", Kind::SurfaceEnergy, 1.0e-3),
    ("1/Pa", Kind::Compliance, 1.0), ("1/MPa", Kind::Compliance, 1.0e-6), ("1/GPa", Kind::Compliance, 1.0e-9), ("m3/J", Kind::Compliance, 1.0), ("mm3/J", Kind::Compliance, 1.0e-9),
    ("J/kg", Kind::SpecificEnergy, 1.0), ("kJ/kg", Kind::SpecificEnergy, 1.0e3),
    ("%", Kind::Share, 1.0e-2),
];

impl Kind {
    fn facts(self) -> &'static KindFacts {
        KINDS
            .iter()
            .find(|facts| facts.kind == self)
            .expect("every kind has a row in the table")
    }

    /// The kind of a name in the schema.
    pub(crate) fn named(name: &str) -> Option<Self> {
        KINDS
            .iter()
            .find(|facts| facts.name == name)
            .map(|facts| facts.kind)
    }

    pub(crate) fn name(self) -> &'static str {
        self.facts().name
    }

    pub(crate) fn phrase(self) -> &'static str {
        self.facts().phrase
    }

    pub(crate) fn si(self) -> &'static str {
        self.facts().si
    }

    pub(crate) fn example(self) -> &'static str {
        self.facts().example
    }

    pub(crate) fn largest(self) -> f64 {
        self.facts().largest
    }
}

/// A string that is not a quantity of the kind asked for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum UnitError {
    NoNumber,
    NoUnit,
    UnknownUnit {
        unit: String,
        known: Vec<&'static str>,
    },
    WrongKind {
        found: Kind,
    },
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoNumber => write!(f, "does not begin with a number"),
            Self::NoUnit => write!(f, "has no unit"),
            Self::UnknownUnit { unit, known } => {
                let known = suggest::list(known.iter().copied());
                write!(f, "has the unknown unit `{unit}`, expected {known}")
            }
            Self::WrongKind { found } => write!(f, "is {}", found.phrase()),
        }
    }
}

/// Value in SI units of a text such as `15 mm`, and which of the accepted kinds it is.
pub(crate) fn parse(text: &str, accepted: &[Kind]) -> Result<(f64, Kind), UnitError> {
    let text = text.trim();
    let (number, unit) = text.split_at(number_length(text));
    let number: f64 = number.parse().map_err(|_| UnitError::NoNumber)?;
    let unit = plain(unit.trim());
    if unit.is_empty() {
        return Err(UnitError::NoUnit);
    }
    let Some(&(_, kind, size)) = UNITS.iter().find(|(symbol, ..)| *symbol == unit) else {
        let known = UNITS
            .iter()
            .filter(|(_, kind, _)| accepted.contains(kind))
            .map(|(symbol, ..)| *symbol)
            .collect();
        return Err(UnitError::UnknownUnit { unit, known });
    };
    if accepted.contains(&kind) {
        Ok((number * size, kind))
    } else {
        Err(UnitError::WrongKind { found: kind })
    }
}

/// Bytes at the start that belong to the number; the `e` of an exponent counts only before a digit.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let is_digit = |index: usize| bytes.get(index).is_some_and(u8::is_ascii_digit);
    let mut length = 0;
    while let Some(byte) = bytes.get(length) {
        let belongs = match byte {
            b'0'..=b'9' | b'.' => true,
            b'+' | b'-' => length == 0 || matches!(bytes[length - 1], b'e' | b'E'),
            b'e' | b'E' => {
                let is_signed = matches!(bytes.get(length + 1), Some(b'+' | b'-'));
                length > 0 && is_digit(length + 1 + usize::from(is_signed))
            }
            _ => false,
        };
        if !belongs {
            break;
        }
        length += 1;
    }
    length
}

/// The unit in plain letters: `kg/m³`, `kg/m^3` and `kg/m3` are one.
fn plain(unit: &str) -> String {
    unit.chars()
        .filter(|letter| *letter != '^')
        .map(|letter| match letter {
            '³' => '3',
            '²' => '2',
            'µ' | 'μ' => 'u',
            other => other,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_of_the_guide_have_their_si_values() {
        for (text, kind, value) in [
            ("15 mm", Kind::Length, 0.015),
            ("15mm", Kind::Length, 0.015),
            ("-1.5e-1 m", Kind::Length, -0.15),
            ("250 t/h", Kind::MassFlow, 250.0 / 3.6),
            ("60 MPa", Kind::Pressure, 60.0e6),
            ("30 deg", Kind::Angle, std::f64::consts::FRAC_PI_6),
            ("3700 kg/m³", Kind::Density, 3700.0),
            ("3700 kg/m^3", Kind::Density, 3700.0),
            ("200 1/s", Kind::CountRate, 200.0),
            ("10 rpm", Kind::TurnRate, TURN / 6.0),
            ("50 µm", Kind::Length, 50.0e-6),
            ("0.1 %", Kind::Share, 0.001),
            ("2e-4 mm3/J", Kind::Compliance, 2.0e-13),
        ] {
            let (found, found_kind) = parse(text, &[kind]).expect(text);
            assert_eq!(found_kind, kind);
            // One rounding of the product.
            assert!((found / value - 1.0).abs() < 1.0e-15, "{text}: {found}");
        }
    }

    #[test]
    fn a_unit_of_another_kind_is_named() {
        assert_eq!(
            parse("15 kg", &[Kind::Length]),
            Err(UnitError::WrongKind { found: Kind::Mass })
        );
    }

    #[test]
    fn a_misspelt_unit_is_answered_with_the_units_of_its_kind() {
        assert_eq!(
            parse("2 Nm", &[Kind::Force]),
            Err(UnitError::UnknownUnit {
                unit: "Nm".into(),
                known: vec!["N", "kN", "MN", "daN", "kgf"]
            })
        );
    }

    #[test]
    fn text_without_number_or_unit_is_refused() {
        assert_eq!(parse("fast", &[Kind::Speed]), Err(UnitError::NoNumber));
        assert_eq!(parse("15", &[Kind::Length]), Err(UnitError::NoUnit));
        assert_eq!(parse("inf m", &[Kind::Length]), Err(UnitError::NoNumber));
    }

    #[test]
    fn every_symbol_stands_for_one_unit_and_every_example_is_of_its_kind() {
        for (index, (symbol, ..)) in UNITS.iter().enumerate() {
            assert!(
                UNITS[index + 1..].iter().all(|(other, ..)| other != symbol),
                "{symbol}"
            );
        }
        for facts in KINDS {
            assert!(parse(facts.example, &[facts.kind]).is_ok());
            assert_eq!(Kind::named(facts.name), Some(facts.kind));
        }
    }
}
