//! Where pellets are and how they move, as a file: a first line that says what they are of, then `x y z vx vy vz` each.

use pelletflow::core::Vec3;
use pelletflow::sim::{Fill, Seats, Simulation};
use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::Path;

/// A pellet at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// Its center [m].
    pub(crate) position: Vec3,
    /// Its velocity [m/s].
    pub(crate) velocity: Vec3,
}

impl Place {
    pub(crate) fn at_rest(position: Vec3) -> Self {
        Self {
            position,
            velocity: Vec3::zeros(),
        }
    }
}

/// All pellets inside, in order of their numbers.
pub(crate) fn of(simulation: &Simulation) -> Vec<Place> {
    let mut all: Vec<_> = simulation.pellets().collect();
    all.sort_by_key(|pellet| pellet.id);
    all.iter()
        .map(|pellet| Place {
            position: pellet.position,
            velocity: pellet.velocity,
        })
        .collect()
}

/// Fills that put pellets there, one for each row of pellets with the same velocity.
pub(crate) fn fills(places: &[Place]) -> Vec<Fill> {
    places
        .chunk_by(|a, b| a.velocity == b.velocity)
        .enumerate()
        .map(|(index, alike)| Fill {
            name: format!("bed {index}"),
            pellets: 0,
            seats: Seats::Points(alike.iter().map(|place| place.position).collect()),
            velocity: alike[0].velocity,
            spin: Vec3::zeros(),
        })
        .collect()
}

pub(crate) fn write(path: &Path, first_line: &str, places: &[Place]) -> Result<(), String> {
    let fail = |error: std::io::Error| format!("cannot write {}: {error}", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(fail)?;
    }
    // Under another name until it is whole, so that a killed run leaves no half of it.
    let unfinished = path.with_extension("unfinished");
    let mut file = BufWriter::new(File::create(&unfinished).map_err(fail)?);
    writeln!(file, "{first_line}").map_err(fail)?;
    for Place { position, velocity } in places {
        writeln!(
            file,
            "{} {} {} {} {} {}",
            position.x, position.y, position.z, velocity.x, velocity.y, velocity.z
        )
        .map_err(fail)?;
    }
    file.flush().map_err(fail)?;
    std::fs::rename(&unfinished, path).map_err(fail)
}

/// The pellets of a file; none where there is no file, or its first line is another.
pub(crate) fn read(path: &Path, first_line: &str) -> Result<Option<Vec<Place>>, String> {
    let Ok(file) = File::open(path) else {
        return Ok(None);
    };
    let mut lines = BufReader::new(file).lines();
    let told = lines.next().and_then(Result::ok).unwrap_or_default();
    if told != first_line {
        return Ok(None);
    }
    lines
        .map(|line| {
            line.ok().as_deref().and_then(place).ok_or_else(|| {
                format!(
                    "{} holds a line that is no six numbers; remove the file",
                    path.display()
                )
            })
        })
        .collect::<Result<_, _>>()
        .map(Some)
}

fn place(line: &str) -> Option<Place> {
    let mut numbers = line.split(' ').map_while(|word| word.parse().ok());
    let mut vector = || Some(Vec3::new(numbers.next()?, numbers.next()?, numbers.next()?));
    Some(Place {
        position: vector()?,
        velocity: vector()?,
    })
}
