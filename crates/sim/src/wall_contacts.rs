//! Contacts between pellets and walls.

use crate::forces::ForceChunk;
use crate::meter::WallTouch;
use crate::pair_contacts::add_load;
use crate::state::vector;
use crate::tally::{DeepestContact, Partner};
use crate::workspace::NearWall;
use pelletflow_core::{Contact, Vec3};

/// Least curvature of a contact over the pellet's own [-]: a pellet in a hollow of nearly its own radius would
/// otherwise be held by an infinite force.
pub(crate) const LEAST_CURVATURE_SHARE: f64 = 0.05;

/// Adds the forces of all walls that the chunk lists.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    for slot in 0..chunk.list.near_walls.len() {
        let NearWall { pellet, wall } = chunk.list.near_walls[slot];
        let (local, wall) = (pellet as usize, wall as usize);
        let is_touching = chunk.walls[wall].is_present && touch(chunk, local, wall, slot);
        let steps = chunk.contacts.wall.rows[slot].steps;
        if !is_touching && steps > 0 {
            chunk.tally.finish(steps);
            chunk.contacts.wall.forget(slot);
        }
    }
}

/// Adds the force of one wall, if it touches the pellet; tells whether they hold on to each other.
fn touch(chunk: &mut ForceChunk, local: usize, index: usize, slot: usize) -> bool {
    let model = chunk.model;
    let a = chunk.range.start + local;
    let (center, radius) = (
        vector(&chunk.pellets.position[a]),
        chunk.pellets.position[a][3],
    );
    let wall = &model.setup().walls[index];
    let pose = &chunk.walls[index].pose;
    let is_moving = wall.motion.is_moving();
    let surface = wall.shape.surface(if is_moving {
        pose.inverse_point(center)
    } else {
        center
    });
    let overlap = radius - surface.distance;
    let is_held = chunk.contacts.wall.rows[slot].steps > 0 && overlap > -model.holding_gap();
    if overlap <= 0.0 && !is_held {
        return false;
    }
    let normal = if is_moving {
        pose.direction(surface.normal)
    } else {
        surface.normal
    };
    let arm = radius - 0.5 * overlap;
    let wall_velocity = wall.surface_velocity_at(center - arm * normal, normal, chunk.time);
    let wall_spin = wall.motion.spin(chunk.time);
    let (velocity, spin) = (
        vector(&chunk.pellets.velocity[a]),
        vector(&chunk.pellets.spin[a]),
    );
    let curvature = (1.0 / radius + surface.mean_curvature()).max(LEAST_CURVATURE_SHARE / radius);
    let contact = Contact {
        normal,
        overlap,
        relative_velocity: velocity - wall_velocity - arm * spin.cross(&normal),
        relative_spin: spin - wall_spin,
        effective_radius: 1.0 / curvature,
        effective_mass: 1.0 / chunk.pellets.velocity[a][3],
    };
    let pair = model.pair_with_wall(chunk.pellets.kind[a], index);
    let laws = model.laws();
    let memories = &mut chunk.contacts.wall;
    let last = memories.history(slot, laws);
    let mut history = last;
    let force = laws.force(&contact, pair, &mut history, model.sampling());

    let moment: Vec3 = -arm * normal.cross(&force.force);
    add_load(&mut chunk.loads[local], &force, 1.0, moment);
    let depth = DeepestContact {
        ratio: overlap / radius,
        pellet: a,
        partner: Partner::Wall(index),
    };
    let found = || (contact, *pair, last);
    chunk.tally.open(&force, depth, found, model);
    chunk.tally.open_with_walls += 1;
    chunk.tally.wall_force[index] -= force.force;
    chunk.tally.wall_power +=
        force.force.dot(&wall_velocity) + force.turning_torque.dot(&wall_spin);
    let is_over = history.normal_force == 0.0;
    if model.is_watched(index) {
        chunk.tally.wall_touches.push(WallTouch {
            wall: index,
            is_first: !is_over && chunk.contacts.wall.rows[slot].steps == 0,
            point: center - arm * normal,
            velocity: velocity - wall_velocity,
            friction: pair.friction,
            contact,
            force,
        });
    }
    if !is_over {
        chunk.contacts.wall.step(slot, &history, laws);
    }
    !is_over
}
