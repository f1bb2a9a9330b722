//! Fills: where the pellets are put and how many.

use super::{Resolver, point, vector, velocity};
use crate::key_path::KeyPath;
use crate::number::show;
use crate::quantity::{Acceleration, Coordinate, TurnRate};
use crate::spec::feed::{FillSpec, PackingSpec};
use pelletflow_core::{Bounds, Shape, Vec3};
use pelletflow_sim::{Fill, FillAmount, PelletKind, Seats};

/// Share of its volume that a settled bed fills [-]: between random loose and random close packing of equal spheres,
/// 0.555 and 0.64 (Onoda & Liniger 1990, Scott & Kilgour 1969).
const SETTLED_FILLING: f64 = 0.6;
/// Points along each side of a region's box at which it is looked whether they are in it [-].
const POINTS: u32 = 64;

impl Resolver<'_> {
    pub(super) fn fills(&mut self, kinds: &[PelletKind]) -> Vec<Fill> {
        let spec = self.spec;
        spec.fill
            .iter()
            .map(|(name, fill)| {
                let path = KeyPath::of(["fill", name]);
                let pellets = self.index(&spec.pellets, &fill.pellets, &path.key("pellets"));
                Fill {
                    name: name.to_owned(),
                    pellets,
                    seats: self.seats(fill, kinds.get(pellets), &path),
                    velocity: velocity(fill.velocity),
                    spin: fill.spin.map_or_else(Vec3::zeros, |spin| {
                        vector(spin.map(|TurnRate(value)| value))
                    }),
                }
            })
            .collect()
    }

    fn seats(&mut self, fill: &FillSpec, kind: Option<&PelletKind>, path: &KeyPath) -> Seats {
        let amounts = [
            ("count", fill.count.is_some()),
            ("mass", fill.mass.is_some()),
            ("to_level", fill.to_level.is_some()),
        ];
        let given: Vec<String> = amounts
            .iter()
            .filter(|(_, is_given)| *is_given)
            .map(|(key, _)| format!("`{key}`"))
            .collect();
        if let Some(at) = &fill.at {
            if fill.region.is_some() || fill.packing.is_some() || !given.is_empty() {
                self.findings.add(
                    path,
                    "`at` places every pellet by itself; leave out `region`, `packing`, `count`, `mass` and `to_level`",
                );
            }
            return Seats::Points(at.iter().map(|&center| point(center)).collect());
        }
        let Some(region) = &fill.region else {
            self.findings.add(
                path,
                "`region` is missing; give one with a `count` or a `mass`, or centers such as `at = [[0, 0, 1]]`",
            );
            return Seats::Points(Vec::new());
        };
        let region = self.region(region, path);
        let amount = match (fill.count, &fill.mass, fill.to_level) {
            (Some(count), None, None) => FillAmount::Count(count),
            (None, Some(mass), None) => FillAmount::Mass(mass.0),
            (None, None, Some(Coordinate(level))) => self.up_to_level(&region, level, kind, path),
            _ => {
                let message = if given.is_empty() {
                    "`count`, `mass` or `to_level` is missing; write for example `count = 1000` or `mass = \"50 kg\"`"
                        .to_owned()
                } else {
                    format!("{} are both given; keep one", given.join(" and "))
                };
                self.findings.add(path, message);
                FillAmount::Count(1)
            }
        };
        let is_of_one_size =
            kind.is_none_or(|kind| kind.size.min_diameter() == kind.size.max_diameter());
        let default =
            if fill.to_level.is_none() && (is_of_one_size || self.gravity() == Vec3::zeros()) {
                PackingSpec::Lattice
            } else {
                PackingSpec::Deposit
            };
        match fill.packing.unwrap_or(default) {
            PackingSpec::Lattice => Seats::Lattice { region, amount },
            PackingSpec::Deposit => Seats::Deposit { region, amount },
        }
    }

    /// How many pellets fill a region up to a level [m] when they have settled.
    fn up_to_level(
        &mut self,
        region: &Shape,
        level: f64,
        kind: Option<&PelletKind>,
        path: &KeyPath,
    ) -> FillAmount {
        let gravity = self.gravity();
        let (Some(kind), true) = (kind, region.bounds().is_finite()) else {
            // Mistakes of their own.
            return FillAmount::Count(1);
        };
        let path = path.key("to_level");
        let Some(up) = (-gravity).try_normalize(0.0) else {
            self.findings.add(
                &path,
                "there is no gravity, so nothing settles; give a `count` or a `mass`",
            );
            return FillAmount::Count(1);
        };
        let volume = volume_below(region, up, level);
        let count = (SETTLED_FILLING * volume / kind.size.mean_volume()).round();
        if count < 1.0 {
            let bounds = region.bounds();
            let corners = [bounds.min, bounds.max].map(|corner| rounded(corner.dot(&up)));
            self.findings.add(
                &path,
                format!(
                    "no pellet fits below {} m; the region goes from {} m to {} m against gravity",
                    show(level),
                    corners[0],
                    corners[1]
                ),
            );
            return FillAmount::Count(1);
        }
        self.notes.push(format!(
            "{path}: {count} pellets up to {} m, estimated from {} m3 of the region below it and a settled bed that is \
             {SETTLED_FILLING} pellet; the level comes out within some percent",
            show(level),
            rounded(volume),
        ));
        FillAmount::Count(count as usize)
    }

    fn gravity(&self) -> Vec3 {
        vector(self.spec.scene.gravity.map(|Acceleration(value)| value))
    }
}

/// A number for a message, to a millionth.
fn rounded(value: f64) -> String {
    show((value * 1.0e6).round() / 1.0e6)
}

/// Volume of the part of a region that lies below a height along a direction [m³].
fn volume_below(region: &Shape, up: Vec3, level: f64) -> f64 {
    let Bounds { min, max } = region.bounds();
    let size = max - min;
    let share = |index: u32| (f64::from(index) + 0.5) / f64::from(POINTS);
    let mut inside = 0_u32;
    for i in 0..POINTS {
        for j in 0..POINTS {
            for k in 0..POINTS {
                let place = min + size.component_mul(&Vec3::new(share(i), share(j), share(k)));
                inside += u32::from(place.dot(&up) < level && region.distance(place) < 0.0);
            }
        }
    }
    size.product() * f64::from(inside) / f64::from(POINTS).powi(3)
}
