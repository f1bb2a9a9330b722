//! Draws frames of a recording side by side: pellets colored by speed, walls cut open.
//!
//! ```text
//! cargo run --release --example picture -- out/hopper/run.mcap hopper.png 0.78 1.0 1.3
//! ```
//!
//! Each time [s] gives one panel; without times, three spread over the run are drawn.
//! The scene is read from the recording, so that a recording alone is enough.

mod camera;
mod canvas;
mod palette;
mod panel;
mod pellets;
mod walls;

use canvas::Canvas;
use panel::Panel;
use pelletflow::core::Bounds;
use pelletflow::log::{FrameRecord, inspect, read_attachment, read_frames};
use pelletflow::scene::Scene;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Size of the picture [px].
const SIZE: [usize; 2] = [1200, 700];
/// Height of the strip above the panels, which holds their times [px].
const CAPTION_HEIGHT: usize = 46;
/// Height of the strip below the panels, which holds the scale [px].
const SCALE_HEIGHT: usize = 60;
/// Panels drawn where no times are given [-].
const PANELS: usize = 3;
/// Share of the pellets that are slower than the end of the scale [-].
const SCALE_SHARE: f64 = 0.995;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let (Some(recording), Some(picture)) = (arguments.next(), arguments.next()) else {
        return told("usage: picture RECORDING PICTURE.png [TIME]...");
    };
    let times: Result<Vec<f64>, _> = arguments.map(|time| time.parse()).collect();
    let Ok(times) = times else {
        return told("a time is not a number; give seconds, such as 0.8");
    };
    match draw(&PathBuf::from(recording), &PathBuf::from(picture), &times) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => told(&error.to_string()),
    }
}

#[expect(
    clippy::print_stderr,
    reason = "a program tells its user what went wrong"
)]
fn told(message: &str) -> ExitCode {
    eprintln!("{message}");
    ExitCode::FAILURE
}

fn draw(recording: &Path, picture: &Path, times: &[f64]) -> Result<(), Box<dyn Error>> {
    // Meshes lie beside the scene; a recording on its own has only the text.
    let beside = recording.with_file_name("scene.toml");
    let scene = if beside.is_file() {
        Scene::read(&beside, &[])?
    } else {
        Scene::parse(&read_attachment(recording, "scene.toml")?, "scene", &[])?
    };
    let frames = chosen(recording, times)?;
    let full_speed = scale_end(&frames);
    let bounds = shown(&scene, &frames);
    let mut canvas = Canvas::new(SIZE);
    let width = SIZE[0] / frames.len();
    for (index, frame) in frames.iter().enumerate() {
        let panel = Panel::new(&scene.setup, frame, &bounds, full_speed);
        let origin = [index * width, CAPTION_HEIGHT];
        let height = SIZE[1] - CAPTION_HEIGHT - SCALE_HEIGHT;
        panel.render(&mut canvas, origin, [width, height]);
        let caption = format!("t = {:.2} s", frame.time);
        canvas.centered_text(&caption, [origin[0] + width / 2, 16], 2);
    }
    canvas.scale(full_speed, SIZE[1] - SCALE_HEIGHT);
    canvas.save(picture)?;
    Ok(())
}

/// The frames nearest to the times asked for, or some spread over the run.
fn chosen(recording: &Path, times: &[f64]) -> Result<Vec<FrameRecord>, Box<dyn Error>> {
    let times = if times.is_empty() {
        let duration = inspect(recording)?.duration_s;
        let moment = |panel: usize| duration * (panel as f64 + 0.5) / PANELS as f64;
        (0..PANELS).map(moment).collect()
    } else {
        times.to_vec()
    };
    let mut best: Vec<Option<FrameRecord>> = vec![None; times.len()];
    for frame in read_frames(recording)? {
        let frame = frame?;
        for (time, best) in times.iter().zip(&mut best) {
            let off = |frame: &FrameRecord| (frame.time - time).abs();
            if best.as_ref().is_none_or(|best| off(&frame) < off(best)) {
                *best = Some(frame.clone());
            }
        }
    }
    let found: Option<Vec<_>> = best.into_iter().collect();
    found.ok_or_else(|| "the recording holds no frame".into())
}

/// A round speed that nearly all pellets stay below [m/s].
fn scale_end(frames: &[FrameRecord]) -> f64 {
    let mut speeds: Vec<f64> = frames
        .iter()
        .flat_map(|frame| frame.pellets.iter().map(|pellet| f64::from(pellet.speed)))
        .collect();
    speeds.sort_unstable_by(f64::total_cmp);
    let place = (speeds.len() as f64 * SCALE_SHARE) as usize;
    let speed = speeds.get(place.min(speeds.len().saturating_sub(1)));
    let speed = speed.copied().unwrap_or(0.0).max(1.0e-3);
    let decade = 10.0_f64.powf(speed.log10().floor());
    [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0]
        .map(|digit| digit * decade)
        .into_iter()
        .find(|round| *round >= speed)
        .unwrap_or(speed)
}

/// A box about the walls that end somewhere, and about every pellet [m].
fn shown(scene: &Scene, frames: &[FrameRecord]) -> Bounds {
    let domain = &scene.setup.domain.bounds;
    let walls = scene.setup.walls.iter().map(|wall| wall.shape.bounds());
    let pellets = frames
        .iter()
        .flat_map(|frame| &frame.pellets)
        .map(|pellet| {
            let center = pellets::center(pellet);
            let point = Bounds {
                min: center,
                max: center,
            };
            point.grown(f64::from(pellet.radius))
        });
    walls
        .filter(Bounds::is_finite)
        .chain(pellets)
        .reduce(|all, one| all.merged(&one))
        .map_or(*domain, |all| all.common(domain))
}
