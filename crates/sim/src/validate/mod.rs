//! What makes a setup impossible: every mistake, each with its key.

mod feed;
mod motion;
pub(crate) mod periodic;

use crate::error::SetupError;
use crate::law_needs::{self, pairs_that_meet};
use crate::setup::Setup;
use crate::time_step::StepRequest;
use pelletflow_core::Vec3;

/// Every mistake of a setup.
pub(crate) fn mistakes(setup: &Setup) -> Vec<SetupError> {
    let mut found = Mistakes(Vec::new());
    found.contents(setup);
    found.materials(setup);
    found.pairs(setup);
    found.pellets(setup);
    found.walls(setup);
    found.fills(setup);
    for inlet in &setup.inlets {
        found.inlet(setup, inlet);
    }
    found.rest(setup);
    if found.0.is_empty() {
        found.0 = law_needs::missing(setup);
    }
    found.0
}

struct Mistakes(Vec<SetupError>);

impl Mistakes {
    fn add(&mut self, key: impl Into<String>, message: impl Into<String>) {
        self.0.push(SetupError::new(key, message));
    }

    /// Adds a mistake unless `holds`; `bound` completes "is …; expected …".
    fn expect(&mut self, holds: bool, key: String, value: f64, unit: &str, bound: &str) {
        if !holds {
            let unit = if unit.is_empty() {
                String::new()
            } else {
                format!(" {unit}")
            };
            self.add(key, format!("is {value}{unit}; expected {bound}"));
        }
    }

    fn contents(&mut self, setup: &Setup) {
        if setup.pellets.is_empty() {
            self.add(
                "pellets",
                "the scene has no pellets; add a table such as [pellets.ore]",
            );
        }
        if setup.fills.is_empty() && setup.inlets.is_empty() {
            self.add("scene", "nothing to simulate: the scene has neither a fill nor an inlet; add [fill.NAME] or [inlets.NAME]");
        }
        if !is_finite(setup.gravity) {
            self.add(
                "scene.gravity",
                "is not finite; expected three numbers in m/s²",
            );
        }
    }

    fn materials(&mut self, setup: &Setup) {
        for named in &setup.materials {
            let key = |field: &str| format!("materials.{}.{field}", named.name);
            let material = &named.material;
            let is_positive = |value: f64| value.is_finite() && value > 0.0;
            self.expect(
                is_positive(material.density),
                key("density"),
                material.density,
                "kg/m³",
                "more than 0",
            );
            let modulus = material.youngs_modulus;
            self.expect(
                is_positive(modulus),
                key("youngs_modulus"),
                modulus,
                "Pa",
                "more than 0",
            );
            let poisson = material.poisson_ratio;
            let is_possible = poisson > -1.0 && poisson < 0.5;
            self.expect(
                is_possible,
                key("poisson_ratio"),
                poisson,
                "",
                "more than -1 and less than 0.5",
            );
        }
    }

    fn pairs(&mut self, setup: &Setup) {
        for ([a, b], properties) in &setup.pairs {
            let names = [&setup.materials[*a].name, &setup.materials[*b].name];
            let key = |field: &str| format!("pairs.{}-{}.{field}", names[0], names[1]);
            let restitution = properties.restitution;
            let is_possible = restitution > 0.0 && restitution <= 1.0;
            self.expect(
                is_possible,
                key("restitution"),
                restitution,
                "",
                "more than 0 and at most 1",
            );
            let is_coefficient = |value: f64| value.is_finite() && value >= 0.0;
            self.expect(
                is_coefficient(properties.friction),
                key("friction"),
                properties.friction,
                "",
                "0 or more",
            );
            let rolling = properties.rolling_friction;
            self.expect(
                is_coefficient(rolling),
                key("rolling_friction"),
                rolling,
                "",
                "0 or more",
            );
            let damping = properties.rolling_damping;
            self.expect(
                is_coefficient(damping),
                key("rolling_damping"),
                damping,
                "",
                "0 or more",
            );
            for (field, value, unit) in [
                ("stiffness", properties.stiffness, "N/m"),
                ("yield_pressure", properties.yield_pressure, "Pa"),
                ("surface_energy", properties.surface_energy, "J/m²"),
            ] {
                if let Some(value) = value {
                    let is_positive = value.is_finite() && value > 0.0;
                    self.expect(is_positive, key(field), value, unit, "more than 0");
                }
            }
        }
        for [a, b] in pairs_that_meet(setup) {
            if setup.pair_properties(a, b).is_none() {
                let (a, b) = (&setup.materials[a].name, &setup.materials[b].name);
                self.add(
                    "pairs",
                    format!("the pair of `{a}` and `{b}` is missing; add [pairs.\"{a}-{b}\"] with restitution, friction and rolling_friction"),
                );
            }
        }
    }

