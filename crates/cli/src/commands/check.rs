//! `pelletflow check`.

mod walls;

use crate::args::CheckArguments;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, bytes, count, number, span};
use pelletflow_log::WORST_HITS;
use pelletflow_scene::{MeshReport, Scene};
use pelletflow_sim::{Simulation, WallTrials};
use serde_json::{Value, json};

/// Pellet steps per second and core: of a packed bed on an old computer, and of a loose flow on a new one [1/s].
const SPEED: [f64; 2] = [1.0e6, 6.0e6];

/// Memory per pellet with its contacts and neighbors, and of the program itself [B].
const MEMORY_PER_PELLET: f64 = 1.0e3;
/// What its contacts take beside, where they are recorded: kept by the step, and copied in three frames [B].
const MEMORY_OF_CONTACTS: f64 = 1.2e3;
const MEMORY_AT_REST: f64 = 3.0e7;

/// What a recording takes of a pellet in a frame, compressed: in a dense flow, all channels but the spheres and contacts,
/// the spheres, and its contacts [B].
const BYTES_OF_PELLET: f64 = 12.0;
const BYTES_OF_SPHERE: f64 = 30.0;
const BYTES_OF_CONTACTS: f64 = 40.0;

/// Validates a scene and shows what a run will do.
pub(crate) fn check(arguments: &CheckArguments) -> Result<Exit, Failure> {
    let scene = Scene::read(&arguments.scene, &arguments.set)?;
    // Placing the fills tells whether they fit.
    let simulation = Simulation::new(scene.model.clone(), 0)
        .map_err(|errors| Failure::from(scene.locate(&errors)))?;
    let forecast = Forecast::new(&scene, &simulation);
    let trials = if arguments.walls {
        let trials = WallTrials::run(&scene.model);
        Some(trials.map_err(|error| Failure::new(Exit::Failed, error.to_string()))?)
    } else {
        None
    };
    if arguments.json {
        let mut json = forecast.json(&scene);
        if let Some(trials) = trials {
            json["walls"] = trials.iter().map(walls::json).collect();
        }
        screen::json(&json)?;
    } else {
        let tried = trials.map(|trials| format!("\n\n{}", walls::page(&scene, &trials)));
        screen::result(&(forecast.page(&scene) + &tried.unwrap_or_default()))?;
    }
    Ok(Exit::Done)
}

/// A number of things, with the plural where it is due.
fn numbered(what: &str, number: usize) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {what}{plural}")
}

/// What a run will do.
struct Forecast {
    filled: f64,
    fed: f64,
    steps: f64,
    frames: f64,
    /// Frames that stay in the recording at most [-]; none where all do.
    kept_frames: Option<f64>,
    /// What a frame takes [B].
    frame_bytes: f64,
    threads: usize,
    memory: f64,
    /// At the most and at the least [s].
    wall_time: [f64; 2],
    skipped: Vec<[String; 2]>,
}

impl Forecast {
    fn new(scene: &Scene, simulation: &Simulation) -> Self {
        let end_time = scene.plan.end_time;
        let filled = simulation.pellet_count() as f64;
        let fed = scene.model.fed_until(end_time);
        let steps = (end_time / scene.model.time_step().seconds).ceil();
        let threads = simulation.threads();
        // As if none left: fed pellets are there for half of the time on average.
        let pellets = filled + fed / 2.0;
        let particle_steps = steps * pellets;
        let frames = frames_within(end_time, scene);
        Self {
            filled,
            fed,
            steps,
            frames,
            kept_frames: kept_frames(scene).map(|kept| kept.min(frames)),
            frame_bytes: pellets * bytes_of_pellet(scene, pellets),
            threads,
            memory: MEMORY_AT_REST + memory_per_pellet(scene) * (filled + fed),
            wall_time: SPEED.map(|speed| particle_steps / (speed * threads as f64)),
            skipped: simulation
                .skipped()
                .into_iter()
                .map(|skipped| [skipped.what.to_owned(), skipped.reason])
                .collect(),
        }
    }

    fn page(&self, scene: &Scene) -> String {
        let step = scene.model.time_step();
        let setup = &scene.setup;
        let mut facts = vec![
            ("pellets at the start".to_owned(), count(self.filled as u64)),
            ("pellets fed at most".into(), count(self.fed as u64)),
            (
                "equipment".into(),
                [
                    ("wall", setup.walls.len()),
                    ("inlet", setup.inlets.len()),
                    ("outlet", setup.outlets.len()),
                    ("meter", setup.meters.len()),
                ]
                .map(|(what, number)| numbered(what, number))
                .join(", "),
            ),
            (
                "simulated time".into(),
                format!("{} s at most", number(scene.plan.end_time)),
            ),
            (
                "time step".into(),
                format!("{}: {}", span(step.seconds), step.reason),
            ),
            (
                "fastest hit expected".into(),
                format!("{} m/s", number(step.expected_speed)),
            ),
            ("steps".into(), count(self.steps as u64)),
            ("frames recorded".into(), self.recorded(self.frames)),
            ("threads".into(), self.threads.to_string()),
            (
                "memory".into(),
                format!("about {}", bytes(self.memory as u64)),
            ),
            (
                "run time".into(),
                format!(
                    "{} to {}, by a rule of thumb as if no pellet left",
                    span(self.wall_time[1]),
                    span(self.wall_time[0])
                ),
            ),
        ];
        if let Some(kept) = self.kept_frames {
            facts.push((
                "frames kept at the end".into(),
                format!("at most {}", self.recorded(kept)),
            ));
        }
        for mesh in &scene.meshes {
            facts.push((format!("mesh of `{}`", mesh.wall), mesh.summary()));
            if let Some(bake) = mesh.bake {
                facts.push((format!("baked mesh of `{}`", mesh.wall), bake.summary()));
            }
            for warning in mesh.warnings() {
                facts.push((format!("warning: mesh of `{}`", mesh.wall), warning));
            }
        }
        for [what, reason] in &self.skipped {
            facts.push((format!("will skip: {what}"), reason.clone()));
        }
        for note in &scene.notes {
            let (what, choice) = note.split_once(": ").unwrap_or(("note", note));
            facts.push((what.to_owned(), choice.to_owned()));
        }
        format!("{}: no mistakes\n\n{}", scene.title, table::facts(facts))
    }

