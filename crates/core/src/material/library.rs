//! Named materials to start from, each with where its numbers come from.
//!
//! A value of one's own is better than any of these: the moduli of pellets span two powers of ten.

use super::Material;

/// A material with a name, its spread and its source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LibraryMaterial {
    /// Name, in lower case with dashes.
    pub name: &'static str,
    /// What it is.
    pub description: &'static str,
    /// The values to start from.
    pub material: Material,
    /// Least and greatest Young's modulus that are plausible for it [Pa].
    pub youngs_modulus_range: [f64; 2],
    /// Diameter to start from, where the material is that of pellets [m].
    pub diameter: Option<f64>,
    /// Restitution against a pellet to start from, where there is one [-].
    pub restitution: Option<f64>,
    /// Friction against a pellet to start from, where there is one [-].
    pub friction: Option<f64>,
    /// Where the numbers come from; it says so where that is an assumption.
    pub source: &'static str,
}

impl LibraryMaterial {
    /// The material of a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        LIBRARY.iter().find(|material| material.name == name)
    }
}

/// All named materials, pellets first.
pub const LIBRARY: [LibraryMaterial; 6] = [
    LibraryMaterial {
        name: "fired-pellet",
        description: "hardened iron-ore pellet",
        material: Material {
            density: 3800.0,
            youngs_modulus: 2.0e9,
            poisson_ratio: 0.25,
        },
        youngs_modulus_range: [0.2e9, 20.0e9],
        diameter: Some(0.012),
        restitution: Some(0.5),
        friction: Some(0.6),
        source: "assumed, no single measurement: density of 3500 to 4200 kg/m3, Young's modulus of 0.2 to 20 GPa, its \
                 geometric mean chosen, Poisson's ratio of 0.2 to 0.3; pellet on pellet: friction of 0.4 to 0.8",
    },
    LibraryMaterial {
        name: "papers-pellet",
        description: "iron-ore pellet of the paper",
        material: Material {
            density: 3700.0,
            youngs_modulus: 146.4e6,
            poisson_ratio: 0.22,
        },
        youngs_modulus_range: [24.4e6, 366.0e6],
        diameter: Some(0.015),
        restitution: None,
        friction: None,
        source: "the paper, figures 2 to 7: diameter 15 mm, shear modulus 60 MPa (10 to 150 MPa in its figure 6), \
                 Poisson's ratio 0.22; it gives no density: 3700 kg/m3 assumed",
    },
    LibraryMaterial {
        name: "green-pellet",
        description: "wet iron-ore pellet before firing",
        material: Material {
            density: 3500.0,
            youngs_modulus: 10.0e6,
            poisson_ratio: 0.25,
        },
        youngs_modulus_range: [1.0e6, 100.0e6],
        diameter: Some(0.012),
        restitution: None,
        friction: None,
        source: "assumed order of magnitude, no measurement: Young's modulus of 1 to 100 MPa, its geometric mean \
                 chosen; green pellets yield rather than rebound, so an elastic force is far too large",
    },
    LibraryMaterial {
        name: "steel",
        description: "structural steel",
        material: Material {
            density: 7850.0,
            youngs_modulus: 207.36e9,
            poisson_ratio: 0.28,
        },
        youngs_modulus_range: [200.0e9, 215.0e9],
        diameter: None,
        restitution: Some(0.5),
        friction: Some(0.45),
        source: "the paper: shear modulus 81 GPa, Poisson's ratio 0.28; density: EN 1991-1-1:2002, table A.4; against \
                 a pellet assumed: restitution of 0.4 to 0.6, friction of 0.3 to 0.6, their middles",
    },
    LibraryMaterial {
        name: "rubber",
        description: "rubber liner",
        material: Material {
            density: 1100.0,
            youngs_modulus: 4.5e6,
            poisson_ratio: 0.49,
        },
        youngs_modulus_range: [2.0e6, 10.0e6],
        diameter: None,
        restitution: None,
        friction: None,
        source: "assumed: liner rubbers of 50 to 70 Shore A have a Young's modulus of 2 to 10 MPa, its geometric mean \
                 chosen; thick enough to feel no backing, which a hard hit may not find",
    },
    LibraryMaterial {
        name: "concrete",
        description: "normal concrete C30/37",
        material: Material {
            density: 2400.0,
            youngs_modulus: 33.0e9,
            poisson_ratio: 0.2,
        },
        youngs_modulus_range: [27.0e9, 37.0e9],
        diameter: None,
        restitution: None,
        friction: None,
        source: "EN 1992-1-1:2004, table 3.1 (27 to 37 GPa from C12/15 to C50/60) and section 3.1.3; density: \
                 EN 1991-1-1:2002, table A.1",
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_material_is_found_by_its_name_and_lies_in_its_own_range() {
        for entry in &LIBRARY {
            assert_eq!(LibraryMaterial::named(entry.name), Some(entry));
            let [least, greatest] = entry.youngs_modulus_range;
            let modulus = entry.material.youngs_modulus;
            assert!(least < modulus && modulus < greatest, "{}", entry.name);
            assert!((-1.0..0.5).contains(&entry.material.poisson_ratio));
            assert!(entry.material.density > 1000.0);
            assert!(!entry.source.is_empty() && !entry.source.contains("  "));
        }
        assert_eq!(LibraryMaterial::named("stel"), None);
    }

    #[test]
    fn the_papers_materials_have_the_papers_shear_moduli() {
        for (name, shear_modulus) in [("papers-pellet", 60.0e6), ("steel", 81.0e9)] {
            let entry = LibraryMaterial::named(name).expect("in the library");
            assert!((entry.material.shear_modulus() / shear_modulus - 1.0).abs() < 1.0e-12);
        }
    }
}
