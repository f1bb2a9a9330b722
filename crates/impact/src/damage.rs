//! Damage that adds up over blows too weak to break a pellet (Tavares & King 2002; Tavares 2009).
//!
//! A blow of the energy `E_k` lowers the fracture energy of a pellet that it does not break, from `E` to `E (1 − D)`:
//!
//! `D = [2γ / (2γ − 5D + 5) · E_k/E]^(2γ/5)`
//!
//! with the damage constant γ. The damage is 1 where the blow breaks, `E_k = E`.

/// Steps of the table of damage [-]; it is then right within 2e-5 for γ of 2.5 or more.
const TABLE_STEPS: usize = 4096;

/// Strengths that stand for all [-].
///
/// A pellet is as strong as it is, only nobody knows how strong: these are followed, and between them the strength that
/// the blows just break is interpolated. Shares that break are then within 0.002 of those of ten thousand strengths.
const STRENGTHS: usize = 64;

/// Places in the distribution of strengths that the first and the last one stand for [-].
const PLACES: (f64, f64) = (-5.5, 5.0);

/// Damage of a blow that takes up the share `energy_ratio` of the fracture energy, at most 1, for a damage constant γ
/// [-].
///
/// The law is implicit in the damage and explicit in the energy, `E_k/E = D^(5/2γ) (2γ + 5 − 5D)/2γ`, which grows with
/// the damage; so it is halved.
pub fn damage(energy_ratio: f64, damage_constant: f64) -> f64 {
    if energy_ratio >= 1.0 {
        return 1.0;
    }
    let double = 2.0 * damage_constant;
    let energy = |damage: f64| damage.powf(5.0 / double) * (double + 5.0 - 5.0 * damage) / double;
    let (mut low, mut high) = (0.0, 1.0);
    while high - low > 1.0e-15 * high {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        if energy(middle) < energy_ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// How the strengths of a pellet weaken: in medians of the fracture energy, so that one serves pellets of all sizes.
#[derive(Debug)]
pub(crate) struct Weakening {
    /// What is left of the fracture energy after a blow, over `√(1 − E_k/E)`: there the law bends nowhere.
    left: Vec<f64>,
    /// Fracture energy of the first blow, growing.
    strengths: Vec<f64>,
    /// Fracture energy now.
    now: Vec<f64>,
    /// The first that is not broken.
    first: usize,
    /// The strength that the blows have just broken.
    broken: f64,
}

impl Weakening {
    /// Of strengths whose logarithm has this standard deviation [-].
    pub(crate) fn new(deviation: f64, damage_constant: f64) -> Self {
        let step = (PLACES.1 - PLACES.0) / (STRENGTHS - 1) as f64;
        let strengths: Vec<f64> = (0..STRENGTHS)
            .map(|index| (deviation * (PLACES.0 + index as f64 * step)).exp())
            .collect();
        let left = (0..=TABLE_STEPS + 1)
            .map(|index| {
                let root = (index as f64 / TABLE_STEPS as f64).min(1.0);
                1.0 - damage(1.0 - root * root, damage_constant)
            })
            .collect();
        Self {
            left,
            now: strengths.clone(),
            strengths,
            first: 0,
            broken: 0.0,
        }
    }

    /// Takes a new pellet.
    pub(crate) fn renew(&mut self) {
        self.now.copy_from_slice(&self.strengths);
        self.first = 0;
        self.broken = 0.0;
    }

    /// Strength up to which all are broken after a blow of this energy, in medians of the fracture energy [-].
    pub(crate) fn hit(&mut self, energy: f64) -> f64 {
        let (mut weaker, mut weaker_now) = (self.broken, 0.0);
        while self.first < STRENGTHS && self.now[self.first] <= energy {
            (weaker, weaker_now) = (self.strengths[self.first], self.now[self.first]);
            self.first += 1;
        }
        let broken = match self.strengths.get(self.first) {
            None => weaker.max(energy),
            Some(stronger) => {
                let part = (energy - weaker_now) / (self.now[self.first] - weaker_now);
                // Just above what a blow has broken, the fracture energy left grows with the root of the strength.
                let part = if weaker_now == 0.0 && self.broken > 0.0 {
                    part * part
                } else {
                    part
                };
                weaker + part * (stronger - weaker)
            }
        };
        self.broken = self.broken.max(broken);
        for now in &mut self.now[self.first..] {
            let root = (1.0 - energy / *now).max(0.0).sqrt();
            let at = root * TABLE_STEPS as f64;
            let index = at as usize;
            let part = at - index as f64;
            *now *= self.left[index] + part * (self.left[index + 1] - self.left[index]);
        }
        self.broken
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_damage_satisfies_the_published_equation() {
        for constant in [2.5, 3.0, 5.0, 5.4] {
            for ratio in [1.0e-3, 0.1, 0.5, 0.9, 0.999] {
                let found = damage(ratio, constant);
                let double = 2.0 * constant;
                let right = (double / (double - 5.0 * found + 5.0) * ratio).powf(double / 5.0);
                assert!((found / right - 1.0).abs() < 1.0e-9, "{constant} {ratio}");
            }
        }
    }

    #[test]
    fn a_blow_of_the_whole_fracture_energy_is_damage_one_and_a_weak_one_a_power_of_it() {
        assert_eq!(damage(1.0, 5.0), 1.0);
        // D → [2γ/(2γ + 5) · E_k/E]^(2γ/5): (2/3 · 0.001)² for γ = 5.
        let weak = damage(1.0e-3, 5.0) / (2.0e-3_f64 / 3.0).powi(2);
        assert!((weak - 1.0).abs() < 1.0e-6, "{weak}");
    }

    #[test]
    fn the_table_of_damage_is_right_within_2e_5() {
        for constant in [2.5, 3.0, 5.0, 8.0] {
            let table = Weakening::new(0.5, constant).left;
            for index in 0..10 * TABLE_STEPS {
                let at = index as f64 / 10.0;
                let (low, part) = (at as usize, at.fract());
                let found = table[low] + part * (table[low + 1] - table[low]);
                let root = at / TABLE_STEPS as f64;
                let exact = 1.0 - damage(1.0 - root * root, constant);
                assert!((found - exact).abs() < 2.0e-5, "{constant} {root}");
            }
        }
    }

    #[test]
    fn one_blow_breaks_exactly_what_is_weaker() {
        let mut weakening = Weakening::new(0.5, 5.0);
        for energy in [1.0e-3, 0.3, 1.0, 7.0] {
            weakening.renew();
            assert!((weakening.hit(energy) / energy - 1.0).abs() < 1.0e-12);
        }
    }
}
