//! What breaks, by cause, by what is hit, by size and by place.

use super::Scored;
use crate::table::number;
use pelletflow_impact::Interval;
use pelletflow_log::RecordedHits;
use pelletflow_sim::{Cause, Hit, HitPartner};
use std::collections::BTreeMap;

/// Sizes told one by one; of more, classes of equal width [-].
const SIZES: usize = 5;
/// Side of the cubes that places are told by, over the diameter of the largest pellet [-].
const CUBE_SIDE: f64 = 4.0;

/// One group of blows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Group {
    pub(super) name: String,
    /// Pellets broken.
    pub(super) broken: Interval,
    /// Blows of the group [-].
    pub(super) blows: u64,
    /// Greatest force of one of them [N].
    pub(super) worst_force: f64,
}

/// A cube of space where pellets break.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Place {
    /// Its middle, in the world [m].
    pub(super) middle: [f64; 3],
    pub(super) group: Group,
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
    pub(super) fn new(
        recorded: &RecordedHits,
        scored: &Scored,
        force: impl Fn(&Hit) -> f64,
        places: usize,
    ) -> Self {
        let force = &force;
        let by_cause = grouped(recorded, scored, force, |_, hit| recorded.hits[hit].cause);
        let by_wall = grouped(recorded, scored, force, |_, hit| {
            match recorded.hits[hit].partner {
                HitPartner::Wall(wall) => Some(wall),
                HitPartner::Pellet { .. } => None,
            }
        });
        let diameters = || scored.blows.iter().map(|blow| blow.diameter);
        let largest = diameters().fold(0.0, f64::max);
        let least = diameters().fold(largest, f64::min);
        let width = (largest - least) / SIZES as f64;
        let class = |diameter: f64| {
            let class = if width > 0.0 {
                (diameter - least) / width
            } else {
                0.0
            };
            (class as usize).min(SIZES - 1)
        };
        let by_size = grouped(recorded, scored, force, |blow, _| {
            class(scored.blows[blow].diameter)
        });
        let cube_side = CUBE_SIDE * largest;
        let by_place = grouped(recorded, scored, force, |_, hit| {
            let place = recorded.hits[hit].place;
            [0, 1, 2].map(|axis| (place[axis] / cube_side).floor() as i64)
        });
        let mut by_place: Vec<Place> = by_place
            .into_iter()
            .filter(|(_, group)| group.broken.best > 0.0)
            .map(|(cube, group)| Place {
                middle: cube.map(|index| (index as f64 + 0.5) * cube_side),
                group,
            })
            .collect();
        by_place.sort_by(|one, other| other.group.broken.best.total_cmp(&one.group.broken.best));
        by_place.truncate(places);
        Self {
            by_cause: named(by_cause, |cause: Cause| cause.name().into()),
            by_wall: named(by_wall, |wall| match wall {
                Some(wall) => recorded
                    .walls
                    .get(wall)
                    .map_or_else(|| format!("wall {wall}"), |name| format!("wall `{name}`")),
                None => "another pellet".into(),
            }),
            by_size: named(by_size, |class| {
                let from = least + class as f64 * width;
                if width > 0.0 {
                    format!(
                        "{} to {} mm",
                        number(1.0e3 * from),
                        number(1.0e3 * (from + width))
                    )
                } else {
                    format!("{} mm", number(1.0e3 * from))
                }
            }),
            by_place,
            cube_side,
        }
    }
}

/// Blows that have the same key, in order of the key; the key follows from the place of a blow and of its hit.
fn grouped<K: Ord>(
    recorded: &RecordedHits,
    scored: &Scored,
    force: impl Fn(&Hit) -> f64,
    key: impl Fn(usize, usize) -> K,
) -> BTreeMap<K, Group> {
    let mut members: BTreeMap<K, Vec<usize>> = BTreeMap::new();
    for (blow, &hit) in scored.hits.iter().enumerate() {
        members.entry(key(blow, hit)).or_default().push(blow);
    }
    members
        .into_iter()
        .map(|(key, blows)| {
            let forces = blows
                .iter()
                .map(|&blow| force(&recorded.hits[scored.hits[blow]]));
            let group = Group {
                name: String::new(),
                worst_force: forces.fold(0.0, f64::max),
                blows: blows.len() as u64,
                broken: scored.score.broken_by(blows),
            };
            (key, group)
        })
        .collect()
}

fn named<K>(groups: BTreeMap<K, Group>, name: impl Fn(K) -> String) -> Vec<Group> {
    groups
        .into_iter()
        .map(|(key, group)| Group {
            name: name(key),
            ..group
        })
        .collect()
}