    fn pellets(&mut self, setup: &Setup) {
        for kind in &setup.pellets {
            let key = format!("pellets.{}.diameter", kind.name);
            let (least, greatest) = (kind.size.min_diameter(), kind.size.max_diameter());
            self.expect(
                least.is_finite() && least > 0.0,
                key.clone(),
                least,
                "m",
                "more than 0",
            );
            if least > greatest || !greatest.is_finite() {
                self.add(key, format!("the smallest is {least} m and the largest {greatest} m; expected the smallest first"));
            } else if let Err(mistake) = kind.size.validate() {
                self.add(key, mistake);
            }
        }
    }

    fn walls(&mut self, setup: &Setup) {
        for wall in &setup.walls {
            let key = |field: &str| format!("walls.{}.{field}", wall.name);
            if let Err(error) = wall.shape.validate() {
                self.add(key("shape"), error.to_string());
            }
            if !is_finite(wall.surface_velocity) {
                self.add(
                    key("surface_velocity"),
                    "is not finite; expected three numbers in m/s",
                );
            }
            if wall.surface_velocity != Vec3::zeros()
                && let Some(kind) = wall.shape.curved_part()
            {
                self.add(
                    key("surface_velocity"),
                    format!(
                        "moves the surface of a {kind} along one straight line; expected a belt of plane faces, such as a box or \
                         a plate; let a round wall turn by `motion`, and make a pulley a wall of its own"
                    ),
                );
            }
            if let Some(message) = motion::mistake(&wall.motion) {
                self.add(key("motion"), message);
            }
            if !wall.schedule.changes().is_sorted_by(|a, b| a < b) {
                self.add(
                    key("schedule"),
                    "the moments do not rise; list them in order of time",
                );
            }
        }
    }

    fn rest(&mut self, setup: &Setup) {
        for outlet in &setup.outlets {
            self.outlet(setup, outlet);
        }
        for meter in &setup.meters {
            for (key, message) in meter.kind.mistakes(setup) {
                self.add(format!("meters.{}.{key}", meter.name), message);
            }
        }
        let bounds = &setup.domain.bounds;
        if !bounds.is_finite() || (bounds.max - bounds.min).min() <= 0.0 {
            self.add(
                "domain",
                "is not a box; expected finite corners, `min` below `max` on every axis",
            );
        }
        let (step, key, unit) = match setup.step {
            StepRequest::PeakForceError(error) => (error, "time.peak_force_error", ""),
            StepRequest::Fixed(step) | StepRequest::Unchecked(step) => (step, "time.step", "s"),
        };
        self.expect(
            step.is_finite() && step > 0.0,
            key.into(),
            step,
            unit,
            "more than 0",
        );
        if let Some(skin) = setup.skin {
            self.expect(
                skin.is_finite() && skin > 0.0,
                "contact.skin".into(),
                skin,
                "m",
                "more than 0",
            );
        }
        let limits = &setup.limits;
        let ratio = limits.overlap_ratio;
        self.expect(
            ratio > 0.0 && ratio < 1.0,
            "limits.overlap_ratio".into(),
            ratio,
            "",
            "more than 0 and less than 1",
        );
        let residual = limits.energy_residual;
        self.expect(
            residual > 0.0,
            "limits.energy_residual".into(),
            residual,
            "",
            "more than 0",
        );
    }
}

fn is_finite(vector: Vec3) -> bool {
    vector.iter().all(|value| value.is_finite())
}
