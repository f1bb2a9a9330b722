//! Quantities, lists and ranges as they stand on the command line.

use pelletflow_scene::{Kind, measure};

pub(crate) fn length(text: &str) -> Result<f64, String> {
    positive(text, Kind::Length)
}

pub(crate) fn modulus(text: &str) -> Result<f64, String> {
    positive(text, Kind::Pressure)
}

pub(crate) fn density(text: &str) -> Result<f64, String> {
    positive(text, Kind::Density)
}

pub(crate) fn speed(text: &str) -> Result<f64, String> {
    positive(text, Kind::Speed)
}

pub(crate) fn time(text: &str) -> Result<f64, String> {
    positive(text, Kind::Time)
}

pub(crate) fn force(text: &str) -> Result<f64, String> {
    positive(text, Kind::Force)
}

/// A share such as `1%` or 0.01.
pub(crate) fn share(text: &str) -> Result<f64, String> {
    measure(text, Kind::Share).map_err(|error| error.to_string())
}

/// A share of at least something and less than all.
pub(crate) fn risk(text: &str) -> Result<f64, String> {
    let risk = share(text)?;
    if risk > 0.0 && risk < 1.0 {
        return Ok(risk);
    }
    Err(format!(
        "a share of {risk} is none; expected more than 0 and less than 1, for example 1%"
    ))
}

/// An angle; a plain number here is in degrees, as on a drawing.
pub(crate) fn angle(text: &str) -> Result<f64, String> {
    let angle = match text.trim().parse::<f64>() {
        Ok(degrees) => degrees.to_radians(),
        Err(_) => measure(text, Kind::Angle).map_err(|error| error.to_string())?,
    };
    if (0.0..std::f64::consts::FRAC_PI_2).contains(&angle) {
        return Ok(angle);
    }
    Err("expected 0 or more and less than 90deg, from the normal of the surface".into())
}

/// A restitution in (0, 1].
pub(crate) fn restitution(text: &str) -> Result<f64, String> {
    let value = plain(text)?;
    if value > 0.0 && value <= 1.0 {
        return Ok(value);
    }
    Err(format!(
        "a restitution of {value} is none; expected more than 0 and at most 1, where 1 is elastic"
    ))
}

/// A friction of 0 or more.
pub(crate) fn friction(text: &str) -> Result<f64, String> {
    let value = plain(text)?;
    if value >= 0.0 {
        return Ok(value);
    }
    Err(format!("a friction of {value} is none; expected 0 or more"))
}

/// A number without a unit.
pub(crate) fn plain(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err("expected a number without a unit, for example 0.25".into()),
    }
}

fn positive(text: &str, kind: Kind) -> Result<f64, String> {
    let value = measure(text, kind).map_err(|error| error.to_string())?;
    if value > 0.0 {
        return Ok(value);
    }
    Err("expected more than 0".into())
}

/// Speeds given as one value, a list or a range.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Speeds(pub(crate) Vec<f64>);

/// Most speeds of one call; more is a slip of the pen [-].
const MOST_SPEEDS: usize = 1000;

/// Speeds such as `5`, `1,2.5,8m/s`, `1..8` or `1..8:0.5`; without a step, a range goes in steps of 1 m/s.
pub(crate) fn speeds(text: &str) -> Result<Speeds, String> {
    let mut all = Vec::new();
    for part in text.split(',') {
        match part.split_once("..") {
            None => all.push(speed(part)?),
            Some((start, rest)) => {
                let (end, step) = rest.split_once(':').unwrap_or((rest, "1 m/s"));
                all.extend(steps(speed(start)?, speed(end)?, speed(step)?)?);
            }
        }
    }
    if all.len() > MOST_SPEEDS {
        return Err(format!(
            "more than {MOST_SPEEDS} speeds; take a larger step"
        ));
    }
    Ok(Speeds(all))
}

