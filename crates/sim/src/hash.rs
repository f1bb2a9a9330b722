//! A hash of the state: equal only for equal bits.

use crate::state::State;
use xxhash_rust::xxh3::Xxh3;

/// 32 hexadecimal digits over step and pellets, in order of their numbers.
pub(crate) fn of(state: &State) -> String {
    let pellets = &state.pellets;
    let mut order: Vec<usize> = (0..pellets.len()).collect();
    order.sort_unstable_by_key(|&index| pellets.id[index]);
    let mut hasher = Xxh3::new();
    hasher.update(&state.step.to_le_bytes());
    for index in order {
        hasher.update(&pellets.id[index].to_le_bytes());
        hasher.update(&pellets.kind[index].to_le_bytes());
        let rows = [
            &pellets.position[index],
            &pellets.velocity[index],
            &pellets.spin[index],
            &pellets.half_step_velocity[index],
            &pellets.half_step_spin[index],
        ];
        for value in rows.into_iter().flatten() {
            hasher.update(&value.to_bits().to_le_bytes());
        }
    }
    format!("{:032x}", hasher.digest128())
}
