//! Frames that are left out of a recording once its run is over.
//!
//! Only then is it known which hits were the hardest and when the run ended. Until then the recording holds every frame, so
//! that a run that is killed shows all of it, and one that is interrupted can go on.

use crate::error::RunError;
use crate::message::nanoseconds;
use crate::opening::{RECORDING, UNFINISHED, as_io, record};
use crate::output::{Output, sync_directory};
use crate::recording::CarryError;
use crate::records::Records;
use crate::run::RunRequest;
use pelletflow_sim::{KeptFrames, Simulation};
use std::fs;
use std::io;

/// Moments from and to which all frames are kept [ns].
type Span = [u64; 2];

/// Writes the recording of a run that is over again, beside itself and with the frames only that are kept; `moments` are
/// those of the hardest hits [s]. Whether that was asked for.
pub(crate) fn thin(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    moments: &[f64],
) -> Result<bool, RunError> {
    let kept = request.plan.kept_frames;
    if kept.are_all() {
        return Ok(false);
    }
    let thinned = written(
        output,
        simulation,
        request,
        &spans(kept, simulation, moments),
    );
    if thinned.is_err() {
        // It may be what fills the disk; the recording is whole without it.
        let _ = fs::remove_file(output.path(UNFINISHED));
    }
    thinned.map(|()| true)
}

/// Puts what [`thin`] has written in the place of the recording.
pub(crate) fn take_place(output: &Output) -> Result<(), RunError> {
    let unfinished = output.path(UNFINISHED);
    fs::rename(&unfinished, output.path(RECORDING))
        .map_err(|source| RunError::output(&unfinished, source))?;
    sync_directory(output.directory());
    Ok(())
}

fn written(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
    spans: &[Span],
) -> Result<(), RunError> {
    let path = output.path(UNFINISHED);
    let refused = |error: CarryError| {
        let source = match error {
            CarryError::Unwritable(error) => as_io(error),
            CarryError::Unreadable(error) => io::Error::other(error),
            CarryError::Short(_) | CarryError::Other => {
                io::Error::other("the recording is not as it was written")
            }
        };
        RunError::output(&path, source)
    };
    let mut whole = Records::open(&output.path(RECORDING))
        .map_err(|error| refused(CarryError::Unreadable(error)))?;
    let (mut recording, file) = record(output, simulation, request, UNFINISHED, None)?;
    recording
        .thin(&mut whole, |moment| {
            spans
                .iter()
                .any(|[from, to]| (*from..=*to).contains(&moment))
        })
        .and_then(|()| recording.finish().map_err(CarryError::Unwritable))
        .map_err(refused)?
        .into_inner()
        .map_err(|error| RunError::output(&path, error.into_error()))?;
    file.sync_all()
        .map_err(|source| RunError::output(&path, source))
}

/// What is kept of a run that is over; the last frame in any case.
fn spans(kept: KeptFrames, simulation: &Simulation, moments: &[f64]) -> Vec<Span> {
    let (end, step) = (simulation.time(), simulation.model().time_step().seconds);
    let span = |from: f64, to: f64| [from.max(0.0), to].map(nanoseconds);
    let mut spans = vec![span(end - kept.of_last.unwrap_or(0.0), end)];
    if let Some(reach) = kept.around_worst_hits {
        // Frames fall on whole steps, and so up to a step farther apart than asked for.
        let reach = reach + step;
        spans.extend(moments.iter().map(|at| span(at - reach, at + reach)));
    }
    spans
}
