//! Many single hits at once.

use crate::errors;
use numpy::{PyArray1, PyReadonlyArray1};
use pelletflow_core::Material;
use pelletflow_core::material::library::LIBRARY;
use pelletflow_impact::{
    Arrival, Damping, Interval, Outline, Outlines, SafeSpeed, Scatter, Slip, Strength,
};
use pelletflow_scene::StrengthCard;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// A value for each hit.
type Values<'py> = PyReadonlyArray1<'py, f64>;
/// Results by name, a value for each hit.
type Columns<'py> = Vec<(&'static str, Bound<'py, PyArray1<f64>>)>;

/// Named materials: name, density [kg/m³], Young's modulus and its range [Pa], Poisson's ratio [-], diameter [m], source.
#[pyfunction]
pub(crate) fn library(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    LIBRARY
        .iter()
        .map(|entry| {
            let row = PyDict::new(py);
            row.set_item("name", entry.name)?;
            row.set_item("density", entry.material.density)?;
            row.set_item("youngs_modulus", entry.material.youngs_modulus)?;
            row.set_item("youngs_modulus_range", entry.youngs_modulus_range)?;
            row.set_item("poisson_ratio", entry.material.poisson_ratio)?;
            row.set_item("diameter", entry.diameter)?;
            row.set_item("source", entry.source)?;
            Ok(row)
        })
        .collect()
}

/// Pellets and the surfaces that they arrive at, all of one length.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Arrivals<'py> {
    speed: Values<'py>,
    angle: Values<'py>,
    diameter: Values<'py>,
    density: Values<'py>,
    /// One of the two moduli is given.
    #[pyo3(default)]
    youngs_modulus: Option<Values<'py>>,
    #[pyo3(default)]
    shear_modulus: Option<Values<'py>>,
    poisson_ratio: Values<'py>,
    onto_youngs_modulus: Values<'py>,
    onto_poisson_ratio: Values<'py>,
}

impl Arrivals<'_> {
    /// One of them, elastic.
    fn get(&self, index: usize) -> Arrival {
        let at = |values: &Values<'_>| values.as_array()[index];
        let (density, poisson_ratio) = (at(&self.density), at(&self.poisson_ratio));
        let pellet = match (&self.shear_modulus, &self.youngs_modulus) {
            (Some(shear), _) => Material::from_shear_modulus(density, at(shear), poisson_ratio),
            (None, own) => Material {
                density,
                youngs_modulus: own.as_ref().map_or(f64::NAN, at),
                poisson_ratio,
            },
        };
        Arrival {
            pellet,
            surface: Material {
                // What a surface weighs does not matter.
                density: 1.0,
                youngs_modulus: at(&self.onto_youngs_modulus),
                poisson_ratio: at(&self.onto_poisson_ratio),
            },
            diameter: at(&self.diameter),
            speed: at(&self.speed),
            angle: at(&self.angle),
            friction: 0.0,
            slip: Slip::Coulomb,
            damping: Damping::None,
        }
    }

    fn all(&self) -> Vec<Arrival> {
        (0..self.speed.as_array().len())
            .map(|index| self.get(index))
            .collect()
    }
}

/// The numbers of hits along the normal; `damping` names what the values beside it are.
#[pyfunction]
#[pyo3(signature = (arrivals, damping, values))]
pub(crate) fn impacts<'py>(
    py: Python<'py>,
    arrivals: Arrivals<'py>,
    damping: &str,
    values: Option<Values<'py>>,
) -> PyResult<Columns<'py>> {
    let mut arrivals = arrivals.all();
    for (index, arrival) in arrivals.iter_mut().enumerate() {
        let value = values.as_ref().map(|values| values.as_array()[index]);
        arrival.damping = match (damping, value) {
            ("restitution", Some(restitution)) => Damping::Restitution(restitution),
            ("relaxation_time", Some(time)) => Damping::Viscoelastic(time),
            _ => Damping::None,
        };
    }
    let outlines = py.detach(|| {
        let mut solved = Outlines::default();
        arrivals
            .iter()
            .enumerate()
            .map(|(index, arrival)| {
                let outline = arrival.outline(&mut solved);
                outline.map_err(|error| (index, error))
            })
            .collect::<Result<Vec<Outline>, _>>()
    });
    let outlines = outlines.map_err(|(index, error)| errors::from_impact(py, &error, index))?;
    let column =
        |value: fn(&Outline) -> f64| PyArray1::from_vec(py, outlines.iter().map(value).collect());
    Ok(vec![
        ("peak_force", column(|outline| outline.peak_force)),
        ("contact_time", column(|outline| outline.contact_time)),
        ("max_approach", column(|outline| outline.max_approach)),
        ("contact_radius", column(|outline| outline.contact_radius)),
        ("peak_pressure", column(|outline| outline.peak_pressure)),
        ("restitution", column(|outline| outline.restitution)),
        ("impulse", column(|outline| outline.impulse)),
        (
            "specific_impulse",
            column(|outline| outline.specific_impulse),
        ),
        ("peak_parameter", column(|outline| outline.peak_parameter)),
        ("asymmetry", column(|outline| outline.asymmetry)),
    ])
}

