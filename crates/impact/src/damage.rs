//! Damage that adds up over blows too weak to break a pellet (Tavares & King 2002; Tavares 2009).
//!
//! A blow of the energy `E_k` lowers the fracture energy of a pellet that it does not break, from `E` to `E (1 − D)`:
//!
//! `D = [2γ / (2γ − 5D + 5) · E_k/E]^(2γ/5)`
//!
//! with the damage constant γ. The damage is 1 where the blow breaks, `E_k = E`.

/// Steps of the table of damage [-]; it is then right within 5e-5 for γ of 2.5 or more.
const TABLE_STEPS: usize = 2048;

/// Strengths that are followed for all [-].
///
/// A pellet has one strength, only nobody knows which: these are followed, and between them the strength that the blows
/// just break is interpolated. Shares that break are then within 0.01 of those of thousands of strengths.
const STRENGTHS: usize = 128;

/// Strengths that are added where the blows have just broken others [-].
const SPARE: usize = 32;

/// Where they are put between the broken strength and the next one, from the stronger to the weaker [-].
const REFINEMENT: [f64; 2] = [0.4, 0.1];

/// Distance to the next strength, in broken ones, below which none is added [-].
const FINEST: f64 = 0.01;

/// Places in the distribution of strengths that the first and the last one stand for [-].
const PLACES: (f64, f64) = (-4.5, 4.0);

/// Damage that does not count: ten thousand such blows take a thousandth off the fracture energy [-].
const NEGLIGIBLE: f64 = 1.0e-7;

