//! Meters.

use super::{Resolver, point};
use crate::key_path::KeyPath;
use crate::quantity::{Size, SpeedBound, WearCoefficient};
use crate::spec::meter::MeterSpec;
use pelletflow_core::{Bounds, Vec3};
use pelletflow_sim::{
    Heap, MassFlow, Meter, MeterKind, PlaneFlow, Region, Residence, Wall, WallForce, WallImpacts,
    Wear,
};

/// Speed of approach up to which a touch is no impact, where none is given [m/s].
const LEAST_SPEED: f64 = 0.1;

impl Resolver<'_> {
    pub(super) fn meters(&mut self, walls: &[Wall]) -> Vec<Meter> {
        let spec = self.spec;
        spec.meters
            .iter()
            .map(|(name, meter)| Meter {
                name: name.to_owned(),
                kind: self.meter(meter, walls, &KeyPath::of(["meters", name])),
            })
            .collect()
    }

    fn meter(&mut self, spec: &MeterSpec, walls: &[Wall], path: &KeyPath) -> MeterKind {
        match spec {
            MeterSpec::MassFlow { outlet } => MeterKind::MassFlow(MassFlow {
                outlet: self.index(&self.spec.outlets, outlet, &path.key("outlet")),
            }),
            MeterSpec::PlaneFlow {
                point: center,
                normal,
                radius,
            } => MeterKind::PlaneFlow(PlaneFlow {
                point: point(*center),
                normal: self.direction(*normal, &path.key("normal")),
                radius: radius.map_or(f64::INFINITY, |Size(radius)| radius),
            }),
            MeterSpec::WallForce { wall, about } => {
                let wall = self.wall_of_meter(wall, path);
                let center = || walls.get(wall).map_or_else(Vec3::zeros, Wall::center);
                MeterKind::WallForce(WallForce {
                    wall,
                    about: about.map_or_else(center, point),
                })
            }
            MeterSpec::WallImpacts {
                wall,
                cell,
                least_speed: speed,
            } => MeterKind::WallImpacts(WallImpacts {
                wall: self.wall_of_meter(wall, path),
                cell: cell.0,
                least_speed: least_speed(*speed),
            }),
            MeterSpec::Wear {
                wall,
                cell,
                archard,
                finnie,
                least_speed: speed,
            } => MeterKind::Wear(Wear {
                wall: self.wall_of_meter(wall, path),
                cell: cell.0,
                archard: archard.map_or(0.0, |WearCoefficient(value)| value),
                finnie: finnie.map_or(0.0, |WearCoefficient(value)| value),
                least_speed: least_speed(*speed),
            }),
            MeterSpec::Box { min, max } => MeterKind::Region(Region {
                bounds: Bounds {
                    min: point(*min),
                    max: point(*max),
                },
            }),
            MeterSpec::Residence => MeterKind::Residence(Residence),
            MeterSpec::Heap { point: foot, up } => MeterKind::Heap(Heap {
                point: point(*foot),
                up: up.map_or_else(Vec3::z_axis, |up| self.direction(up, &path.key("up"))),
            }),
        }
    }

    fn wall_of_meter(&mut self, name: &str, path: &KeyPath) -> usize {
        self.index(&self.spec.walls, name, &path.key("wall"))
    }
}

fn least_speed(given: Option<SpeedBound>) -> f64 {
    given.map_or(LEAST_SPEED, |SpeedBound(speed)| speed)
}
