//! Contacts side by side: each quantity an array, so that one instruction works on several contacts.
//!
//! A batch is filled from pellet rows or contact by contact, worked out by
//! [`ContactLaws::forces`](super::ContactLaws::forces) with the very functions that serve a single contact, and read
//! back; neither way differs from the other in any bit.

mod meeting;
mod totals;

pub use meeting::SpherePair;
pub use totals::Totals;

use super::{Contact, ContactForce, ContactHistory, ContactLaws};
use crate::{MaterialPair, Vec3};

/// Contacts in a batch [-]: what a law reads and writes of them fills half a level-1 cache.
pub const LANES: usize = 32;
/// Lanes are worked out by so many at a time [-]: the widest instructions take as many.
const BLOCK: usize = 8;

/// One quantity of all contacts.
pub(super) type Lanes = [f64; LANES];
type Lanes3 = [Lanes; 3];
/// Three components and a companion.
pub type Row = [f64; 4];
type Lanes4 = [Lanes; 4];

/// Contacts, and what they do.
#[derive(Debug, Clone)]
pub struct Batch {
    between: Lanes3,
    radii: [Lanes; 2],
    velocity: Lanes3,
    spins: [Lanes3; 2],
    /// 1 where a contact is counted, or 0.
    counted: Lanes,

    normal: Lanes3,
    overlap: Lanes,
    relative_velocity: Lanes3,
    relative_spin: Lanes3,
    effective_radius: Lanes,
    effective_mass: Lanes,
    inverse_mass: Lanes,
    arms: [Lanes; 2],
    pair: [Lanes; 11],
    /// Tangential stretch and last normal force.
    memory: Lanes4,
    /// Samples since first touch.
    samples: Lanes,
    /// What else the laws remember.
    pub(super) extra: Vec<Lanes>,

    /// The same, one step on.
    reached: Lanes4,
    pub(super) next_extra: Vec<Lanes>,
    is_edge: Lanes,
    /// Force on the first body and normal force.
    force: Lanes4,
    torques: [Lanes3; 2],
    /// Elastic energy, dissipation, shear energy, shear power and the size of the tangential force.
    scalar: [Lanes; 5],
}

impl Batch {
    /// Lanes that touch, lightly and at rest, so that those never set hold numbers; ready for some laws.
    pub fn new(laws: ContactLaws) -> Self {
        let extra = vec![[0.0; LANES]; laws.extra_numbers()];
        let zeros = [0.0; LANES];
        let ones = [1.0; LANES];
        Self {
            between: [[1.5; LANES], zeros, zeros],
            radii: [ones; 2],
            velocity: [zeros; 3],
            spins: [[zeros; 3]; 2],
            counted: zeros,
            normal: [ones, zeros, zeros],
            overlap: ones,
            relative_velocity: [zeros; 3],
            relative_spin: [zeros; 3],
            effective_radius: ones,
            effective_mass: ones,
            inverse_mass: ones,
            arms: [ones; 2],
            pair: [ones; 11],
            memory: [zeros; 4],
            samples: zeros,
            next_extra: extra.clone(),
            extra,
            reached: [zeros; 4],
            is_edge: zeros,
            force: [zeros; 4],
            torques: [[zeros; 3]; 2],
            scalar: [zeros; 5],
        }
    }
}

/// Lanes to work on for a number of contacts [-]: whole blocks, so that no lane is left over for single instructions.
#[inline(always)]
pub(super) fn whole_blocks(count: usize) -> usize {
    (count.min(LANES) + (BLOCK - 1)) & !(BLOCK - 1)
}

impl Batch {
    /// Puts the contact of a sphere of a radius [m] into a lane; its arm reaches from the center to the contact [m].
    ///
    /// Nothing is known of the other body but what the contact says: no torque on it is worked out.
    #[inline]
    pub fn set_contact(&mut self, lane: usize, contact: &Contact, radius: f64, arm: f64) {
        self.radii[0][lane] = radius;
        self.radii[1][lane] = f64::INFINITY;
        for axis in 0..3 {
            self.normal[axis][lane] = contact.normal[axis];
            self.relative_velocity[axis][lane] = contact.relative_velocity[axis];
            self.relative_spin[axis][lane] = contact.relative_spin[axis];
        }
        self.overlap[lane] = contact.overlap;
        self.effective_radius[lane] = contact.effective_radius;
        self.effective_mass[lane] = contact.effective_mass;
        self.inverse_mass[lane] = contact.inverse_mass;
        self.arms[0][lane] = arm;
        self.arms[1][lane] = 0.0;
        self.counted[lane] = 1.0;
    }