    /// A number of frames, and what they take.
    fn recorded(&self, frames: f64) -> String {
        format!(
            "{}, about {}",
            count(frames as u64),
            bytes((frames * self.frame_bytes) as u64)
        )
    }

    fn json(&self, scene: &Scene) -> Value {
        let step = scene.model.time_step();
        let bounds = &scene.setup.domain.bounds;
        let skipped: Vec<Value> = self
            .skipped
            .iter()
            .map(|[what, reason]| json!({ "what": what, "reason": reason }))
            .collect();
        json!({
            "scene": scene.name,
            "title": scene.title,
            "scene_hash": scene.hash,
            "bodies": { "filled": self.filled, "fed_at_most": self.fed.floor() },
            "time": {
                "end_s": scene.plan.end_time,
                "step_s": step.seconds,
                "step_reason": step.reason,
                "steps": self.steps,
                "expected_speed_m_per_s": step.expected_speed,
            },
            "frames": self.frames,
            "frames_kept_at_most": self.kept_frames.unwrap_or(self.frames),
            "threads": self.threads,
            "expected": {
                "memory_bytes": self.memory,
                "recording_bytes": self.frame_bytes * self.kept_frames.unwrap_or(self.frames),
                "recording_bytes_before_the_end": self.frame_bytes * self.frames,
                "wall_least_s": self.wall_time[1],
                "wall_most_s": self.wall_time[0],
            },
            "domain": { "min_m": bounds.min.as_slice(), "max_m": bounds.max.as_slice() },
            "meshes": scene.meshes.iter().map(mesh_json).collect::<Vec<_>>(),
            "skipped": skipped,
            "notes": scene.notes,
        })
    }
}

fn mesh_json(mesh: &MeshReport) -> Value {
    let rim = mesh
        .largest_rim
        .map(|rim| json!({ "center_m": rim.center.as_slice(), "size_m": rim.size }));
    let bake = mesh.bake.map(|bake| {
        json!({
            "spacing_m": bake.spacing,
            "memory_bytes": bake.bytes,
            "greatest_deviation_m": bake.greatest,
            "greatest_deviation_share": bake.greatest_share(),
            "root_mean_square_deviation_m": bake.root_mean_square,
            "root_mean_square_deviation_share": bake.root_mean_square_share(),
            "likely_spacing_m": bake.likely_spacing(),
        })
    });
    json!({
        "wall": mesh.wall,
        "file": mesh.file,
        "triangles": mesh.triangles,
        "vertices": mesh.vertices,
        "size_m": mesh.size.as_slice(),
        "degenerate": mesh.degenerate,
        "duplicates": mesh.duplicates,
        "welded": mesh.welded,
        "flipped": mesh.flipped,
        "open_edges": mesh.open_edges,
        "rims": mesh.rims,
        "largest_rim": rim,
        "crowded_edges": mesh.crowded_edges,
        "unread_bytes": mesh.unread_bytes,
        "is_repaired": mesh.is_repaired,
        "bake": bake,
        "warnings": mesh.warnings(),
    })
}

/// Frames of a stretch of time [s], the one at its beginning included [-].
fn frames_within(span: f64, scene: &Scene) -> f64 {
    (span / scene.plan.frame_interval).floor() + 1.0
}

/// Frames that are kept at most [-], the first among them; none where all are.
fn kept_frames(scene: &Scene) -> Option<f64> {
    let kept = scene.plan.kept_frames;
    let of_last = kept.of_last.map(|span| frames_within(span, scene));
    let around = kept
        .around_worst_hits
        .map(|reach| WORST_HITS as f64 * frames_within(2.0 * reach, scene) + 1.0);
    let asked: Vec<f64> = of_last.into_iter().chain(around).collect();
    (!asked.is_empty()).then(|| 1.0 + asked.into_iter().sum::<f64>())
}

/// Memory of each pellet at the most [B].
fn memory_per_pellet(scene: &Scene) -> f64 {
    if scene.output.contacts {
        MEMORY_PER_PELLET + MEMORY_OF_CONTACTS
    } else {
        MEMORY_PER_PELLET
    }
}

/// What a frame of so many pellets takes of each [B].
fn bytes_of_pellet(scene: &Scene, pellets: f64) -> f64 {
    let output = &scene.output;
    let spheres = if pellets <= output.spheres_up_to as f64 {
        BYTES_OF_SPHERE
    } else {
        0.0
    };
    let contacts = if output.contacts {
        BYTES_OF_CONTACTS
    } else {
        0.0
    };
    BYTES_OF_PELLET + spheres + contacts
}
