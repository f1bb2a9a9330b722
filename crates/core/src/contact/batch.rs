//! Contacts side by side: each quantity an array, so that one instruction works on several contacts.
//!
//! A batch is filled from pellet rows, worked out by [`ContactLaws::forces`](super::ContactLaws::forces) with the very
//! functions that serve a single contact, and read back; neither way differs from the other in any bit.

use super::{Contact, ContactForce, ContactHistory};
use crate::{MaterialPair, Vec3};

/// Contacts in a batch [-]: its arrays fill a third of a level-1 cache.
pub const LANES: usize = 32;

type Lanes = [f64; LANES];
type Lanes3 = [Lanes; 3];

/// One sphere of a contact, as the batch needs it.
#[derive(Debug, Clone, Copy)]
pub struct Sphere {
    /// Center [m].
    pub center: Vec3,
    /// Radius [m].
    pub radius: f64,
    /// Velocity [m/s].
    pub velocity: Vec3,
    /// Spin [rad/s].
    pub spin: Vec3,
    /// Inverse mass [1/kg].
    pub inverse_mass: f64,
}

/// Contacts of spheres, and what they do.
#[derive(Debug, Clone)]
pub struct Batch {
    between: Lanes3,
    radius: [Lanes; 2],
    velocity: Lanes3,
    spin: [Lanes3; 2],
    inverse_mass: Lanes,
    pair: [Lanes; 7],
    stretch: Lanes3,
    last_force: Lanes,
    reached: Lanes3,
    next_force: Lanes,
    is_edge: Lanes,
    overlap: Lanes,
    force: Lanes3,
    twist: Lanes3,
    turning_torque: Lanes3,
    scalar: [Lanes; 5],
}

impl Default for Batch {
    fn default() -> Self {
        let lanes = [0.0; LANES];
        let lanes3 = [lanes; 3];
        Self {
            between: lanes3,
            radius: [lanes; 2],
            velocity: lanes3,
            spin: [lanes3; 2],
            inverse_mass: lanes,
            pair: [lanes; 7],
            stretch: lanes3,
            last_force: lanes,
            reached: lanes3,
            next_force: lanes,
            is_edge: lanes,
            overlap: lanes,
            force: lanes3,
            twist: lanes3,
            turning_torque: lanes3,
            scalar: [lanes; 5],
        }
    }
}

