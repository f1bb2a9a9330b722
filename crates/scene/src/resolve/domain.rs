//! The box in which pellets may be: as given, or about everything in the scene.

use super::{Resolver, point};
use crate::key_path::KeyPath;
use crate::spec::header::AxisSpec;
use pelletflow_core::{Bounds, Vec3};
use pelletflow_sim::{Domain, Fill, Inlet, Outlet, Seats, Wall};

/// Margin of a chosen domain on every side, as a share of its longest side [-].
const MARGIN: f64 = 0.5;

/// Moments of the run at which moving walls are looked at [-].
const SAMPLES: u32 = 32;

impl Resolver<'_> {
    pub(super) fn domain(
        &mut self,
        walls: &[Wall],
        fills: &[Fill],
        inlets: &[Inlet],
        outlets: &[Outlet],
    ) -> Domain {
        if let Some(spec) = &self.spec.domain {
            let bounds = Bounds {
                min: point(spec.min),
                max: point(spec.max),
            };
            if (0..3).any(|axis| bounds.min[axis] >= bounds.max[axis]) {
                self.findings.add(
                    &KeyPath::of(["domain", "max"]),
                    "`max` is not above `min` along every axis; exchange or correct them",
                );
            }
            let is_periodic =
                [AxisSpec::X, AxisSpec::Y, AxisSpec::Z].map(|axis| spec.periodic.contains(&axis));
            return Domain {
                bounds,
                is_periodic,
            };
        }
        let fixed = fills
            .iter()
            .map(bounds_of)
            .chain(inlets.iter().map(|inlet| inlet.region.bounds()))
            .chain(outlets.iter().map(|outlet| outlet.region.bounds()));
        let end_time = self.spec.time.end.0;
        let moving = walls.iter().flat_map(|wall| places(wall, end_time));
        let parts = fixed.chain(moving);
        let extent = parts.fold(Bounds::nothing(), |extent, part| widened(extent, &part));
        if !extent.is_finite() {
            // Without pellets there is no extent; that is a mistake of its own.
            return Domain::closed(Bounds {
                min: Vec3::repeat(-1.0),
                max: Vec3::repeat(1.0),
            });
        }
        let bounds = extent.grown(MARGIN * (extent.max - extent.min).max());
        self.notes.push(format!(
            "domain: from ({:.2}, {:.2}, {:.2}) to ({:.2}, {:.2}, {:.2}) m, chosen around everything in the scene; set it with \
             [domain]",
            bounds.min.x, bounds.min.y, bounds.min.z, bounds.max.x, bounds.max.y, bounds.max.z
        ));
        Domain::closed(bounds)
    }
}

fn bounds_of(fill: &Fill) -> Bounds {
    match &fill.seats {
        Seats::Lattice { region, .. } | Seats::Deposit { region, .. } => region.bounds(),
        Seats::Points(points) => points.iter().fold(Bounds::nothing(), |bounds, &point| {
            let point = Bounds {
                min: point,
                max: point,
            };
            bounds.merged(&point)
        }),
    }
}

/// Where a wall is in the course of a run.
fn places(wall: &Wall, end_time: f64) -> impl Iterator<Item = Bounds> {
    let bounds = wall.shape.bounds();
    let samples = if wall.motion.is_moving() { SAMPLES } else { 0 };
    (0..=samples).map(move |sample| {
        let time = end_time * f64::from(sample) / f64::from(samples.max(1));
        let pose = wall.motion.pose(time);
        let turned = if pose.rotation == pelletflow_core::UnitQuaternion::identity() {
            bounds
        } else {
            bounds.rotated(&pose.rotation)
        };
        Bounds {
            min: turned.min + pose.translation,
            max: turned.max + pose.translation,
        }
    })
}

/// The box widened to every finite side of another: the face of a half-space counts, its depth does not.
fn widened(mut extent: Bounds, part: &Bounds) -> Bounds {
    for axis in 0..3 {
        for side in [part.min[axis], part.max[axis]] {
            if side.is_finite() {
                extent.min[axis] = extent.min[axis].min(side);
                extent.max[axis] = extent.max[axis].max(side);
            }
        }
    }
    extent
}