/// Damage of a blow that takes up the share `energy_ratio` of the fracture energy, at most 1, for a damage constant γ
/// [-].
///
/// The law is implicit in the damage and explicit in the energy, `E_k/E = D^(5/2γ) (2γ + 5 − 5D)/2γ`, which grows with
/// the damage; so it is halved.
pub fn damage(energy_ratio: f64, damage_constant: f64) -> f64 {
    if energy_ratio >= 1.0 {
        return 1.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    while high - low > 1.0e-15 * high {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        if self::energy_ratio(middle, damage_constant) < energy_ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// Share of the fracture energy that a blow of this damage takes up.
fn energy_ratio(damage: f64, damage_constant: f64) -> f64 {
    let double = 2.0 * damage_constant;
    damage.powf(5.0 / double) * (double + 5.0 - 5.0 * damage) / double
}

/// How the strengths of a pellet weaken: in medians of the fracture energy, so that one serves pellets of all sizes.
#[derive(Debug)]
pub(crate) struct Weakening {
    /// What is left of the fracture energy after a blow, over `√(1 − E_k/E)`, where the law bends nowhere: value and rise of each
    /// step of the table.
    left: Vec<[f64; 2]>,
    /// Share of the fracture energy below which a blow leaves no damage that counts.
    negligible: f64,
    /// All strengths that a new pellet may have.
    fresh: Vec<Node>,
    /// Those followed; the ones before the first are broken or spare.
    nodes: Vec<Node>,
    /// The first that is not broken.
    first: usize,
    /// The strength that the blows have just broken.
    broken: f64,
}

/// A strength that a pellet may have.
#[derive(Debug, Clone, Copy, Default)]
struct Node {
    /// Fracture energy of its first blow.
    strength: f64,
    /// Fracture energy now.
    now: f64,
}

impl Weakening {
    /// Of strengths whose logarithm has this standard deviation [-].
    pub(crate) fn new(deviation: f64, damage_constant: f64) -> Self {
        let step = (PLACES.1 - PLACES.0) / (STRENGTHS - 1) as f64;
        let mut fresh = vec![Node::default(); SPARE];
        fresh.extend((0..STRENGTHS).map(|index| {
            let strength = (deviation * (PLACES.0 + index as f64 * step)).exp();
            Node {
                strength,
                now: strength,
            }
        }));
        let value = |index: usize| {
            let root = (index as f64 / TABLE_STEPS as f64).min(1.0);
            1.0 - damage(1.0 - root * root, damage_constant)
        };
        let left = (0..=TABLE_STEPS)
            .map(|index| [value(index), value(index + 1) - value(index)])
            .collect();
        Self {
            left,
            negligible: energy_ratio(NEGLIGIBLE, damage_constant),
            nodes: fresh.clone(),
            fresh,
            first: SPARE,
            broken: 0.0,
        }
    }

    /// Takes a new pellet.
    pub(crate) fn renew(&mut self) {
        self.nodes.copy_from_slice(&self.fresh);
        self.first = SPARE;
        self.broken = 0.0;
    }

    /// Strength up to which all are broken after a blow of this energy, in medians of the fracture energy [-].
    pub(crate) fn hit(&mut self, energy: f64) -> f64 {
        let mut weaker = Node {
            strength: self.broken,
            now: 0.0,
        };
        while let Some(node) = self.nodes.get(self.first).filter(|node| node.now <= energy) {
            weaker = *node;
            self.first += 1;
        }
        let Some(&stronger) = self.nodes.get(self.first) else {
            self.broken = self.broken.max(weaker.strength).max(energy);
            return self.broken;
        };
        let cell = Cell {
            weaker,
            stronger,
            // Just above what a blow has broken, the fracture energy left grows with the root of the strength.
            is_root: weaker.now == 0.0 && self.broken > 0.0,
        };
        self.broken = cell.strength_at(energy).max(self.broken);
        self.refine(&cell);
        let unharmed = energy / self.negligible;
        for node in &mut self.nodes[self.first..] {
            if node.now > unharmed {
                break;
            }
            let at = (1.0 - energy / node.now).max(0.0).sqrt() * TABLE_STEPS as f64;
            let index = at as u32;
            let [left, rise] = self.left[index as usize];
            node.now *= left + (at - f64::from(index)) * rise;
        }
        self.broken
    }

    /// Follows more strengths just above the broken ones, where the damage of this blow changes fast.
    fn refine(&mut self, cell: &Cell) {
        let gap = cell.stronger.strength - self.broken;
        if gap < FINEST * self.broken {
            return;
        }
        for part in REFINEMENT {
            if self.first == 0 {
                return;
            }
            let strength = self.broken + part * gap;
            self.first -= 1;
            self.nodes[self.first] = Node {
                strength,
                now: cell.now_at(strength),
            };
        }
    }
}

/// Two strengths followed, and what lies between them.
struct Cell {
    weaker: Node,
    stronger: Node,
    is_root: bool,
}

impl Cell {
    /// Strength whose fracture energy is now `energy`.
    fn strength_at(&self, energy: f64) -> f64 {
        let part = (energy - self.weaker.now) / (self.stronger.now - self.weaker.now);
        let part = if self.is_root { part * part } else { part };
        self.weaker.strength + part * (self.stronger.strength - self.weaker.strength)
    }

    /// Fracture energy now of a strength.
    fn now_at(&self, strength: f64) -> f64 {
        let part =
            (strength - self.weaker.strength) / (self.stronger.strength - self.weaker.strength);
        let part = if self.is_root { part.sqrt() } else { part };
        self.weaker.now + part * (self.stronger.now - self.weaker.now)
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
    fn the_table_of_damage_is_right_within_5e_5() {
        for constant in [2.5, 3.0, 5.0, 8.0] {
            let table = Weakening::new(0.5, constant).left;
            for index in 0..10 * TABLE_STEPS {
                let at = index as f64 / 10.0;
                let (low, part) = (at as usize, at.fract());
                let found = table[low][0] + part * table[low][1];
                let root = at / TABLE_STEPS as f64;
                let exact = 1.0 - damage(1.0 - root * root, constant);
                assert!((found - exact).abs() < 5.0e-5, "{constant} {root}");
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
