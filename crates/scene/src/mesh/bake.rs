//! What was baked of a mesh, and how far it is off.

use crate::number::show;
use pelletflow_sim::{BakedMesh, Deviation};

/// Deviation over the radius of the smallest pellet from which on it is warned of [-].
const MOST_OFF: f64 = 0.01;

/// The grid of distances that stands in for a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BakeReport {
    /// Length of a cell [m].
    pub spacing: f64,
    /// Memory of the grid [B].
    pub bytes: f64,
    /// Greatest deviation from the distance of the triangles, up to a radius of the largest pellet from them [m].
    pub greatest: f64,
    /// Root mean square of the deviation over points spread evenly about the surface [m].
    pub root_mean_square: f64,
    /// Radius of the smallest pellet [m].
    pub smallest_radius: f64,
}

impl BakeReport {
    pub(crate) fn new(baked: &BakedMesh, smallest_radius: f64, largest_radius: f64) -> Self {
        let Deviation {
            greatest,
            root_mean_square,
        } = baked.deviation(largest_radius);
        Self {
            spacing: baked.spacing(),
            bytes: baked.bytes(),
            greatest,
            root_mean_square,
            smallest_radius,
        }
    }

    /// Greatest deviation over the radius of the smallest pellet [-].
    pub fn greatest_share(&self) -> f64 {
        self.greatest / self.smallest_radius
    }

    /// Root mean square of the deviation over the radius of the smallest pellet [-].
    pub fn root_mean_square_share(&self) -> f64 {
        self.root_mean_square / self.smallest_radius
    }

    /// Length of a cell that would likely keep the greatest deviation within 1 % of the smallest radius [m].
    ///
    /// At edges and corners the deviation is proportional to the cell, on curves it falls faster.
    pub fn likely_spacing(&self) -> f64 {
        let exact = self.spacing * (MOST_OFF / self.greatest_share()).min(1.0);
        let digit = 10.0_f64.powi(exact.log10().floor() as i32 - 1);
        (exact / digit).floor() * digit
    }

    /// The grid and its error, in a sentence.
    pub fn summary(&self) -> String {
        format!(
            "cells of {} mm, {:.1} MB; off by at most {:.4} mm, {:.2} % of the smallest radius, and by {:.4} mm, {:.2} %, as a \
             root mean square",
            show(rounded(1.0e3 * self.spacing)),
            self.bytes / 1.0e6,
            1.0e3 * self.greatest,
            1.0e2 * self.greatest_share(),
            1.0e3 * self.root_mean_square,
            1.0e2 * self.root_mean_square_share(),
        )
    }

    /// What is wrong with it and what would cure it, where it is too far off.
    pub(super) fn warning(&self) -> Option<String> {
        (self.greatest_share() > MOST_OFF).then(|| {
            format!(
                "baked distances are off by up to {:.4} mm, {:.2} % of the smallest radius; expected at most {:.0} %: edges are \
                 rounded by a cell; `bake = \"{} mm\"` would likely hold, or leave `bake` out",
                1.0e3 * self.greatest,
                1.0e2 * self.greatest_share(),
                1.0e2 * MOST_OFF,
                show(rounded(1.0e3 * self.likely_spacing())),
            )
        })
    }
}

/// Without the digits that a change of units leaves behind.
fn rounded(value: f64) -> f64 {
    (value * 1.0e6).round() / 1.0e6
}
