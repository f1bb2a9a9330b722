//! How a recording is opened: anew, or where an earlier part of it ended.

use crate::error::{FolderError, RunError};
use crate::layout::{self, View, layout};
use crate::live::{Live, Program};
use crate::output::{Output, sync_directory};
use crate::patches;
use crate::provenance::{FORMAT, FORMAT_KEY};
use crate::recording::{CarryError, Drawn, Mark, Recording, Title};
use crate::records::Records;
use crate::run::RunRequest;
use mcap::McapError;
use pelletflow_sim::Simulation;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

/// Name of the recording.
pub(crate) const RECORDING: &str = "run.mcap";
/// The same while it is written again.
pub(crate) const UNFINISHED: &str = "run.mcap.part";

/// What there is of a run that goes on.
pub(crate) struct EarlierPart {
    pub(crate) mark: Mark,
    /// A checkpoint newer than the one that is taken up, which cannot be.
    pub(crate) damaged: Option<PathBuf>,
}

/// A recording, and its file once more, so that what has been written can be waited for.
pub(crate) type Recorded = (Recording<BufWriter<File>>, File);

/// Writes what is known before the first step, and begins the recording.
pub(crate) fn begin(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
) -> Result<Recorded, RunError> {
    prepare(output, simulation, request)?;
    record(output, simulation, request, RECORDING, program(request))
}

/// Writes what an earlier part of the recording holds up to its mark into a new file, which then takes its place.
///
/// Where that is refused, the directory is left as it is.
pub(crate) fn go_on(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    earlier: &EarlierPart,
) -> Result<Recorded, RunError> {
    let (path, unfinished) = (output.path(RECORDING), output.path(UNFINISHED));
    let mut records =
        Records::open(&path).map_err(|source| FolderError::UnreadableRecording { source })?;
    let (mut recording, file) = record(output, simulation, request, UNFINISHED, program(request))?;
    let carried = recording
        .carry(&mut records, &earlier.mark)
        .map_err(|error| refused(error, &path, &earlier.mark));
    drop(records);
    if carried.is_err() {
        // The earlier part is left as it is; of this one nothing is needed.
        let _ = fs::remove_file(&unfinished);
    }
    carried?;
    recording
        .flush()
        .map_err(as_io)
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&unfinished, &path))
        .map_err(|source| RunError::output(&unfinished, source))?;
    sync_directory(output.directory());
    prepare(output, simulation, request)?;
    if let Some(damaged) = &earlier.damaged {
        // Else it would push out the good one.
        fs::remove_file(damaged).map_err(|source| RunError::output(damaged, source))?;
    }
    Ok((recording, file))
}

/// Why an earlier part cannot be carried on.
fn refused(error: CarryError, path: &Path, mark: &Mark) -> RunError {
    let path = path.to_owned();
    match error {
        CarryError::Unwritable(error) => RunError::output(&path, as_io(error)),
        CarryError::Unreadable(source) => FolderError::UnreadableRecording { source }.into(),
        CarryError::Other => FolderError::OtherRecording { path }.into(),
        CarryError::Short(found) => FolderError::ShortRecording {
            path,
            found,
            needed: mark.messages,
        }
        .into(),
    }
}

/// Writes what stands beside the recording, and takes away what another run has left.
fn prepare(output: &Output, simulation: &Simulation, request: &RunRequest) -> Result<(), RunError> {
    output.clear("summary.json")?;
    output.clear(UNFINISHED)?;
    output.write("scene.toml", request.scene_text)?;
    for (path, bytes) in request.scene_files {
        output.write_beside(path, bytes)?;
    }
    output.write("layout.json", &layout_of(simulation, request))?;
    patches::write(output, simulation)
}

/// What viewers see of the run, where they are let.
fn program(request: &RunRequest) -> Option<Program> {
    request.live.map(Live::program)
}

/// Begins a recording in a file of a name, and shows it where it is to be watched.
pub(crate) fn record(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    name: &str,
    live: Option<Program>,
) -> Result<Recorded, RunError> {
    let title = Title {
        scene_text: request.scene_text,
        layout: &layout_of(simulation, request),
        facts: facts(simulation, request),
    };
    let path = output.path(name);
    let file = output.file(name)?;
    let again = file
        .try_clone()
        .map_err(|source| RunError::output(&path, source))?;
    let model = simulation.model();
    let recording = Recording::start(
        BufWriter::new(file),
        model.setup(),
        &title,
        Drawn {
            spheres_up_to: request.spheres_up_to,
            full_speed: model.time_step().expected_speed,
            contacts: request.contacts,
        },
        live,
    )
    .map_err(|error| RunError::output(&path, as_io(error)))?;
    Ok((recording, again))
}

fn layout_of(simulation: &Simulation, request: &RunRequest) -> String {
    let model = simulation.model();
    let most_pellets = simulation.pellet_count() as f64 + model.fed_until(request.plan.end_time);
    layout(&View {
        bounds: &layout::bounds_of(simulation),
        meters: &simulation.meter_readings(),
        has_hits: model.setup().hits.is_some(),
        has_spheres: request.spheres_up_to > 0,
        has_points: most_pellets > request.spheres_up_to as f64,
        full_speed: model.time_step().expected_speed,
    })
}

fn facts(simulation: &Simulation, request: &RunRequest) -> BTreeMap<String, String> {
    let model = simulation.model();
    [
        (FORMAT_KEY, FORMAT.to_string()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("scene", request.scene_name.to_owned()),
        ("title", request.scene_title.to_owned()),
        ("scene_hash", request.scene_hash.to_owned()),
        ("seed", model.setup().seed.to_string()),
        ("threads", simulation.threads().to_string()),
        ("step_s", model.time_step().seconds.to_string()),
        ("step_reason", model.time_step().reason.clone()),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

/// The error of the file system, where it is one.
pub(crate) fn as_io(error: McapError) -> io::Error {
    match error {
        McapError::Io(error) => error,
        other => io::Error::other(other),
    }
}
