//! What a card holds beside the strength: the checks between keys, and from tables to physics.

use crate::key_path::KeyPath;
use crate::mistakes::Findings;
use crate::spec::strength_card::{
    DistributionSpec, FractureEnergySpec, ProvenanceSpec, StrengthCardSpec, TumbleSpec,
};
use pelletflow_impact::{DropLevel, FractureEnergy, Goodness, MedianEnergy, Scatter};

/// How the numbers of a card were found; for people, and for the record.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Provenance {
    /// File of the sheet.
    pub file: Option<String>,
    /// Date of the sheet, as it stands there.
    pub date: Option<String>,
    /// The test.
    pub method: Option<String>,
    /// How the distribution was fitted.
    pub fit: Option<String>,
    /// Interval of the scale or of the median [N].
    pub center_interval: Option<[f64; 2]>,
    /// Interval of the modulus or of the deviation [-].
    pub shape_interval: Option<[f64; 2]>,
    /// How far the loads lie from the distribution.
    pub goodness: Option<Goodness>,
}

/// What a tumble test found (ISO 3271). It tells of attrition only: no breakage is worked out from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tumble {
    /// Share of the mass that stays on the sieve of 6.3 mm [-].
    pub tumble_index: f64,
    /// Share of the mass that passes the sieve of 0.5 mm [-].
    pub abrasion_index: Option<f64>,
}

impl From<ProvenanceSpec> for Provenance {
    fn from(spec: ProvenanceSpec) -> Self {
        Self {
            file: spec.file,
            date: spec.date,
            method: spec.method,
            fit: spec.fit,
            center_interval: spec.center_interval.map(|ends| ends.map(|force| force.0)),
            shape_interval: spec.shape_interval,
            goodness: spec
                .distance
                .zip(spec.p_value)
                .map(|(distance, p_value)| Goodness { distance, p_value }),
        }
    }
}

impl From<TumbleSpec> for Tumble {
    fn from(spec: TumbleSpec) -> Self {
        Self {
            tumble_index: spec.tumble_index.0,
            abrasion_index: spec.abrasion_index.map(|share| share.0),
        }
    }
}

/// The distribution that a card gives in one of its ways.
pub(super) fn scatter(spec: &StrengthCardSpec, findings: &mut Findings) -> Option<Scatter> {
    let given = (
        spec.mean.map(|force| force.0),
        spec.coefficient_of_variation.map(|share| share.0),
        spec.median.map(|force| force.0).zip(spec.deviation),
        spec.scale.map(|force| force.0).zip(spec.modulus),
    );
    let is_half = spec.median.is_some() != spec.deviation.is_some()
        || spec.scale.is_some() != spec.modulus.is_some();
    let made = match (spec.distribution, given) {
        _ if is_half => None,
        (DistributionSpec::Fixed, (Some(load), None, None, None)) => Some(Ok(Scatter::Fixed(load))),
        (DistributionSpec::LogNormal, (Some(mean), Some(variation), None, None)) => {
            Some(Scatter::log_normal_from_mean(mean, variation))
        }
        (DistributionSpec::LogNormal, (None, None, Some((median, deviation)), None)) => {
            Some(Ok(Scatter::LogNormal { median, deviation }))
        }
        (DistributionSpec::Weibull, (Some(mean), Some(variation), None, None)) => {
            Some(Scatter::weibull_from_mean(mean, variation))
        }
        (DistributionSpec::Weibull, (None, None, None, Some((scale, modulus)))) => {
            Some(Ok(Scatter::Weibull { scale, modulus }))
        }
        _ => None,
    };
    let Some(made) = made else {
        let expected = match spec.distribution {
            DistributionSpec::Fixed => "`mean` alone",
            DistributionSpec::LogNormal => {
                "either `mean` and `coefficient_of_variation`, or `median` and `deviation`"
            }
            DistributionSpec::Weibull => {
                "either `mean` and `coefficient_of_variation`, or `scale` and `modulus`"
            }
        };
        findings.add(
            &KeyPath::of(["distribution"]),
            format!("this distribution is told by {expected}; give these and no others"),
        );
        return None;
    };
    made.map_err(|error| findings.add(&KeyPath::of(["mean"]), error.to_string()))
        .ok()
}

/// The fracture energy with its median in one of its two ways.
pub(super) fn fracture_energy(
    spec: &FractureEnergySpec,
    findings: &mut Findings,
) -> Option<FractureEnergy> {
    let size = spec.characteristic_diameter.map(|diameter| diameter.0);
    let by_size = (spec.large.map(|energy| energy.0), size, spec.exponent);
    let median = match (spec.median.map(|energy| energy.0), by_size) {
        (Some(median), (None, None, None)) if spec.stiffness_ratio.is_none() => {
            MedianEnergy::OfAnySize(median)
        }
        (None, (Some(large), Some(diameter), Some(exponent))) => MedianEnergy::BySize {
            large,
            stiffness_ratio: spec.stiffness_ratio.unwrap_or(0.0),
            diameter,
            exponent,
        },
        _ => {
            findings.add(
                &KeyPath::of(["fracture_energy"]),
                "the median is told by `median` alone, or by `large`, `characteristic_diameter`, `exponent` and, where \
                 the surface is not rigid, `stiffness_ratio`; give these and no others",
            );
            return None;
        }
    };
    Some(FractureEnergy {
        median,
        deviation: spec.deviation,
        truncation: spec.truncation,
        damage_constant: spec.damage_constant,
        sample_size: spec.sample_size,
    })
}

/// The levels of a drop test, none of which breaks more than it drops.
pub(super) fn drops(spec: &StrengthCardSpec, findings: &mut Findings) -> Vec<DropLevel> {
    let levels = spec.drops.iter().map(|level| DropLevel {
        speed: level.speed.0,
        dropped: level.dropped,
        broken: level.broken,
    });
    let levels: Vec<DropLevel> = levels.collect();
    for level in &levels {
        if let Err(error) = level.share() {
            findings.add(&KeyPath::of(["drops"]), error.to_string());
        }
    }
    levels
}