impl Batch {
    /// Puts the contact of two spheres into a lane.
    #[inline]
    pub fn set(&mut self, lane: usize, a: &Sphere, b: &Sphere, history: &ContactHistory) {
        for axis in 0..3 {
            self.between[axis][lane] = a.center[axis] - b.center[axis];
            self.velocity[axis][lane] = a.velocity[axis] - b.velocity[axis];
            self.spin[0][axis][lane] = a.spin[axis];
            self.spin[1][axis][lane] = b.spin[axis];
            self.stretch[axis][lane] = history.tangential_stretch[axis];
        }
        self.last_force[lane] = history.normal_force;
        self.radius[0][lane] = a.radius;
        self.radius[1][lane] = b.radius;
        self.inverse_mass[lane] = a.inverse_mass + b.inverse_mass;
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
        ];
        for (lanes, value) in self.pair.iter_mut().zip(values) {
            lanes[lane] = value;
        }
    }

    /// The effective values of the two materials in a lane.
    #[inline]
    pub fn pair(&self, lane: usize) -> MaterialPair {
        MaterialPair {
            effective_youngs_modulus: self.pair[0][lane],
            effective_shear_modulus: self.pair[1][lane],
            damping_ratio: self.pair[2][lane],
            tangential_damping_share: self.pair[3][lane],
            friction: self.pair[4][lane],
            rolling_friction: self.pair[5][lane],
            linear_stiffness: self.pair[6][lane],
            ..MaterialPair::UNSET
        }
    }

    /// The contact in a lane.
    #[inline(always)]
    pub fn contact(&self, lane: usize) -> Contact {
        let between = vector(&self.between, lane);
        let radii = [self.radius[0][lane], self.radius[1][lane]];
        let distance = between.norm_squared().sqrt();
        let normal = between * (1.0 / distance);
        let radii_sum = radii[0] + radii[1];
        let overlap = radii_sum - distance;
        let arms = [radii[0] - 0.5 * overlap, radii[1] - 0.5 * overlap];
        let spins = [vector(&self.spin[0], lane), vector(&self.spin[1], lane)];
        let surface_spin = arms[0] * spins[0] + arms[1] * spins[1];
        Contact {
            normal,
            overlap,
            relative_velocity: vector(&self.velocity, lane) - surface_spin.cross(&normal),
            relative_spin: spins[0] - spins[1],
            effective_radius: radii[0] * radii[1] / radii_sum,
            effective_mass: 1.0 / self.inverse_mass[lane],
        }
    }

    /// What the contact in a lane remembered when it was set.
    #[inline]
    pub fn history(&self, lane: usize) -> ContactHistory {
        ContactHistory {
            tangential_stretch: vector(&self.stretch, lane),
            normal_force: self.last_force[lane],
            ..ContactHistory::default()
        }
    }

    /// What the contact in a lane remembers from now on.
    #[inline]
    pub fn next_history(&self, lane: usize) -> ContactHistory {
        ContactHistory {
            tangential_stretch: vector(&self.reached, lane),
            normal_force: self.next_force[lane],
            ..ContactHistory::default()
        }
    }

    /// Whether the contact in a lane begins or ends near this sample.
    #[inline]
    pub(super) fn is_edge(&self, lane: usize) -> bool {
        self.is_edge[lane] > 0.0
    }

    /// Notes whether the contact in a lane begins or ends near this sample.
    #[inline]
    pub(super) fn set_edge(&mut self, lane: usize, is_edge: bool) {
        self.is_edge[lane] = if is_edge { 1.0 } else { 0.0 };
    }

    /// Puts what a contact does, and what it remembers from now on, into its lane.
    #[inline(always)]
    pub fn set_force(
        &mut self,
        lane: usize,
        contact: &Contact,
        force: &ContactForce,
        history: &ContactHistory,
    ) {
        self.next_force[lane] = history.normal_force;
        self.overlap[lane] = contact.overlap;
        set_vector(&mut self.force, lane, force.force);
        set_vector(&mut self.twist, lane, contact.normal.cross(&force.force));
        set_vector(&mut self.turning_torque, lane, force.turning_torque);
        set_vector(&mut self.reached, lane, history.tangential_stretch);
        self.scalar[0][lane] = force.normal;
        self.scalar[1][lane] = force.elastic_energy;
        self.scalar[2][lane] = force.dissipation;
        self.scalar[3][lane] = force.shear_energy;
        self.scalar[4][lane] = force.shear_power;
    }

    /// What the contact in a lane does.
    #[inline]
    pub fn force(&self, lane: usize) -> ContactForce {
        ContactForce {
            normal: self.scalar[0][lane],
            force: vector(&self.force, lane),
            turning_torque: vector(&self.turning_torque, lane),
            elastic_energy: self.scalar[1][lane],
            dissipation: self.scalar[2][lane],
            shear_energy: self.scalar[3][lane],
            shear_power: self.scalar[4][lane],
        }
    }

    /// Normal times force in a lane: the torque on each body is its arm times the negative of this [N].
    #[inline]
    pub fn twist(&self, lane: usize) -> Vec3 {
        vector(&self.twist, lane)
    }

    /// Distances from the centers of both spheres in a lane to the middle of their contact [m].
    #[inline]
    pub fn arms(&self, lane: usize) -> [f64; 2] {
        let half_overlap = 0.5 * self.overlap[lane];
        [
            self.radius[0][lane] - half_overlap,
            self.radius[1][lane] - half_overlap,
        ]
    }

    /// Overlap in a lane [m].
    #[inline]
    pub fn overlap(&self, lane: usize) -> f64 {
        self.overlap[lane]
    }
}

