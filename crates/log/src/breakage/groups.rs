//! What breaks, by cause, by what is hit, by size and by place.

use super::{Blows, Share};
use crate::hits::wall_in_words;
use pelletflow_impact::{Blow, Chance, Score};
use pelletflow_sim::{Cause, Hit, HitPartner};
use serde::Serialize;
use std::collections::BTreeMap;

/// Sizes told one by one; of more, classes of equal width [-].
const SIZES: usize = 5;
/// Side of the cubes that places are told by, over the diameter of the largest pellet [-].
const CUBE_SIDE: f64 = 4.0;

/// The blows that break, each counted by its chance to do so: their means.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Breaking {
    /// Speed of the contact points at first touch, toward and past each other [m/s].
    pub speed_m_per_s: f64,
    /// Its part along the normal, which makes the force [m/s].
    pub normal_speed_m_per_s: f64,
    /// Diameter of the pellet [m].
    pub diameter_m: f64,
    /// Mass of the pellet [kg].
    pub mass_kg: f64,
}

/// Blows that have something in common.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Group {
    /// What they have in common.
    pub name: String,
    /// Pellets that they break.
    #[serde(flatten)]
    pub broken: Share,
    /// How many they are [-].
    pub blows: u64,
    /// Greatest force of one of them [N].
    pub worst_force_n: f64,
    /// Those of them that break; none where none does.
    pub breaking: Option<Breaking>,
}

/// A cube of space where pellets break.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    /// Its middle, in the world [m].
    pub middle_m: [f64; 3],
    /// The blows in it.
    #[serde(flatten)]
    pub group: Group,
}

/// All groupings.
pub(super) struct Groups {
    pub(super) by_cause: Vec<Group>,
    pub(super) by_wall: Vec<Group>,
    pub(super) by_size: Vec<Group>,
    pub(super) by_place: Vec<Place>,
    /// Side of the cubes of places [m].
    pub(super) cube_side: f64,
}

impl Groups {
    /// Groups the blows, whose forces are told by `force` [N], and tells the `places` where most breaks.
    pub(super) fn new(blows: &Blows, score: &Score, force: fn(&Hit) -> f64, places: usize) -> Self {
        let sizes = Sizes::of(blows);
        let cube_side = CUBE_SIDE * sizes.largest;
        let cube = |hit: &Hit| [0, 1, 2].map(|axis| (hit.place[axis] / cube_side).floor() as i64);
        let grouping = Grouping {
            blows,
            score,
            force,
        };
        Self {
            by_cause: grouping.by(|_, hit| hit.cause, |cause: Cause| cause.name().into()),
            by_wall: grouping.by(
                |_, hit| match hit.partner {
                    HitPartner::Wall(wall) => Some(wall),
                    HitPartner::Pellet { .. } => None,
                },
                |wall| wall_name(&blows.recorded.walls, wall),
            ),
            by_size: grouping.by(
                |blow, _| sizes.class(blow.diameter),
                |class| sizes.name(class),
            ),
            by_place: grouping.places(cube, cube_side, places),
            cube_side,
        }
    }
}

/// How a wall, or where there is none another pellet, is named as a partner.
pub(crate) fn wall_name(walls: &[String], wall: Option<usize>) -> String {
    wall.map_or_else(
        || "another pellet".into(),
        |wall| wall_in_words(walls, wall),
    )
}

/// Classes of diameters, equally wide.
struct Sizes {
    least: f64,
    largest: f64,
    width: f64,
}

impl Sizes {
    fn of(blows: &Blows) -> Self {
        let diameters = || blows.felt.iter().map(|blow| blow.diameter);
        let largest = diameters().fold(0.0, f64::max);
        let least = diameters().fold(largest, f64::min);
        Self {
            least,
            largest,
            width: (largest - least) / SIZES as f64,
        }
    }

    fn class(&self, diameter: f64) -> usize {
        if self.width > 0.0 {
            (((diameter - self.least) / self.width) as usize).min(SIZES - 1)
        } else {
            0
        }
    }

    fn name(&self, class: usize) -> String {
        let millimeters = |diameter: f64| (1.0e6 * diameter).round() / 1.0e3;
        let from = self.least + class as f64 * self.width;
        if self.width > 0.0 {
            format!(
                "{} to {} mm",
                millimeters(from),
                millimeters(from + self.width)
            )
        } else {
            format!("{} mm", millimeters(from))
        }
    }
}

/// Blows that are to be grouped.
struct Grouping<'a> {
    blows: &'a Blows<'a>,
    score: &'a Score,
    force: fn(&Hit) -> f64,
}

/// What adds up over the blows of a group.
#[derive(Default)]
struct Sum {
    chance: Chance,
    /// Speed, its normal part, diameter and mass, each times the chance.
    moments: [f64; 4],
    blows: u64,
    worst_force: f64,
}

impl Grouping<'_> {
    /// Groups by a key of blow and hit, in order of the key, named by it.
    fn by<K: Ord + Copy>(
        &self,
        key: impl Fn(&Blow, &Hit) -> K,
        name: impl Fn(K) -> String,
    ) -> Vec<Group> {
        self.sums(key)
            .into_iter()
            .map(|(key, sum)| self.group(name(key), &sum))
            .collect()
    }

    /// The cubes where most breaks, the worst first.
    fn places(&self, cube: impl Fn(&Hit) -> [i64; 3], cube_side: f64, count: usize) -> Vec<Place> {
        let sums = self.sums(|_, hit| cube(hit)).into_iter();
        let mut worst: Vec<([i64; 3], Sum)> =
            sums.filter(|(_, sum)| sum.chance.best > 0.0).collect();
        worst.sort_by(|(_, one), (_, other)| other.chance.best.total_cmp(&one.chance.best));
        worst.truncate(count);
        worst
            .into_iter()
            .map(|(cube, sum)| {
                let middle_m = cube.map(|index| (index as f64 + 0.5) * cube_side);
                let name = middle_m.map(|at| format!("{at:.3}")).join(", ");
                Place {
                    middle_m,
                    group: self.group(name, &sum),
                }
            })
            .collect()
    }

    fn sums<K: Ord + Copy>(&self, key: impl Fn(&Blow, &Hit) -> K) -> BTreeMap<K, Sum> {
        let mut sums: BTreeMap<K, Sum> = BTreeMap::new();
        for ((blow, hit), &chance) in self.blows.iter().zip(&self.score.chances) {
            let sum = sums.entry(key(blow, hit)).or_default();
            if chance != Chance::default() {
                sum.chance += chance;
                let moments = [hit.speed(), hit.approach_speed, blow.diameter, blow.mass];
                for (sum, moment) in sum.moments.iter_mut().zip(moments) {
                    *sum += chance.best * moment;
                }
            }
            sum.blows += 1;
            sum.worst_force = sum.worst_force.max((self.force)(hit));
        }
        sums
    }

    fn group(&self, name: String, sum: &Sum) -> Group {
        let breaking = (sum.chance.best > 0.0).then(|| {
            let [speed_m_per_s, normal_speed_m_per_s, diameter_m, mass_kg] =
                sum.moments.map(|moment| moment / sum.chance.best);
            Breaking {
                speed_m_per_s,
                normal_speed_m_per_s,
                diameter_m,
                mass_kg,
            }
        });
        Group {
            name,
            breaking,
            broken: Share::of(sum.chance.broken(), self.blows.recorded.pellets),
            blows: sum.blows,
            worst_force_n: sum.worst_force,
        }
    }
}
