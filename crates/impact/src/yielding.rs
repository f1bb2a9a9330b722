//! Hits that yield: the greatest force of an elastic and perfectly plastic contact.
//!
//! Beyond the pressure that it yields under, the force grows along a straight line in place of Hertz's curve, so that
//! the same energy makes less force (Thornton 1997, J. Appl. Mech. 64, 383–386). With the force `F_y` and the speed
//! `v_y` at first yield, the greatest force of a hit of speed `v` is `F_y √(6/5 (v/v_y)² − 1/5)`.

use crate::elastic::ElasticImpact;

/// Greatest force of a hit [N] whose contact yields under a `yield_pressure` [Pa], from what the force [N] and the
/// pressure [Pa] would be if it stayed elastic.
///
/// Of a damped hit the energy is that which a force of this size takes.
///
/// ```
/// use pelletflow_impact::yielding::yielded_force;
///
/// assert_eq!(yielded_force(100.0, 40.0e6, 50.0e6), 100.0);
/// assert!(yielded_force(100.0, 60.0e6, 50.0e6) < 100.0);
/// ```
pub fn yielded_force(elastic_force: f64, elastic_pressure: f64, yield_pressure: f64) -> f64 {
    let excess = elastic_pressure / yield_pressure;
    if excess <= 1.0 {
        return elastic_force;
    }
    // The pressure grows as the third root of the force, and as the fifth of the energy.
    let at_yield = elastic_force / excess.powi(3);
    at_yield * (1.2 * excess.powi(5) - 0.2).sqrt()
}

/// Speed at which a hit like `hit` reaches a force [N] where its contact yields under a `yield_pressure` [Pa]: the
/// inverse of [`yielded_force`] [m/s].
pub fn speed_of_yielded_force(hit: &ElasticImpact, force: f64, yield_pressure: f64) -> f64 {
    let excess = hit.pressure(force) / yield_pressure;
    if excess <= 1.0 {
        return hit.speed_of_peak_force(force);
    }
    let at_yield = force / excess.powi(3);
    let speed_at_yield = hit.speed_of_peak_force(at_yield);
    speed_at_yield * ((5.0 * (force / at_yield).powi(2) + 1.0) / 6.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A 12 mm pellet of 3.44 g on a flat wall.
    const HIT: ElasticImpact = ElasticImpact {
        effective_youngs_modulus: 5.0e9,
        effective_radius: 0.006,
        effective_mass: 3.44e-3,
        speed: 4.0,
    };

    /// Energy over force up to a greatest approach, summed in small steps of Hertz's curve and of the line beyond.
    fn summed_force(yield_pressure: f64) -> f64 {
        let energy = 0.5 * HIT.effective_mass * HIT.speed.powi(2);
        let step = HIT.greatest_approach() * 1.0e-5;
        let (mut taken, mut approach, mut force) = (0.0, 0.0_f64, 0.0);
        let slope = std::f64::consts::PI * yield_pressure * HIT.effective_radius;
        while taken < energy {
            let next = HIT.stiffness() * (approach + step).powf(1.5);
            let next = if HIT.pressure(next) > yield_pressure {
                force + slope * step
            } else {
                next
            };
            taken += 0.5 * (force + next) * step;
            force = next;
            approach += step;
        }
        force
    }

    #[test]
    fn the_force_is_that_whose_work_is_the_energy_of_the_hit() {
        let elastic = (HIT.peak_force(), HIT.peak_pressure());
        for share in [0.9, 0.5, 0.2] {
            let yield_pressure = share * elastic.1;
            let force = yielded_force(elastic.0, elastic.1, yield_pressure);
            let exact = summed_force(yield_pressure);
            // One step of the sum, on each side of where it yields and where it ends.
            assert!(
                (force / exact - 1.0).abs() < 4.0e-5,
                "{share}: {force} {exact}"
            );
        }
    }

    #[test]
    fn the_speed_is_the_inverse_of_the_force() {
        let pressure = HIT.peak_pressure();
        for share in [2.0, 1.0, 0.5, 0.1] {
            let force = yielded_force(HIT.peak_force(), pressure, share * pressure);
            let speed = speed_of_yielded_force(&HIT, force, share * pressure);
            assert!(
                (speed / HIT.speed - 1.0).abs() < 1.0e-12,
                "{share}: {speed}"
            );
        }
    }
}
