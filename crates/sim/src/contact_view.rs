//! Contacts as a step found them, for those who look.

use crate::state::{Row, vector};
use crate::tally::Partner;
use pelletflow_core::Vec3;
use std::cmp::Ordering;

/// A contact of a pellet, as the last step found it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactView {
    /// Permanent number of the pellet [-]; of two that touch the smaller one.
    pub pellet: u32,
    /// Radius of the pellet [m].
    pub radius: f64,
    /// What it touches.
    pub partner: ContactPartner,
    /// Where they touch, halfway through the overlap as seen from the pellet, in the world; across a periodic border
    /// beside the pellet [m].
    pub point: Vec3,
    /// Force of the contact on the pellet, friction and all, in the world [N].
    pub force: Vec3,
    /// Its part along the normal [N].
    pub normal_force: f64,
    /// How far the two undeformed surfaces overlap; less than 0 where adhesion holds them across a gap [m].
    pub overlap: f64,
}

/// What a pellet touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ContactPartner {
    /// Another pellet, by its permanent number [-].
    Pellet(u32),
    /// A wall, by index in the setup.
    Wall(usize),
}

impl ContactView {
    /// Orders contacts by pellet and partner; where these are the same, by place.
    pub fn by_number(&self, other: &Self) -> Ordering {
        let along = |axis: usize| self.point[axis].total_cmp(&other.point[axis]);
        (self.pellet, self.partner)
            .cmp(&(other.pellet, other.partner))
            .then_with(|| along(0))
            .then_with(|| along(1))
            .then_with(|| along(2))
    }
}

/// A contact that a step has worked out, with rows of the pellets as they were then.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeptContact {
    /// Index of the first pellet [-].
    pub(crate) pellet: usize,
    pub(crate) partner: Partner,
    /// Center and radius of each pellet; of a wall nothing [m].
    pub(crate) ends: [Row; 2],
    /// From the partner toward the pellet [-].
    pub(crate) normal: Vec3,
    pub(crate) overlap: f64,
    /// Force on the pellet, and its part along the normal [N].
    pub(crate) force: Row,
}

impl KeptContact {
    /// The contact by permanent numbers, the same whichever of two pellets is stored first.
    pub(crate) fn view(&self, ids: &[u32]) -> ContactView {
        let [first, second] = &self.ends;
        let pellet = ids[self.pellet];
        match self.partner {
            Partner::Wall(wall) => self.seen_from(pellet, first, ContactPartner::Wall(wall), 1.0),
            Partner::Pellet(other) if ids[other] < pellet => {
                self.seen_from(ids[other], second, ContactPartner::Pellet(pellet), -1.0)
            }
            Partner::Pellet(other) => {
                self.seen_from(pellet, first, ContactPartner::Pellet(ids[other]), 1.0)
            }
        }
    }

    /// `side` is 1 seen from the first body and -1 from the second [-].
    fn seen_from(&self, pellet: u32, end: &Row, partner: ContactPartner, side: f64) -> ContactView {
        let radius = end[3];
        ContactView {
            pellet,
            radius,
            partner,
            point: vector(end) - (radius - 0.5 * self.overlap) * side * self.normal,
            // Nothing is nothing from either side, and has no sign.
            force: (side * vector(&self.force)).add_scalar(0.0),
            normal_force: self.force[3],
            overlap: self.overlap,
        }
    }
}
