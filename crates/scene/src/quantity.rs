//! Quantities of a scene: a plain number in SI units, or a text with a unit.

use crate::units::{self, Kind};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, Visitor};
use std::borrow::Cow;
use std::fmt;

/// Which values a quantity may take, beside the largest magnitude of its kind.
#[derive(Debug, Clone, Copy)]
enum Range {
    Any,
    NotNegative,
    Positive,
}

fn schema_of(kinds: &[Kind], range: Range) -> Schema {
    let names: Vec<&str> = kinds.iter().map(|kind| kind.name()).collect();
    let examples: Vec<&str> = kinds.iter().map(|kind| kind.example()).collect();
    let largest = kinds.iter().map(|kind| kind.largest()).fold(0.0, f64::max);
    let mut schema = json_schema!({
        "type": ["number", "string"],
        "x-quantity": names,
        "examples": examples,
        "maximum": largest,
    });
    match range {
        Range::Any => schema.insert("minimum".into(), (-largest).into()),
        Range::NotNegative => schema.insert("minimum".into(), 0.0.into()),
        Range::Positive => schema.insert("exclusiveMinimum".into(), 0.0.into()),
    };
    schema
}

/// Reads a number, or a text with a unit of one of these kinds.
struct AnyOf(&'static [Kind]);

impl Visitor<'_> for AnyOf {
    type Value = (f64, Kind);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0[0].phrase())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Self::Value, E> {
        Ok((value, self.0[0]))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        units::parse(text, self.0).map_err(|error| E::custom(format!("`{text}` {error}")))
    }
}

macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident: $kind:ident, $range:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub(crate) struct $name(pub(crate) f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let (value, _) = deserializer.deserialize_any(AnyOf(&[Kind::$kind]))?;
                Ok(Self(value))
            }
        }

        impl JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                schema_of(&[Kind::$kind], Range::$range)
            }
        }
    )*};
}

quantities! {
    /// A place along an axis [m].
    Coordinate: Length, Any;
    /// How large something is [m].
    Size: Length, Positive;
    /// A moment of simulated time [s].
    Moment: Time, NotNegative;
    /// A span of time [s].
    Duration: Time, Positive;
    /// A span of time that may be nothing [s].
    Pause: Time, NotNegative;
    /// A mass [kg].
    Mass: Mass, Positive;
    /// A velocity along an axis [m/s].
    Velocity: Speed, Any;
    /// A speed [m/s].
    Speed: Speed, Positive;
    /// A speed that may be nothing [m/s].
    SpeedBound: Speed, NotNegative;
    /// An acceleration along an axis [m/s²].
    Acceleration: Acceleration, Any;
    /// A density [kg/m³].
    Density: Density, Positive;
    /// A modulus of elasticity [Pa].
    Modulus: Pressure, Positive;
    /// Swings per time [1/s].
    Frequency: CountRate, Positive;
    /// An angle [rad].
    Angle: Angle, Any;
    /// A turn per time [rad/s].
    TurnRate: TurnRate, Any;
    /// A force [N].
    Force: Force, Positive;
    /// A force per length [N/m].
    Stiffness: Stiffness, Positive;
    /// An energy per area [J/m²].
    SurfaceEnergy: SurfaceEnergy, Positive;
    /// A volume worn off over energy [1/Pa].
    WearCoefficient: Compliance, Positive;
    /// An energy per mass [J/kg].
    SpecificEnergy: SpecificEnergy, Positive;
    /// A share of a whole [-].
    Share: Share, Positive;
    /// A share of a whole that may be nothing [-].
    Portion: Share, NotNegative;
}

/// How fast pellets come: mass per time [kg/s] or pellets per time [1/s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FeedRate {
    Mass(f64),
    Count(f64),
}

impl FeedRate {
    const KINDS: &'static [Kind] = &[Kind::MassFlow, Kind::CountRate];
}

impl<'de> Deserialize<'de> for FeedRate {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, kind) = deserializer.deserialize_any(AnyOf(Self::KINDS))?;
        Ok(match kind {
            Kind::CountRate => Self::Count(value),
            _ => Self::Mass(value),
        })
    }
}

impl JsonSchema for FeedRate {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "FeedRate".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        schema_of(Self::KINDS, Range::Positive)
    }
}
