//! Recordings, as every command that reads one does.

use crate::file::folder;
use pelletflow_impact::{Scatter, Strength, StrengthLaw};
use pelletflow_log::{
    BreakageRequest, ExportFormat, ReportRequest, ReportStrength, TableKind, breakage, export,
    inspect, read_attachment, read_frames, read_hits, read_tables, report,
};
use std::fs;
use std::path::Path;

/// Force that breaks a pellet [N].
const STRENGTH: f64 = 5.0;
/// Size of a page at most [B].
const PAGE: usize = 1_000_000;

/// Inspects, scores, reports and exports a recording.
pub(crate) fn read(bytes: &[u8]) -> bool {
    let folder = folder(&[("run.mcap", bytes)]);
    let recording = folder.path().join("run.mcap");
    let is_scored = score(&recording);
    let reported = report(&ReportRequest {
        recording: &recording,
        most_bytes: PAGE,
        strength: Some(ReportStrength {
            request: request(),
            told: "a load",
        }),
        materials: &[],
        checks: &[],
    });
    let formats = [ExportFormat::Csv, ExportFormat::Parquet, ExportFormat::Vtk];
    let are_exported = formats.map(|format| {
        let output = folder.path().join("exported");
        export(&recording, format, output).is_ok()
    });
    assert_eq!(
        fs::read_dir(folder.path()).map(Iterator::count).ok(),
        Some(if folder.path().join("exported").exists() {
            2
        } else {
            1
        }),
        "nothing is written beside what was asked for"
    );
    let are_frames =
        read_frames(&recording).is_ok_and(|mut frames| frames.all(|frame| frame.is_ok()));
    let are_tables = read_tables(&recording, &TableKind::ALL).is_ok();
    // Nothing to hold it against: it must end, whatever it says.
    let _ = read_attachment(&recording, "scene.toml");
    inspect(&recording).is_ok()
        && is_scored
        && reported.is_ok()
        && are_exported == [true; 3]
        && are_frames
        && are_tables
}

fn request() -> BreakageRequest {
    let law = StrengthLaw::Load(Strength {
        scatter: Scatter::Fixed(STRENGTH),
        test_diameter: None,
        sample_size: None,
    });
    BreakageRequest {
        law,
        yield_pressure: Some(6.0e7),
        places: 5,
    }
}

fn score(recording: &Path) -> bool {
    read_hits(recording).is_ok_and(|hits| breakage(&hits, &request()).is_ok())
}
