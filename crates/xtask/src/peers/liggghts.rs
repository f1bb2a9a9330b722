//! Script and hopper for LIGGGHTS.

use super::description::{Description, Silo};
use super::log::{LEFT, MEASURE};
use super::race::{Floor, Length};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Sides of the hopper; fewer push the bed about, many more are refused as slivers.
const SIDES: usize = 144;

/// The script of the silo; it reads `pellets.data` and `hopper.stl`.
pub(crate) fn script(scene: &Description, floor: Floor, length: Length) -> String {
    let skin = scene.skin.unwrap_or(0.1 * scene.diameter);
    let open = match floor {
        Floor::Closed => "",
        Floor::Opens => "unfix floor\n",
    };
    let Length { warm, steps } = length;
    format!(
        "units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
processors * * 1
read_data pellets.data
neighbor {skin} bin
neigh_modify delay 0
fix young all property/global youngsModulus peratomtype {youngs_modulus}
fix poisson all property/global poissonsRatio peratomtype {poisson_ratio}
fix restitution all property/global coefficientRestitution peratomtypepair 1 {restitution}
fix friction all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran model hertz tangential history
pair_coeff * *
timestep {step}
fix weight all gravity {weight} vector 0.0 0.0 -1.0
fix mesh all mesh/surface file hopper.stl type 1
fix hopper all wall/gran model hertz tangential history mesh n_meshes 1 meshes mesh
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix motion all nve/sphere
region above block INF INF INF INF 0 INF units box
variable now equal count(all)
variable all equal ${{now}}
thermo_style custom step atoms ke
thermo_modify lost ignore norm no
thermo {steps}
run {warm}
print \"{MEASURE}\"
{open}run {steps}
variable left equal ${{all}}-count(all,above)
print \"{LEFT} ${{left}}\"
",
        youngs_modulus = scene.youngs_modulus,
        poisson_ratio = scene.poisson_ratio,
        restitution = scene.restitution,
        friction = scene.friction,
        step = scene.time_step,
        weight = scene.weight(),
    )
}

/// Cone and shaft up to a height as triangles, in the text form of STL.
pub(crate) fn hopper(silo: &Silo, top: f64) -> String {
    let ring = |radius: f64, z: f64| -> Vec<[f64; 3]> {
        let corner = |side: usize| {
            let angle = TAU * side as f64 / SIDES as f64;
            [radius * angle.cos(), radius * angle.sin(), z]
        };
        (0..SIDES).map(corner).collect()
    };
    let rings = [
        ring(silo.outlet_radius, 0.0),
        ring(silo.radius, silo.cone_height),
        ring(silo.radius, top),
    ];
    let mut text = String::from("solid hopper\n");
    for band in rings.windows(2) {
        let (lower, upper) = (&band[0], &band[1]);
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            for triangle in [
                [lower[side], lower[next], upper[next]],
                [lower[side], upper[next], upper[side]],
            ] {
                text.push_str("facet normal 0 0 0\n outer loop\n");
                for [x, y, z] in triangle {
                    writeln!(text, "  vertex {x:.9} {y:.9} {z:.9}").expect("a string takes all");
                }
                text.push_str(" endloop\nendfacet\n");
            }
        }
    }
    text.push_str("endsolid hopper\n");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hopper_is_closed_round_about() {
        let silo = Silo {
            radius: 0.15,
            outlet_radius: 0.06,
            cone_height: 0.156,
        };
        let text = hopper(&silo, 1.0);
        assert_eq!(text.matches("endfacet").count(), 4 * SIDES);
        // Each corner of the cone's upper rim belongs to three triangles of the cone and three of the shaft.
        assert_eq!(
            text.matches("vertex 0.150000000 0.000000000 0.156000000\n")
                .count(),
            6
        );
    }
}