    /// Puts what the contact in a lane remembers into it: its stretch, its last normal force [N] and the samples since first
    /// touch; `extra` is what its laws need beside the other two.
    #[inline(always)]
    pub fn set_history(
        &mut self,
        lane: usize,
        stretch: [f64; 3],
        [normal_force, samples]: [f64; 2],
        extra: &[f64],
    ) {
        for (lanes, value) in self.memory.iter_mut().zip(stretch) {
            lanes[lane] = value;
        }
        self.memory[3][lane] = normal_force;
        self.samples[lane] = samples;
        for (lanes, number) in self.extra.iter_mut().zip(extra) {
            lanes[lane] = *number;
        }
    }

    /// Sets the effective values of the two materials in a lane.
    #[inline]
    pub fn set_pair(&mut self, lane: usize, pair: &MaterialPair) {
        let values = [
            pair.effective_youngs_modulus,
            pair.effective_shear_modulus,
            pair.damping_ratio,
            pair.tangential_damping_share,
            pair.friction,
            pair.rolling_friction,
            pair.linear_stiffness,
            pair.rolling_damping,
            pair.series_shear_modulus,
            pair.yield_pressure,
            pair.surface_energy,
        ];
        for (lanes, value) in self.pair.iter_mut().zip(values) {
            lanes[lane] = value;
        }
    }

    /// The effective values of the two materials in a lane.
    #[inline(always)]
    pub fn pair(&self, lane: usize) -> MaterialPair {
        MaterialPair {
            effective_youngs_modulus: self.pair[0][lane],
            effective_shear_modulus: self.pair[1][lane],
            damping_ratio: self.pair[2][lane],
            tangential_damping_share: self.pair[3][lane],
            friction: self.pair[4][lane],
            rolling_friction: self.pair[5][lane],
            linear_stiffness: self.pair[6][lane],
            rolling_damping: self.pair[7][lane],
            series_shear_modulus: self.pair[8][lane],
            yield_pressure: self.pair[9][lane],
            surface_energy: self.pair[10][lane],
        }
    }

    /// The contact in a lane.
    #[inline(always)]
    pub fn contact(&self, lane: usize) -> Contact {
        Contact {
            normal: vector(&self.normal, lane),
            overlap: self.overlap[lane],
            relative_velocity: vector(&self.relative_velocity, lane),
            relative_spin: vector(&self.relative_spin, lane),
            effective_radius: self.effective_radius[lane],
            effective_mass: self.effective_mass[lane],
            inverse_mass: self.inverse_mass[lane],
        }
    }

    /// What the contact in a lane remembered when it was set.
    pub fn history(&self, lane: usize, laws: ContactLaws) -> ContactHistory {
        let extra: Vec<f64> = self.extra.iter().map(|lanes| lanes[lane]).collect();
        let mut history = self.basic_history(lane);
        laws.unpack(&extra, &mut history);
        history
    }

    /// The same without what only some laws need.
    #[inline(always)]
    pub(super) fn basic_history(&self, lane: usize) -> ContactHistory {
        let stretch = [
            self.memory[0][lane],
            self.memory[1][lane],
            self.memory[2][lane],
        ];
        ContactHistory {
            tangential_stretch: Vec3::from(stretch),
            normal_force: self.memory[3][lane],
            samples: self.samples[lane],
            ..ContactHistory::default()
        }
    }

    /// Stretch and normal force that the contact in a lane remembers from now on; one that is over has no force.
    #[inline(always)]
    pub fn next_memory(&self, lane: usize) -> Row {
        row(&self.reached, lane)
    }

    /// Writes what else the contact in a lane remembers from now on.
    #[inline(always)]
    pub fn next_extra(&self, lane: usize, into: &mut [f64]) {
        for (number, lanes) in into.iter_mut().zip(&self.next_extra) {
            *number = lanes[lane];
        }
    }

    /// Whether some contact of the first `count` begins or ends near this sample.
    #[inline(always)]
    pub(super) fn has_edge(&self, count: usize) -> bool {
        let edges = self.is_edge[..whole_blocks(count)].iter();
        edges.fold(0.0, |sum, edge| sum + edge) > 0.0
    }

    /// Whether the contact in a lane begins or ends near this sample.
    #[inline(always)]
    pub(super) fn is_edge(&self, lane: usize) -> bool {
        self.is_edge[lane] > 0.0
    }

