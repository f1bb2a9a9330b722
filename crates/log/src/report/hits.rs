//! What a report tells of hits: how many of which force, and the hardest.

use crate::plot::{Axis, Chart, Series, SeriesStyle};
use crate::worst_hits::WorstHits;
use pelletflow_sim::{Hit, HitClass, HitClassKey, HitPartner};
use std::collections::BTreeMap;

/// Hits that are marked on the walls at most [-].
const MAPPED: usize = 1500;
/// Classes of force that a step of the histogram joins [-]: there are eight for each doubling.
const JOINED_CLASSES: i32 = 4;
/// Walls with a line of their own in the histogram [-]; the rest are told together.
const LINES: usize = 5;

/// Hits of a recording, of which a number is kept that does not grow with the run.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HitFindings {
    /// Names of the walls, by index; none where hits were not followed.
    pub(super) walls: Option<Vec<String>>,
    /// Whether some material was softer in the run than it really is.
    pub(super) is_softened: bool,
    /// The hardest.
    pub(super) worst: WorstHits,
    /// The sketch of all hits.
    pub(super) classes: BTreeMap<HitClassKey, HitClass>,
}

/// What the hits on one wall, or of pellets on each other, came to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PartnerRow {
    pub(super) name: String,
    /// Index of the wall; none of pellets.
    pub(super) wall: Option<usize>,
    /// How many [-].
    pub(super) count: u64,
    /// The greatest force, by its class from below [N].
    pub(super) force: f64,
    /// Energy taken from motion [J].
    pub(super) lost_energy: f64,
}

impl HitFindings {
    /// Of no hit yet.
    pub(super) fn new() -> Self {
        Self {
            walls: None,
            is_softened: false,
            worst: WorstHits::new(MAPPED),
            classes: BTreeMap::new(),
        }
    }

    /// Name of what a pellet met.
    pub(super) fn partner(&self, hit: &Hit) -> String {
        match hit.partner {
            HitPartner::Pellet { id, .. } => format!("pellet {id}"),
            HitPartner::Wall(wall) => self.wall(wall),
        }
    }

    fn wall(&self, wall: usize) -> String {
        let name = self.walls.as_ref().and_then(|walls| walls.get(wall));
        name.cloned().unwrap_or_else(|| format!("wall {wall}"))
    }

    fn name(&self, wall: Option<usize>) -> String {
        wall.map_or_else(|| "pellet on pellet".into(), |wall| self.wall(wall))
    }

    /// What each partner's hits came to, the hardest first.
    pub(super) fn by_partner(&self) -> Vec<PartnerRow> {
        let mut rows: BTreeMap<Option<usize>, PartnerRow> = BTreeMap::new();
        for (key, class) in &self.classes {
            let row = rows.entry(key.wall).or_insert_with(|| PartnerRow {
                name: self.name(key.wall),
                wall: key.wall,
                count: 0,
                force: 0.0,
                lost_energy: 0.0,
            });
            row.count += class.count;
            row.force = row.force.max(key.forces()[0]);
            row.lost_energy += class.lost_energy;
        }
        let mut rows: Vec<_> = rows.into_values().collect();
        rows.sort_by(|one, other| other.force.total_cmp(&one.force));
        rows
    }

    /// How many hits reached which force, as steps, beside named loads [N]; none where there are none.
    pub(super) fn histogram(&self, loads: Vec<(String, f64)>) -> Option<Chart> {
        let mut totals: BTreeMap<Option<usize>, u64> = BTreeMap::new();
        for (key, class) in &self.classes {
            *totals.entry(key.wall).or_default() += class.count;
        }
        let mut partners: Vec<_> = totals.into_iter().collect();
        partners.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
        let mut series: Vec<Series> = partners
            .iter()
            .take(LINES)
            .map(|&(wall, _)| self.steps(self.name(wall), |key| key.wall == wall))
            .collect();
        if partners.len() > LINES {
            let rest = &partners[LINES..];
            let others = self.steps("other walls".into(), |key| {
                rest.iter().any(|(wall, _)| *wall == key.wall)
            });
            series.push(others);
        }
        series.retain(|line| !line.points.is_empty());
        let most = series
            .iter()
            .flat_map(|line| &line.points)
            .fold(0.0_f64, |most, point| most.max(point[1]));
        if most == 0.0 {
            return None;
        }
        series.extend(loads.into_iter().map(|(label, load)| Series {
            label,
            points: vec![[load, 0.5], [load, most]],
            style: SeriesStyle::Dashed,
        }));
        Some(Chart {
            title: String::new(),
            x: Axis::logarithmic("greatest force of a hit [N]"),
            y: Axis::logarithmic("hits [-]"),
            series,
        })
    }

    /// The line of some classes; it falls to half a hit where there is none, as a logarithm has no zero.
    fn steps(&self, label: String, is_of: impl Fn(&HitClassKey) -> bool) -> Series {
        let mut counts: BTreeMap<i32, u64> = BTreeMap::new();
        for (key, class) in &self.classes {
            // Forces that no contact of a pellet makes are rounding.
            if is_of(key) && key.forces()[0] > LEAST_FORCE {
                *counts
                    .entry(key.force_class.div_euclid(JOINED_CLASSES))
                    .or_default() += class.count;
            }
        }
        let mut points = Vec::new();
        let (first, last) = (counts.keys().next(), counts.keys().next_back());
        if let (Some(&first), Some(&last)) = (first, last) {
            let edge = |joined: i32| {
                let key = HitClassKey {
                    wall: None,
                    force_class: joined * JOINED_CLASSES,
                };
                key.forces()[0]
            };
            points.push([edge(first), 0.5]);
            for joined in first..=last {
                let count = counts.get(&joined).copied().unwrap_or(0) as f64;
                points.push([edge(joined), count.max(0.5)]);
                points.push([edge(joined + 1), count.max(0.5)]);
            }
            points.push([edge(last + 1), 0.5]);
        }
        Series {
            label,
            points,
            style: SeriesStyle::Line,
        }
    }
}

/// Hits below this force are not drawn [N]: grazes that bend nothing.
const LEAST_FORCE: f64 = 1.0e-3;
