//! Patches of a wall: the cells of a regular grid in the wall's frame, which moves with it.

use super::touch::WallTouch;
use pelletflow_core::{Pose, Vec3};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How deep under the surface a contact is put to its cell, over the width of a cell [-]: a face that lies in a plane
/// of the grid then belongs to the cells on one side of it.
const DEPTH: f64 = 1.0e-3;

/// Place of a cell in the grid.
type Cell = [i64; 3];

/// What each patch received; only patches that received something take room.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Patches<T>(BTreeMap<Cell, T>);

/// What each patch of a wall received, the worst first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PatchTable {
    /// Quantities with their units in their names; the first three are the patch's center in the wall's frame,
    /// which is the world's before the wall moves.
    pub columns: Vec<&'static str>,
    /// A value for each column, patch by patch [units of the columns].
    pub rows: Vec<Vec<f64>>,
}

impl<T> Default for Patches<T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<T: Default> Patches<T> {
    /// What the patch of a contact has received, in a grid of cells of a width [m], on a wall at a pose.
    pub(crate) fn at(&mut self, touch: &WallTouch, width: f64, pose: &Pose) -> &mut T {
        let point = pose.inverse_point(touch.point - DEPTH * width * touch.contact.normal);
        let cell = (point / width).map(|coordinate| coordinate.floor() as i64);
        self.0.entry(cell.into()).or_default()
    }

    /// What every patch has received, in the order of the grid.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &T> {
        self.0.values()
    }

    /// A table of the patches, the worst first; equal ones in the order of the grid.
    ///
    /// `row` gives the same quantities for every patch, and `badness` what they are sorted by.
    pub(crate) fn table(
        &self,
        width: f64,
        badness: impl Fn(&T) -> f64,
        row: impl Fn(&T) -> Vec<(&'static str, f64)>,
    ) -> PatchTable {
        let mut patches: Vec<(&Cell, &T)> = self.0.iter().collect();
        patches.sort_by(|a, b| badness(b.1).total_cmp(&badness(a.1)));
        let center = |cell: &Cell| Vec3::from(cell.map(|place| (place as f64 + 0.5) * width));
        let columns = ["x_m", "y_m", "z_m"].into_iter();
        PatchTable {
            columns: columns
                .chain(row(&T::default()).into_iter().map(|(name, _)| name))
                .collect(),
            rows: patches
                .into_iter()
                .map(|(cell, received)| {
                    let place = center(cell);
                    let values = row(received).into_iter().map(|(_, value)| value);
                    place.iter().copied().chain(values).collect()
                })
                .collect(),
        }
    }
}

/// What is wrong with a width of cells [m].
pub(crate) fn mistakes(width: f64) -> Option<(&'static str, String)> {
    let is_width = width.is_finite() && width > 0.0;
    (!is_width).then(|| ("cell", format!("is {width} m; expected more than 0")))
}