    /// Notes whether the contact in a lane begins or ends near this sample.
    #[inline(always)]
    pub(super) fn set_edge(&mut self, lane: usize, is_edge: bool) {
        self.is_edge[lane] = if is_edge { 1.0 } else { 0.0 };
    }

    /// Puts what a contact does, and what it remembers from now on, into its lane.
    #[inline(always)]
    pub(super) fn set_force(
        &mut self,
        lane: usize,
        contact: &Contact,
        force: &ContactForce,
        history: &ContactHistory,
    ) {
        let stretch = history.tangential_stretch;
        for axis in 0..3 {
            self.reached[axis][lane] = stretch[axis];
            self.force[axis][lane] = force.force[axis];
        }
        self.reached[3][lane] = history.normal_force;
        self.force[3][lane] = force.normal;
        let twist = contact.normal.cross(&force.force);
        let turning = force.turning_torque;
        let torque = turning - self.arms[0][lane] * twist;
        set_vector(&mut self.torques[0], lane, torque);
        let torque = -turning - self.arms[1][lane] * twist;
        set_vector(&mut self.torques[1], lane, torque);
        self.scalar[0][lane] = force.elastic_energy;
        self.scalar[1][lane] = force.dissipation;
        self.scalar[2][lane] = force.shear_energy;
        self.scalar[3][lane] = force.shear_power;
        self.scalar[4][lane] = force.tangential;
    }

    /// Force on the first body in a lane, and the normal force [N]; the second body receives the negative.
    #[inline(always)]
    pub fn force(&self, lane: usize) -> Row {
        row(&self.force, lane)
    }

    /// Torques on both bodies in a lane [N·m].
    #[inline(always)]
    pub fn torques(&self, lane: usize) -> [Vec3; 2] {
        [
            vector(&self.torques[0], lane),
            vector(&self.torques[1], lane),
        ]
    }

    /// Normal force in a lane [N].
    #[inline]
    pub fn normal_force(&self, lane: usize) -> f64 {
        self.force[3][lane]
    }

    /// Normal and tangential force that stand for the step [N], and the power that the contact takes from motion beside
    /// what its normal spring stores [W].
    #[inline(always)]
    pub fn exertion(&self, lane: usize) -> [f64; 3] {
        let power = self.scalar[1][lane] + self.scalar[3][lane];
        [self.reached[3][lane], self.scalar[4][lane], power]
    }

    /// Normal [-] and effective radius [m] of the contact in a lane.
    #[inline(always)]
    pub fn lie(&self, lane: usize) -> (Vec3, f64) {
        (vector(&self.normal, lane), self.effective_radius[lane])
    }

    /// Energy stored in the normal spring in a lane [J].
    #[inline]
    pub fn elastic_energy(&self, lane: usize) -> f64 {
        self.scalar[0][lane]
    }

    /// Distance from the center of the first body in a lane to the contact [m].
    #[inline]
    pub fn arm(&self, lane: usize) -> f64 {
        self.arms[0][lane]
    }

    /// Overlap in a lane [m].
    #[inline]
    pub fn overlap(&self, lane: usize) -> f64 {
        self.overlap[lane]
    }

    /// What the contact in a lane does.
    ///
    /// The torque against turning is what is left of the torque without the moment of the force, rounding and all.
    pub fn contact_force(&self, lane: usize) -> ContactForce {
        let [x, y, z, normal] = row(&self.force, lane);
        let force = Vec3::new(x, y, z);
        let moment = -self.arms[0][lane] * vector(&self.normal, lane).cross(&force);
        ContactForce {
            normal,
            force,
            tangential: self.scalar[4][lane],
            turning_torque: vector(&self.torques[0], lane) - moment,
            elastic_energy: self.scalar[0][lane],
            dissipation: self.scalar[1][lane],
            shear_energy: self.scalar[2][lane],
            shear_power: self.scalar[3][lane],
        }
    }
}

#[inline(always)]
fn vector(lanes: &Lanes3, lane: usize) -> Vec3 {
    Vec3::new(lanes[0][lane], lanes[1][lane], lanes[2][lane])
}

#[inline(always)]
fn set_vector(lanes: &mut Lanes3, lane: usize, vector: Vec3) {
    for axis in 0..3 {
        lanes[axis][lane] = vector[axis];
    }
}

#[inline(always)]
fn row(lanes: &Lanes4, lane: usize) -> Row {
    [
        lanes[0][lane],
        lanes[1][lane],
        lanes[2][lane],
        lanes[3][lane],
    ]
}

#[cfg(test)]
mod tests;
