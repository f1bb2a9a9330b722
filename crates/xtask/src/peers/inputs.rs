//! Input files of a scene for LAMMPS and LIGGGHTS.

use super::code::{Code, Program};
use super::description::{Description, Place};
use super::race::{Floor, Length};
use super::{lammps, liggghts};
use anyhow::{Context, Result};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// How far the box reaches beyond the shaft and above the pellets, in diameters [-].
const CLEARANCE: f64 = 3.0;
/// Where the box of a silo ends below: pellets are followed to there [m].
const LOWEST: f64 = -0.3;

/// A scene as other codes read it.
pub(crate) struct Inputs {
    pub(crate) folder: PathBuf,
    pub(crate) scene: Description,
    /// Pellets that move [-].
    pub(crate) pellets: usize,
}

/// A pellet's center and velocity.
type Row = [f64; 6];

impl Inputs {
    /// Writes what all codes read of a scene, from the pellets that `places` holds.
    pub(crate) fn write(folder: PathBuf, scene: Description, places: &Path) -> Result<Self> {
        let text = fs::read_to_string(places)
            .with_context(|| format!("cannot read {}", places.display()))?;
        let rows: Vec<Row> = text.lines().filter_map(row).collect();
        let top = rows.iter().map(|row| row[2]).fold(0.0, f64::max) + CLEARANCE * scene.diameter;
        let inputs = Self {
            pellets: rows.len(),
            folder,
            scene,
        };
        if let Place::Silo(silo) = &inputs.scene.place {
            inputs.put("hopper.stl", &liggghts::hopper(silo, top))?;
        }
        inputs.put("pellets.data", &data(&inputs.scene, &rows, top))?;
        Ok(inputs)
    }

    /// Writes the script of a code and gives its name.
    pub(crate) fn script(&self, code: Code, floor: Floor, length: Length) -> Result<String> {
        let script = match code.program() {
            Program::Lammps => lammps::script(code, &self.scene, floor, length),
            Program::Liggghts => liggghts::script(&self.scene, floor, length),
        };
        let name = format!("{}.in", code.file_stem());
        self.put(&name, &script)?;
        Ok(name)
    }

    fn put(&self, name: &str, text: &str) -> Result<()> {
        let path = self.folder.join(name);
        fs::create_dir_all(&self.folder)
            .and_then(|()| fs::write(&path, text))
            .with_context(|| format!("cannot write {}", path.display()))
    }
}

fn row(line: &str) -> Option<Row> {
    let numbers: Vec<f64> = line
        .split(' ')
        .map_while(|word| word.parse().ok())
        .collect();
    numbers.try_into().ok()
}

/// The file of pellets, and of the balls of a bottom.
fn data(scene: &Description, rows: &[Row], top: f64) -> String {
    let (balls, ranges) = match &scene.place {
        Place::Silo(silo) => {
            let side = silo.radius + CLEARANCE * scene.diameter;
            (&[][..], [[-side, side], [-side, side], [LOWEST, top]])
        }
        Place::Chute(chute) => {
            let [low, high] = scene.bounds;
            let across = [0, 1].map(|axis| [low[axis], high[axis]]);
            (&chute.balls[..], [across[0], across[1], [low[2], high[2]]])
        }
        Place::Nothing {} => {
            let [low, high] = scene.bounds;
            (&[][..], [0, 1, 2].map(|axis| [low[axis], high[axis]]))
        }
    };
    let types = if balls.is_empty() { 1 } else { 2 };
    let mut text = format!(
        "pellets\n\n{} atoms\n{types} atom types\n\n",
        rows.len() + balls.len()
    );
    let mut add = |line: std::fmt::Arguments| {
        text.write_fmt(line).expect("a string takes all");
    };
    for (axis, [low, high]) in ["x", "y", "z"].into_iter().zip(ranges) {
        add(format_args!("{low} {high} {axis}lo {axis}hi\n"));
    }
    add(format_args!("\nAtoms\n\n"));
    let Description {
        diameter, density, ..
    } = scene;
    let flowing = rows.iter().map(|[x, y, z, ..]| (1, [x, y, z]));
    let frozen = balls.iter().map(|[x, y, z]| (2, [x, y, z]));
    for (index, (kind, [x, y, z])) in flowing.chain(frozen).enumerate() {
        add(format_args!(
            "{} {kind} {diameter} {density} {x} {y} {z}\n",
            index + 1
        ));
    }
    add(format_args!("\nVelocities\n\n"));
    let velocities = rows.iter().map(|[.., u, v, w]| [*u, *v, *w]);
    let still = balls.iter().map(|_| [0.0; 3]);
    for (index, [u, v, w]) in velocities.chain(still).enumerate() {
        add(format_args!("{} {u} {v} {w} 0 0 0\n", index + 1));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pellets_keep_their_places_and_velocities() {
        let scene: Description = serde_json::from_value(serde_json::json!({
            "diameter": 0.015, "density": 3700.0, "youngs_modulus": 1.0e8, "poisson_ratio": 0.2, "restitution": 0.5,
            "friction": 0.5, "time_step": 2.0e-5, "skin": null, "gravity": [0.0, 0.0, -9.81],
            "box": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]],
            "place": { "radius": 0.15, "outlet_radius": 0.06, "cone_height": 0.156 },
        }))
        .expect("a scene");
        assert!(matches!(scene.place, Place::Silo(_)));
        let rows = [row("0.1 0.2 0.3 0 0 -1").expect("six numbers")];
        let text = data(&scene, &rows, 0.4);
        assert!(
            text.contains("\nAtoms\n\n1 1 0.015 3700 0.1 0.2 0.3\n"),
            "{text}"
        );
        assert!(text.contains("\nVelocities\n\n1 0 0 -1 0 0 0\n"), "{text}");
        assert_eq!(row("# silo"), None);
    }
}
