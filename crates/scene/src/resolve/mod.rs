//! The tables of a scene against each other: names to indices, shapes to solids, defaults to values.

mod domain;
mod feed;
mod fill;
mod material;
mod mesh;
mod meter;
mod motion;
mod run;
mod shape;
mod size;
mod wall;

use crate::expect::Expectations;
use crate::key_path::KeyPath;
use crate::mesh::MeshReport;
use crate::mistakes::{Findings, SceneError};
use crate::named::Named;
use crate::quantity::{Acceleration, Coordinate, Size, Velocity};
use crate::spec::SceneSpec;
use pelletflow_core::{UnitVector3, Vec3};
use pelletflow_sim::{RunPlan, Setup};
use std::path::Path;

pub(crate) use mesh::MeshFile;

/// A scene with its names resolved and its defaults filled in.
#[derive(Debug, Clone)]
pub(crate) struct Resolved {
    pub(crate) title: String,
    pub(crate) setup: Setup,
    pub(crate) plan: RunPlan,
    pub(crate) output: OutputOptions,
    pub(crate) strength: Option<Strength>,
    pub(crate) expectations: Expectations,
    /// What was chosen for the user, in sentences.
    pub(crate) notes: Vec<String>,
    /// Files that walls were made from, and what was found in them.
    pub(crate) files: Vec<MeshFile>,
    pub(crate) meshes: Vec<MeshReport>,
}

/// Why a scene could not be resolved.
#[derive(Debug)]
pub(crate) enum Unresolved {
    /// Its tables do not go together.
    Wrong(Findings),
    /// A file that it names could not be read.
    Unreadable(SceneError),
}

/// What is recorded, beside how often.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutputOptions {
    /// Number of pellets up to which they are recorded as spheres of true size [-].
    pub spheres_up_to: usize,
    /// Whether every contact is recorded in every frame.
    pub contacts: bool,
}

/// What a pellet withstands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// Normal force at which half of the pellets break [N].
    pub load: f64,
}

/// Turns a scene into a setup, or says what in it does not go together.
///
/// Files are sought in a directory.
pub(crate) fn resolve(
    spec: &SceneSpec,
    name: &str,
    directory: &Path,
) -> Result<Resolved, Unresolved> {
    let mut resolver = Resolver {
        spec,
        directory,
        files: Vec::new(),
        reports: Vec::new(),
        unreadable: None,
        findings: Findings::default(),
        notes: Vec::new(),
    };
    let resolved = resolver.scene(name);
    match resolver.unreadable {
        _ if !resolver.findings.is_empty() => Err(Unresolved::Wrong(resolver.findings)),
        Some(error) => Err(Unresolved::Unreadable(error)),
        None => Ok(resolved),
    }
}

/// What resolution works with; where something is wrong it notes that and goes on with a stand-in.
struct Resolver<'s> {
    spec: &'s SceneSpec,
    /// Where files of meshes are sought.
    directory: &'s Path,
    findings: Findings,
    notes: Vec<String>,
    files: Vec<MeshFile>,
    reports: Vec<MeshReport>,
    unreadable: Option<SceneError>,
}

impl Resolver<'_> {
    fn scene(&mut self, name: &str) -> Resolved {
        let spec = self.spec;
        let materials = self.materials();
        let pairs = self.pairs();
        let pellets = self.pellets();
        let walls = self.walls(&pellets);
        let fills = self.fills(&pellets);
        let inlets = self.inlets();
        let outlets = self.outlets();
        let meters = self.meters(&walls);
        self.amounts(&fills, &inlets, &materials, &pellets);
        let domain = self.domain(&walls, &fills, &inlets, &outlets);
        let title = match spec.scene.title.trim() {
            "" => name.to_owned(),
            title => title.to_owned(),
        };
        Resolved {
            title,
            plan: self.plan(),
            output: self.output(),
            strength: spec.strength.as_ref().map(|strength| Strength {
                load: strength.load.0,
            }),
            expectations: self.expectations(),
            setup: Setup {
                seed: spec.scene.seed,
                gravity: vector(spec.scene.gravity.map(|Acceleration(value)| value)),
                materials,
                pairs,
                pellets,
                laws: run::laws(&spec.contact),
                walls,
                fills,
                inlets,
                outlets,
                meters,
                domain,
                integrator: run::integrator(spec.time.integrator),
                step: self.step(),
                search: run::search(spec.contact.search),
                skin: spec.contact.skin.map(|Size(skin)| skin),
                limits: run::limits(&spec.limits),
                skips: run::skips(&spec.skip),
                instructions: None,
                hits: self.hits(),
            },
            notes: std::mem::take(&mut self.notes),
            files: std::mem::take(&mut self.files),
            meshes: std::mem::take(&mut self.reports),
        }
    }

    /// Position of a name in its table; 0 stands in for one that is not there.
    fn index<T>(&mut self, names: &Named<T>, name: &str, path: &KeyPath) -> usize {
        names.find(name).unwrap_or_else(|cure| {
            let what = path.last_key();
            self.findings
                .add(path, format!("unknown {what} `{name}`; {cure}"));
            0
        })
    }

    /// A direction of unit length; z stands in for one that has none.
    fn direction(&mut self, components: [f64; 3], path: &KeyPath) -> UnitVector3<f64> {
        UnitVector3::try_new(Vec3::from(components), f64::MIN_POSITIVE).unwrap_or_else(|| {
            let key = path.last_key();
            self.findings.add(
                path,
                format!("`{key}` is a zero vector; expected a direction, for example [0, 0, 1]"),
            );
            Vec3::z_axis()
        })
    }

    fn expectations(&mut self) -> Expectations {
        Expectations::resolve(&self.spec.expect, &mut self.findings)
    }
}

fn vector(components: [f64; 3]) -> Vec3 {
    Vec3::from(components)
}

fn point(coordinates: [Coordinate; 3]) -> Vec3 {
    vector(coordinates.map(|Coordinate(value)| value))
}

fn sides(sizes: [Size; 3]) -> Vec3 {
    vector(sizes.map(|Size(value)| value))
}

/// A velocity; at rest where none is given.
fn velocity(components: Option<[Velocity; 3]>) -> Vec3 {
    components.map_or_else(Vec3::zeros, |components| {
        vector(components.map(|Velocity(value)| value))
    })
}
