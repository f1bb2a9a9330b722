//! The effective radius of two bodies that bend more one way than across it.
//!
//! Their contact is an ellipse (Hertz 1882; Johnson 1985, section 4.2). With semi-axes a ≥ b, eccentricity e² = 1 − b²/a²,
//! complete elliptic integrals K and E of e, and relative principal curvatures 2A ≤ 2B:
//!
//! > B/A = ((a/b)² E − K) / (K − E), A + B = (p₀/E*) E/b, δ = (p₀/E*) b K, F = (2/3) π a b p₀.
//!
//! A sphere of the effective radius given here has the same force at the same approach.

use std::f64::consts::FRAC_PI_2;

/// Difference of the curvatures over their sum up to which the series below serves [-].
const NEARLY_ROUND: f64 = 0.4;
/// Powers of the square of that in the effective radius over that of the mean curvature, less 1 [-]: fitted to the exact
/// solution, from which it differs by 3e-8 at most.
const SERIES: [f64; 5] = [
    0.666_666_81,
    0.574_029_42,
    0.526_865_91,
    0.455_897_9,
    0.707_279_44,
];
/// Steps of the secant method at most; five reach the last digits [-].
const MOST_STEPS: u32 = 12;
/// Error of the root of the ratio of curvatures that is left [-].
const CLOSE: f64 = 1.0e-13;

/// Radius of the sphere that pushes a plane as two bodies of these relative principal curvatures push each other [m].
///
/// The relative curvatures are the sums of both bodies' in either principal direction, positive [1/m].
pub fn effective_radius(relative_curvatures: [f64; 2]) -> f64 {
    let [one, other] = relative_curvatures;
    let mean = f64::midpoint(one, other);
    let difference = (one - other) / (one + other);
    let squared = difference * difference;
    if difference.abs() < NEARLY_ROUND {
        let series = SERIES
            .iter()
            .rev()
            .fold(0.0, |sum, coefficient| squared * (coefficient + sum));
        return (1.0 + series) / mean;
    }
    let axes = ratio_of_axes(one.min(other) / one.max(other));
    let (first, second) = elliptic_integrals(axes);
    FRAC_PI_2 * FRAC_PI_2 * second / (axes * axes * first * first * first * mean)
}

/// The shorter over the longer axis of the ellipse [-], from the lesser over the greater curvature [-].
///
/// The axes nearly go with the power 0.64 of the curvatures (Hamrock & Brewe 1983). No function but the root is used, so
/// that the bits are those of any platform.
fn ratio_of_axes(ratio_of_curvatures: f64) -> f64 {
    let goal = ratio_of_curvatures.sqrt();
    let miss = |axes: f64| root_of_curvatures(axes) - goal;
    let mut last = goal * goal.sqrt().sqrt();
    let mut last_miss = miss(last);
    let mut axes = last * (1.0 - last_miss / goal);
    for _ in 0..MOST_STEPS {
        let new_miss = miss(axes);
        if new_miss.abs() < CLOSE * goal || new_miss == last_miss {
            break;
        }
        let step = new_miss * (axes - last) / (new_miss - last_miss);
        (last, last_miss) = (axes, new_miss);
        axes -= step;
    }
    axes
}

/// Root of A/B from b/a.
fn root_of_curvatures(axes: f64) -> f64 {
    let (_, lack) = means(axes);
    let squared_eccentricity = (1.0 - axes) * (1.0 + axes);
    axes * (lack / (squared_eccentricity - lack)).sqrt()
}

/// K and E from b/a.
fn elliptic_integrals(axes: f64) -> (f64, f64) {
    let (mean, lack) = means(axes);
    let first = FRAC_PI_2 / mean;
    (first, first * (1.0 - lack))
}

/// Gauss's mean of 1 and b/a, with K = π/2 over it, and 1 − E/K, free of cancellation (Abramowitz & Stegun 1964, 17.6).
fn means(axes: f64) -> (f64, f64) {
    let (mut arithmetic, mut geometric) = (1.0, axes);
    let mut lack = 0.5 * (1.0 - axes) * (1.0 + axes);
    let mut weight = 1.0;
    // Each step doubles the digits.
    for _ in 0..12 {
        let half_difference = 0.5 * (arithmetic - geometric);
        if half_difference.abs() < 1.0e-17 * arithmetic {
            break;
        }
        lack += weight * half_difference * half_difference;
        (arithmetic, geometric) = (
            f64::midpoint(arithmetic, geometric),
            (arithmetic * geometric).sqrt(),
        );
        weight *= 2.0;
    }
    (arithmetic, lack)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral over (0, ∞) of f(w) / √((1 + w)(b² + w) w), by the trapezoidal rule in t with w = exp(sinh t).
    fn potential(axes: f64, weight: impl Fn(f64) -> f64) -> f64 {
        let step = 1.0 / 128.0;
        (-640..=640)
            .map(|index| {
                let t = f64::from(index) * step;
                let w = t.sinh().exp();
                let root = ((1.0 + w) * (axes * axes + w) * w).sqrt();
                let term = weight(w) / root * w * t.cosh() * step;
                if term.is_finite() { term } else { 0.0 }
            })
            .sum()
    }

    #[test]
    fn the_force_is_that_of_a_pressure_over_an_ellipse() {
        // The potential of the pressure p₀ √(1 − x²/a² − y²/b²) (Johnson 1985, equations 3.62 to 3.64), a = 1, p₀ = E* = 1.
        for axes in [0.99, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.1, 0.02] {
            let half = 0.5 * axes;
            let approach = half * potential(axes, |_| 1.0);
            let along = half * potential(axes, |w| 1.0 / (1.0 + w));
            let across = half * potential(axes, |w| 1.0 / (axes * axes + w));
            let force = 2.0 / 3.0 * std::f64::consts::PI * axes;
            let radius = effective_radius([2.0 * along, 2.0 * across]);
            let found = 4.0 / 3.0 * radius.sqrt() * approach.powf(1.5);
            // The sum stands for the integral to about 1e-9, and the series for the solution to 3e-8.
            assert!(
                (found / force - 1.0).abs() < 3.0e-8,
                "b/a = {axes}: {}",
                found / force
            );
        }
    }

    #[test]
    fn the_mean_curvature_errs_as_tabulated() {
        // Ratio of curvatures, and what the mean curvature lacks of the force: 4, 18, 32 and 45 %.
        for (ratio, lack) in [(2.0, 0.04), (5.0, 0.18), (10.0, 0.32), (20.0, 0.45)] {
            let exact = effective_radius([1.0, ratio]).sqrt();
            let mean = (2.0 / (1.0 + ratio)).sqrt();
            // Tabulated to a percent.
            assert!(
                (1.0 - mean / exact - lack).abs() < 0.0055,
                "{ratio}: {}",
                1.0 - mean / exact
            );
        }
    }

    #[test]
    fn nearly_round_contacts_join_on_smoothly() {
        let ratio = (1.0 + NEARLY_ROUND) / (1.0 - NEARLY_ROUND);
        let below = effective_radius([1.0, ratio * (1.0 - 1.0e-9)]);
        let above = effective_radius([1.0, ratio * (1.0 + 1.0e-9)]);
        // What the series is off.
        assert!((below / above - 1.0).abs() < 3.0e-8);
        assert_eq!(effective_radius([4.0, 4.0]), 0.25);
    }
}
