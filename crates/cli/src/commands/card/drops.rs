//! The drop test of a card.

use super::answer::between;
use super::refused;
use crate::args::hit::HitArguments;
use crate::commands::hit::Hit;
use crate::exit::Failure;
use crate::table::{self, number};
use pelletflow_impact::{
    Arrival, Damping, DropFit, DropLevel, FractureEnergy, ImpactError, Interval, Slip,
};
use serde_json::{Value, json};

/// A drop test, and the fracture energy fitted to it.
pub(super) struct Drops {
    pub(super) levels: Vec<DropLevel>,
    fit: Result<DropFit, ImpactError>,
    damage_constant: Option<f64>,
    /// The pellet and what it falls on, where they are told.
    hit: Option<Hit>,
}

impl Drops {
    pub(super) fn new(
        levels: Vec<DropLevel>,
        hit: &HitArguments,
        damage_constant: Option<f64>,
    ) -> Result<Self, Failure> {
        let is_told = hit.pellet.is_some() || hit.diameter.is_some() || hit.density.is_some();
        Ok(Self {
            fit: DropFit::new(&levels),
            levels,
            damage_constant,
            hit: is_told.then(|| Hit::new(hit, None)).transpose()?,
        })
    }

    pub(super) fn fracture_energy(&self) -> Option<FractureEnergy> {
        let fit = self.fit.as_ref().ok()?;
        Some(fit.fracture_energy(self.damage_constant))
    }

    /// Greatest force of an elastic hit at a speed [N].
    fn force(&self, speed: f64) -> Option<f64> {
        let hit = self.hit.as_ref()?;
        let arrival = Arrival {
            pellet: hit.pellet,
            surface: hit.surface,
            diameter: hit.diameter,
            speed,
            angle: 0.0,
            friction: 0.0,
            slip: Slip::Coulomb,
            damping: Damping::None,
        };
        Some(arrival.elastic().peak_force())
    }

    /// Greatest force of an elastic hit that breaks half of the pellets [N].
    fn median_force(&self, fit: &DropFit) -> Option<Interval> {
        let speed = median_speed(fit);
        Some(Interval {
            low: self.force(speed.low)?,
            best: self.force(speed.best)?,
            high: self.force(speed.high)?,
        })
    }

    pub(super) fn page(&self) -> Result<String, Failure> {
        let rows = self
            .levels
            .iter()
            .map(|level| {
                let share = level.share().map_err(|error| refused(&error))?;
                let share = share.map(|share| 100.0 * share);
                Ok([
                    number(level.speed),
                    number(level.specific_energy()),
                    self.force(level.speed).map_or_else(String::new, number),
                    format!("{} of {}", level.broken, level.dropped),
                    format!("{} %", number(share.best)),
                    format!("{} %", between(share)),
                ])
            })
            .collect::<Result<Vec<_>, Failure>>()?;
        let header = [
            "dropped at [m/s]",
            "energy [J/kg]",
            "elastic force [N]",
            "broken",
            "share",
            "interval",
        ];
        let table = table::listing(header, &[0, 1, 2, 3, 4], rows);
        Ok(format!("{table}\n\n{}", self.conclusion()))
    }

    fn conclusion(&self) -> String {
        let fit = match &self.fit {
            Ok(fit) => fit,
            Err(error) => return format!("{error}; the levels go into the card as they are"),
        };
        let damage = self.damage_constant.map_or_else(
            || "without a damage constant, weak blows leave no trace".into(),
            |constant| format!("damage constant {}", number(constant)),
        );
        let speed = median_speed(fit);
        let force = self.median_force(fit).map_or_else(
            || "give --pellet for its force".into(),
            |force| {
                format!(
                    "{} N, {} N by Hertz, elastic",
                    number(force.best),
                    between(force)
                )
            },
        );
        format!(
            "fracture energy: half break at {} J/kg, {} J/kg; deviation {}, {}\nthat is a drop at {} m/s, {} m/s: {force}\n{damage}",
            number(fit.median.best),
            between(fit.median),
            number(fit.deviation.best),
            between(fit.deviation),
            number(speed.best),
            between(speed),
        )
    }

    pub(super) fn json(&self) -> Result<Value, Failure> {
        let levels = self
            .levels
            .iter()
            .map(|level| {
                let share = level.share().map_err(|error| refused(&error))?;
                Ok(json!({
                    "speed_m_per_s": level.speed,
                    "energy_j_per_kg": level.specific_energy(),
                    "elastic_force_n": self.force(level.speed),
                    "dropped": level.dropped,
                    "broken": level.broken,
                    "share": share.best,
                    "share_interval": [share.low, share.high],
                }))
            })
            .collect::<Result<Value, Failure>>()?;
        let fit = match &self.fit {
            Ok(fit) => json!({
                "median_elastic_force_n": self.median_force(fit).map(|force| force.best),
                "median_elastic_force_interval_n": self.median_force(fit).map(|force| [force.low, force.high]),
                "median_j_per_kg": fit.median.best,
                "median_interval_j_per_kg": [fit.median.low, fit.median.high],
                "deviation": fit.deviation.best,
                "deviation_interval": [fit.deviation.low, fit.deviation.high],
                "damage_constant": self.damage_constant,
            }),
            Err(error) => json!({ "refused": error.to_string() }),
        };
        Ok(json!({ "levels": levels, "fit": fit }))
    }
}

/// Speed at which half of the pellets break [m/s].
fn median_speed(fit: &DropFit) -> Interval {
    fit.median.map(|energy| (2.0 * energy).sqrt())
}
