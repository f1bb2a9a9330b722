//! `pelletflow safe-speed`.

mod scene;

use crate::args::safe_speed::{DistributionName, SafeSpeedArguments};
use crate::commands::hit::{Hit, bad_input};
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, chosen, number};
use pelletflow_core::Material;
use pelletflow_impact::safe_speed::speed_of_fall;
use pelletflow_impact::strength::CONFIDENCE;
use pelletflow_impact::{
    Arrival, Damping, ImpactError, Interval, SafeSpeed, Scatter, Slip, Strength,
};
use pelletflow_scene::StrengthCard;
use serde_json::{Value, json};

/// What an elastic force cannot know.
const WARNINGS: [&str; 3] = [
    "slow crushing is not an impact: the load of a crushing test and that of a hit break pellets in different ways and \
     need not be equal",
    "the force is elastic: a pellet that yields, cracks or damps feels less at the same speed, so the speed errs to the \
     safe side as far as its modulus is right",
    "each hit is taken alone: damage that adds up over many hits, and wear, are not in it",
];

/// Tells the arrival speed at which a share of pellets breaks.
pub(crate) fn safe_speed(arguments: &SafeSpeedArguments) -> Result<Exit, Failure> {
    let asked = Asked::new(arguments)?;
    if let Some(path) = &arguments.of_scene.scene {
        return scene::safe_setting_of(path, arguments, &asked);
    }
    arguments.of_scene.refuse_without_scene()?;
    let hit = Hit::new(&arguments.hit, None)?;
    let Asked {
        strength,
        yield_pressure,
        told,
    } = asked;
    let moduli = Moduli::new(arguments, &hit)?;
    let elastic = |youngs_modulus| arrival(&hit, youngs_modulus).elastic();
    let safe = SafeSpeed::new(
        &strength,
        arguments.risk,
        hit.diameter,
        &elastic(hit.pellet.youngs_modulus),
        [moduli.least, moduli.greatest].map(|modulus| elastic(modulus).effective_youngs_modulus),
    )
    .map_err(|error| refused(&error))?;
    let answer = Answer {
        safe,
        arrival_speed: arguments
            .arrival_speed
            .unwrap_or_else(|| speed_of_fall(arguments.fall)),
        risk: arguments.risk,
        yield_pressure,
        is_fixed: matches!(strength.scatter, Scatter::Fixed(_)),
        basis: vec![told, interval_basis(&strength, &moduli)],
    };
    if arguments.json {
        screen::json(&answer.json())?;
    } else {
        screen::result(&answer.page())?;
    }
    Ok(Exit::Done)
}

fn arrival(hit: &Hit, youngs_modulus: f64) -> Arrival {
    Arrival {
        pellet: Material {
            youngs_modulus,
            ..hit.pellet
        },
        surface: hit.surface,
        diameter: hit.diameter,
        speed: 1.0,
        angle: 0.0,
        friction: 0.0,
        slip: Slip::Coulomb,
        damping: Damping::None,
    }
}

/// The strength and what tells it.
struct Asked {
    strength: Strength,
    yield_pressure: Option<f64>,
    told: String,
}

impl Asked {
    fn new(arguments: &SafeSpeedArguments) -> Result<Self, Failure> {
        if let Some(path) = &arguments.strength_card {
            let card = StrengthCard::read(path)?;
            return Ok(Self {
                strength: card.strength,
                yield_pressure: card.yield_pressure,
                told: format!("{}: {}", card.name, card.source),
            });
        }
        let mean = arguments.strength.unwrap_or_default();
        let scatter = match (arguments.scatter, arguments.distribution) {
            (None, _) => Ok(Scatter::Fixed(mean)),
            (Some(scatter), DistributionName::LogNormal) => {
                Scatter::log_normal_from_mean(mean, scatter)
            }
            (Some(scatter), DistributionName::Weibull) => Scatter::weibull_from_mean(mean, scatter),
        };
        let strength = Strength {
            scatter: scatter.map_err(|error| refused(&error))?,
            test_diameter: arguments.test_diameter,
            sample_size: arguments.tests,
        };
        let told = match arguments.scatter {
            None => format!("every pellet breaks at {} N", chosen(mean)),
            Some(scatter) => format!(
                "mean {} N, scatter {} %, {}",
                chosen(mean),
                chosen(scatter * 100.0),
                match arguments.distribution {
                    DistributionName::LogNormal => "log-normal",
                    DistributionName::Weibull => "Weibull",
                }
            ),
        };
        Ok(Self {
            strength,
            yield_pressure: None,
            told,
        })
    }
}

/// Young's moduli of the pellet between which the truth lies, and where they come from.
struct Moduli {
    least: f64,
    greatest: f64,
    source: String,
}

