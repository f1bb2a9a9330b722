//! One timed run.

use crate::places;
use crate::request::Request;
use crate::scene::Scene;
use crate::{free, silo, start};
use pelletflow::core::{Bounds, InstructionSet, Shape, Vec3};
use pelletflow::sim::{NeighborSearch, Outlet, Schedule, Setup, Simulation, Skips};
use serde_json::{Value, json};
use std::time::Instant;

/// Speed beyond which a pellet moves [m/s].
const MOVING: f64 = 0.01;
/// Height below which a pellet that left the silo is counted but not followed any more [m].
const FOLLOWED_TO: f64 = -0.3;

/// Warms up, runs a number of steps and tells how long they took and what came of them.
pub(crate) fn run(scene: Scene, request: &Request) -> Result<Value, String> {
    let warm: u64 = request.number("warm", 0)?;
    let steps: u64 = request.number("steps", 1000)?;
    let threads: usize = request.number("threads", 1)?;
    let mut setup = scene.setup();
    match request.text("floor").unwrap_or("closed") {
        "closed" => {}
        "opens" => open_floor(&mut setup, warm)?,
        other => {
            return Err(format!(
                "`floor={other}` is unknown; expected closed or opens"
            ));
        }
    }
    match request.text("path").unwrap_or("usual") {
        "usual" => {}
        "reference" => take_reference_path(scene, &mut setup),
        other => {
            return Err(format!(
                "`path={other}` is unknown; expected usual or reference"
            ));
        }
    }
    let gravity = setup.gravity;
    setup.fills = places::fills(&start::pellets(scene, &request.folder()?)?);
    let mut simulation = silo::simulation(setup, threads);
    let pellets = simulation.pellet_count();
    let fail = |error| format!("the run failed: {error}");
    simulation.advance(warm).map_err(fail)?;
    let began = Instant::now();
    simulation.advance(steps).map_err(fail)?;
    let seconds = began.elapsed().as_secs_f64();
    if let Some(path) = request.path("out") {
        places::write(&path, "", &places::of(&simulation))?;
    }
    let flight_error = (scene == Scene::Free).then(|| {
        let pellet = simulation.pellets().next();
        pellet.map_or(f64::NAN, |pellet| {
            free::error(pellet.position, simulation.time(), gravity)
        })
    });
    let ledger = simulation.energy_ledger();
    Ok(json!({
        "pellets": pellets,
        "steps": steps,
        "seconds": seconds,
        "kinetic": kinetic(&simulation),
        "moving": share_moving(&simulation),
        "left": left(&simulation),
        "residual": ledger.residual / ledger.throughput,
        "coordination": simulation.contact_statistics().mean_coordination,
        "hash": simulation.state_hash(),
        "peak_memory": peak_memory(),
        "flight_error": flight_error,
    }))
}

/// Takes the floor away after a number of steps.
fn open_floor(setup: &mut Setup, warm: u64) -> Result<(), String> {
    let floor = setup
        .walls
        .iter_mut()
        .find(|wall| wall.name == "floor")
        .ok_or("this scene has no floor to open")?;
    floor.schedule = Schedule::opening_at(vec![(warm as f64 - 0.5) * silo::TIME_STEP]);
    let bounds = &mut setup.domain.bounds;
    let depth = 0.3;
    bounds.min.z = FOLLOWED_TO - depth;
    let below = Bounds {
        max: Vec3::new(bounds.max.x, bounds.max.y, FOLLOWED_TO),
        ..*bounds
    };
    setup.outlets.push(Outlet {
        name: "below".into(),
        region: Shape::Cuboid {
            half_sides: (below.max - below.min) / 2.0,
        }
        .translated((below.max + below.min) / 2.0),
    });
    Ok(())
}

/// Nothing left out, and neighbors found in the plainest way there is time for.
fn take_reference_path(scene: Scene, setup: &mut Setup) {
    setup.skips = Skips {
        rotation: false,
        distant_walls: false,
        free_flight: false,
    };
    setup.instructions = Some(InstructionSet::Baseline);
    setup.search = match scene {
        Scene::Silo { pellets, .. } if pellets <= 10_000 => NeighborSearch::AllPairs,
        _ => NeighborSearch::Tree,
    };
}

/// Energy of motion without spin [J]: what other codes report.
fn kinetic(simulation: &Simulation) -> f64 {
    simulation
        .pellets()
        .map(|pellet| 0.5 * pellet.mass * pellet.velocity.norm_squared())
        .sum()
}

fn share_moving(simulation: &Simulation) -> f64 {
    let moving = simulation
        .pellets()
        .filter(|pellet| pellet.velocity.norm() > MOVING)
        .count();
    moving as f64 / simulation.pellet_count().max(1) as f64
}

/// Pellets below the outlet or gone [-].
fn left(simulation: &Simulation) -> u64 {
    let below = simulation
        .pellets()
        .filter(|pellet| pellet.position.z < 0.0)
        .count();
    below as u64 + simulation.mass_ledger().discharged.count
}

/// Greatest memory of this process so far [B], where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().trim_end_matches(" kB").parse().ok()?;
    Some(1024 * kilobytes)
}
