//! What makes a fill or an inlet impossible.

use super::{Mistakes, is_finite};
use crate::inlet;
use crate::random::{Draw, Purpose};
use crate::setup::{FillAmount, Inlet, Outlet, Rate, Seats, Setup};
use pelletflow_core::Bounds;

/// Tonnes per hour in a kilogram per second.
const TONNES_PER_HOUR: f64 = 3.6;

/// Places of an inlet's region that are looked at for room [-].
const PLACES: u32 = 4000;

impl Mistakes {
    /// An outlet that no pellet can reach.
    pub(super) fn outlet(&mut self, setup: &Setup, outlet: &Outlet) {
        let key = format!("outlets.{}.region", outlet.name);
        if let Err(error) = outlet.region.validate() {
            self.add(key, error.to_string());
            return;
        }
        let (region, domain) = (outlet.region.bounds(), setup.domain.bounds);
        let apart = (0..3).find(|&axis| {
            region.min[axis] >= domain.max[axis] || region.max[axis] <= domain.min[axis]
        });
        if let Some(axis) = apart {
            self.add(
                key,
                format!(
                    "the outlet lies outside of the domain, which goes from {} m to {} m along {}: pellets are lost before they \
                     reach it; widen `domain` or move the outlet",
                    domain.min[axis],
                    domain.max[axis],
                    ["x", "y", "z"][axis]
                ),
            );
        }
    }

    pub(super) fn fills(&mut self, setup: &Setup) {
        for fill in &setup.fills {
            let key = |field: &str| format!("fill.{}.{field}", fill.name);
            match &fill.seats {
                Seats::Lattice { region, amount } | Seats::Deposit { region, amount } => {
                    if let Err(error) = region.validate() {
                        self.add(key("region"), error.to_string());
                    } else if !region.bounds().is_finite() {
                        self.add(key("region"), "is not bounded on every side; expected a closed shape such as a box or a cylinder");
                    }
                    if let (Some(message), true) = (
                        outside(setup, &region.bounds()),
                        region.bounds().is_finite(),
                    ) {
                        self.add(key("region"), message);
                    }
                    if let FillAmount::Mass(mass) = *amount {
                        self.expect(
                            mass.is_finite() && mass > 0.0,
                            key("mass"),
                            mass,
                            "kg",
                            "more than 0",
                        );
                    }
                }
                Seats::Points(points) => {
                    if !points.iter().copied().all(is_finite) {
                        self.add(
                            key("at"),
                            "holds a number that is not finite; expected centers in m",
                        );
                    } else if let Some(message) = outside(setup, &fill.bounds()) {
                        self.add(key("at"), message);
                    }
                }
            }
            if !(is_finite(fill.velocity) && is_finite(fill.spin)) {
                self.add(
                    key("velocity"),
                    "or `spin` is not finite; expected three numbers in m/s and in rad/s",
                );
            }
        }
    }

    pub(super) fn inlet(&mut self, setup: &Setup, inlet: &Inlet) {
        let key = |field: &str| format!("inlets.{}.{field}", inlet.name);
        let (rate, unit) = match inlet.rate {
            Rate::Mass(rate) => (rate, "kg/s"),
            Rate::Count(rate) => (rate, "1/s"),
        };
        if !(rate.is_finite() && rate > 0.0) {
            self.expect(false, key("rate"), rate, unit, "more than 0");
            return;
        }
        if let Err(error) = inlet.region.validate() {
            self.add(key("region"), error.to_string());
            return;
        }
        if !inlet.region.bounds().is_finite() {
            self.add(
                key("region"),
                "is not bounded on every side; expected a closed shape such as a box",
            );
            return;
        }
        if !(inlet.start >= 0.0 && inlet.end > inlet.start) {
            let (start, end) = (inlet.start, inlet.end);
            self.add(key("end"), format!("feeding runs from {start} s to {end} s; expected the start at 0 s or later and the end after it"));
        }
        if let Some(message) = outside(setup, &inlet.region.bounds()) {
            self.add(key("region"), message);
            return;
        }
        let kind = &setup.pellets[inlet.pellets];
        let largest = kind.size.max_diameter();
        let size = inlet.region.bounds().max - inlet.region.bounds().min;
        if size.min() < largest {
            self.add(
                key("region"),
                format!(
                    "is {:.4} m at its narrowest; expected at least one pellet, {largest} m",
                    size.min()
                ),
            );
            return;
        }
        let room = Room::of(setup, inlet, largest / 2.0);
        if let Some(message) = room.mistake(setup, largest) {
            self.add(key("region"), message);
            return;
        }
        let density = setup.materials[kind.material].material.density;
        let capacity = inlet::capacity(inlet, setup.gravity, density, room.free_share);
        let asked = match inlet.rate {
            Rate::Mass(rate) => rate,
            Rate::Count(rate) => rate * setup.mass(inlet.pellets, largest / 2.0),
        };
        if asked > capacity {
            self.add(
                key("rate"),
                format!(
                    "asks for {:.4} t/h ({asked:.4} kg/s), but pellets leave the region no faster than {:.4} t/h ({capacity:.4} kg/s); \
                     widen the region, raise the velocity or lower the rate",
                    asked * TONNES_PER_HOUR,
                    capacity * TONNES_PER_HOUR
                ),
            );
        }
    }
}

