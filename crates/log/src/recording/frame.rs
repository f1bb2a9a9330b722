//! Where everything is at one moment, copied so that the run can go on while it is written.

use pelletflow_core::{Pose, Vec3};
use pelletflow_sim::{ContactView, EnergyLedger, MassLedger, Simulation};

/// What is drawn of a pellet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DrawnPellet {
    /// Permanent number [-].
    pub(crate) id: u32,
    /// Center, in the world [m].
    pub(crate) position: Vec3,
    /// Radius [m].
    pub(crate) radius: f64,
    /// Speed [m/s].
    pub(crate) speed: f64,
    /// Greatest normal force of its contacts in the last step [N].
    pub(crate) force: f64,
}

/// What is drawn in every frame; filled anew, it keeps its memory.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Frame {
    /// Simulated time [s].
    pub(crate) time: f64,
    /// Pellets, in the order in which they are stored.
    pub(crate) pellets: Vec<DrawnPellet>,
    /// Contacts, in the order in which they are stored.
    pub(crate) contacts: Vec<ContactView>,
    /// Whether contacts are known.
    pub(crate) has_contacts: bool,
    /// Where each wall is, in the order of the setup.
    pub(crate) poses: Vec<Pose>,
    pub(crate) mass: MassLedger,
    pub(crate) energy: EnergyLedger,
}

impl Frame {
    /// Takes the place of what was here before.
    pub(crate) fn fill(&mut self, simulation: &Simulation) {
        self.time = simulation.time();
        self.pellets.clear();
        let pellets = simulation.pellets().map(|pellet| DrawnPellet {
            id: pellet.id,
            position: pellet.position,
            radius: pellet.radius,
            speed: pellet.velocity.norm(),
            force: pellet.max_normal_force,
        });
        self.pellets.extend(pellets);
        self.contacts.clear();
        let contacts = simulation.contacts();
        self.has_contacts = contacts.is_some();
        self.contacts.extend(contacts.into_iter().flatten());
        self.poses.clear();
        self.poses.extend(simulation.walls().map(|wall| wall.pose));
        self.mass = simulation.mass_ledger();
        self.energy = simulation.energy_ledger();
    }

    /// Sorts pellets and contacts by their numbers.
    pub(crate) fn sort(&mut self) {
        self.pellets.sort_unstable_by_key(|pellet| pellet.id);
        self.contacts.sort_unstable_by(ContactView::by_number);
    }
}
