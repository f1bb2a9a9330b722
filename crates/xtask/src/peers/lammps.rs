//! Scripts for LAMMPS.

use super::code::Code;
use super::description::{Chute, Description, Place, Silo};
use super::log::{LEFT, MEASURE};
use super::race::{Floor, Length};

/// Damping of `gran/hertz/history` over effective mass [1/(m·s)].
///
/// It goes with another power of the overlap than the restitution asks for: at 1 m/s 0.52 is left of the speed, at 0.3 m/s 0.60.
const HERTZ_HISTORY_DAMPING: f64 = 3.6e6;

/// The script of a scene; it reads `pellets.data`.
pub(crate) fn script(code: Code, scene: &Description, floor: Floor, length: Length) -> String {
    let law = law(code, scene);
    let (boundary, walls) = match &scene.place {
        Place::Silo(silo) => ("f f f", silo_walls(scene, silo, &law)),
        Place::Chute(chute) => ("p p f", slope(scene, chute)),
        Place::Nothing {} => ("f f f", String::new()),
    };
    let pair = pair(code, &law);
    let open = match floor {
        Floor::Closed => "",
        Floor::Opens => "unfix floor\n",
    };
    let skin = scene.skin.unwrap_or(0.1 * scene.diameter);
    let Length { warm, steps } = length;
    format!(
        "units si
atom_style sphere
boundary {boundary}
newton off
comm_modify vel yes
processors * * 1
read_data pellets.data
neighbor {skin} bin
neigh_modify every 1 delay 0 check yes
{pair}timestep {step}
{walls}region above block INF INF INF INF 0 INF
variable all equal {all}
thermo_style custom step atoms ke
thermo_modify lost ignore norm no
thermo {steps}
run {warm}
print \"{MEASURE}\"
{open}run {steps}
variable left equal v_all-count(all,above)
print \"{LEFT} ${{left}}\"
",
        step = scene.time_step,
        all = "$(count(all))",
    )
}

/// Style and numbers of the law, as pairs and walls take them.
fn law(code: Code, scene: &Description) -> String {
    let Description {
        youngs_modulus,
        poisson_ratio,
        restitution,
        friction,
        ..
    } = scene;
    match (code, &scene.place) {
        (Code::LammpsHookeHistory, Place::Chute(chute)) => format!(
            "hooke/history {} {} {} {} {friction} 1",
            chute.normal_stiffness,
            chute.tangential_stiffness,
            chute.normal_damping,
            chute.tangential_damping
        ),
        (Code::LammpsGranular, _) => format!(
            "granular hertz/material {youngs_modulus} {restitution} {poisson_ratio} \
             tangential mindlin NULL 1.0 {friction} damping tsuji"
        ),
        _ => {
            let effective = youngs_modulus / (2.0 * (1.0 - poisson_ratio * poisson_ratio));
            let shear = youngs_modulus / (2.0 * (1.0 + poisson_ratio));
            let effective_shear = shear / (2.0 * (2.0 - poisson_ratio));
            format!(
                "hertz/history {} {} {HERTZ_HISTORY_DAMPING} {} {friction} 1",
                4.0 / 3.0 * effective,
                8.0 * effective_shear,
                HERTZ_HISTORY_DAMPING / 2.0
            )
        }
    }
}

fn pair(code: Code, law: &str) -> String {
    match (code, law.split_once(' ')) {
        (Code::LammpsGranular, Some((style, numbers))) => {
            format!("pair_style {style}\npair_coeff * * {numbers}\n")
        }
        _ => format!("pair_style gran/{law}\npair_coeff * *\n"),
    }
}

fn silo_walls(scene: &Description, silo: &Silo, law: &str) -> String {
    let Silo {
        radius,
        outlet_radius,
        cone_height,
    } = silo;
    format!(
        "region cone cone z 0 0 {outlet_radius} {radius} 0 {cone_height} side in open 1 open 2
region shaft cylinder z 0 0 {radius} {cone_height} INF side in open 1 open 2
fix weight all gravity {weight} vector 0 0 -1
fix motion all nve/sphere
fix cone all wall/gran/region {law} region cone
fix shaft all wall/gran/region {law} region shaft
fix floor all wall/gran {law} zplane 0.0 NULL
",
        weight = scene.weight(),
    )
}

/// Gravity along the slope, and the balls of its bottom, type 2, frozen.
fn slope(scene: &Description, chute: &Chute) -> String {
    format!(
        "group bottom type 2
group flow subtract all bottom
neigh_modify exclude group bottom bottom
fix weight all gravity {} chute {}
fix stay bottom freeze
fix motion flow nve/sphere
",
        scene.weight(),
        chute.angle
    )
}
