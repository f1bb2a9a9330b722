//! Curves of the paper, and better ones, fitted to a hit by least squares.
//!
//! `τ` is the time since first touch over the contact time [-].

use crate::ImpactError;
use rmpfit::{MPFitter, MPPar, MPResult};
use statrs::function::beta::beta;

/// The bell curve of the paper, `P/P_max = [(τ/τ_m)^τ_m ((1−τ)/(1−τ_m))^(1−τ_m)]^ε`.
///
/// This is its (14) without the factor `t_k`, which has no place in it: a force over a force has no unit. With
/// `τ_m = 1/2` it is `[4 τ (1−τ)]^(ε/2)`, so that the 4 before the bracket of the paper's (15) is `2^ε`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BellFit {
    /// Shape parameter ε [-].
    pub shape_parameter: f64,
    /// Asymmetry `τ_m`, the moment of the greatest force [-].
    pub asymmetry: f64,
    /// Root mean square of the error, as a share of the greatest force [-].
    pub rms_error: f64,
    /// Greatest error, as a share of the greatest force [-].
    pub worst_error: f64,
}

/// Fitted asymmetries stay this far from 0 and 1, where the curve has no meaning [-].
const LEAST_ASYMMETRY: f64 = 1.0e-3;

impl BellFit {
    /// Fits to pairs of `τ` and force over greatest force.
    pub(crate) fn new(points: &[[f64; 2]], start_asymmetry: f64) -> Result<Self, ImpactError> {
        let asymmetry = start_asymmetry.clamp(2.0 * LEAST_ASYMMETRY, 1.0 - 2.0 * LEAST_ASYMMETRY);
        let mut parameters = [4.0, asymmetry];
        let bounds = [[0.1, 100.0], [LEAST_ASYMMETRY, 1.0 - LEAST_ASYMMETRY]];
        let shape = |p: &[f64], tau: f64| bell(tau, p[0], p[1]);
        let [rms_error, worst_error] = fit("bell curve", points, &mut parameters, &bounds, &shape)?;
        Ok(Self {
            shape_parameter: parameters[0],
            asymmetry: parameters[1],
            rms_error,
            worst_error,
        })
    }

    /// Force over greatest force at `τ` [-].
    pub fn value(&self, tau: f64) -> f64 {
        bell(tau, self.shape_parameter, self.asymmetry)
    }
}

/// The bell curve of the paper at `τ`, for a shape parameter and an asymmetry [-].
pub fn bell(tau: f64, shape_parameter: f64, asymmetry: f64) -> f64 {
    let rise = (tau / asymmetry).powf(asymmetry);
    let fall = ((1.0 - tau) / (1.0 - asymmetry)).powf(1.0 - asymmetry);
    (rise * fall).powf(shape_parameter)
}

/// Area under the bell curve, the paper's (17): `k_P` of a hit of this shape [-].
///
/// `B(ε τ_m + 1, ε (1 − τ_m) + 1) / (τ_m^τ_m (1 − τ_m)^(1 − τ_m))^ε`, with Euler's beta function B.
pub fn bell_area(shape_parameter: f64, asymmetry: f64) -> f64 {
    let rise = shape_parameter * asymmetry;
    let fall = shape_parameter - rise;
    let peak = asymmetry.powf(rise) * (1.0 - asymmetry).powf(fall);
    beta(rise + 1.0, fall + 1.0) / peak
}

/// A power of the sine, `P/P_max = sin^n(π τ)`: nearer to an elastic hit than the bell curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SineFit {
    /// Exponent n [-].
    pub exponent: f64,
    /// Root mean square of the error, as a share of the greatest force [-].
    pub rms_error: f64,
    /// Greatest error, as a share of the greatest force [-].
    pub worst_error: f64,
}

impl SineFit {
    /// Fits to pairs of `τ` and force over greatest force.
    pub(crate) fn new(points: &[[f64; 2]]) -> Result<Self, ImpactError> {
        let mut parameters = [1.6];
        let shape = |p: &[f64], tau: f64| power_of_sine(tau, p[0]);
        let bounds = [[0.1, 100.0]];
        let [rms_error, worst_error] = fit(
            "power of the sine",
            points,
            &mut parameters,
            &bounds,
            &shape,
        )?;
        Ok(Self {
            exponent: parameters[0],
            rms_error,
            worst_error,
        })
    }

    /// Force over greatest force at `τ` [-].
    pub fn value(&self, tau: f64) -> f64 {
        power_of_sine(tau, self.exponent)
    }
}

fn power_of_sine(tau: f64, exponent: f64) -> f64 {
    // The sine of π is a rounding error below zero.
    (std::f64::consts::PI * tau).sin().max(0.0).powf(exponent)
}

/// The logistic curve by which an oblique hit changes a velocity: `y₀ + Δ / (1 + exp(−κ (τ − τ₀)))`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogisticFit {
    /// Value before the hit, in the unit of what is fitted [its unit].
    pub start: f64,
    /// Change Δ, in the unit of what is fitted [its unit].
    pub change: f64,
    /// Steepness κ [-].
    pub steepness: f64,
    /// Moment τ₀ of the middle of the change [-].
    pub middle: f64,
    /// Root mean square of the error, as a share of the range of what is fitted [-].
    pub rms_error: f64,
}

