//! Walls: shape and schedule.

use super::{Resolver, velocity};
use crate::key_path::KeyPath;
use crate::quantity::Moment;
use crate::spec::wall::{GateState, ScheduleSpec, WallSpec};
use pelletflow_core::Shape;
use pelletflow_sim::{PelletKind, Schedule, Wall, WallShape};

impl Resolver<'_> {
    pub(super) fn walls(&mut self, pellets: &[PelletKind]) -> Vec<Wall> {
        let spec = self.spec;
        spec.walls
            .iter()
            .map(|(name, wall)| {
                let path = KeyPath::of(["walls", name]);
                Wall {
                    name: name.to_owned(),
                    material: self.index(&spec.materials, &wall.material, &path.key("material")),
                    shape: self.wall_shape(name, wall, pellets, &path),
                    motion: self.motions(&wall.motion, &path.key("motion")),
                    surface_velocity: velocity(wall.surface_velocity),
                    schedule: self.schedule(wall, &path),
                }
            })
            .collect()
    }

    /// What a wall is made of: a shape or a mesh.
    fn wall_shape(
        &mut self,
        name: &str,
        spec: &WallSpec,
        pellets: &[PelletKind],
        path: &KeyPath,
    ) -> WallShape {
        match (&spec.shape, &spec.mesh) {
            (Some(shape), None) => return self.shape(shape, &path.key("shape")).into(),
            (None, Some(mesh)) => {
                if let Some(shape) = self.mesh(name, mesh, pellets, &path.key("mesh")) {
                    return shape;
                }
            }
            (Some(_), Some(_)) => self.findings.add(
                &path.key("mesh"),
                "`shape` and `mesh` are both given; a wall is one of the two: keep that, or make two walls",
            ),
            (None, None) => self.findings.add(
                path,
                "missing `shape` or `mesh`; write for example `shape = { kind = \"box\", center = [0, 0, 0], size = [1, 1, 0.01] }` \
                 or `mesh = { file = \"chute.stl\", unit = \"mm\" }`",
            ),
        }
        // Taken for a wall that cannot be, so that the checks can go on.
        Shape::Sphere { radius: 1.0 }.into()
    }

    /// From 0 where no start is given, without end where no end is given.
    pub(super) fn span(
        &mut self,
        start: Option<Moment>,
        end: Option<Moment>,
        path: &KeyPath,
    ) -> (f64, f64) {
        let start = start.map_or(0.0, |moment| moment.0);
        let end = end.map_or(f64::INFINITY, |moment| moment.0);
        if end <= start {
            self.findings.add(
                &path.key("end"),
                format!("`end` is {end} s and `start` is {start} s; expected `end` after `start`"),
            );
        }
        (start, end)
    }

    fn schedule(&mut self, wall: &WallSpec, path: &KeyPath) -> Schedule {
        let opens_at = wall.opens_at.map(|moment| moment.0);
        let closes_at = wall.closes_at.map(|moment| moment.0);
        if let Some(schedule) = &wall.schedule {
            if opens_at.is_some() || closes_at.is_some() {
                self.findings.add(
                    &path.key("schedule"),
                    "`schedule` stands in place of `opens_at` and `closes_at`; keep one way",
                );
            }
            return self.changes(schedule, &path.key("schedule"));
        }
        match (opens_at, closes_at) {
            (None, None) => Schedule::always(),
            (Some(opens_at), None) => Schedule::opening_at(vec![opens_at]),
            (None, Some(closes_at)) => Schedule::closing_at(vec![closes_at]),
            (Some(opens_at), Some(closes_at)) if opens_at < closes_at => {
                Schedule::opening_at(vec![opens_at, closes_at])
            }
            (Some(opens_at), Some(closes_at)) => {
                if opens_at == closes_at {
                    self.findings.add(
                        &path.key("closes_at"),
                        format!("the gate opens and closes at {opens_at} s; move one of the two"),
                    );
                }
                Schedule::closing_at(vec![closes_at, opens_at])
            }
        }
    }

    fn changes(&mut self, spec: &ScheduleSpec, path: &KeyPath) -> Schedule {
        let changes: Vec<f64> = spec.changes.iter().map(|moment| moment.0).collect();
        for (index, pair) in changes.windows(2).enumerate() {
            if pair[1] <= pair[0] {
                self.findings.add(
                    &path.key("changes").index(index + 1),
                    format!(
                        "{} s does not come after {} s; let the moments rise",
                        pair[1], pair[0]
                    ),
                );
            }
        }
        match spec.at_first {
            GateState::Closed => Schedule::opening_at(changes),
            GateState::Open => Schedule::closing_at(changes),
        }
    }
}
