//! The replay that a page carries: one packed run of bytes, and what tells how to read it.

use super::broken::Broken;
use super::frames::ReplayFrame;
use super::hits::HitFindings;
use super::html::put;
use super::pass::Gathered;
use super::tracks::{FORCE_DECADES, Scales, Tracks};
use crate::walls::{WallPlace, WallSurface};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use pelletflow_sim::{Hit, HitPartner};
use serde_json::{Value, json};
use std::io::Write;

/// Colors that a scale is told in [-].
const COLORS: u32 = 64;
/// Where the scale of colors begins [-]: pellets at rest would swallow their own shading in its darkest part.
const DARKEST: f64 = 1.0 / 9.0;

/// A replay, ready for the page.
pub(super) struct Replay {
    /// How to read the bytes.
    pub(super) header: Value,
    /// The bytes, deflated and in base 64.
    pub(super) packed: String,
}

impl Replay {
    /// Packs what was gathered; of the walls, those of `is_drawn` have their triangles.
    pub(super) fn pack(gathered: &Gathered, broken: Option<&Broken>, is_drawn: &[bool]) -> Self {
        let frames: Vec<&ReplayFrame> = gathered.frames.frames().collect();
        let scales = Scales::of(frames.iter().copied());
        let tracks = Tracks::of(frames.iter().copied(), &scales);
        let mut bytes = Vec::new();
        let mut walls = Vec::new();
        for (index, (surface, is_drawn)) in
            gathered.walls.surfaces().iter().zip(is_drawn).enumerate()
        {
            walls.push(wall(index, surface, *is_drawn, &frames, &mut bytes));
        }
        tracks.write(&mut bytes);
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        let packed = encoder
            .write_all(&bytes)
            .and_then(|()| encoder.finish())
            .expect("memory takes all that is written to it");
        Self {
            header: json!({
                "bytes": bytes.len(),
                "times": frames.iter().map(|frame| rounded(frame.time)).collect::<Vec<_>>(),
                "tracks": tracks.len(),
                "points": tracks.points(),
                "min": scales.min,
                "max": scales.max,
                "radius": scales.radius,
                "speed": scales.speed,
                "force": scales.force,
                "decades": FORCE_DECADES,
                "colors": colors(),
                "walls": walls,
                "hits": hits(&gathered.hits, broken),
            }),
            packed: STANDARD.encode(packed),
        }
    }
}

/// Tells of a wall and writes its numbers: poses where it moves, corners, edges and triangles.
fn wall(
    index: usize,
    surface: &WallSurface,
    is_drawn: bool,
    frames: &[&ReplayFrame],
    bytes: &mut Vec<u8>,
) -> Value {
    // A wall that the first frames do not know is not there yet.
    let place = |frame: &ReplayFrame| frame.walls.get(index).copied();
    let places: Vec<WallPlace> = frames
        .iter()
        .map(|frame| place(frame).unwrap_or(WallPlace::UNKNOWN))
        .collect();
    let moves = places.windows(2).any(|pair| pair[0].pose != pair[1].pose);
    let poses = if moves {
        places.as_slice()
    } else {
        &places[..places.len().min(1)]
    };
    let mut floats = |values: &[f32]| {
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    };
    for place in poses {
        floats(&place.pose);
    }
    let corners: &[_] = if is_drawn { &surface.corners } else { &[] };
    let triangles: &[_] = if is_drawn { &surface.triangles } else { &[] };
    for point in corners.iter().chain(&surface.edges) {
        floats(point);
    }
    bytes.extend(triangles.iter().flat_map(|index| index.to_le_bytes()));
    let presence: String = places
        .iter()
        .map(|place| if place.is_present { '1' } else { '0' })
        .collect();
    json!({
        "name": surface.name,
        "active": surface.is_active,
        "poses": poses.len(),
        "corners": corners.len(),
        "edges": surface.edges.len(),
        "indices": triangles.len(),
        "presence": presence,
    })
}

/// Hits that are marked: those that may break a pellet where a strength is given, the hardest on walls otherwise.
///
/// Each is told by its moment, its place and its weight, which the area of its mark goes by: how many pellets it breaks,
/// or its force.
fn hits(findings: &HitFindings, broken: Option<&Broken>) -> Value {
    let told = |hit: &Hit, weight: f64| {
        let place = [hit.place.x, hit.place.y, hit.place.z].map(rounded);
        json!([rounded(hit.peak_time), place, rounded(weight)])
    };
    if let Some(broken) = broken {
        let marked = broken.marked().iter();
        return marked.map(|(hit, weight)| told(hit, *weight)).collect();
    }
    let is_on_wall = |hit: &&Hit| matches!(hit.partner, HitPartner::Wall(_));
    let worst = findings.worst.as_slice().iter().filter(is_on_wall);
    worst.map(|hit| told(hit, hit.peak_force)).collect()
}

/// Colors of the scale, from its first to its last, as six hexadecimal digits each.
fn colors() -> String {
    let mut digits = String::new();
    for index in 0..COLORS {
        let share = f64::from(index) / f64::from(COLORS - 1);
        let color = colorous::VIRIDIS.eval_continuous(DARKEST + (1.0 - DARKEST) * share);
        put(&mut digits, format_args!("{color:x}"));
    }
    digits
}

/// A number short enough for a page: six digits after the point.
fn rounded(value: f64) -> f64 {
    (value * 1.0e6).round() / 1.0e6
}
