//! Diameters of pellets: one for all, or a distribution.

use super::Resolver;
use crate::key_path::KeyPath;
use crate::quantity::Size;
use crate::spec::material::{DiameterSpec, DistributionSpec};
use pelletflow_sim::SizeDistribution;

/// Deviations from the middle at which a distribution ends where no end is given [-].
const REACH: f64 = 3.0;

impl Resolver<'_> {
    pub(super) fn size(&mut self, diameter: &DiameterSpec, path: &KeyPath) -> SizeDistribution {
        match diameter {
            DiameterSpec::Single(diameter) => SizeDistribution::Single {
                diameter: diameter.0,
            },
            DiameterSpec::Distributed(spec) => match distribution(spec) {
                Ok(sizes) => {
                    let (min, max) = (sizes.min_diameter(), sizes.max_diameter());
                    if let Err(mistake) = sizes.validate() {
                        self.findings.add(path, mistake);
                    } else if min > max {
                        self.findings.add(
                            path,
                            format!("`min` is {min} m and `max` {max} m; exchange them"),
                        );
                    }
                    sizes
                }
                Err(mistake) => {
                    self.findings.add(path, mistake);
                    SizeDistribution::Single { diameter: 1.0 }
                }
            },
        }
    }
}

/// The distribution that the keys given stand for.
fn distribution(spec: &DistributionSpec) -> Result<SizeDistribution, String> {
    let length = |size: Option<Size>| size.map(|size| size.0);
    let (min, max) = (length(spec.min), length(spec.max));
    let normal = length(spec.mean).zip(length(spec.deviation));
    let log_normal = length(spec.median).zip(spec.spread);
    let sieve = spec.openings.as_ref().zip(spec.passing.as_ref());
    match (keys_of_middle(spec).as_slice(), normal, log_normal, sieve) {
        ([], ..) => match (min, max) {
            (Some(min_diameter), Some(max_diameter)) => Ok(SizeDistribution::Uniform {
                min_diameter,
                max_diameter,
            }),
            _ => Err(unclear(spec)),
        },
        ([_, _], Some((mean, deviation)), ..) => {
            let min_diameter = min.unwrap_or(mean - REACH * deviation);
            if min_diameter <= 0.0 {
                return Err(format!(
                    "three deviations below the mean is {min_diameter:.4} m; expected more than 0: give `min`"
                ));
            }
            Ok(SizeDistribution::Normal {
                mean,
                deviation,
                min_diameter,
                max_diameter: max.unwrap_or(mean + REACH * deviation),
            })
        }
        ([_, _], _, Some((median, spread)), _) => {
            let factor = (REACH * spread).exp();
            Ok(SizeDistribution::LogNormal {
                median,
                spread,
                min_diameter: min.unwrap_or(median / factor),
                max_diameter: max.unwrap_or(median * factor),
            })
        }
        ([_, _], .., Some((openings, passing))) if min.is_none() && max.is_none() => {
            Ok(SizeDistribution::Sieve {
                openings: openings.iter().map(|opening| opening.0).collect(),
                passing: passing.iter().map(|share| share.0).collect(),
            })
        }
        _ => Err(unclear(spec)),
    }
}

/// Names of the keys given beside the ends.
fn keys_of_middle(spec: &DistributionSpec) -> Vec<&'static str> {
    [
        ("mean", spec.mean.is_some()),
        ("deviation", spec.deviation.is_some()),
        ("median", spec.median.is_some()),
        ("spread", spec.spread.is_some()),
        ("openings", spec.openings.is_some()),
        ("passing", spec.passing.is_some()),
    ]
    .into_iter()
    .filter_map(|(key, is_given)| is_given.then_some(key))
    .collect()
}

/// Why the keys given stand for no distribution.
fn unclear(spec: &DistributionSpec) -> String {
    let ends = [("min", spec.min), ("max", spec.max)];
    let given: Vec<String> = ends
        .into_iter()
        .filter_map(|(key, end)| end.is_some().then_some(key))
        .chain(keys_of_middle(spec))
        .map(|key| format!("`{key}`"))
        .collect();
    let given = match given.as_slice() {
        [] => "nothing is".to_owned(),
        [one] => format!("only {one} is"),
        all => format!("{} are", all.join(", ")),
    };
    format!(
        "{given} given; expected `min` and `max`, or `mean` and `deviation`, or `median` and `spread`, or `openings` and \
         `passing`; only the second and third may have `min` and `max` beside"
    )
}
