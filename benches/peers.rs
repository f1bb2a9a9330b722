//! The settled silo side by side with LIGGGHTS, on one thread, from the same positions, in one run.
//!
//! Same law (Hertz with restitution, Mindlin's history, no rolling), same step, same skin. Each round runs one after
//! the other, so that what else the machine does falls on both; the median of the rounds' ratios is what counts.
//! `cargo bench --bench peers [-- ROUNDS]`; needs `liggghts` on the path (Debian: `apt-get install liggghts`).

#![expect(clippy::print_stdout, reason = "a comparison is printed")]

mod silo;

use pelletflow::core::Vec3;
use pelletflow::sim::Integrator;
use silo::{DIAMETER, OUTLET_RADIUS, TIME_STEP};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const PELLETS: usize = 10_000;
const RADIUS: f64 = 0.15;
const WARM_STEPS: u64 = 500;
const STEPS: u64 = 1000;
/// Sides of the hopper that LIGGGHTS is given; fewer push the bed about, many more it refuses.
const SIDES: usize = 144;

/// What one code did with the bed.
struct Measured {
    /// Million particle-steps per second.
    speed: f64,
    /// Kinetic energy at the end [J]: what is left of the motion of a bed at rest.
    kinetic: f64,
}

fn main() {
    let rounds: usize = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(5);
    if Command::new("liggghts")
        .args(["-help", "-log", "none"])
        .output()
        .is_err()
    {
        println!("liggghts is not on the path; on Debian: apt-get install liggghts");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    println!("settling {PELLETS} pellets ...");
    let positions = silo::settled_positions(PELLETS, RADIUS);
    write_inputs(folder.path(), &positions);

    println!("round   pelletflow   LIGGGHTS   ratio   (million particle-steps/s, one thread)");
    let mut ratios = Vec::new();
    for round in 1..=rounds {
        let ours = run_pelletflow(&positions);
        let theirs = run_liggghts(folder.path());
        let ratio = ours.speed / theirs.speed;
        println!(
            "{round:>5}   {:>10.2}   {:>8.2}   {ratio:>5.2}   kinetic energy {:.1e} J, {:.1e} J",
            ours.speed, theirs.speed, ours.kinetic, theirs.kinetic
        );
        ratios.push(ratio);
    }
    ratios.sort_by(f64::total_cmp);
    println!(
        "median ratio {:.2} (target 1.00), from {:.2} to {:.2}",
        ratios[rounds / 2],
        ratios[0],
        ratios[rounds - 1]
    );
}

fn run_pelletflow(positions: &[Vec3]) -> Measured {
    let mut simulation = silo::from_positions(positions, RADIUS, Integrator::default(), 1);
    simulation.advance(WARM_STEPS).expect("the bed rests");
    let start = Instant::now();
    simulation.advance(STEPS).expect("the bed rests");
    Measured {
        speed: speed(start.elapsed().as_secs_f64()),
        kinetic: simulation.energy_ledger().kinetic,
    }
}

fn run_liggghts(folder: &Path) -> Measured {
    let output = Command::new("liggghts")
        .args(["-in", "silo.in", "-log", "silo.log"])
        .current_dir(folder)
        .output()
        .expect("liggghts starts");
    let log = fs::read_to_string(folder.join("silo.log")).unwrap_or_default();
    let measured = log.rsplit("MEASURE").next().unwrap_or_default();
    let seconds = measured.lines().find_map(|line| {
        line.strip_prefix("Loop time of ")?
            .split_whitespace()
            .next()?
            .parse()
            .ok()
    });
    let kinetic = measured
        .lines()
        .take_while(|line| !line.starts_with("Loop time"))
        .filter_map(|line| line.split_whitespace().nth(2)?.parse().ok())
        .last();
    let (Some(seconds), Some(kinetic)) = (seconds, kinetic) else {
        panic!(
            "liggghts gave no time; its log ends: {}\n{}",
            tail(&log),
            String::from_utf8_lossy(&output.stderr)
        );
    };
    Measured {
        speed: speed(seconds),
        kinetic,
    }
}

fn speed(seconds: f64) -> f64 {
    (PELLETS as u64 * STEPS) as f64 / seconds / 1.0e6
}

fn tail(text: &str) -> &str {
    let start = text
        .char_indices()
        .rev()
        .nth(400)
        .map_or(0, |(index, _)| index);
    &text[start..]
}

fn write_inputs(folder: &Path, positions: &[Vec3]) {
    let top = positions
        .iter()
        .map(|position| position.z)
        .fold(0.0, f64::max)
        + 0.1;
    let side = RADIUS + 0.02;
    let mut data = format!(
        "settled silo\n\n{} atoms\n1 atom types\n\n{} {side} xlo xhi\n{} {side} ylo yhi\n-0.3 {top} zlo zhi\n\nAtoms\n\n",
        positions.len(),
        -side,
        -side
    );
    for (index, position) in positions.iter().enumerate() {
        let (x, y, z) = (position.x, position.y, position.z);
        writeln!(data, "{} 1 {DIAMETER} 3700 {x} {y} {z}", index + 1).expect("a string takes all");
    }
    let inputs = [
        ("silo.data", data),
        ("hopper.stl", hopper(top)),
        ("silo.in", script()),
    ];
    for (name, text) in inputs {
        fs::write(folder.join(name), text).expect("the temporary folder can be written");
    }
}

/// Cone and cylinder as triangles in the text form of STL.
fn hopper(top: f64) -> String {
    let ring = |radius: f64, z: f64| -> Vec<[f64; 3]> {
        let corner = |side: usize| {
            let angle = TAU * side as f64 / SIDES as f64;
            [radius * angle.cos(), radius * angle.sin(), z]
        };
        (0..SIDES).map(corner).collect()
    };
    let cone_top = silo::cone_height(RADIUS);
    let rings = [
        ring(OUTLET_RADIUS, 0.0),
        ring(RADIUS, cone_top),
        ring(RADIUS, top),
    ];
    let mut text = String::from("solid hopper\n");
    for band in rings.windows(2) {
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            let (lower, upper) = (&band[0], &band[1]);
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

fn script() -> String {
    let skin = 0.1 * DIAMETER;
    format!(
        "units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
read_data silo.data
neighbor {skin} bin
neigh_modify delay 0
fix young all property/global youngsModulus peratomtype 1.464e8
fix poisson all property/global poissonsRatio peratomtype 0.22
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.5
fix friction all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep {TIME_STEP}
fix weight all gravity 9.81 vector 0.0 0.0 -1.0
fix mesh all mesh/surface file hopper.stl type 1
fix hopper all wall/gran model hertz tangential history mesh n_meshes 1 meshes mesh
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix motion all nve/sphere
thermo_style custom step atoms ke
thermo 250
thermo_modify lost ignore norm no
run {WARM_STEPS}
print \"MEASURE\"
run {STEPS}
"
    )
}