/// Mean of what replicates gave with its interval: low, best, high.
#[pyfunction]
pub(crate) fn mean_interval(values: PyReadonlyArray1<'_, f64>, confidence: f64) -> [f64; 3] {
    let values: Vec<f64> = values.as_array().to_vec();
    let Interval { low, best, high } = Interval::of_mean(&values, confidence);
    [low, best, high]
}

/// What breaks pellets, a value for each hit, or a card that tells it for all.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Strengths<'py> {
    card: Option<PathBuf>,
    distribution: String,
    mean: Option<Values<'py>>,
    variation: Option<Values<'py>>,
    test_diameter: Option<Values<'py>>,
    tests: Option<u32>,
}

/// Strengths that were told.
pub(crate) struct Told {
    pub(crate) strengths: Vec<Strength>,
    /// Pressure that pellets yield under, where a card tells it [Pa].
    pub(crate) yield_pressure: Option<f64>,
}

impl Strengths<'_> {
    /// One for each of `count` hits.
    pub(crate) fn all(&self, py: Python<'_>, count: usize) -> PyResult<Told> {
        if let Some(path) = &self.card {
            let card = StrengthCard::read(path).map_err(|error| errors::from_card(py, error))?;
            return Ok(Told {
                strengths: vec![card.strength; count],
                yield_pressure: card.yield_pressure,
            });
        }
        let strengths = (0..count)
            .map(|index| {
                let at = |values: &Option<Values<'_>>| {
                    values.as_ref().map(|values| values.as_array()[index])
                };
                let mean = at(&self.mean).ok_or_else(|| {
                    PyValueError::new_err("a strength is missing; give `strength` or a card")
                })?;
                let scatter = match at(&self.variation) {
                    None => Ok(Scatter::Fixed(mean)),
                    Some(variation) if self.distribution == "weibull" => {
                        Scatter::weibull_from_mean(mean, variation)
                    }
                    Some(variation) => Scatter::log_normal_from_mean(mean, variation),
                };
                Ok(Strength {
                    scatter: scatter.map_err(|error| errors::from_impact(py, &error, index))?,
                    test_diameter: at(&self.test_diameter),
                    sample_size: self.tests,
                })
            })
            .collect::<PyResult<_>>()?;
        Ok(Told {
            strengths,
            yield_pressure: None,
        })
    }
}

/// Safe speeds of hits: the load that breaks a share `risk` and the speed that reaches it, each with its interval.
///
/// `moduli` are the least and the greatest Young's modulus that a pellet may have; its own where there are none.
#[pyfunction]
#[pyo3(signature = (arrivals, strengths, risk, moduli))]
pub(crate) fn safe_speeds<'py>(
    py: Python<'py>,
    arrivals: Arrivals<'py>,
    strengths: Strengths<'py>,
    risk: Values<'py>,
    moduli: Option<[Values<'py>; 2]>,
) -> PyResult<Columns<'py>> {
    let arrivals = arrivals.all();
    let strengths = strengths.all(py, arrivals.len())?.strengths;
    let risks = risk.as_array().to_vec();
    let moduli = moduli.map(|ends| ends.map(|values| values.as_array().to_vec()));
    let safe = py.detach(|| {
        arrivals
            .iter()
            .enumerate()
            .map(|(index, arrival)| {
                let with_modulus = |youngs_modulus| Arrival {
                    pellet: Material {
                        youngs_modulus,
                        ..arrival.pellet
                    },
                    ..*arrival
                };
                let own = arrival.pellet.youngs_modulus;
                let moduli = moduli
                    .as_ref()
                    .map_or([own; 2], |ends| ends.each_ref().map(|values| values[index]))
                    .map(|modulus| with_modulus(modulus).elastic().effective_youngs_modulus);
                arrival
                    .validate()
                    .and_then(|()| {
                        SafeSpeed::new(
                            &strengths[index],
                            risks[index],
                            arrival.diameter,
                            &arrival.elastic(),
                            moduli,
                        )
                    })
                    .map_err(|error| (index, error))
            })
            .collect::<Result<Vec<SafeSpeed>, _>>()
    });
    let safe = safe.map_err(|(index, error)| errors::from_impact(py, &error, index))?;
    let column =
        |value: fn(&SafeSpeed) -> f64| PyArray1::from_vec(py, safe.iter().map(value).collect());
    let height = |safe: &SafeSpeed| -> Interval { safe.drop_height() };
    let heights = |end: fn(Interval) -> f64| {
        PyArray1::from_vec(py, safe.iter().map(|safe| end(height(safe))).collect())
    };
    Ok(vec![
        ("load", column(|safe| safe.load.best)),
        ("load_low", column(|safe| safe.load.low)),
        ("load_high", column(|safe| safe.load.high)),
        ("speed", column(|safe| safe.speed.best)),
        ("speed_low", column(|safe| safe.speed.low)),
        ("speed_high", column(|safe| safe.speed.high)),
        ("drop_height", heights(|height| height.best)),
        ("drop_height_low", heights(|height| height.low)),
        ("drop_height_high", heights(|height| height.high)),
    ])
}