#[inline]
fn vector(lanes: &Lanes3, lane: usize) -> Vec3 {
    Vec3::new(lanes[0][lane], lanes[1][lane], lanes[2][lane])
}

#[inline]
fn set_vector(lanes: &mut Lanes3, lane: usize, vector: Vec3) {
    for axis in 0..3 {
        lanes[axis][lane] = vector[axis];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactLaws, NormalLaw, Sampling, TangentialLaw, TurningLaw};
    use crate::{Material, PairProperties};

    /// A sphere near the origin that differs from all others.
    fn sphere(number: usize, center: Vec3) -> Sphere {
        let phase = number as f64;
        Sphere {
            center,
            radius: 7.5e-3 * (1.0 + 0.1 * phase.sin()),
            velocity: Vec3::new(phase.cos(), (1.3 * phase).sin(), (0.7 * phase).cos()),
            spin: 30.0 * Vec3::new((2.1 * phase).sin(), phase.cos(), 0.3),
            inverse_mass: 150.0 * (1.0 + 0.2 * phase.cos()),
        }
    }

    /// Every composition that may have a batch.
    fn compositions() -> Vec<ContactLaws> {
        let mut all = Vec::new();
        for normal in [NormalLaw::Hertz, NormalLaw::Linear] {
            for tangential in [
                TangentialLaw::None,
                TangentialLaw::Coulomb,
                TangentialLaw::Mindlin,
            ] {
                for rolling in [TurningLaw::None, TurningLaw::ConstantTorque] {
                    all.push(ContactLaws {
                        normal,
                        tangential,
                        rolling,
                        twisting: TurningLaw::None,
                    });
                }
            }
        }
        all
    }

    #[test]
    fn a_batch_has_the_bits_of_its_contacts_one_by_one() {
        let ore = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
        let properties = PairProperties {
            restitution: 0.5,
            friction: 0.4,
            rolling_friction: 0.05,
            stiffness: Some(1.0e5),
            ..PairProperties::ELASTIC
        };
        let pair = MaterialPair::new(&ore, &ore, &properties);
        for laws in compositions() {
            for sampling in [Sampling::plain(2.0e-5), Sampling::located(2.0e-5)] {
                let mut batch = Batch::default();
                for lane in 0..LANES {
                    let a = sphere(lane, Vec3::zeros());
                    let mut b = sphere(lane + 100, Vec3::zeros());
                    // Some lanes at their first sample, some near their last, most in the middle.
                    let depth = [1.0e-6, 1.0e-5, 1.0e-4, 4.0e-4][lane % 4];
                    b.center = Vec3::new(0.6, 0.0, 0.8) * (a.radius + b.radius - depth);
                    let history = ContactHistory {
                        tangential_stretch: Vec3::new(8.0e-4, 3.0e-4, -6.0e-4),
                        normal_force: if lane % 3 == 0 { 0.0 } else { 2.0 },
                        ..ContactHistory::default()
                    };
                    batch.set(lane, &a, &b, &history);
                    batch.set_pair(lane, &pair);
                }
                assert!(laws.forces(&mut batch, LANES, &sampling), "{laws:?}");
                for lane in 0..LANES {
                    let mut history = batch.history(lane);
                    let force = laws.force(&batch.contact(lane), &pair, &mut history, &sampling);
                    assert_eq!(
                        batch.force(lane),
                        force,
                        "lane {lane}, {laws:?}, {sampling:?}"
                    );
                    let next = batch.next_history(lane);
                    assert_eq!(next.tangential_stretch, history.tangential_stretch);
                    assert_eq!(next.normal_force, history.normal_force);
                }
            }
        }
    }
}
