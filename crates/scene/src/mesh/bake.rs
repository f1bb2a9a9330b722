//! What was baked of a mesh, and how far it is off.

use crate::number::show;
use pelletflow_core::mesh::MOST_MEMORY;
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
            let likely = self.likely_spacing();
            // No more than the volume near the surface, as blocks shrink with their cells.
            let fits = self.bytes * (self.spacing / likely).powi(3) < MOST_MEMORY;
            let finer = if fits {
                format!(
                    "`bake = \"{} mm\"` would likely hold, or ",
                    show(rounded(1.0e3 * likely))
                )
            } else {
                String::new()
            };
            format!(
                "baked distances are off by up to {:.4} mm, {:.2} % of the smallest radius; expected at most {:.0} %: edges are \
                 rounded by a cell; {finer}leave `bake` out",
                1.0e3 * self.greatest,
                1.0e2 * self.greatest_share(),
                1.0e2 * MOST_OFF,
            )
        })
    }
}

/// Without the digits that a change of units leaves behind.
fn rounded(value: f64) -> f64 {
    (value * 1.0e6).round() / 1.0e6
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(greatest: f64, bytes: f64) -> BakeReport {
        BakeReport {
            spacing: 0.002,
            bytes,
            greatest,
            root_mean_square: greatest / 10.0,
            smallest_radius: 0.0075,
        }
    }

    #[test]
    fn a_deviation_of_less_than_a_hundredth_of_the_radius_is_not_warned_of() {
        let fair = report(0.000_07, 1.0e6);
        assert_eq!(fair.warning(), None);
        assert_eq!(
            fair.summary(),
            "cells of 2 mm, 1.0 MB; off by at most 0.0700 mm, 0.93 % of the smallest radius, and by 0.0070 mm, 0.09 %, as a \
             root mean square"
        );
    }

    #[test]
    fn the_cell_that_would_hold_is_named_where_it_fits_into_memory() {
        // Four times the hundredth of the radius.
        let warning = report(0.000_3, 1.0e6).warning().expect("too far off");
        assert!(
            warning.contains("off by up to 0.3000 mm, 4.00 % of the smallest radius"),
            "{warning}"
        );
        let named = warning.contains("`bake = \"0.5 mm\"` would likely hold");
        assert!(
            named || warning.contains("`bake = \"0.49 mm\"`"),
            "{warning}"
        );
        let vast = report(0.000_3, 1.0e8).warning().expect("too far off");
        assert!(
            vast.ends_with("rounded by a cell; leave `bake` out"),
            "{vast}"
        );
    }
}
