//! How a recording is opened: anew, or where an earlier part of it ended.

use crate::error::{FolderError, RunError};
use crate::layout::layout;
use crate::output::{Output, sync_directory};
use crate::patches;
use crate::provenance::{FORMAT, FORMAT_KEY};
use crate::recording::{CarryError, Mark, Recording, Title};
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
/// The same while an earlier part is copied.
const UNFINISHED: &str = "run.mcap.part";

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
    start(output, simulation, request, RECORDING)
}

/// Writes what an earlier part of the recording holds up to its mark into a new file, which then takes its place.
pub(crate) fn go_on(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    earlier: &EarlierPart,
) -> Result<Recorded, RunError> {
    let (path, unfinished) = (output.path(RECORDING), output.path(UNFINISHED));
    let mut records =
        Records::open(&path).map_err(|source| FolderError::UnreadableRecording { source })?;
    let (mut recording, file) = start(output, simulation, request, UNFINISHED)?;
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

/// Writes what stands beside the recording, and begins that in a file of a name.
fn start(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    name: &str,
) -> Result<Recorded, RunError> {
    let setup = simulation.model().setup();
    let full_speed = simulation.model().time_step().expected_speed;
    let layout = layout(
        &setup.domain.bounds,
        &simulation.meter_readings(),
        request.spheres_up_to,
        full_speed,
    );
    output.write("scene.toml", request.scene_text)?;
    for (path, bytes) in request.scene_files {
        output.write_beside(path, bytes)?;
    }
    output.write("layout.json", &layout)?;
    patches::write(output, simulation)?;
    let title = Title {
        scene_text: request.scene_text,
        layout: &layout,
        facts: facts(simulation, request),
    };
    let path = output.path(name);
    let file = output.file(name)?;
    let again = file
        .try_clone()
        .map_err(|source| RunError::output(&path, source))?;
    let file = BufWriter::new(file);
    let recording = Recording::start(file, setup, &title, request.spheres_up_to, full_speed)
        .map_err(|error| RunError::output(&path, as_io(error)))?;
    Ok((recording, again))
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
