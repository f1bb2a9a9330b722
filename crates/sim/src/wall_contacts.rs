//! Contacts between pellets and walls.

use crate::forces::ForceChunk;
use crate::meter::WallTouch;
use crate::pair_contacts::add_load;
use crate::state::vector;
use crate::tally::{DeepestContact, Partner};
use crate::workspace::NearWall;
use pelletflow_core::contact::curvature;
use pelletflow_core::solid::MOST_TOUCHES;
use pelletflow_core::{Contact, Surface, Vec3};
use std::ops::Range;

/// Least curvature of a contact over the pellet's own [-]: a pellet in a hollow of nearly its own radius would
/// otherwise be held by an infinite force.
pub(crate) const LEAST_CURVATURE_SHARE: f64 = 0.05;

/// Cosine between the normals of a contact in two steps below which it is another contact [-].
const SAME_CONTACT: f64 = 0.8;

/// Adds the forces of all walls that the chunk lists.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    let list = chunk.list;
    let mut first = 0;
    let (mut mesh, mut first_triangle) = (0, 0);
    while first < list.near_walls.len() {
        let NearWall { pellet, wall } = list.near_walls[first];
        let places = first..first + chunk.model.touches_at(wall as usize);
        first = places.end;
        let mut triangles: &[u32] = &[];
        if chunk.model.touchable(wall as usize).is_mesh() {
            let end = list.near_triangle_ends[mesh] as usize;
            triangles = &list.near_triangles[first_triangle..end];
            (mesh, first_triangle) = (mesh + 1, end);
        }
        touch_wall(chunk, pellet as usize, wall as usize, places, triangles);
    }
}

/// Adds the forces of all contacts of one pellet with one wall, which remember in `places`; of a mesh, with the triangles
/// near the pellet.
fn touch_wall(
    chunk: &mut ForceChunk,
    local: usize,
    wall: usize,
    places: Range<usize>,
    triangles: &[u32],
) {
    let mut is_free = [true; MOST_TOUCHES];
    if chunk.walls[wall].is_present {
        let a = chunk.range.start + local;
        let row = &chunk.pellets.position[a];
        let (center, reach) = (vector(row), row[3] + chunk.model.holding_gap());
        let pose = &chunk.walls[wall].pose;
        let is_moving = chunk.model.setup().walls[wall].motion.is_moving();
        let seen = if is_moving {
            pose.inverse_point(center)
        } else {
            center
        };
        let touchable = chunk.model.touchable(wall);
        let touches = touchable.touches(seen, reach, triangles);
        for &surface in touches.as_slice() {
            let surface = Surface {
                normal: if is_moving {
                    pose.direction(surface.normal)
                } else {
                    surface.normal
                },
                ..surface
            };
            let Some(place) = place_of(chunk, &surface, &places, &is_free) else {
                continue;
            };
            is_free[place] = !touch(chunk, local, wall, places.start + place, &surface);
        }
    }
    for (slot, is_free) in places.zip(is_free) {
        let steps = chunk.contacts.wall.rows[slot].steps;
        if is_free && steps > 0 {
            chunk.tally.finish(steps);
            chunk.contacts.wall.forget(slot);
        }
    }
}

/// Which of the places remembers a contact: the one that was there in the last step, or else one without a memory.
fn place_of(
    chunk: &ForceChunk,
    surface: &Surface,
    places: &Range<usize>,
    is_free: &[bool],
) -> Option<usize> {
    if places.len() == 1 {
        return is_free[0].then_some(0);
    }
    let sameness = |place: usize| {
        let slot = places.start + place;
        if chunk.contacts.wall.rows[slot].steps > 0 {
            chunk.contacts.wall_normals[slot].dot(&surface.normal)
        } else {
            SAME_CONTACT
        }
    };
    (0..places.len())
        .filter(|&place| is_free[place] && sameness(place) >= SAME_CONTACT)
        .max_by(|&a, &b| sameness(a).total_cmp(&sameness(b)))
}

/// Effective radius of a pellet's contact with a wall, from its own radius [m].
pub(crate) fn effective_radius(radius: f64, surface: &Surface) -> f64 {
    let relative = surface.principal_curvatures.map(|of_wall| {
        // The true radius of a sharp edge is unknown; it counts as flat.
        let of_wall = if of_wall.is_finite() { of_wall } else { 0.0 };
        (1.0 / radius + of_wall).max(LEAST_CURVATURE_SHARE / radius)
    });
    curvature::effective_radius(relative)
}

/// Adds the force of one contact with a wall; tells whether the two hold on to each other.
fn touch(
    chunk: &mut ForceChunk,
    local: usize,
    index: usize,
    slot: usize,
    surface: &Surface,
) -> bool {
    let model = chunk.model;
    let a = chunk.range.start + local;
    let (center, radius) = (
        vector(&chunk.pellets.position[a]),
        chunk.pellets.position[a][3],
    );
    let wall = &model.setup().walls[index];
    let normal = surface.normal;
    let overlap = radius - surface.distance;
    let is_held = chunk.contacts.wall.rows[slot].steps > 0 && overlap > -model.holding_gap();
    if overlap <= 0.0 && !is_held {
        return false;
    }
    let arm = radius - 0.5 * overlap;
    let wall_velocity = wall.surface_velocity_at(center - arm * normal, normal, chunk.time);
    let wall_spin = wall.motion.spin(chunk.time);
    let (velocity, spin) = (
        vector(&chunk.pellets.velocity[a]),
        vector(&chunk.pellets.spin[a]),
    );
    let contact = Contact {
        normal,
        overlap,
        relative_velocity: velocity - wall_velocity - arm * spin.cross(&normal),
        relative_spin: spin - wall_spin,
        effective_radius: effective_radius(radius, surface),
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
        chunk.contacts.wall_normals[slot] = normal;
    }
    !is_over
}
