//! Recordings and summaries out, and recordings read back.
//!
//! [`run()`] drives a simulation and writes a directory: `run.mcap` opens in Lichtblick, Foxglove and Rerun,
//! `summary.json` holds the run in numbers. [`inspect()`], [`read_frames`] and [`tables`] read a recording back,
//! even one that was cut off.

pub mod accuracy;
pub mod breakage;
mod checkpoint;
mod counts_before;
mod course;
mod ending;
mod error;
mod export;
pub mod figures;
mod frames;
mod hit_summary;
mod hits;
mod inspect;
mod layout;
mod live;
mod logbook;
mod markup;
mod message;
mod opening;
mod output;
mod patches;
pub mod plot;
mod profile;
mod provenance;
mod recording;
mod records;
mod report;
mod run;
pub mod safe_setting;
mod summary;
pub mod surface;
pub mod tables;
mod thinning;
mod walls;
mod worst_hits;

pub use breakage::{Breakage, BreakageRequest, breakage};
pub use checkpoint::{
    Earlier, Resumption, SnapshotError, admit, discard, earlier, snapshot_from_bytes,
    snapshot_to_bytes,
};
pub use error::{FolderError, ReadError, RunError};
pub use export::{ExportError, ExportFormat, Exported, export};
pub use frames::{FrameRecord, Frames, PelletRecord, read_attachment, read_frames};
pub use hit_summary::HitSummary;
pub use hits::{RecordedHits, read_hits};
pub use inspect::{AttachmentInspection, ChannelInspection, Inspection, inspect};
pub use live::{LIVE_ADDRESS, Live, LiveError};
pub use message::color::color_on_scale;
pub use plot::{Axis, Chart, ChartError, Drawing, Scale, Series, SeriesStyle};
pub use profile::{PhaseCost, Profile};
pub use report::{Report, ReportCheck, ReportError, ReportRequest, ReportStrength, report};
pub use run::{Progress, RunRequest, run};
pub use safe_setting::{SafeSetting, SafeSettingError, SafeSettingRequest, safe_setting};
pub use summary::{
    BodySummary, ContactSummary, Ended, EnergySummary, MassSummary, MeterSummary, PatchSummary,
    PerformanceSummary, SkippedSummary, Summary, TallySummary, TimeSummary,
};
pub use surface::Mesh;
pub use tables::{Column, Table, TableKind, Tables, Values, hits_table, read_tables};
pub use worst_hits::{WORST_HITS, WorstHits};