impl LogisticFit {
    /// Fits to pairs of `τ` and value; of a value that does not change there is nothing to fit.
    pub(crate) fn new(points: &[[f64; 2]]) -> Result<Option<Self>, ImpactError> {
        let values = points.iter().map(|point| point[1]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        let range = high - low;
        let [Some([_, start]), Some([_, end])] = [points.first(), points.last()] else {
            return Ok(None);
        };
        if range <= 1.0e-12 * high.abs().max(low.abs()) {
            return Ok(None);
        }
        let scaled: Vec<[f64; 2]> = points
            .iter()
            .map(|[tau, value]| [*tau, (value - start) / range])
            .collect();
        let mut parameters = [(end - start) / range, 8.0, 0.5];
        let bounds = [[-4.0, 4.0], [0.5, 1.0e3], [-1.0, 2.0]];
        let shape = |p: &[f64], tau: f64| p[0] / (1.0 + (-p[1] * (tau - p[2])).exp());
        let [rms_error, _] = fit("logistic curve", &scaled, &mut parameters, &bounds, &shape)?;
        Ok(Some(Self {
            start: *start,
            change: parameters[0] * range,
            steepness: parameters[1],
            middle: parameters[2],
            rms_error,
        }))
    }

    /// Value at `τ`, in the unit of what is fitted [its unit].
    pub fn value(&self, tau: f64) -> f64 {
        self.start + self.change / (1.0 + (-self.steepness * (tau - self.middle)).exp())
    }
}

/// A curve and the points that it is to meet.
struct Problem<'p> {
    points: &'p [[f64; 2]],
    bounds: Vec<MPPar>,
    shape: &'p dyn Fn(&[f64], f64) -> f64,
}

impl MPFitter for Problem<'_> {
    fn eval(&mut self, parameters: &[f64], deviations: &mut [f64]) -> MPResult<()> {
        for (deviation, [tau, value]) in deviations.iter_mut().zip(self.points) {
            *deviation = value - (self.shape)(parameters, *tau);
        }
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.points.len()
    }

    fn parameters(&self) -> &[MPPar] {
        &self.bounds
    }
}

/// Fits the parameters; returns the root mean square and the greatest deviation.
fn fit(
    curve: &'static str,
    points: &[[f64; 2]],
    parameters: &mut [f64],
    bounds: &[[f64; 2]],
    shape: &dyn Fn(&[f64], f64) -> f64,
) -> Result<[f64; 2], ImpactError> {
    let bounds = bounds
        .iter()
        .map(|&[limit_low, limit_up]| MPPar {
            limited_low: true,
            limited_up: true,
            limit_low,
            limit_up,
            ..MPPar::new()
        })
        .collect();
    let mut problem = Problem {
        points,
        bounds,
        shape,
    };
    // The error of the library has no text.
    problem.mpfit(parameters).map_err(|_| ImpactError::NoFit {
        curve,
        reason: "the least-squares fit refused the samples of the hit",
    })?;
    let deviations = points
        .iter()
        .map(|[tau, value]| value - shape(parameters, *tau));
    let squares: f64 = deviations.clone().map(|deviation| deviation.powi(2)).sum();
    let worst = deviations.map(f64::abs).fold(0.0, f64::max);
    Ok([(squares / points.len() as f64).sqrt(), worst])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Evenly spaced points of a curve.
    fn points(curve: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        (0..=200)
            .map(|index| f64::from(index) / 200.0)
            .map(|tau| [tau, curve(tau)])
            .collect()
    }

    #[test]
    fn a_curve_fitted_to_itself_has_its_own_parameters_and_no_error() {
        // The fit ends when it gains less than 1e-10 of the sum of squares.
        let fitted = BellFit::new(&points(|tau| bell(tau, 4.5, 0.45)), 0.5).expect("a fit");
        assert!((fitted.shape_parameter - 4.5).abs() < 1.0e-6);
        assert!((fitted.asymmetry - 0.45).abs() < 1.0e-6);
        assert!(fitted.worst_error < 1.0e-6);
        let fitted = SineFit::new(&points(|tau| power_of_sine(tau, 1.7))).expect("a fit");
        assert!((fitted.exponent - 1.7).abs() < 1.0e-6);
        let logistic = |tau: f64| 3.0 - 2.0 / (1.0 + (-9.0 * (tau - 0.4)).exp());
        let fitted = LogisticFit::new(&points(logistic))
            .expect("a fit")
            .expect("a change");
        assert!((fitted.value(0.7) - logistic(0.7)).abs() < 0.05);
        assert!(fitted.rms_error < 0.02);
    }

    #[test]
    fn the_symmetric_bell_carries_two_to_the_shape_parameter_and_not_four() {
        for shape_parameter in [3.0, 4.0, 5.0_f64] {
            for tau in [0.1, 0.3, 0.5_f64] {
                let symmetric =
                    2.0_f64.powf(shape_parameter) * (tau * (1.0 - tau)).powf(0.5 * shape_parameter);
                assert!((bell(tau, shape_parameter, 0.5) / symmetric - 1.0).abs() < 1.0e-14);
            }
        }
    }

    #[test]
    fn the_area_under_the_bell_is_eight_fifteenths_at_shape_four_and_0_490874_at_five() {
        // The paper's (17): k_P = 0.533 and 0.49; 5 π/32.
        assert!((bell_area(4.0, 0.5) - 8.0 / 15.0).abs() < 1.0e-12);
        assert!((bell_area(5.0, 0.5) - 5.0 * std::f64::consts::PI / 32.0).abs() < 1.0e-12);
        // An asymmetric one by the trapezium rule, whose error is that of the ends.
        let sum: f64 = points(|tau| bell(tau, 6.0, 0.45))
            .iter()
            .map(|point| point[1])
            .sum();
        assert!((sum / 200.0 - bell_area(6.0, 0.45)).abs() < 1.0e-5);
    }

    #[test]
    fn a_value_that_does_not_change_has_no_logistic_fit() {
        assert_eq!(LogisticFit::new(&points(|_| 2.0)), Ok(None));
    }
}
