//! The pellet and the surface that arguments name.

use crate::args::hit::HitArguments;
use crate::exit::{Exit, Failure};
use pelletflow_core::Material;
use pelletflow_core::material::library::{LIBRARY, LibraryMaterial};

/// A pellet and the surface that it hits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hit {
    pub(crate) pellet: Material,
    pub(crate) diameter: f64,
    pub(crate) surface: Material,
    /// The surface's name in the library, with its friction and its restitution.
    pub(crate) onto: &'static LibraryMaterial,
    /// The pellet's name in the library, where its stiffness is from there.
    pub(crate) stiffness_from: Option<&'static LibraryMaterial>,
}

impl Hit {
    /// Puts the options over the values of the library.
    pub(crate) fn new(
        arguments: &HitArguments,
        default_pellet: Option<&str>,
    ) -> Result<Self, Failure> {
        let base = arguments
            .pellet
            .as_deref()
            .or(default_pellet)
            .map(|name| named("--pellet", name))
            .transpose()?;
        let onto = named("--onto", &arguments.onto)?;
        let from_base = |value: fn(&LibraryMaterial) -> f64| base.map(value);
        let poisson_ratio = given(
            "--poisson",
            arguments.poisson,
            from_base(|base| base.material.poisson_ratio),
        )?;
        let density = given(
            "--density",
            arguments.density,
            from_base(|base| base.material.density),
        )?;
        let youngs_modulus = match arguments.shear_modulus {
            Some(modulus) => {
                Material::from_shear_modulus(density, modulus, poisson_ratio).youngs_modulus
            }
            None => given(
                "--shear-modulus",
                arguments.youngs_modulus,
                from_base(|base| base.material.youngs_modulus),
            )?,
        };
        let is_own = arguments.shear_modulus.is_some() || arguments.youngs_modulus.is_some();
        let diameter = given(
            "--diameter",
            arguments.diameter,
            base.and_then(|base| base.diameter),
        )?;
        let surface_poisson = arguments
            .onto_poisson
            .unwrap_or(onto.material.poisson_ratio);
        let surface = match arguments.onto_shear_modulus {
            Some(modulus) => {
                Material::from_shear_modulus(onto.material.density, modulus, surface_poisson)
            }
            None => Material {
                poisson_ratio: surface_poisson,
                ..onto.material
            },
        };
        check_poisson("--poisson", poisson_ratio)?;
        check_poisson("--onto-poisson", surface_poisson)?;
        Ok(Self {
            pellet: Material {
                density,
                youngs_modulus,
                poisson_ratio,
            },
            diameter,
            surface,
            onto,
            stiffness_from: base.filter(|_| !is_own),
        })
    }
}

fn named(option: &str, name: &str) -> Result<&'static LibraryMaterial, Failure> {
    LibraryMaterial::named(name).ok_or_else(|| {
        let names: Vec<&str> = LIBRARY.iter().map(|material| material.name).collect();
        let cure = pelletflow_scene::instead(name, &names);
        bad_input(format!("unknown material `{name}` of {option}; {cure}"))
    })
}

fn given(option: &str, own: Option<f64>, from_library: Option<f64>) -> Result<f64, Failure> {
    own.or(from_library).ok_or_else(|| {
        bad_input(format!(
            "{option} is missing; give it, or a pellet of the library, for example --pellet fired-pellet"
        ))
    })
}

fn check_poisson(option: &str, ratio: f64) -> Result<(), Failure> {
    if ratio > -1.0 && ratio < 0.5 {
        return Ok(());
    }
    Err(bad_input(format!(
        "{option} is {ratio}; expected more than -1 and less than 0.5"
    )))
}

pub(crate) fn bad_input(message: String) -> Failure {
    Failure::new(Exit::BadInput, message)
}
