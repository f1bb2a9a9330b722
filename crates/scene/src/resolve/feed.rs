//! Inlets and outlets, and how many pellets come.

use super::{Resolver, velocity};
use crate::key_path::KeyPath;
use crate::number::show;
use crate::quantity::FeedRate;
use crate::spec::shape::ShapeSpec;
use pelletflow_core::{Bounds, Shape};
use pelletflow_sim::{Fill, FillAmount, Inlet, NamedMaterial, Outlet, PelletKind, Rate, Seats};

/// Most pellets of a scene; each takes about a kilobyte with its contacts [-].
const MOST_PELLETS: f64 = 5.0e6;

/// Most places of a lattice over a region that are searched for room [-].
const MOST_SITES: f64 = 1.0e9;

impl Resolver<'_> {
    pub(super) fn inlets(&mut self) -> Vec<Inlet> {
        let spec = self.spec;
        spec.inlets
            .iter()
            .map(|(name, inlet)| {
                let path = KeyPath::of(["inlets", name]);
                let (start, end) = self.span(inlet.start, inlet.end, &path);
                Inlet {
                    name: name.to_owned(),
                    pellets: self.index(&spec.pellets, &inlet.pellets, &path.key("pellets")),
                    region: self.region(&inlet.region, &path),
                    rate: match inlet.rate {
                        FeedRate::Mass(rate) => Rate::Mass(rate),
                        FeedRate::Count(rate) => Rate::Count(rate),
                    },
                    velocity: velocity(inlet.velocity),
                    start,
                    end,
                }
            })
            .collect()
    }

    pub(super) fn outlets(&mut self) -> Vec<Outlet> {
        let spec = self.spec;
        spec.outlets
            .iter()
            .map(|(name, outlet)| Outlet {
                name: name.to_owned(),
                region: self.shape(&outlet.region, &KeyPath::of(["outlets", name, "region"])),
            })
            .collect()
    }

    /// A region in which pellets appear, which must end somewhere.
    pub(super) fn region(&mut self, spec: &ShapeSpec, path: &KeyPath) -> Shape {
        let path = path.key("region");
        let region = self.shape(spec, &path);
        if !region.bounds().is_finite() {
            self.findings.add(
                &path,
                "the region has no end; use a box, a cylinder or another shape of finite size",
            );
        }
        region
    }

    /// Refuses a scene without pellets, and one with more than a computer holds.
    pub(super) fn amounts(
        &mut self,
        fills: &[Fill],
        inlets: &[Inlet],
        materials: &[NamedMaterial],
        pellets: &[PelletKind],
    ) {
        if fills.is_empty() && inlets.is_empty() {
            self.findings.add(
                &KeyPath::root(),
                "the scene has no pellets; add a [fill.NAME] or an [inlets.NAME]",
            );
        }
        let end_time = self.spec.time.end.0;
        let mass_of = |kind: usize| {
            let kind = pellets.get(kind)?;
            let material = &materials.get(kind.material)?.material;
            Some(material.density * kind.size.mean_volume())
        };
        for fill in fills {
            let path = KeyPath::of(["fill", &fill.name]);
            let count = match &fill.seats {
                Seats::Points(points) => Some(points.len() as f64),
                Seats::Lattice { region, amount } | Seats::Deposit { region, amount } => {
                    self.sites(region, pellets.get(fill.pellets), &path.key("region"));
                    match *amount {
                        FillAmount::Count(count) => Some(count as f64),
                        FillAmount::Mass(mass) => mass_of(fill.pellets).map(|of_one| mass / of_one),
                    }
                }
            };
            self.amount(count, &path, "fewer or larger pellets");
        }
        for inlet in inlets {
            let seconds = inlet.end.min(end_time) - inlet.start;
            let count = match inlet.rate {
                Rate::Count(rate) => Some(rate * seconds),
                Rate::Mass(rate) => mass_of(inlet.pellets).map(|of_one| rate * seconds / of_one),
            };
            let path = KeyPath::of(["inlets", &inlet.name]);
            self.amount(
                count,
                &path,
                "a lower rate, a shorter time or larger pellets",
            );
        }
    }

    fn amount(&mut self, count: Option<f64>, path: &KeyPath, cure: &str) {
        if let Some(count) = count.filter(|&count| count > MOST_PELLETS) {
            let count = show((count / 1.0e5).round() * 1.0e5);
            let most = show(MOST_PELLETS);
            self.findings.add(
                path,
                format!("this is about {count} pellets; expected at most {most}: ask for {cure}"),
            );
        }
    }

    fn sites(&mut self, region: &Shape, kind: Option<&PelletKind>, path: &KeyPath) {
        let Bounds { min, max } = region.bounds();
        let Some(kind) = kind else { return };
        let sites = (max - min).product() / kind.size.max_diameter().powi(3);
        if sites.is_finite() && sites > MOST_SITES {
            self.findings.add(
                path,
                format!(
                    "the region has room for {} pellets; expected at most {}: make it smaller",
                    show(sites.round()),
                    show(MOST_SITES)
                ),
            );
        }
    }
}
