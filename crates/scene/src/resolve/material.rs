//! Materials, their pairs, and the pellets made of them.

use super::Resolver;
use crate::key_path::KeyPath;
use crate::named::Named;
use crate::number::show;
use crate::quantity::{Density, Modulus};
use crate::spec::SceneSpec;
use crate::spec::material::{MaterialSpec, PairSpec};
use crate::suggest;
use pelletflow_core::{Material, PairProperties};
use pelletflow_sim::{NamedMaterial, PelletKind};
use std::collections::BTreeMap;

impl Resolver<'_> {
    pub(super) fn materials(&mut self) -> Vec<NamedMaterial> {
        let spec = self.spec;
        spec.materials
            .iter()
            .map(|(name, spec)| {
                let path = KeyPath::of(["materials", name]);
                let material = self.material(spec, &path);
                NamedMaterial {
                    name: name.to_owned(),
                    material,
                    true_youngs_modulus: self.true_youngs_modulus(spec, &material, &path),
                }
            })
            .collect()
    }

    fn material(&mut self, spec: &MaterialSpec, path: &KeyPath) -> Material {
        let Density(density) = spec.density;
        let poisson_ratio = spec.poisson_ratio;
        match (spec.youngs_modulus, spec.shear_modulus) {
            (None, Some(Modulus(shear_modulus))) => {
                Material::from_shear_modulus(density, shear_modulus, poisson_ratio)
            }
            (Some(Modulus(youngs_modulus)), None) => Material {
                density,
                youngs_modulus,
                poisson_ratio,
            },
            (youngs_modulus, _) => {
                let message = if youngs_modulus.is_some() {
                    "`youngs_modulus` and `shear_modulus` are both given; keep one, the other follows"
                } else {
                    "`youngs_modulus` or `shear_modulus` is missing; write for example `youngs_modulus = \"200 GPa\"`"
                };
                self.findings.add(path, message);
                Material {
                    density,
                    youngs_modulus: 1.0,
                    poisson_ratio,
                }
            }
        }
    }

    /// The modulus of the real body, which is no softer than the one computed with.
    fn true_youngs_modulus(
        &mut self,
        spec: &MaterialSpec,
        material: &Material,
        path: &KeyPath,
    ) -> Option<f64> {
        let Modulus(of_body) = spec.true_youngs_modulus?;
        let softened = material.youngs_modulus;
        if of_body < softened {
            let message = format!(
                "`true_youngs_modulus` is {} Pa; expected at least the {} Pa computed with: it is that of the real body, \
                 of which the other is a softer stand-in; swap the two, or leave it out",
                show(of_body),
                show(softened)
            );
            self.findings.add(&path.key("true_youngs_modulus"), message);
        }
        Some(of_body)
    }

    pub(super) fn pellets(&mut self) -> Vec<PelletKind> {
        let spec = self.spec;
        spec.pellets
            .iter()
            .map(|(name, pellet)| {
                let path = KeyPath::of(["pellets", name]);
                PelletKind {
                    name: name.to_owned(),
                    material: self.index(&spec.materials, &pellet.material, &path.key("material")),
                    size: self.size(&pellet.diameter, &path.key("diameter")),
                }
            })
            .collect()
    }

    pub(super) fn pairs(&mut self) -> Vec<([usize; 2], PairProperties)> {
        let spec = self.spec;
        let mut seen: BTreeMap<[usize; 2], &str> = BTreeMap::new();
        let mut pairs = Vec::new();
        for (name, pair) in spec.pairs.iter() {
            let path = KeyPath::of(["pairs", name]);
            let Some(indices) = materials_of_pair(name, &spec.materials) else {
                let known = pair_names(&spec.materials);
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                let cure = suggest::instead(name, &known);
                self.findings.add(
                    &path,
                    format!("`{name}` does not name two materials as \"A-B\"; {cure}"),
                );
                continue;
            };
            let mut sorted = indices;
            sorted.sort_unstable();
            if let Some(earlier) = seen.insert(sorted, name) {
                self.findings.add(
                    &path,
                    format!("`{name}` is the pair `{earlier}` once more; keep one of the two"),
                );
            }
            pairs.push((indices, properties(pair)));
        }
        for [a, b] in pairs_that_meet(spec) {
            let mut indices = [a, b].map(|name| spec.materials.find(name).unwrap_or_default());
            indices.sort_unstable();
            if !seen.contains_key(&indices) {
                self.findings.add(
                    &KeyPath::of(["pairs", &format!("{a}-{b}")]),
                    format!(
                        "missing pair: `{a}` and `{b}` can meet; add, with your values,\n[pairs.\"{a}-{b}\"]\nrestitution = \
                         0.4\nfriction = 0.5\nrolling_friction = 0.1"
                    ),
                );
            }
        }
        pairs
    }
}

/// Names of materials that can touch: of pellets with each other and with walls.
fn pairs_that_meet(spec: &SceneSpec) -> Vec<[&str; 2]> {
    let known = |name: &&str| spec.materials.find(name).is_ok();
    let of_pellets: Vec<&str> = spec
        .pellets
        .iter()
        .map(|(_, pellet)| pellet.material.as_str())
        .filter(known)
        .collect();
    let of_walls = spec.walls.iter().map(|(_, wall)| wall.material.as_str());
    let all: Vec<&str> = of_pellets
        .iter()
        .copied()
        .chain(of_walls.filter(known))
        .collect();
    let mut pairs: Vec<[&str; 2]> = Vec::new();
    for &pellet in &of_pellets {
        for &other in &all {
            if !pairs.contains(&[pellet, other]) && !pairs.contains(&[other, pellet]) {
                pairs.push([pellet, other]);
            }
        }
    }
    pairs
}

fn properties(pair: &PairSpec) -> PairProperties {
    PairProperties {
        restitution: pair.restitution,
        friction: pair.friction,
        rolling_friction: pair.rolling_friction,
        rolling_damping: pair
            .rolling_damping
            .unwrap_or(PairProperties::ELASTIC.rolling_damping),
        stiffness: pair.stiffness.map(|stiffness| stiffness.0),
        yield_pressure: pair.yield_pressure.map(|pressure| pressure.0),
        surface_energy: pair.surface_energy.map(|energy| energy.0),
    }
}

/// The two materials of `A-B`; a name may hold dashes itself, so every cut is tried.
fn materials_of_pair(name: &str, materials: &Named<MaterialSpec>) -> Option<[usize; 2]> {
    name.match_indices('-').find_map(|(dash, _)| {
        let first = materials.find(&name[..dash]).ok()?;
        let second = materials.find(&name[dash + 1..]).ok()?;
        Some([first, second])
    })
}

fn pair_names(materials: &Named<MaterialSpec>) -> Vec<String> {
    let names: Vec<&str> = materials.names().collect();
    let mut pairs = Vec::new();
    for (index, a) in names.iter().enumerate() {
        for b in &names[index..] {
            pairs.push(format!("{a}-{b}"));
        }
    }
    pairs
}