/// What is wrong with a box in which pellets appear that reaches out of the domain.
fn outside(setup: &Setup, bounds: &Bounds) -> Option<String> {
    let domain = setup.domain.bounds;
    // Beyond a periodic side pellets come in at the opposite one.
    let mut closed = (0..3).filter(|&axis| !setup.domain.is_periodic[axis]);
    closed.find_map(|axis| {
        let place = if bounds.min[axis] < domain.min[axis] {
            bounds.min[axis]
        } else if bounds.max[axis] > domain.max[axis] {
            bounds.max[axis]
        } else {
            return None;
        };
        let name = ["x", "y", "z"][axis];
        // To a nanometer: what rounding adds tells nothing.
        let place = (place * 1.0e9).round() / 1.0e9;
        Some(format!(
            "reaches to {name} = {place} m, outside of the domain, which goes from {} m to {} m along {name}: pellets there are \
             lost; widen `domain` or move them",
            domain.min[axis], domain.max[axis]
        ))
    })
}

/// How much of an inlet's region is free when it starts.
struct Room {
    /// Share of the region's box that is in the region and in no wall [-].
    free_share: f64,
    /// Whether the region has a place for the largest pellet, walls or not.
    has_place: bool,
    /// Places for the largest pellet that a wall takes, by wall; none if one is free.
    taken: Option<Vec<u32>>,
}

impl Room {
    /// Looks at random places; `radius` is that of the largest pellet [m].
    fn of(setup: &Setup, inlet: &Inlet, radius: f64) -> Self {
        let bounds = inlet.region.bounds();
        let walls: Vec<_> = setup
            .walls
            .iter()
            .map(|wall| (wall, wall.at(inlet.start)))
            .collect();
        let mut draw = Draw::new(setup.seed, Purpose::InletRoom, 0);
        let mut free = 0;
        let (mut has_place, mut has_free_place) = (false, false);
        let mut taken = vec![0; walls.len()];
        for _ in 0..PLACES {
            let center = draw.point(&bounds);
            let place = draw.point(&bounds.grown(-radius));
            let distances = |point| {
                walls.iter().map(move |(wall, now)| {
                    if now.is_present {
                        wall.shape.distance(now.pose.inverse_point(point))
                    } else {
                        f64::INFINITY
                    }
                })
            };
            let is_free =
                inlet.region.distance(center) <= 0.0 && distances(center).all(|d| d > 0.0);
            free += u32::from(is_free);
            if inlet.region.distance(place) <= -radius {
                has_place = true;
                has_free_place |= distances(place).all(|distance| distance > radius);
                for (count, distance) in taken.iter_mut().zip(distances(place)) {
                    *count += u32::from(distance <= radius);
                }
            }
        }
        Self {
            free_share: f64::from(free) / f64::from(PLACES),
            has_place,
            taken: (!has_free_place).then_some(taken),
        }
    }

    fn mistake(&self, setup: &Setup, largest: f64) -> Option<String> {
        if !self.has_place {
            return Some(format!(
                "the region has no place for the largest pellet, of {largest} m; widen it"
            ));
        }
        let most = self.taken.as_ref()?.iter().zip(&setup.walls);
        let (_, wall) = most.max_by_key(|(count, _)| **count)?;
        Some(format!(
            "the region has no free place for the largest pellet, of {largest} m: wall `{}` takes it up; move the region or the \
             wall",
            wall.name
        ))
    }
}
