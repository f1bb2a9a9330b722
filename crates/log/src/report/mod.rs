//! A recording as one page that opens in any browser, without a network: what was run, plots, and a replay in space.
//!
//! The recording is read in one pass, and in another one for each of two reasons: pellets may break, or what was let go
//! of on the way would have had room.
//! But for those hits, memory is bounded by the size of the page: what does not fit is thinned on the way, and the page
//! says so.

mod broken;
mod charts;
mod curve;
mod frames;
mod hits;
mod html;
mod page;
mod pass;
mod replay;
mod tracks;

use crate::breakage::BreakageRequest;
use crate::error::ReadError;
use broken::Broken;
use pass::Gathered;
use pelletflow_impact::ImpactError;
use replay::Replay;
use std::path::Path;

/// Bytes of a page per pellet and frame at least, after packing and base 64 [B]: of pellets that hardly move.
const FEWEST_BYTES: usize = 3;
/// Pellets times frames that are held at most where they turn out to pack better than that [-]: half a gigabyte.
const MOST_HELD: usize = 16_000_000;
/// Share of the page that walls may take before they are packed [-].
const WALL_SHARE: f64 = 0.25;

/// What a report is made of.
#[derive(Debug, Clone, Copy)]
pub struct ReportRequest<'a> {
    /// The recording.
    pub recording: &'a Path,
    /// Size of the page at most [B].
    pub most_bytes: usize,
    /// What breaks a pellet, held against the hits.
    pub strength: Option<ReportStrength<'a>>,
    /// Materials, as a name and what is known of each.
    pub materials: &'a [(String, String)],
    /// What a right run shows, and what this one did.
    pub checks: &'a [ReportCheck],
}

/// What breaks a pellet.
#[derive(Debug, Clone, Copy)]
pub struct ReportStrength<'a> {
    /// What is asked of the hits.
    pub request: BreakageRequest,
    /// The strength in words.
    pub told: &'a str,
}

/// A report that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The recording cannot be read, is none of ours, or is damaged.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The strength or a recorded hit is outside its bounds.
    #[error(transparent)]
    Strength(#[from] ImpactError),
}

/// Something that a right run shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportCheck {
    /// Which quantity of the summary.
    pub key: String,
    /// What was expected, ready to read.
    pub expected: String,
    /// What was found, ready to read.
    pub found: String,
    /// Whether the two agree.
    pub is_met: bool,
}

/// A report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// The page.
    pub html: String,
    /// What the page shows in place of all that the recording holds, in words; the page says it too.
    pub omissions: Vec<String>,
}

/// Makes a page of a recording; of one that is cut off, of what is before the cut.
///
/// # Errors
/// The recording cannot be read, is none of ours, or is damaged, or a quantity of the strength is outside its bounds.
pub fn report(request: &ReportRequest) -> Result<Report, ReportError> {
    let capacity = request.most_bytes / FEWEST_BYTES;
    let gathered = Gathered::read(request.recording, capacity)?;
    let is_thinned = !gathered.frames.omissions().is_empty();
    // A run that did not follow hits has none to hold against a strength, and the page says so.
    let followed = gathered.hits.walls.is_some();
    let strength = request.strength.as_ref().filter(|_| followed);
    let broken = strength
        .map(|strength| Broken::read(request.recording, strength))
        .transpose()?;
    let report = page_of(gathered, broken.as_ref(), request);
    let room = request.most_bytes / report.html.len();
    let greater = (capacity * room).min(MOST_HELD);
    if is_thinned && greater >= 2 * capacity {
        let gathered = Gathered::read(request.recording, greater)?;
        return Ok(page_of(gathered, broken.as_ref(), request));
    }
    Ok(report)
}

/// Makes a page of what was gathered, and thins it until it fits.
fn page_of(mut gathered: Gathered, broken: Option<&Broken>, request: &ReportRequest) -> Report {
    let mut omissions = Vec::from_iter(gathered.omission());
    omissions.extend(broken.and_then(Broken::omission));
    let is_drawn = drawn_walls(&gathered, request.most_bytes, &mut omissions);
    let fixed = page::Fixed::of(&gathered, broken, request);
    loop {
        let replay = Replay::pack(&gathered, broken, &is_drawn);
        let mut omissions = omissions.clone();
        omissions.extend(gathered.frames.omissions());
        let html = fixed.page(&replay, &omissions);
        if html.len() <= request.most_bytes || !gathered.frames.thin() {
            return Report { html, omissions };
        }
    }
}

/// Which walls have their triangles on the page: the largest are left out where they are too many.
fn drawn_walls(gathered: &Gathered, most_bytes: usize, omissions: &mut Vec<String>) -> Vec<bool> {
    let surfaces = gathered.walls.surfaces();
    let bytes: Vec<usize> = surfaces
        .iter()
        .map(|surface| 12 * surface.corners.len() + 4 * surface.triangles.len())
        .collect();
    let mut order: Vec<usize> = (0..surfaces.len()).collect();
    order.sort_by_key(|&index| bytes[index]);
    let mut room = (WALL_SHARE * most_bytes as f64) as usize;
    let mut is_drawn = vec![true; surfaces.len()];
    for index in order {
        if bytes[index] <= room {
            room -= bytes[index];
        } else {
            is_drawn[index] = false;
            omissions.push(format!(
                "the surface of wall `{}`, {} triangles; its edges are drawn",
                surfaces[index].name,
                crate::figures::count(surfaces[index].triangles.len() as u64 / 3)
            ));
        }
    }
    is_drawn
}