fn steps(start: f64, end: f64, step: f64) -> Result<Vec<f64>, String> {
    if end < start {
        return Err(format!(
            "the range runs backwards, from {start} to {end} m/s; write {end}..{start}"
        ));
    }
    // A step that divides the range leaves its end in, whatever the rounding.
    let count = ((end - start) / step + 1.0e-9).floor();
    if count >= MOST_SPEEDS as f64 {
        return Err(format!(
            "more than {MOST_SPEEDS} speeds; take a larger step"
        ));
    }
    if count == 0.0 && end > start {
        return Err(format!(
            "a step of {step} m/s is longer than the range; write for example {start}..{end}:{}",
            (end - start) / 4.0
        ));
    }
    Ok((0..=count as usize)
        .map(|index| start + index as f64 * step)
        .collect())
}

/// Two moduli such as `40MPa..80MPa`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ModulusRange {
    pub(crate) least: f64,
    pub(crate) greatest: f64,
}

pub(crate) fn modulus_range(text: &str) -> Result<ModulusRange, String> {
    let (least, greatest) = text
        .split_once("..")
        .ok_or("expected two moduli, for example 40MPa..80MPa")?;
    let (least, greatest) = (modulus(least)?, modulus(greatest)?);
    if greatest < least {
        return Err("the range runs backwards; write the smaller modulus first".into());
    }
    Ok(ModulusRange { least, greatest })
}

/// Two values of one unit, such as `2..15m/s`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ValueRange {
    pub(crate) least: f64,
    pub(crate) greatest: f64,
    /// The unit as it was written; empty where there is none.
    pub(crate) unit: String,
}

pub(crate) fn value_range(text: &str) -> Result<ValueRange, String> {
    let example = "expected two values of one unit, for example 2..15m/s";
    let (low, high) = text.split_once("..").ok_or(example)?;
    let parted = |text: &str| -> Result<(f64, String), String> {
        let text = text.trim();
        // The longest beginning that is a number: what follows is the unit.
        (1..=text.len())
            .rev()
            .filter(|&end| text.is_char_boundary(end))
            .find_map(|end| Some((text[..end].trim_end().parse().ok()?, text[end..].trim())))
            .filter(|(number, _): &(f64, _)| number.is_finite())
            .map(|(number, unit)| (number, unit.to_owned()))
            .ok_or_else(|| format!("`{text}` begins with no number; {example}"))
    };
    let ((least, unit_of_least), (greatest, unit)) = (parted(low)?, parted(high)?);
    if !unit_of_least.is_empty() && unit_of_least != unit {
        return Err(format!(
            "`{unit_of_least}` and `{unit}` are two units; {example}"
        ));
    }
    if greatest <= least {
        return Err("the range runs backwards or is empty; write the smaller value first".into());
    }
    Ok(ValueRange {
        least,
        greatest,
        unit,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_are_values_lists_and_ranges() {
        let of = |text| speeds(text).expect(text).0;
        assert_eq!(of("5"), [5.0]);
        assert_eq!(of("1,2.5,8m/s"), [1.0, 2.5, 8.0]);
        assert_eq!(of("1..4"), [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(of("3.6km/h..2:0.5"), [1.0, 1.5, 2.0]);
        assert_eq!(of("2..2"), [2.0]);
        // The sum of tenths is rounded; the end is there all the same.
        assert_eq!(of("0.1..0.4:0.1").len(), 4);
    }

    #[test]
    fn wrong_speeds_are_refused_with_a_cure() {
        for (text, expected) in [
            ("8..1", "runs backwards, from 8 to 1 m/s; write 1..8"),
            ("0..8", "expected more than 0"),
            ("1 kg", "is a mass; expected a speed"),
            ("1..8:1e-9", "take a larger step"),
            (
                "1..1.5",
                "longer than the range; write for example 1..1.5:0.125",
            ),
            ("", "expected a speed"),
        ] {
            let message = speeds(text).expect_err(text);
            assert!(message.contains(expected), "{text}: {message}");
        }
    }

    #[test]
    fn plain_angles_are_degrees() {
        assert_eq!(angle("45"), angle("45deg"));
        assert!(angle("90deg").is_err());
        assert!(angle("1kg").is_err());
    }
}