impl Moduli {
    fn new(arguments: &SafeSpeedArguments, hit: &Hit) -> Result<Self, Failure> {
        let own = hit.pellet.youngs_modulus;
        if let Some(range) = arguments.shear_modulus_range {
            let of = |shear_modulus| {
                let Material {
                    density,
                    poisson_ratio,
                    ..
                } = hit.pellet;
                Material::from_shear_modulus(density, shear_modulus, poisson_ratio).youngs_modulus
            };
            let (least, greatest) = (of(range.least), of(range.greatest));
            // A rounding error of the conversion is no contradiction.
            if !(least * (1.0 - 1.0e-9)..=greatest * (1.0 + 1.0e-9)).contains(&own) {
                return Err(bad_input(format!(
                    "the shear modulus of {} MPa lies outside --shear-modulus-range; widen the range",
                    number(hit.pellet.shear_modulus() * 1.0e-6)
                )));
            }
            return Ok(Self {
                least,
                greatest,
                source: "the range of shear moduli given".into(),
            });
        }
        Ok(match hit.stiffness_from {
            Some(entry) => {
                let [least, greatest] = entry.youngs_modulus_range;
                Self {
                    least,
                    greatest,
                    source: format!(
                        "a Young's modulus of {} to {} MPa in the library",
                        chosen(least * 1.0e-6),
                        chosen(greatest * 1.0e-6)
                    ),
                }
            }
            None => Self {
                least: own,
                greatest: own,
                source: "no scatter of stiffness; give --shear-modulus-range".into(),
            },
        })
    }
}

/// What the interval is made of.
fn interval_basis(strength: &Strength, moduli: &Moduli) -> String {
    let of_strength = match (strength.scatter, strength.sample_size) {
        (Scatter::Fixed(_), _) => "no scatter of strength; give --scatter".into(),
        (_, None) => "no error of the strength test; give the number of tests".into(),
        (_, Some(size)) => format!(
            "the {} % interval that {size} tests leave",
            chosen(CONFIDENCE * 100.0)
        ),
    };
    format!("interval: {of_strength}; {}", moduli.source)
}

fn refused(error: &ImpactError) -> Failure {
    bad_input(error.to_string())
}

struct Answer {
    safe: SafeSpeed,
    arrival_speed: f64,
    risk: f64,
    yield_pressure: Option<f64>,
    is_fixed: bool,
    basis: Vec<String>,
}

impl Answer {
    fn slope(&self) -> Interval {
        self.safe.chute_slope(self.arrival_speed)
    }

    fn warnings(&self) -> Vec<&'static str> {
        let fixed =
            "a fixed load knows no risk: all pellets break at once; give --scatter for a share";
        self.is_fixed
            .then_some(fixed)
            .into_iter()
            .chain(WARNINGS)
            .collect()
    }

    fn page(&self) -> String {
        let row = |name: String, value: Interval, unit: &str| {
            [
                name,
                format!("{} {unit}", number(value.best)),
                format!("{} to {} {unit}", number(value.low), number(value.high)),
            ]
        };
        let share = if self.is_fixed {
            "load that breaks".to_owned()
        } else {
            format!("load that breaks {} %", chosen(self.risk * 100.0))
        };
        let mut rows = vec![
            row(share, self.safe.load, "N"),
            row("safe arrival speed".into(), self.safe.speed, "m/s"),
        ];
        if let Some(pressure) = self.yield_pressure {
            let name = format!(
                "the same, if they yield at {} MPa",
                chosen(pressure * 1.0e-6)
            );
            rows.push(row(name, self.safe.yielding_speed(pressure), "m/s"));
        }
        rows.extend([
            row("drop height".into(), self.safe.drop_height(), "m"),
            row(
                format!(
                    "least slope of a chute at {} m/s straight down",
                    number(self.arrival_speed)
                ),
                self.slope().map(f64::to_degrees),
                "°",
            ),
        ]);
        let table = table::listing(["", "best", "interval"], &[1, 2], rows);
        let basis = self.basis.join("\n");
        let warnings: Vec<String> = self
            .warnings()
            .iter()
            .map(|warning| format!("warning: {warning}"))
            .collect();
        format!("{table}\n\n{basis}\n\n{}", warnings.join("\n"))
    }

    fn json(&self) -> Value {
        let interval = |value: Interval| json!([value.low, value.high]);
        let (load, speed) = (self.safe.load, self.safe.speed);
        let (height, slope) = (self.safe.drop_height(), self.slope());
        let yielding = self
            .yield_pressure
            .map(|pressure| self.safe.yielding_speed(pressure));
        json!({
            "risk": if self.is_fixed { Value::Null } else { json!(self.risk) },
            "load_n": load.best,
            "load_interval_n": interval(load),
            "speed_m_per_s": speed.best,
            "speed_interval_m_per_s": interval(speed),
            "yielding_speed_m_per_s": yielding.map(|speed| speed.best),
            "yielding_speed_interval_m_per_s": yielding.map(interval),
            "drop_height_m": height.best,
            "drop_height_interval_m": interval(height),
            "arrival_speed_m_per_s": self.arrival_speed,
            "chute_slope_rad": slope.best,
            "chute_slope_interval_rad": interval(slope),
            "basis": self.basis,
            "warnings": self.warnings(),
        })
    }
}
